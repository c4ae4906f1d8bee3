# Rows of `strength` to the quality checks of the runs, one row for each test and pressure: the largest part of the load that damping
# carried, the largest error of the energy balance and difference of the platen forces, and the runs in which damping carried more than 2 %.
BEGIN { FS = "\t" }
FNR == 1 { head(); next }
{
    test = value("test") (value("confining_pressure_MPa") > 0 ? " at " value("confining_pressure_MPa") " MPa" : "")
    if (!(test in runs)) order[++n] = test
    ++runs[test]
    load[test] = max(load[test], 100 * value("damping_load"))
    balance[test] = max(balance[test], 100 * value("energy_balance_error"))
    forces[test] = max(forces[test], 100 * value("platen_force_difference"))
    if (value("damping_load") > 0.02) above[test] = above[test] (above[test] == "" ? "" : ", ") stem(value("file"))
}
END {
    print "test\truns\tdamping_carried_at_most_percent\tenergy_balance_off_by_at_most_percent\tplaten_forces_differ_at_most_percent\tdamping_carried_more_than_2_percent_in"
    for (i = 1; i <= n; ++i)
        printf "%s\t%d\t%.2f\t%.3f\t%.2f\t%s\n", order[i], runs[order[i]], load[order[i]], balance[order[i]], forces[order[i]], above[order[i]] == "" ? "none" : above[order[i]]
}
function max(a, b) { return a + 0 > b + 0 ? a : b + 0 }
