-- What moves the surface: one row per kind other than granite, or value left out, and quantity: the mean difference from the granite of the same point, %, by
-- logarithms, with half of its 95 % interval, and the verdict of rule 1 of README.md.
WITH tests AS (
    SELECT kind, point, variant, property, mean(ln(value)) AS logarithm FROM specimens WHERE series <> 'high' GROUP BY kind, point, variant, property
), differences AS (
    SELECT iif(other.kind = 'granite', other.variant, other.kind) AS changed, other.property AS property, 100 * (other.logarithm - base.logarithm) AS difference
    FROM tests AS other JOIN tests AS base USING (point, property)
    WHERE base.kind = 'granite' AND base.variant = 'base' AND (other.kind <> 'granite' OR other.variant <> 'base')
), means AS (
    SELECT changed, property, count(*) AS pairs, mean(difference) AS mean, half_interval(difference) AS half FROM differences GROUP BY changed, property
)
SELECT *, CASE WHEN half < abs(mean) AND abs(mean) > 3 THEN 'moves' WHEN abs(mean) + half <= 5 THEN 'hardly moves' ELSE 'not decided' END AS verdict
FROM means
