-- The power law through logarithms of each series, test and confining pressure.
WITH edges AS (SELECT *, ifnull(tensile_strength_MPa, peak_compressive_stress_MPa) AS strength_MPa FROM strength_b)
SELECT replace(source, 'exponents-', '') AS series, test, confining_pressure_MPa, runs, runs_at_strain_limit, exponent, exponent_low, exponent_high,
    coefficient AS coefficient_MPa, zone_over_smallest_edge, zone_over_largest_edge
FROM fitted
UNION ALL SELECT 'b', test, NULL, count(*), NULL, exponent(mean_edge_mm, strength_MPa), exponent_low(mean_edge_mm, strength_MPa),
    exponent_high(mean_edge_mm, strength_MPa), exp(intercept(ln(mean_edge_mm), ln(strength_MPa))), NULL, NULL
FROM edges WHERE strength_MPa IS NOT NULL GROUP BY test ORDER BY series
