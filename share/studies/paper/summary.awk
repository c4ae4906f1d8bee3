# claims.tsv of the paper to counts by study.
BEGIN { FS = "\t"; print "study\tpoint\tclaims\tholds\topen\tdiffers" }
FNR == 1 { head(); next }
{
    study = value("study")
    if (!(study in seen)) { seen[study] = 1; order[++n] = study }
    ++number[study, "the paper's", value("verdict")]
    ++number[study, "ours", value("our_verdict")]
    ++number[study, "with minerals", value("their_verdict")]
}
END {
    for (i = 1; i <= n; ++i) { row(order[i], "the paper's"); row(order[i], "ours"); row(order[i], "with minerals") }
}
function row(study, point,    all) {
    all = number[study, point, "holds"] + number[study, point, "open"] + number[study, point, "differs"]
    if (all) printf "%s\t%s\t%d\t%d\t%d\t%d\n", study, point, all, number[study, point, "holds"], number[study, point, "open"], number[study, point, "differs"]
}
