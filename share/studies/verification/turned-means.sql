-- Means over discs, for --pivot: σt along each diameter; scatter over the angles of a disc, and over discs at one angle.
WITH discs AS (
    SELECT seed, angle, tensile_strength_MPa AS bts FROM turned_strength JOIN runs USING (file)
), over_angles AS (
    SELECT 100 * deviation(bts) / mean(bts) AS scatter FROM discs GROUP BY seed
), over_discs AS (
    SELECT 100 * deviation(bts) / mean(bts) AS scatter FROM discs GROUP BY angle
)
SELECT text('at_{}_deg_MPa', angle), mean(bts) FROM discs GROUP BY angle
UNION ALL SELECT 'deviation_over_angles_percent', mean(scatter) FROM over_angles
UNION ALL SELECT 'deviation_over_discs_percent', mean(scatter) FROM over_discs
