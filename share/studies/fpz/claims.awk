# published.tsv and tables of `graincrack-post fpz` to claims.tsv. A number holds if it is the paper's when rounded as there.
BEGIN { FS = "\t"; claims_head() }
FNR == 1 { delete column; for (i = 1; i <= NF; ++i) column[$i] = i; ++file; level = FILENAME ~ /\/tc[0-9.]+\.tsv$/ ? FILENAME : ""; sub(/.*\/tc/, "", level); sub(/\.tsv$/, "", level); next }
file == 1 { row[++n] = $0; next }
{ ours[$column["quantity"], $column["plane"], level] = $column["value"] + 0 }
END {
    for (i = 1; i <= n; ++i) {
        split(row[i], f, "\t")
        key = f[2] SUBSEP f[3] SUBSEP f[4]
        if (!(key in ours)) { print f[2] ": no such quantity" > "/dev/stderr"; exit 1 }
        x = ours[key] * f[5]
        off = x - f[6]
        if (off < 0) off = -off
        # A tolerance of 1e-3 of the last digit: a following 5 may be rounded up or down.
        claim(f[1], f[6] unit(f[7]), sprintf("%.5g", x) unit(f[7]), sprintf("%+.2f %%", 100 * (x / f[6] - 1)),
            off <= f[8] * 1.001 || (f[1] ~ /at least/ && x > f[6]) ? "holds" : "differs", f[9])
    }
}
function unit(u) { return u == "1" ? "" : " " u }
