# strength.tsv and moduli.tsv to one row for each confining pressure: cracks at the peak by mode, and ductility.
BEGIN { FS = "\t"; print "confining_pressure_MPa\tspecimens\twithout_peak\ttensile_cracks\tshear_cracks\ttensile_share\ttensile_share_half\tall_cracks\tall_cracks_half\tstrain_at_peak_percent\tstrain_at_peak_half\tpost_peak_slope_over_young_modulus" }
FNR == 1 { head(); ++file; next }
file == 1 && value("test") != "brazilian" {
    p = value("confining_pressure_MPa") + 0
    if (!count("all " p)) {
        for (i = n++; i > 0 && order[i] > p; --i) order[i + 1] = order[i]
        order[i + 1] = p
    }
    all = value("tensile_cracks") + value("shear_cracks")
    add("all " p, all)
    add("tensile " p, value("tensile_cracks"))
    add("shear " p, value("shear_cracks"))
    if (all > 0) add("share " p, value("tensile_cracks") / all)
    add("strain " p, 100 * value("strain_at_peak"))
    if (value("peak_kind") != "drop") ++n_without_peak[p]
}
file == 2 && value("post_peak_slope_over_young_modulus") != "" { add("brittleness " confinement(value("file")), value("post_peak_slope_over_young_modulus")) }
END {
    for (i = 1; i <= n; ++i) {
        p = order[i]
        printf "%s\t%d\t%d\t%.5g\t%.5g\t%s\t%s\t%.5g\t%s\t%.4g\t%s\t%s\n", p, count("all " p), n_without_peak[p] + 0, mean("tensile " p), mean("shear " p), of("share " p), half("share " p),
            mean("all " p), half("all " p), mean("strain " p), half("strain " p), of("brittleness " p)
    }
}
function of(name) { return count(name) ? sprintf("%.4g", mean(name)) : "" }
function half(name) { return count(name) > 1 ? sprintf("%.4g", half_interval(name)) : "" }
