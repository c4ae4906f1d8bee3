# properties.tsv of the confirmation, predicted.tsv and toughness.tsv of further tests, moduli.tsv of the confirmation, to a row a property:
# whether it was fitted or predicted, and whether it is within its bound. Set by -v: cohesion, ucs, b, toughness, of the laboratory.
BEGIN {
    FS = "\t"
    print "property\tfrom\tlaboratory\tours\thalf_interval_percent\toff\tbound\tverdict"
    bound["young_modulus_GPa"] = 0.02; bound["tensile_strength_MPa"] = bound["s1_at_0_MPa"] = 0.05; bound["slope_b"] = 0.08
    from["young_modulus_GPa"] = from["poisson_ratio"] = from["tensile_strength_MPa"] = from["s1_at_0_MPa"] = from["slope_b"] = "fitted"
}
FNR == 1 { head(); ++file; next }
file == 1 {
    p = value("property")
    if (p ~ /^s1_at_/ && p != "s1_at_0_MPa") bound[p] = 0.05
    row(p, (p in from) ? from[p] : p ~ /^s1_at_/ ? "fitted, by b" : "predicted", value("laboratory"), value("ours"), value("half_interval_percent"))
    next
}
file == 2 && value("test") == "tension" { row("direct_tensile_strength_MPa", "predicted", "", value("strength_MPa"), interval()); next }
file == 2 {
    p = value("confining_pressure_MPa")
    bound["s1_at_" p "_MPa"] = 0.05
    row("s1_at_" p "_MPa", value("runs_without_peak") > 0 ? "predicted, " value("runs_without_peak") " of " value("runs") " without a peak" : "predicted", cohesion == "" ? ucs + b * p : 2 * cohesion * sqrt(b) + b * p, value("strength_MPa"), interval())
    next
}
file == 3 { add("toughness", value("mode_i_toughness_MPa.m^0.5")); next }
test_of(value("file")) == "uniaxial" {
    if (value("crack_initiation_count_MPa") != "") add("crack_initiation_count_MPa", value("crack_initiation_count_MPa"))
    if (value("crack_damage_2d_MPa") != "") add("crack_damage_2d_MPa", value("crack_damage_2d_MPa"))
}
END {
    threshold("crack_initiation_count_MPa")
    threshold("crack_damage_2d_MPa")
    row("mode_i_toughness_MPa.m^0.5", "predicted", toughness, mean("toughness"), count("toughness") > 1 ? sprintf("%.2f", 100 * half_interval("toughness") / mean("toughness")) : "")
}
function interval() { return value("strength_low_MPa") == "" ? "" : sprintf("%.2f", 50 * (value("strength_high_MPa") - value("strength_low_MPa")) / value("strength_MPa")) }
function threshold(p) { if (count(p)) row(p, "predicted", "", mean(p), count(p) > 1 ? sprintf("%.2f", 100 * half_interval(p) / mean(p)) : "") }
function row(p, origin, laboratory, ours, half,    off, limit, verdict) {
    if (p == "poisson_ratio") { limit = 0.015; off = ours - laboratory }
    else { limit = (p in bound) ? bound[p] : ""; off = laboratory == "" ? "" : ours / laboratory - 1 }
    verdict = limit == "" || laboratory == "" ? "" : abs(off) <= limit ? "within" : "outside"
    if (verdict == "within" && half != "" && half > 3) verdict = "within, interval wider than ±3 %"
    printf "%s\t%s\t%s\t%.5g\t%s\t%s\t%s\t%s\n", p, origin, laboratory == "" ? "" : sprintf("%.5g", laboratory), ours, half,
        off == "" ? "" : p == "poisson_ratio" ? sprintf("%+.4f", off) : sprintf("%+.2f %%", 100 * off), limit == "" ? "" : p == "poisson_ratio" ? "±0.015" : sprintf("±%g %%", 100 * limit), verdict
}
