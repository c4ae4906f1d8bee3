-- Of the deviator: what is left behind the first peak.
WITH tests AS (
    SELECT *, (residual_MPa - confining_pressure_MPa) / (first_peak_MPa - confining_pressure_MPa) AS end_over_peak FROM strength
)
SELECT confining_pressure_MPa, count(seed) AS specimens, mean(first_peak_MPa) AS first_peak_MPa,
    half_interval(first_peak_MPa) AS half_interval_MPa, count(first_peak_MPa) AS with_a_peak, mean(end_over_peak) AS end_over_peak,
    half_interval(end_over_peak) AS half_interval
FROM tests GROUP BY confining_pressure_MPa ORDER BY confining_pressure_MPa
