-- Quantities that criteria.tsv judges: by how many percent the largest mean of the sizes exceeds the smallest, beyond half of their intervals at least by
-- `low`; exponents of σt.
WITH means AS (
    SELECT iif(test = 'uniaxial', 'UCS', text('σ1 at {} MPa', confining_pressure_MPa)) AS name, strength_MPa AS mean,
        ifnull((high_MPa - low_MPa) / 2, 0) AS half
    FROM sizes WHERE series = 'a' AND test <> 'brazilian' AND strength_MPa IS NOT NULL
), extremes AS (
    SELECT least.name, 100 * (most.mean / least.mean - 1) AS range, 100 * sqrt(power(least.half, 2) + power(most.half, 2)) / least.mean AS noise
    FROM (SELECT name, min(mean) AS mean, half FROM means GROUP BY name HAVING count(*) > 1) AS least
        JOIN (SELECT name, max(mean) AS mean, half FROM means GROUP BY name) AS most USING (name)
)
SELECT 'range of ' || name AS quantity, range AS value, range - noise AS low, NULL AS high, text('at most {:.4g} %', range) AS shown FROM extremes
UNION ALL SELECT 'exponent of ' || series, exponent, exponent_low, exponent_high, NULL FROM exponents WHERE test = 'brazilian'
