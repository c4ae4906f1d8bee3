-- The same grains, for --pivot: one row per disc, σt along each diameter and its scatter.
WITH discs AS (SELECT seed, angle, tensile_strength_MPa AS bts FROM turned_strength JOIN runs USING (file))
SELECT seed, text('at_{}_deg_MPa', angle), bts FROM discs
UNION ALL SELECT seed, 'deviation_over_angles_percent', 100 * deviation(bts) / mean(bts) FROM discs GROUP BY seed
