# design.tsv and strength.tsv to one row for each point of the design: the strength at each pressure by each measure (peak, first yield,
# stress at 1, 2, 3 % strain), and C and φ from the line σ1 = a + b σ3 through them (sin φ = (b − 1)/(b + 1), C = a/(2√b)).
# Set by -v: pressures; first_seed, of the first point.
BEGIN {
    FS = "\t"
    pi = 4 * atan2(1, 1)
    n_pressures = split(pressures, pressure, " ")
    n_measures = split("peak first_yield 1_percent 2_percent 3_percent", measure, " ")
    column_of["peak"] = "peak_compressive_stress_MPa"
    column_of["first_yield"] = "first_yield_MPa"
    for (i = 1; i <= 3; ++i) column_of[i "_percent"] = "stress_at_" i "_percent_MPa"
}
FNR == 1 { head(); ++file; next }
file == 1 { design[value("run")] = value("x1") "\t" value("x2") "\t" value("contact_cohesion_MPa") "\t" value("contact_friction_angle_deg"); order[++n] = value("run"); next }
{
    point = seed_of(value("file")) - first_seed + 1
    sigma3 = confinement(value("file"))
    for (i = 1; i <= n_measures; ++i) stress[point, sigma3, measure[i]] = value(column_of[measure[i]])
    if (value("peak_kind") != "drop") ++n_without_peak[point]
}
END {
    line_out = "run\tx1\tx2\tcontact_cohesion_MPa\tcontact_friction_angle_deg\tC_MPa\tphi_deg\tslope\truns_without_peak"
    for (i = 1; i <= n_measures; ++i) {
        for (j = 1; j <= n_pressures; ++j) line_out = line_out "\t" (i == 1 ? "s1" : measure[i]) "_at_" pressure[j] "_MPa"
        if (i > 1) line_out = line_out "\tC_by_" measure[i] "_MPa\tphi_by_" measure[i] "_deg"
    }
    print line_out
    for (k = 1; k <= n; ++k) {
        point = order[k]
        fit(point, "peak")
        line_out = point "\t" design[point] "\t" cohesion "\t" angle "\t" slope "\t" n_without_peak[point] + 0
        for (i = 1; i <= n_measures; ++i) {
            for (j = 1; j <= n_pressures; ++j) line_out = line_out "\t" stress[point, pressure[j], measure[i]]
            if (i > 1) { fit(point, measure[i]); line_out = line_out "\t" cohesion "\t" angle }
        }
        print line_out
    }
}
# Sets cohesion, angle and slope; empty unless there is a stress at every pressure, C and φ also unless the slope is above 0.
function fit(point, kind,    j, key) {
    cohesion = angle = slope = ""
    key = point " " kind
    for (j = 1; j <= n_pressures; ++j) {
        if (stress[point, pressure[j], kind] == "") return
        add(key " x", pressure[j])
        add(key " y", stress[point, pressure[j], kind])
    }
    if (n_pressures < 2) return
    line(key " x", key " y")
    slope = sprintf("%.5g", line_b)
    if (line_b <= 0) return
    cohesion = sprintf("%.5g", line_a / (2 * sqrt(line_b)))
    angle = sprintf("%.5g", 180 / pi * atan2(line_b - 1, 2 * sqrt(line_b)))  # tan φ = (b − 1)/(2√b)
}
