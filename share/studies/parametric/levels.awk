# series.tsv to means over seeds, one row for each test, series and level.
BEGIN { FS = "\t"; print "test\tseries\tlevel\truns\tstrength_MPa\tdeviation_MPa\tlow_MPa\thigh_MPa\tnormalised\twithout_peak" }
FNR == 1 { head(); next }
{
    key = value("test") "\t" value("series") "\t" value("level")
    if (!count(key)) {
        for (i = n++; i > 0 && before(key, order[i]); --i) order[i + 1] = order[i]
        order[i + 1] = key
    }
    add(key, value("strength_MPa"))
    over[key] = value("strength_MPa") / value("normalised")
    if (value("peak_kind") != "drop") ++n_without_peak[key]
}
END {
    for (i = 1; i <= n; ++i) {
        key = order[i]
        m = mean(key)
        h = half_interval(key)
        printf "%s\t%d\t%.5g\t%s\t%s\t%s\t%.4g\t%d\n", key, count(key), m, number(deviation(key)), h == "" ? "" : number(m - h),
            h == "" ? "" : number(m + h), m / over[key], n_without_peak[key]
    }
}
function number(x) { return x == "" ? "" : sprintf("%.5g", x) }
# Rows of one test and series stand together, by rising level.
function before(a, b,    s, t) {
    split(a, s, "\t")
    split(b, t, "\t")
    return s[1] == t[1] && s[2] == t[2] ? s[3] + 0 < t[3] + 0 : s[1] s[2] < t[1] t[2]
}
