-- Mean of the tested beams, with half of its 95 % interval, beside the bounds of each criterion.
WITH measured(quantity, value, half, n) AS (
    SELECT 'peak load', mean(peak_N), half_interval(peak_N), count(*) FROM peaks WHERE series = 'tested'
    UNION ALL SELECT 'mouth opening at the peak', mean(cmod_at_peak_um), half_interval(cmod_at_peak_um), count(*) FROM peaks WHERE series = 'tested'
    UNION ALL SELECT 'rising slope to 8 µm', mean("slope_N/um"), half_interval("slope_N/um"), count(*) FROM peaks WHERE series = 'tested'
    UNION ALL SELECT 'falling branch, 30 to 125 µm, within the envelope', 100.0 * sum(verdict = 'in') / count(*), NULL, max(beams) FROM curves WHERE cmod_um >= 30
)
SELECT quantity || ', ' || unit AS quantity, iif(low < high, text('{:.4g} to {:.4g}', low, high), text('{:.4g}', low)) AS bounds,
    coalesce(iif(value < 100, text('{:.1f} ± {:.1f}', value, half), text('{:.0f} ± {:.0f}', value, half)), text('{:.0f}', value)) AS mean_of_beams, n AS beams,
    iif(value BETWEEN low AND high, 'in', 'out') AS verdict
FROM bounds LEFT JOIN measured USING (quantity) ORDER BY bounds.rowid
