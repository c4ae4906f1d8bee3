-- Quantities that criteria.tsv judges: our strengths beside those of Table 7, terms of the response surfaces, the optimum, and that of the paper's strengths.
-- Run I of the design has seed :FIRST_SEED - 1 + I.
WITH published AS (
    SELECT run, 0 AS pressure, s1_at_0 AS theirs FROM table7
    UNION ALL SELECT run, 4, s1_at_4 FROM table7
    UNION ALL SELECT run, 8, s1_at_8 FROM table7
), compared AS (
    SELECT pressure, peak_compressive_stress_MPa AS ours, theirs FROM published
        JOIN strength ON confining_pressure_MPa = pressure AND seed = :FIRST_SEED - 1 + run WHERE peak_compressive_stress_MPa IS NOT NULL
), series AS (
    SELECT text(' at {} MPa', pressure) AS at, text(' over {} rows', count(*)) AS over, rank_correlation(ours, theirs) AS rank,
        median(abs(ln(ours / theirs))) AS off, 100 * (median(ours / theirs) - 1) AS difference
    FROM compared GROUP BY pressure HAVING count(*) > 2
)
SELECT 'order' || at AS quantity, rank AS value, NULL AS low, NULL AS high, text('{:.4g}', rank) || over AS shown, NULL AS told_difference FROM series
UNION ALL SELECT 'median |ln ratio|' || at, off, NULL, NULL, text('median |ln ratio| {:.2g}', off) || over, text('{:+.1f} %', difference) FROM series
UNION ALL SELECT term || ' in ' || response, coefficient, low, high, NULL, NULL FROM terms
UNION ALL SELECT 'published cc_MPa', cc_MPa, NULL, NULL, NULL, NULL FROM published_optimum WHERE rowid = 1
UNION ALL SELECT 'published phic_deg', phic_deg, NULL, NULL, NULL, NULL FROM published_optimum WHERE rowid = 1
UNION ALL SELECT 'contact_cohesion_MPa', contact_cohesion_MPa, NULL, NULL, NULL, NULL FROM optimum WHERE rowid = 1
UNION ALL SELECT 'contact_friction_angle_deg', contact_friction_angle_deg, NULL, NULL, NULL, NULL FROM optimum WHERE rowid = 1
