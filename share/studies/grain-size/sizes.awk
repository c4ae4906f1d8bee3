# strength-SERIES.tsv to means over seeds, one row for each series, test and size.
BEGIN { FS = "\t"; print "series\ttest\tsize\tmean_edge_mm\truns\twithout_peak\tstrength_MPa\tdeviation_MPa\tlow_MPa\thigh_MPa" }
FNR == 1 { head(); series = FILENAME; sub(/.*strength-/, "", series); sub(/\.tsv$/, "", series); next }
{
    key = series "\t" test_of(value("file")) "\t" size_of(value("file"))
    if (!count(key)) order[++n] = key
    add(key, value("tensile_strength_MPa") value("peak_compressive_stress_MPa"))
    add("edge " key, value("mean_edge_mm"))
    if (value("peak_kind") != "drop") ++n_without_peak[key]
}
END {
    for (i = 1; i <= n; ++i) {
        key = order[i]
        h = half_interval(key)
        printf "%s\t%.4g\t%d\t%d\t%.5g\t%s\t%s\t%s\n", key, mean("edge " key), count(key), n_without_peak[key], mean(key), number(deviation(key)),
            h == "" ? "" : number(mean(key) - h), h == "" ? "" : number(mean(key) + h)
    }
}
function number(x) { return x == "" ? "" : sprintf("%.5g", x) }
