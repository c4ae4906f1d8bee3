-- Strengths of minerals.tsv, for --pivot: one row per variant, means with half of their intervals; in parentheses how many tests have one.
WITH shown(nth, quantities, heading, format, counted) AS (VALUES
    (1, 'UCS_MPa', 'UCS, MPa', '{:.1f}', ''),
    (2, 'first_peak_at_%', NULL, '{:.0f}', ' ({})'),
    (2, 'largest_at_%', NULL, '{:.0f}', ''),
    (2, 'residual_at_%', NULL, '{:.0f}', ' ({})'),
    (3, 'Brazilian_MPa', 'Brazilian', '{:.2f}', ''),
    (4, 'direct_tension_MPa', 'direct tension', '{:.2f}', ''),
    (5, 'direct_over_Brazilian', 'direct / Brazilian', '{:.2f}', ''))
SELECT variant, ifnull(heading, replace(quantity, '_', ' ')),
    coalesce(text(format || ' ± ' || format, mean, half_interval), text(format, mean), '-') || iif(counted = '', '', text(counted, n))
FROM minerals JOIN shown ON quantity LIKE quantities ORDER BY nth, minerals.rowid
