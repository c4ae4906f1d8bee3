-- Each beam: largest load, the opening at it, and the slope up to 8 µm.
WITH rising AS (
    SELECT run, min(cmod_um) FILTER (WHERE cmod_um >= 8) AS at FROM load GROUP BY run
), slopes AS (
    SELECT run, load_N / cmod_um AS slope FROM load JOIN rising USING (run) WHERE cmod_um = at
), peaks AS (
    SELECT run, max(load_N) AS peak, cmod_um AS opening FROM load GROUP BY run
)
SELECT file, series, depth_mm, eccentricity, edge_mm, peak AS peak_N, opening AS cmod_at_peak_um, slope AS "slope_N/um"
FROM runs JOIN peaks ON run = replace(file, '.h5', '') LEFT JOIN slopes USING (run) ORDER BY runs.rowid
