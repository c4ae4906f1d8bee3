# strength.tsv and moduli.tsv of a scan to one table: a row for each variant, means with half of their 95 % intervals.
# Set by -v: variants.
BEGIN { FS = OFS = "\t" }
FNR == 1 { head(); next }
has("crack_damage_2d_MPa") {
    take("ci", value("crack_initiation_count_MPa"))
    take("cd", value("crack_damage_2d_MPa"))
    take("fall", value("post_peak_slope_over_young_modulus"))
    next
}
{
    test = test_of(value("file"))
    pressure = confinement(value("file"))
    if (test == "uniaxial") {
        take("UCS", value("peak_compressive_stress_MPa"))
        failed = value("tensile_cracks") + value("shear_cracks")
        if (failed > 0) {
            take("sign", value("tensile_cracks") / failed)
            take("displacement", value("tensile_cracks_by_displacement") / failed)
        }
    }
    if (test == "brazilian") take("bts", value("tensile_strength_MPa"))
    if (test == "tension") take("dts", value("tensile_strength_MPa"))
    if (pressure > 0) {
        ++tests[variant(value("file")), pressure]
        take("first" pressure, value("first_peak_MPa"))
        take("residual" pressure, value("residual_MPa"))
        take("hardening" pressure, value("rehardening_GPa"))
        take("largest" pressure, value("peak_compressive_stress_MPa"))
    }
}
END {
    print "variant", "UCS, MPa", "first peak at 4 MPa", "at 8 MPa (tests that have one)", "at 20 MPa", "residual at 8 MPa", "re-hardening at 8 MPa, GPa",
        "largest at 8 MPa", "Brazilian", "direct tension", "direct / Brazilian", "fall behind the UCS, E", "CI / UCS", "CD / UCS", "tensile cracks at UCS by sign, by displacement"
    n = split(variants, name_of, " ")
    for (v = 1; v <= n; ++v) {
        name = name_of[v]
        print name, show("UCS"), show("first4") of_tests(4), show("first8") of_tests(8), show("first20") of_tests(20), show("residual8"), show("hardening8"),
            show("largest8"), show("bts"), show("dts"), ratio("dts", "bts", "%.2f"), show("fall"), ratio("ci", "UCS", "%.2f"), ratio("cd", "UCS", "%.2f"),
            share("sign") ", " share("displacement")
    }
}
function take(what, x) { if (x != "") add(what " " variant(value("file")), x) }
function show(what) {
    what = what " " name
    if (count(what) == 0) return "-"
    return count(what) == 1 ? sprintf("%.1f", mean(what)) : sprintf("%.1f ± %.1f", mean(what), half_interval(what))
}
function of_tests(pressure) { return " (" count("first" pressure " " name) " of " tests[name, pressure] + 0 ")" }
function ratio(what, over, format) {
    return count(what " " name) && count(over " " name) ? sprintf(format, mean(what " " name) / mean(over " " name)) : "-"
}
function share(what) { return count(what " " name) ? sprintf("%.0f %%", 100 * mean(what " " name)) : "-" }
