-- Quality checks of the runs.
SELECT test, confining_pressure_MPa, entries(peak_kind) AS "ended by",
    text('{:.1e}', max(energy_balance_error)) AS "largest error of the energy balance",
    ifnull(text('{:.2f} %', 100 * max(platen_force_difference) FILTER (WHERE variant <> 'slow')), '-')
        AS "largest difference of the platen forces before the peak",
    text('{:.2f} %', 100 * max(damping_load)) AS "damping carried at most",
    ifnull(text('{:.2f} %', 100 * max(abs(achieved_confining_pressure_MPa / confining_pressure_MPa - 1))), '-')
        AS "largest error of the pressure"
FROM strength JOIN runs USING (file) GROUP BY test, confining_pressure_MPa ORDER BY min(runs.rowid)
