# strength.tsv, levels.tsv and the crack summaries to a Markdown table: a row for each variant, means over seeds and their range.
# Set by -v: variants, levels (MPa).
BEGIN { FS = "\t" }
FNR == 1 { head(); next }
has("share_with_more_sliding") {
    if (value("at") != "peak") next
    run = variant(value("file"))
    add("tensile", run, value("tensile_cracks"))
    add("shear", run, value("shear_cracks"))
    if (value("share_with_more_sliding") != "") add("sliding", run, value("share_with_more_sliding"))
    next
}
{
    run = variant(value("file"))
    test = test_of(value("file"))
    add(test, run, value("peak_compressive_stress_MPa") value("tensile_strength_MPa"))
    balance_error[test, run] = balance_error[test, run] + 0 > value("energy_balance_error") ? balance_error[test, run] : value("energy_balance_error")
}
END {
    n_variants = split(variants, name_of, " ")
    n_levels = split(levels, level_of, " ")
    print "| variant | σt, MPa | UCS, MPa | σ1 at 8 MPa, MPa | tensile : shear cracks at the UCS peak | tensile cracks with more opening than sliding | largest error of the energy balance: disc, uniaxial, triaxial |"
    print "|---|---|---|---|---|---|---|"
    for (v = 1; v <= n_variants; ++v) {
        name = name_of[v]
        printf "| %s | %s | %s | %s | %s | %s | %s, %s, %s |\n", name, range("brazilian", name), range("uniaxial", name),
            range("triaxial8", name), count["tensile", name] ? sprintf("%.0f : %.0f", mean("tensile", name), mean("shear", name)) : "-",
            count["sliding", name] ? sprintf("%.0f %%", 100 * (1 - mean("sliding", name))) : "-",
            largest_error("brazilian", name), largest_error("uniaxial", name), largest_error("triaxial8", name)
    }
    print ""
    line = "| σt, MPa, at tc = |"
    rule = "|---|"
    for (l = 1; l <= n_levels; ++l) { line = line " " level_of[l] " MPa |"; rule = rule "---|" }
    print line " 24.15 MPa | d ln σt/d ln tc |"
    print rule "---|---|"
    for (v = 1; v <= n_variants; ++v) {
        line = "| " name_of[v] " |"
        n = sx = sy = sxx = sxy = 0
        for (l = 1; l <= n_levels + 1; ++l) {
            name = l <= n_levels ? name_of[v] "-at" level_of[l] : name_of[v]
            level = l <= n_levels ? level_of[l] : 24.15
            line = line " " range("brazilian", name) " |"
            if (count["brazilian", name]) {
                x = log(level); y = log(mean("brazilian", name))
                ++n; sx += x; sy += y; sxx += x * x; sxy += x * y
            }
        }
        print line (n > 1 ? sprintf(" %.2f |", (n * sxy - sx * sy) / (n * sxx - sx * sx)) : " - |")
    }
}
function largest_error(test, name) { return count[test, name] ? sprintf("%.0e", balance_error[test, name]) : "-" }
function add(what, run, x) {
    ++count[what, run]
    sum[what, run] += x
    if (count[what, run] == 1 || x + 0 < low[what, run]) low[what, run] = x + 0
    if (count[what, run] == 1 || x + 0 > high[what, run]) high[what, run] = x + 0
}
function mean(what, run) { return sum[what, run] / count[what, run] }
function range(what, run) {
    return count[what, run] ? sprintf("%.1f (%.1f–%.1f)", mean(what, run), low[what, run], high[what, run]) : "-"
}
