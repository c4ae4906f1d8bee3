-- The change of each specimen by each variant, for --pivot.
SELECT test, confining_pressure_MPa, seed, text('{:.2f}', peak_MPa) AS "peak, MPa", variant || ', %', text('{:+.2f}', change_percent)
FROM changes ORDER BY rowid
