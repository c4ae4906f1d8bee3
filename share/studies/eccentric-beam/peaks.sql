-- Each beam: largest load, the opening at it, and the slope up to 8 µm.
WITH slopes AS (
    SELECT run AS beam, min(time_s), load_N / cmod_um AS slope FROM load WHERE cmod_um >= 8 GROUP BY run
), peaks AS (
    SELECT run AS beam, max(load_N) AS peak, cmod_um AS opening FROM load GROUP BY run
)
SELECT file, series, depth_mm, eccentricity, edge_mm, peak AS peak_N, opening AS cmod_at_peak_um, slope AS "slope_N/um"
FROM runs JOIN peaks ON beam = replace(file, '.h5', '') JOIN slopes USING (beam) ORDER BY runs.rowid
