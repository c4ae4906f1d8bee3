# strength.tsv to a Markdown table: a test and seed a row, what each variant moves the peak by, and how good the runs were.
# Set by -v: tests, seeds, variants (the first is the one that the others are held against; "slow" is held the other way round).
BEGIN { FS = "\t" }
FNR == 1 { head(); next }
{
    test = test_of(value("file"))
    name = test "-" seed_of(value("file")) "-" variant(value("file"))
    peak[name] = value("peak_compressive_stress_MPa") value("tensile_strength_MPa")
    ledger[test] = max(ledger[test], value("ledger_residual"))
    if (name !~ /-slow$/) forces[test] = max(forces[test], value("platen_force_difference"))
    achieved = value("achieved_confining_pressure_MPa")
    if (achieved != "") pressure[test] = max(pressure[test], abs(achieved / value("confining_pressure_MPa") - 1))
    kind[test] = kind[test] == "" || kind[test] == value("peak_kind") ? value("peak_kind") : "mixed"
}
END {
    n_tests = split(tests, test_names, " ")
    n_seeds = split(seeds, seed_names, " ")
    n_variants = split(variants, variant_of, " ")
    first = variant_of[1]
    line = "| test | seed | peak, MPa |"
    rule = "|---|---|---|"
    for (v = 2; v <= n_variants; ++v) {
        line = line " " variant_of[v] ", % |"
        rule = rule "---|"
    }
    print line
    print rule
    for (t = 1; t <= n_tests; ++t) {
        for (v = 2; v <= n_variants; ++v) sum[v] = worst[v] = 0
        mean = 0
        for (s = 1; s <= n_seeds; ++s) {
            own = peak[test_names[t] "-" seed_names[s] "-" first]
            mean += own / n_seeds
            line = sprintf("| %s | %s | %.2f |", test_names[t], seed_names[s], own)
            for (v = 2; v <= n_variants; ++v) {
                run = test_names[t] "-" seed_names[s] "-" variant_of[v]
                if (!(run in peak)) { sum[v] = "none"; line = line " - |"; continue }
                if (sum[v] != "none") sum[v] += peak[run] / n_seeds
                line = line sprintf(" %+.2f |", 100 * (peak[run] / own - 1))
            }
            print line
        }
        line = sprintf("| **%s** | mean | %.2f |", test_names[t], mean)
        for (v = 2; v <= n_variants; ++v) line = line (sum[v] == "none" ? " - |" : sprintf(" %+.2f |", 100 * (sum[v] / mean - 1)))
        print line
    }
    print ""
    print "| test | ended by | largest ledger residual | largest difference of the platen forces before the peak | largest error of the pressure |"
    print "|---|---|---|---|---|"
    for (t = 1; t <= n_tests; ++t) {
        test = test_names[t]
        printf "| %s | %s | %.1e | %.2f %% | %s |\n", test, kind[test], ledger[test], 100 * forces[test],
            (test in pressure) ? sprintf("%.2f %%", 100 * pressure[test]) : "-"
    }
}
function abs(x) { return x < 0 ? -x : x }
function max(a, b) { return a + 0 > b + 0 ? a : b + 0 }
