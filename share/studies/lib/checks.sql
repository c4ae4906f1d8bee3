-- Quality checks of runs, a row for each test and pressure.
SELECT test, confining_pressure_MPa, count(*) AS runs,
    ifnull(text('{:.2f}', 100 * max(damping_load)), '-') AS damping_carried_at_most_percent,
    ifnull(text('{:.3f}', 100 * max(energy_balance_error)), '-') AS energy_balance_off_by_at_most_percent,
    ifnull(text('{:.2f}', 100 * max(platen_force_difference)), '-') AS platen_forces_differ_at_most_percent,
    ifnull(entries(file) FILTER (WHERE damping_load > 0.02), 'none') AS damping_carried_more_than_2_percent_in
FROM strength GROUP BY test, confining_pressure_MPa ORDER BY min(rowid)
