-- Peak loads by depth and eccentricity, and the nominal strength: the load over the section of the beam.
SELECT depth_mm, eccentricity, edge_mm, series, count(*) AS beams, coalesce(text('{:.0f} ± {:.0f}', mean(peak_N), half_interval(peak_N)), text('{:.0f}', mean(peak_N))) AS peak_N,
    round(mean(cmod_at_peak_um), 1) AS cmod_at_peak_um, round(mean(peak_N / 50 / depth_mm), 3) AS nominal_strength_MPa
FROM peaks GROUP BY depth_mm, eccentricity, edge_mm, series ORDER BY depth_mm, eccentricity DESC
