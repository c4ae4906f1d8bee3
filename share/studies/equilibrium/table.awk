# strength.tsv to a Markdown table: for each test and seed the change of the peak by each variant, and the quality checks of the runs.
# Set by -v: tests, seeds, variants (the first is the one with which the others are compared).
BEGIN { FS = "\t" }
FNR == 1 { head(); next }
{
    test = test_of(value("file"))
    name = test "-" seed_of(value("file")) "-" variant(value("file"))
    peak[name] = value("peak_compressive_stress_MPa") value("tensile_strength_MPa")
    carried[test] = max(carried[test], value("damping_load"))
    balance_error[test] = max(balance_error[test], value("energy_balance_error"))
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
    row = "| test | seed | peak, MPa |"
    rule = "|---|---|---|"
    for (v = 2; v <= n_variants; ++v) {
        row = row " " variant_of[v] ", % |"
        rule = rule "---|"
    }
    print row
    print rule
    for (t = 1; t <= n_tests; ++t) {
        for (s = 1; s <= n_seeds; ++s) {
            own = peak[test_names[t] "-" seed_names[s] "-" first]
            add(test_names[t], own)
            row = sprintf("| %s | %s | %.2f |", test_names[t], seed_names[s], own)
            for (v = 2; v <= n_variants; ++v) {
                run = test_names[t] "-" seed_names[s] "-" variant_of[v]
                if (!(run in peak)) { row = row " - |"; continue }
                change = 100 * (peak[run] / own - 1)
                add(test_names[t] variant_of[v], change)
                row = row sprintf(" %+.2f |", change)
            }
            print row
        }
        row = sprintf("| **%s** | mean, 95 %% | %.2f |", test_names[t], mean(test_names[t]))
        for (v = 2; v <= n_variants; ++v) {
            name = test_names[t] variant_of[v]
            row = row (count(name) < 2 ? " - |" : sprintf(" %+.2f ± %.2f |", mean(name), half_interval(name)))
        }
        print row
    }
    print ""
    print "| test | ended by | largest error of the energy balance | largest difference of the platen forces before the peak | damping carried at most | largest error of the pressure |"
    print "|---|---|---|---|---|---|"
    for (t = 1; t <= n_tests; ++t) {
        test = test_names[t]
        printf "| %s | %s | %.1e | %.2f %% | %.2f %% | %s |\n", test, kind[test], balance_error[test], 100 * forces[test], 100 * carried[test],
            (test in pressure) ? sprintf("%.2f %%", 100 * pressure[test]) : "-"
    }
}
function max(a, b) { return a + 0 > b + 0 ? a : b + 0 }
