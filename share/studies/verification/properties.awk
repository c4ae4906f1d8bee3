# strength.tsv, moduli.tsv, envelope.tsv to one row for each property: means over specimens beside the laboratory's (Table 8).
# Set by -v: young_modulus (MPa), poisson_ratio, tensile_strength, compressive_strength, cohesion (MPa), friction_angle (deg), of the
# laboratory, empty if unknown; published, the paper's means in this order.
BEGIN { FS = "\t"; split(published, theirs, " ") }
FNR == 1 { head(); ++file; next }
file == 1 {
    name = value("test") == "brazilian" ? "tensile_strength_MPa" : "s1_at_" value("confining_pressure_MPa") + 0 "_MPa"
    add(name, value("tensile_strength_MPa") value("peak_compressive_stress_MPa"))
    if (value("peak_kind") != "drop") ++n_without_peak[name]
    next
}
file == 2 {
    if (test_of(value("file")) != "uniaxial") next
    add("young_modulus_GPa", value("young_modulus_GPa"))
    add("poisson_ratio", value("poisson_ratio"))
    next
}
{
    for (name in column) fit[name] = value(name)
}
END {
    pi = 4 * atan2(1, 1)
    print "property\tlaboratory\tpublished\tours\tlow\thigh\tdeviation\tspecimens\twithout_peak\toff_laboratory_percent\thalf_interval_percent\tspecimens_for_3_percent"
    b = slope(friction_angle)
    a = friction_angle == "" || cohesion == "" ? "" : 2 * cohesion * sqrt(b)
    of_sample("young_modulus_GPa", young_modulus == "" ? "" : young_modulus / 1000, theirs[1])
    of_sample("poisson_ratio", poisson_ratio, theirs[2])
    of_sample("tensile_strength_MPa", tensile_strength, theirs[3])
    of_sample("s1_at_0_MPa", compressive_strength, theirs[4])
    for (name in n_of) if (name ~ /^s1_at_/ && name != "s1_at_0_MPa") pressures[++n_pressures] = substr(name, 7) + 0
    for (i = 1; i <= n_pressures; ++i) for (j = i + 1; j <= n_pressures; ++j) if (pressures[j] < pressures[i]) { p = pressures[i]; pressures[i] = pressures[j]; pressures[j] = p }
    for (i = 1; i <= n_pressures; ++i) of_sample("s1_at_" pressures[i] "_MPa", a == "" ? "" : a + b * pressures[i], "")
    of_fit("cohesion", "MPa", cohesion, theirs[5])
    of_fit("friction_angle", "deg", friction_angle, theirs[6])
    row("slope_b", b, theirs[6] == "" ? "" : slope(theirs[6]), slope(fit["friction_angle_deg"]), slope(fit["friction_angle_low_deg"]), slope(fit["friction_angle_high_deg"]), "", fit["runs"], fit["runs_at_strain_limit"], "")
    yield_fit("cohesion", "MPa")
    yield_fit("friction_angle", "deg")
}
function slope(angle,    s) { if (angle == "") return ""; s = sin(angle * pi / 180); return (1 + s) / (1 - s) }
function of_sample(name, laboratory, published,    m, h, needed) {
    if (!count(name)) return
    m = mean(name)
    h = half_interval(name)
    if (h != "") { needed = (1.96 * deviation(name) / (0.03 * m)) ^ 2; needed = needed > int(needed) ? int(needed) + 1 : needed; if (needed < 3) needed = 3 }
    row(name, laboratory, published, m, h == "" ? "" : m - h, h == "" ? "" : m + h, deviation(name), count(name), n_without_peak[name] + 0, needed)
}
function of_fit(name, unit, laboratory, published) {
    row(name "_" unit, laboratory, published, fit[name "_" unit], fit[name "_low_" unit], fit[name "_high_" unit], fit["seed_" name "_deviation_" unit], fit["runs"], fit["runs_at_strain_limit"], "")
}
function yield_fit(name, unit) {
    if (fit[name "_at_first_yield_" unit] != "")
        row(name "_at_first_yield_" unit, "", "", fit[name "_at_first_yield_" unit], fit[name "_at_first_yield_low_" unit], fit[name "_at_first_yield_high_" unit], "", fit["runs_at_first_yield"], "", "")
}
function row(name, laboratory, published, ours, low, high, spread, n, without, needed) {
    printf "%s\t%s\t%s\t%s\t%s\t%s\t%s\t%s\t%s\t%s\t%s\t%s\n", name, number(laboratory), published == "" ? "" : number(published), number(ours), number(low), number(high), number(spread), n, without,
        laboratory == "" ? "" : sprintf("%+.2f", 100 * (ours / laboratory - 1)), low == "" || high == "" ? "" : sprintf("%.2f", abs(50 * (high - low) / ours)), needed
}
function number(x) { return x == "" ? "" : sprintf("%.5g", x) }
