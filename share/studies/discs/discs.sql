-- Strength of each variant, its ratio to that of the discs of Ø 60 mm with a facet, and the place of the first cracks. Ratios at Ø 60 mm are of
-- pairs of one seed; those at Ø 68 mm are of pairs too, whose crystals differ.
WITH tests AS (
    SELECT variant, seed, tensile_strength_MPa AS strength, first_crack_radius_over_R AS radius, loading_arc_deg AS arc,
        spanning_strength_MPa / tensile_strength_MPa AS spanning, strength.rowid AS place
    FROM strength JOIN runs USING (file))
SELECT variant, count(*) AS discs, text('{:.1f}', mean(arc)) AS arc_deg,
    text('{:.2f} ± {:.2f}', mean(strength), half_interval(strength)) AS strength_MPa,
    text('{:.1f}', 100 * deviation(strength) / mean(strength)) AS scatter_percent,
    text('{:.3f} ({:.3f} to {:.3f})', exp(mean(change)), exp(mean(change) - half_interval(change)), exp(mean(change) + half_interval(change)))
        AS strength_over_facet_60,
    text('{:.2f} ± {:.2f}', mean(radius), half_interval(radius)) AS first_cracks_radii,
    sum(radius > 0.5) AS first_cracks_beyond_half_a_radius, text('{:.2f}', mean(spanning)) AS load_at_splitting_over_largest
FROM (SELECT *, iif(variant = 'facet-60', NULL, ln(strength / first_value(strength) OVER (PARTITION BY seed ORDER BY variant <> 'facet-60'))) AS change
    FROM tests) GROUP BY variant ORDER BY min(place)
