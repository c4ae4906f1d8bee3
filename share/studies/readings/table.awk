# strength.tsv, levels.tsv and the crack summaries to a Markdown table: a reading a row, means over seeds and their range.
# Set by -v: readings, levels (MPa).
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
    ledger[test, run] = ledger[test, run] + 0 > value("ledger_residual") ? ledger[test, run] : value("ledger_residual")
}
END {
    n_readings = split(readings, reading_of, " ")
    n_levels = split(levels, level_of, " ")
    print "| reading | σt, MPa | UCS, MPa | σ1 at 8 MPa, MPa | tensile : shear at the UCS peak | tensile ones that opened more than they slid | largest ledger residual: disc, uniaxial, triaxial |"
    print "|---|---|---|---|---|---|---|"
    for (r = 1; r <= n_readings; ++r) {
        reading = reading_of[r]
        printf "| %s | %s | %s | %s | %s | %s | %s, %s, %s |\n", reading, range("brazilian", reading), range("uniaxial", reading),
            range("triaxial8", reading), count[ "tensile", reading] ? sprintf("%.0f : %.0f", mean("tensile", reading), mean("shear", reading)) : "-",
            count["sliding", reading] ? sprintf("%.0f %%", 100 * (1 - mean("sliding", reading))) : "-",
            residual("brazilian", reading), residual("uniaxial", reading), residual("triaxial8", reading)
    }
    print ""
    line = "| σt, MPa, at tc = |"
    rule = "|---|"
    for (l = 1; l <= n_levels; ++l) { line = line " " level_of[l] " MPa |"; rule = rule "---|" }
    print line " 24.15 MPa | d ln σt/d ln tc |"
    print rule "---|---|"
    for (r = 1; r <= n_readings; ++r) {
        reading = reading_of[r]
        line = "| " reading " |"
        n = sx = sy = sxx = sxy = 0
        for (l = 1; l <= n_levels + 1; ++l) {
            name = l <= n_levels ? reading "-at" level_of[l] : reading
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
function residual(test, reading) { return count[test, reading] ? sprintf("%.0e", ledger[test, reading]) : "-" }
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
