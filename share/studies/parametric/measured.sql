-- Quantities that criteria.tsv judges: straight lines of strength over the level, strengths at the material's tc, and at each level by how many percent
-- strength differs from that of the same specimens at the level nearest to 1.
WITH parts AS (
    SELECT *, text('change: {}, {}', test, series) AS name FROM series WHERE strength_MPa IS NOT NULL
    UNION ALL SELECT *, text('change: {}, {} below 0.75', test, series) FROM series WHERE strength_MPa IS NOT NULL AND level <= 0.7501
), bases AS (
    SELECT *, min(abs(level - 1)) OVER (PARTITION BY name) = abs(level - 1) AS is_base FROM parts
), changes AS (
    SELECT name, mean(100 * (a.strength_MPa / b.strength_MPa - 1)) AS change, low(100 * (a.strength_MPa / b.strength_MPa - 1)) AS low,
        high(100 * (a.strength_MPa / b.strength_MPa - 1)) AS high
    FROM bases AS a JOIN bases AS b USING (name, seed) WHERE b.is_base AND NOT a.is_base GROUP BY name, a.level
)
SELECT 'intercept: ' || "group" AS quantity, intercept AS value, intercept_low AS low, intercept_high AS high, NULL AS shown,
    iif(slope_low > 0, NULL, 'the slope is not above 0 for certain') AS doubt FROM trends
UNION ALL SELECT 'slope: ' || "group", slope, slope_low, slope_high, NULL, NULL FROM trends
UNION ALL SELECT 'lack_of_fit_p: ' || "group", lack_of_fit_p, NULL, NULL, NULL, NULL FROM trends
UNION ALL SELECT 'tc for σt = BTS', (:BTS - intercept) / slope * :BTS, NULL, NULL, NULL, NULL FROM trends WHERE "group" = 'brazilian, tc_over_BTS'
UNION ALL SELECT 'σt at the material''s tc', mean(strength_MPa), low(strength_MPa), high(strength_MPa), NULL, NULL
    FROM series WHERE test = 'brazilian' AND series = 'tc_over_BTS' AND abs(level - :TC_FIXED / :BTS) < 1e-6 HAVING count(*) > 0
UNION ALL SELECT name, change, low, high, ifnull(text('at most {:.4g} ({:.4g} to {:.4g}) %', change, low, high), text('at most {:.4g} %', change)), NULL
    FROM changes
