# levels.tsv to one series with a column a test, for a picture. Set by -v: series.
BEGIN { FS = "\t" }
FNR == 1 { head(); print series "\ttensile_over_BTS\tuniaxial_over_UCS"; next }
value("series") == series {
    level = value("level")
    if (!(level in seen)) { seen[level] = 1; order[++n] = level }
    normalised[level, value("test")] = value("normalised")
}
END { for (i = 1; i <= n; ++i) printf "%s\t%s\t%s\n", order[i], normalised[order[i], "brazilian"], normalised[order[i], "uniaxial"] }
