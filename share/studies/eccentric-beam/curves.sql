-- Load at openings 5 µm apart: both envelopes and the mean of the tested beams, and of those of the bilinear softening, by straight lines between points.
WITH openings AS (
    SELECT DISTINCT 5 * CAST(cmod_um / 5 AS INTEGER) AS x FROM load WHERE cmod_um BETWEEN 5 AND 129
), points AS (
    SELECT curve AS name, envelopes.rowid AS place, cmod_um AS x, load_N AS y FROM envelopes
    UNION ALL SELECT series || load.run, load.rowid, cmod_um, load_N FROM load JOIN runs ON load.run = replace(file, '.h5', '') WHERE series IN ('tested', 'bilinear')
), pieces AS (
    SELECT name, place, lag(x) OVER line AS x0, lag(y) OVER line AS y0, x AS x1, y AS y1 FROM points WINDOW line AS (PARTITION BY name ORDER BY place)
), met AS (
    SELECT openings.x, name, min(place), y0 + (y1 - y0) * (openings.x - x0) / (x1 - x0) AS y
    FROM openings JOIN pieces ON x0 <= openings.x AND openings.x < x1 GROUP BY openings.x, name
), beside AS (
    SELECT x, max(y) FILTER (WHERE name = 'lower envelope') AS lower, max(y) FILTER (WHERE name = 'upper envelope') AS upper,
        mean(iif(name LIKE 'tested%', y, NULL)) AS mean, half_interval(iif(name LIKE 'tested%', y, NULL)) AS half, sum(name LIKE 'tested%') AS n,
        mean(iif(name LIKE 'bilinear%', y, NULL)) AS bilinear
    FROM met GROUP BY x
)
SELECT x AS cmod_um, round(lower) AS lower_N, round(upper) AS upper_N, round(mean) AS mean_N, round(half) AS half_interval_N, n AS beams,
    CASE WHEN lower IS NULL THEN '' WHEN mean < min(lower, upper) THEN 'below' WHEN mean > max(lower, upper) THEN 'above' ELSE 'in' END AS verdict, round(bilinear) AS bilinear_N
FROM beside ORDER BY x
