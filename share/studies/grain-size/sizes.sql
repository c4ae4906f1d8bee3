-- Means over seeds. The tests of a size have its name, not one edge.
WITH tests AS (
    SELECT *, strength.rowid AS place, ifnull(tensile_strength_MPa, peak_compressive_stress_MPa) AS strength_MPa
    FROM strength JOIN runs USING (file)
)
SELECT replace(series, 'strength-', '') AS series, test, confining_pressure_MPa, size, mean(mean_edge_mm) AS mean_edge_mm, count(*) AS runs,
    count(*) FILTER (WHERE peak_kind <> 'drop') AS without_peak, mean(strength_MPa) AS strength_MPa,
    deviation(strength_MPa) AS deviation_MPa, low(strength_MPa) AS low_MPa, high(strength_MPa) AS high_MPa
FROM tests GROUP BY series, test, confining_pressure_MPa, size ORDER BY min(place)
