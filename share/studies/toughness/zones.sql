-- One row per bending test: toughness, MPa√m, beside that of its size; where the front of half-lost contacts is at the largest load, length and width of
-- the bridged zone behind it, mm; the length of half-lost contacts at the end, and that of those within crystals. Specimens stand with the tip of their slit at
-- y = 0. The front is the end of crystals' breadths, one behind the other from the tip on, that have a half-lost contact each.
WITH tests AS (
    SELECT runs.rowid AS place, replace(file, '.h5', '') AS run, variant, series, toughness.* FROM runs JOIN toughness USING (file)
), peaks AS (
    SELECT run, time_s AS peak, max(load_MPa) AS load FROM load GROUP BY run
), points AS (
    SELECT run, peak, x_m * 1000 AS x, y_m * 1000 AS ahead, CAST(y_m * 1000 / :CRYSTAL AS INTEGER) AS breadth, time_damaged_50_s AS half_lost,
        time_broken_s AS broken, length_m AS length, class LIKE 'within%' AS within
    FROM log JOIN tests USING (run) JOIN peaks USING (run)
    WHERE time_damaged_50_s IS NOT NULL AND y_m >= 0 AND abs(x_m) * 1000 < notch_mm / 2
), breadths AS (
    SELECT run, breadth, row_number() OVER (PARTITION BY run ORDER BY breadth) - 1 AS nth
    FROM (SELECT DISTINCT run, breadth FROM points WHERE half_lost <= peak)
), fronts AS (
    SELECT run, max(breadth) AS breadth FROM breadths WHERE breadth = nth GROUP BY run
), crack AS (
    SELECT points.* FROM points JOIN fronts USING (run) WHERE half_lost <= peak AND points.breadth <= fronts.breadth
), cracks AS (
    SELECT run, max(ahead) AS front FROM crack GROUP BY run
), zone AS (
    SELECT run, x, ahead, percent_rank() OVER (PARTITION BY run ORDER BY x) AS rank FROM crack WHERE broken IS NULL OR broken > peak
), zones AS (
    SELECT run, max(ahead) - min(ahead) AS length, max(0, max(x) FILTER (WHERE rank <= 0.95) - min(x) FILTER (WHERE rank >= 0.05)) AS width
    FROM zone GROUP BY run
), cuts AS (
    SELECT run, 1000 * total(length * within) AS cut, 1000 * total(length) AS crack FROM points GROUP BY run
)
SELECT file, variant, series, seed, notch_mm, "mode_i_toughness_MPa.m^0.5" AS K, "predicted_mode_i_toughness_MPa.m^0.5" AS straight_K, "strip_yield_mode_i_toughness_MPa.m^0.5" AS strip_yield_K,
    ifnull(front, 0) AS front_mm, ifnull(length, 0) AS zone_mm, ifnull(width, 0) AS zone_width_mm, crack AS crack_mm, cut AS cut_mm
FROM tests LEFT JOIN cracks USING (run) LEFT JOIN zones USING (run) LEFT JOIN cuts USING (run) ORDER BY place
