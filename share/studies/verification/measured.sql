-- Quantities that criteria.tsv judges: properties beside the laboratory's, cracks by pressure and how they change from the lowest to the highest, their
-- directions, and where discs crack.
WITH ends AS (
    SELECT * FROM modes WHERE confining_pressure_MPa IN (SELECT min(confining_pressure_MPa) FROM modes UNION SELECT max(confining_pressure_MPa) FROM modes)
), crossed AS (
    SELECT confining_pressure_MPa AS p, 'tensile_share' AS quantity, tensile_share AS value, tensile_share_half AS half FROM ends
    UNION ALL SELECT confining_pressure_MPa, 'all_cracks', all_cracks, all_cracks_half FROM ends
    UNION ALL SELECT confining_pressure_MPa, 'strain_at_peak_percent', strain_at_peak_percent, strain_at_peak_half FROM ends
), changes AS (
    SELECT quantity, b.value - a.value AS change, sqrt(power(a.half, 2) + power(b.half, 2)) AS noise,
        text('{:.4g} at {:g}, {:.4g} at {:g}', a.value, a.p, b.value, b.p) AS shown
    FROM crossed AS a JOIN crossed AS b USING (quantity) WHERE a.p < b.p
), directed AS (
    SELECT mean(above) AS above, deviation(above) / sqrt(count(above)) AS error, low(above) AS low, high(above) AS high
    FROM (SELECT tensile_share_within_30_deg - facet_share_within_30_deg AS above FROM directions)
)
SELECT property AS quantity, ours AS value, low, high, laboratory AS stated, NULL AS shown, NULL AS told_difference,
    text(' ({} of {} without a peak)', iif(without_peak > 0, without_peak, NULL), specimens) AS remark
FROM properties WHERE laboratory IS NOT NULL
UNION ALL SELECT text('tensile_share at {} MPa', confining_pressure_MPa), tensile_share, tensile_share - tensile_share_half,
    tensile_share + tensile_share_half, NULL, NULL, NULL,
    text(' ({} of {} without a peak)', iif(without_peak > 0, without_peak, NULL), specimens) FROM modes
UNION ALL SELECT 'change of ' || quantity, change, change - noise, change + noise, NULL, shown, NULL, NULL FROM changes
UNION ALL SELECT 'tensile_share_within_30_deg above facets, standard errors', above / error, NULL, NULL, NULL,
    text('{:.4g} ({:.4g} to {:.4g})', above, low, high), text('{:+.1f} standard errors', above / error), NULL FROM directed
UNION ALL SELECT 'first_crack_radius_over_R', mean(first_crack_radius_over_R), low(first_crack_radius_over_R), high(first_crack_radius_over_R),
    NULL, NULL, NULL, NULL FROM strength WHERE test = 'brazilian' HAVING count(*) > 0
UNION ALL SELECT 'share of discs that split', 1.0 * count(spanning_strength_MPa) / count(*), NULL, NULL, NULL, NULL, NULL, NULL
    FROM strength WHERE test = 'brazilian' HAVING count(*) > 0
