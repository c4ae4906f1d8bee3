# Means over discs of a table of levels: "mean half" of the level `only`, or the means of all levels in a line.
BEGIN { FS = "\t" }
FNR == 1 { head(); next }
{
    if (!count(value("level"))) order[++n] = value("level")
    add(value("level"), value("tensile_strength_MPa"))
}
END {
    if (only != "") for (i = 1; i <= n; ++i) if (order[i] + 0 == only + 0) { printf "%.4g %.2g\n", mean(order[i]), half_interval(order[i]); exit }
    for (i = 1; i <= n; ++i) line_out = line_out sprintf("%s%.4g", i > 1 ? ", " : "", mean(order[i]))
    if (only == "") print line_out " MPa"
}
