-- Toughness over the growth of the crack on the largest half-discs: the stress intensity, MPa√m, of a crack to the front at the load at which the front came
-- so far, by the function of the half-discs of ISRM 2014. The fronts, of half-lost and of broken contacts, are those of zones.sql.
WITH tests AS (
    SELECT replace(file, '.h5', '') AS run, variant, toughness.seed, notch_mm AS notch, span_mm AS span FROM runs JOIN toughness USING (file)
    WHERE shape = 'half-disc' AND notch_mm > 0.9 * (SELECT max(notch_mm) FROM toughness WHERE shape = 'half-disc')
), points AS (
    SELECT run, CAST(y_m * 1000 / :CRYSTAL AS INTEGER) AS breadth, time_damaged_50_s AS half_lost, time_broken_s AS broken
    FROM log JOIN tests USING (run) WHERE y_m >= 0 AND abs(x_m) * 1000 < notch / 2
), lost AS (
    SELECT run, 'half lost' AS front, breadth, min(half_lost) AS time FROM points WHERE half_lost IS NOT NULL GROUP BY run, breadth
    UNION ALL SELECT run, 'broken', breadth, min(broken) FROM points WHERE broken IS NOT NULL GROUP BY run, breadth
), reached AS (
    SELECT *, row_number() OVER (PARTITION BY run, front ORDER BY breadth) - 1 AS nth, max(time) OVER (PARTITION BY run, front ORDER BY breadth) AS since
    FROM lost
), loads AS (
    SELECT run, load_MPa, time_s, lead(time_s) OVER (PARTITION BY run ORDER BY time_s) AS until FROM load WHERE run IN (SELECT run FROM tests)
), cracks AS (
    SELECT variant, seed, front, nth, nth * :CRYSTAL AS growth, load_MPa AS load, (notch + nth * :CRYSTAL) / (2 * notch) AS b, span / (4 * notch) AS s,
        (notch + nth * :CRYSTAL) / 1000 AS a
    FROM reached JOIN tests USING (run) JOIN loads ON loads.run = reached.run AND since >= time_s AND since < until WHERE breadth = nth
)
SELECT variant, seed, growth AS growth_mm, b AS crack_over_radius,
    max(K) FILTER (WHERE front = 'half lost') AS K_of_half_lost, max(K) FILTER (WHERE front = 'broken') AS K_of_broken
FROM (SELECT *, load * sqrt(3.14159265 * a) * (-1.297 + 9.516 * s - (0.47 + 16.457 * s) * b + (1.071 + 34.401 * s) * b * b) AS K FROM cracks)
GROUP BY variant, seed, nth ORDER BY variant, seed, nth
