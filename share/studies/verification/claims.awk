# properties.tsv, modes.tsv, directions.tsv, strength.tsv to the claims of §5 and §6.1. Set by -v: study, the laboratory's values.
BEGIN { FS = "\t"; claims_head() }
FNR == 1 { head(); ++file; next }
file == 1 {
    name = value("property")
    n_specimens[name] = value("specimens")
    laboratory[name] = value("laboratory"); published[name] = value("published"); ours[name] = value("ours")
    half[name] = value("low") == "" ? "" : (value("high") - value("low")) / 2
    needed[name] = value("specimens_for_3_percent"); n_without_peak[name] = value("without_peak")
    next
}
file == 2 {
    p[++n] = value("confining_pressure_MPa")
    tensile[n] = value("tensile_cracks"); shear[n] = value("shear_cracks"); share[n] = value("tensile_share"); share_half[n] = value("tensile_share_half")
    all[n] = value("all_cracks"); all_half[n] = value("all_cracks_half"); strain[n] = value("strain_at_peak_percent"); strain_half[n] = value("strain_at_peak_half")
    without[n] = value("without_peak"); specimens[n] = value("specimens")
    next
}
file == 3 { if (value("tensile_share_within_30_deg") != "") add("excess", value("tensile_share_within_30_deg") - value("facet_share_within_30_deg")); next }
value("test") == "triaxial" {
    # A test whose stress drops at first yield and does not recover has no separate first yield: it is the strength.
    yield = value("first_yield_MPa") == "" && value("peak_kind") == "drop" ? value("peak_compressive_stress_MPa") : value("first_yield_MPa")
    if (yield != "") add("yield " value("confining_pressure_MPa") + 0, yield)
}
value("test") == "brazilian" {
    if (value("first_crack_radius_over_R") != "") add("radius", value("first_crack_radius_over_R"))
    ++discs
    if (value("spanning_strength_MPa") != "") ++spanned
}
END {
    property("young_modulus_GPa", "E", "GPa", 0.02, 0, "contacts reduce the stiffness by some 4 % where the grains have the rock's E; the first step of `calibrate` corrects this")
    property("poisson_ratio", "ν", "", 0, 0.015, "contact compliance raises ν; the first step of `calibrate` corrects this")
    property("tensile_strength_MPa", "σt", "MPa", 0.05, 0, "the shear strength of open contacts and Gf determine it, tc hardly does (share/doc/readings.md)")
    property("s1_at_0_MPa", "UCS", "MPa", 0.05, 0, "the law under compression determines it, the same in all variants (share/doc/readings.md); a lower cc meets the UCS")
    for (i = 1; i <= n; ++i) if (p[i] > 0) property("s1_at_" p[i] "_MPa", "σ1 at " p[i] " MPa, against the laboratory's line", "MPa", 0.05, 0, end_of_test(i))
    property("slope_b", "slope b of the envelope", "", 0.08, 0, "from the strengths above")
    property("cohesion_MPa", "C", "MPa", 0.05, 0, "from the strengths above")
    property("friction_angle_deg", "φ", "°", 0.05, 0, "from the strengths above")
    for (i = 1; i <= n; ++i)
        claim(p[i] == 0 ? "§6.1: tensile cracks dominate at the uniaxial peak" : "§6.1: shear cracks dominate at the peak at " p[i] " MPa", p[i] == 0 ? "tensile" : "shear",
            sprintf("tensile %.0f : shear %.0f", tensile[i], shear[i]), sprintf("tensile share %.2f", share[i]), dominance(i),
            p[i] == 0 ? "more failed contacts slide under compression than open, and those that open slide too (share/doc/readings.md)" : "tensile cracks dominate")
    if (n > 1) {
        trend("§6.1: the share of shear cracks rises with σ3", "rises", 1 - share[1], 1 - share[n], share_half[1], share_half[n], "share of shear %.2f at %s MPa, %.2f at %s MPa")
        trend("§6.1: more micro-failures at the peak with σ3", "rises", all[1], all[n], all_half[1], all_half[n], "%.0f at %s MPa, %.0f at %s MPa")
        trend("§5.2: more ductile with σ3: strain at the peak", "rises", strain[1], strain[n], strain_half[1], strain_half[n], "%.2f %% at %s MPa, %.2f %% at %s MPa" (without[n] ? sprintf(" (%d of %d end at the strain limit)", without[n], specimens[n]) : ""))
    }
    if (count("excess")) {
        m = mean("excess")
        error = count("excess") > 1 ? deviation("excess") / sqrt(count("excess")) : ""
        claim("Figs 7a, 8: axial splitting: tensile cracks of the uniaxial peak within 30° of the load, above the facets' own share", "≥ 2 standard errors",
            error == "" ? sprintf("%+.2f", m) : sprintf("%+.2f, %.1f standard errors", m, error > 0 ? m / error : 99), "", error == "" ? "open" : m >= 2 * error ? "holds" : "differs", error == "" ? "one specimen has no standard error" : "no direction is preferred")
    }
    if (count("radius")) claim("Fig 7b: the disc's first cracks are near its centre", "centre", with_interval(mean("radius"), half_interval("radius"), "%.2f") " R", "", judge_below(mean("radius"), half_interval("radius"), 0.5), "first tensile cracks lie off the centre: the stress along the loaded diameter is nearly uniform, and single grains decide")
    claim("Fig 7b: the disc splits in half: one network of cracks spans 0.8 D", "splits", sprintf("%d of %d discs", spanned, discs), "", spanned >= 0.5 * discs ? "holds" : "differs", "networks end at contacts that have not failed when the test ends")
}
function property(name, symbol, unit, tolerance, absolute, explanation,    verdict, text) {
    if (!(name in ours) || laboratory[name] == "") return
    verdict = judge(ours[name], half[name], laboratory[name], absolute ? absolute / laboratory[name] : tolerance)
    text = laboratory[name] " " unit (published[name] == "" ? "" : " (its model " published[name] ")")
    if (verdict == "open") explanation = "the interval is too wide for a verdict" (needed[name] == "" ? "" : sprintf("; ±3 %% needs some %d specimens, there are %d", needed[name], n_specimens[name]))
    claim("Table 8: " symbol, text, with_interval(ours[name], half[name], "%.4g") " " unit (n_without_peak[name] > 0 && name ~ /^s1/ ? sprintf(" (%d of %d without a peak)", n_without_peak[name], n_specimens[name]) : ""), percent(ours[name], laboratory[name]), verdict, explanation)
}
function end_of_test(i,    name, key) {
    name = "s1_at_" p[i] "_MPa"
    key = "yield " p[i] + 0
    if (count(key) && ours[name] < laboratory[name] && ours[name] < 1.1 * mean(key))
        return sprintf("strength here is still that of first yield, %.0f MPa, at which %d of %d tests end: the strength of bonded contacts increases by %.1f MPa for each MPa of σ3, and friction exceeds it only at a higher pressure; a straight line from UCS to there lies above both", mean(key), specimens[i] - without[i], specimens[i], (mean(key) - ours["s1_at_0_MPa"]) / p[i])
    return without[i] ? sprintf("%d of %d tests have no peak before the strain limit: the specimen yields and hardens by dilation against the membrane, and strength depends on where the test ends", without[i], specimens[i]) : "from cc and φc"
}
function dominance(i,    more) {
    if (share[i] == "") return "open"
    more = p[i] == 0 ? share[i] - 0.5 : 0.5 - share[i]
    if (share_half[i] != "" && abs(more) < share_half[i]) return "open"
    return more > 0 ? "holds" : "differs"
}
function trend(what, paper, from, to, from_half, to_half, form,    noise) {
    noise = from_half == "" ? "" : sqrt(from_half ^ 2 + to_half ^ 2)
    claim(what, paper, sprintf(form, from, p[1], to, p[n]), "", noise == "" || abs(to - from) < noise ? "open" : to > from ? "holds" : "differs", noise == "" || abs(to - from) < noise ? "not above the scatter" : "it falls")
}
function judge_below(x, h, bound) { return x + h < bound ? "holds" : x - h < bound ? "open" : "differs" }
