# claims.tsv of the paper to counts by study. The columns `verdict` are the sixth and the ninth.
BEGIN { FS = "\t"; print "study\tpoint\tclaims\tholds\topen\tdiffers" }
FNR == 1 { next }
{
    if (!($1 in seen)) { seen[$1] = 1; order[++n] = $1 }
    ++number[$1, "paper", $6]
    ++number[$1, "ours", $9]
}
END {
    for (i = 1; i <= n; ++i) { row(order[i], "paper"); row(order[i], "ours") }
}
function row(study, point,    all) {
    all = number[study, point, "holds"] + number[study, point, "open"] + number[study, point, "differs"]
    if (all) printf "%s\t%s\t%d\t%d\t%d\t%d\n", study, point == "paper" ? "the paper's" : "ours", all, number[study, point, "holds"], number[study, point, "open"], number[study, point, "differs"]
}
