-- Velocity of a wave along one specimen, km/s: its height over the time between below and above, at a tenth of the largest velocity of each end.
WITH moved AS (
    SELECT 'below' AS probe, time_s, displacement_y_m - lag(displacement_y_m) OVER (ORDER BY time_s) AS motion FROM below
    UNION ALL SELECT 'above', time_s, displacement_y_m - lag(displacement_y_m) OVER (ORDER BY time_s) FROM above
), largest AS (
    SELECT probe, max(motion) AS most FROM moved GROUP BY probe
), arrivals AS (
    SELECT probe, min(time_s) AS time_s FROM moved JOIN largest USING (probe) WHERE motion > 0.1 * most GROUP BY probe
)
SELECT :FILE AS file, 'velocity' AS quantity, :HEIGHT / 1e6 / (max(time_s) - min(time_s)) AS value FROM arrivals
