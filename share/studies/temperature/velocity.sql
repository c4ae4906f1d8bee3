-- Velocity of a wave along one specimen, km/s: its height over the time between below and above, at a tenth of the largest velocity of each end, beyond that of
-- its beginning. None where the end above does not move five times as fast as pieces that drift.
WITH steps AS (
    SELECT 'below' AS probe, time_s, displacement_y_m - lag(displacement_y_m) OVER (ORDER BY time_s) AS motion FROM below
    UNION ALL SELECT 'above', time_s, displacement_y_m - lag(displacement_y_m) OVER (ORDER BY time_s) FROM above
), moved AS (
    SELECT probe, time_s, motion - first_value(motion) OVER (PARTITION BY probe ORDER BY time_s) AS motion,
        abs(first_value(motion) OVER (PARTITION BY probe ORDER BY time_s)) AS drift
    FROM steps WHERE motion IS NOT NULL
), largest AS (
    SELECT probe, max(motion) AS most FROM moved GROUP BY probe HAVING most > 5 * max(drift)
), arrivals AS (
    SELECT probe, min(time_s) AS time_s FROM moved JOIN largest USING (probe) WHERE motion > 0.1 * most GROUP BY probe
)
SELECT :FILE AS file, 'velocity' AS quantity, CASE WHEN count(*) = 2 THEN :HEIGHT / 1e6 / (max(time_s) - min(time_s)) END AS value FROM arrivals
