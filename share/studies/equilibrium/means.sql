-- Means over specimens, for --pivot: one row per test, the change by each variant.
SELECT test, confining_pressure_MPa, count(*) AS specimens, text('{:.2f}', mean(peak_MPa)) AS "mean peak, MPa", variant || ', %',
    ifnull(text('{:+.2f} ± {:.2f}', mean(change_percent), half_interval(change_percent)), '-')
FROM changes GROUP BY test, confining_pressure_MPa, variant ORDER BY min(rowid)
