-- One row per variant and judgement: n, mean with its 95 % interval, and whether the whole interval lies in the range (in), outside (out) or neither (open).
WITH means AS (
    SELECT variant, quantity, count(*) AS n, mean(value) AS mean, half_interval(value) AS half, half_interval(value) / mean(value) AS relative FROM measured GROUP BY variant, quantity
), means_told AS (
    SELECT variant, quantity, n, mean, mean - half AS least, mean + half AS most FROM means
), pairs AS (
    -- The same specimens heated and not: exp of the mean of logarithms
    SELECT variant, replace(replace(hot.quantity, '_300', '_after_300'), '_450', '_after_450') AS quantity, ln(hot.value / cold.value) AS change
    FROM measured AS hot JOIN measured AS cold USING (variant, specimen)
    WHERE (hot.quantity LIKE '%\_300' ESCAPE '\' OR hot.quantity LIKE '%\_450' ESCAPE '\') AND cold.quantity = replace(replace(hot.quantity, '_300', ''), '_450', '')
), pairs_told AS (
    SELECT variant, quantity, count(*) AS n, exp(mean(change)) AS mean, exp(mean(change) - half_interval(change)) AS least, exp(mean(change) + half_interval(change)) AS most
    FROM pairs GROUP BY variant, quantity
), quotients(quantity, above, below) AS (
    VALUES ('UCS_over_Brazilian', 'UCS', 'Brazilian'), ('direct_over_Brazilian', 'direct', 'Brazilian'), ('K_IC_large_over_small', 'K_IC_large', 'K_IC_small')
), quotients_told AS (
    SELECT variant, quotients.quantity AS quantity, min(a.n, b.n) AS n, a.mean / b.mean AS mean,
        a.mean / b.mean * (1 - sqrt(power(a.relative, 2) + power(b.relative, 2))) AS least, a.mean / b.mean * (1 + sqrt(power(a.relative, 2) + power(b.relative, 2))) AS most
    FROM quotients JOIN means AS a ON a.quantity = above JOIN means AS b USING (variant) WHERE b.quantity = below
), fitted(quantity, strength, laboratory) AS (
    VALUES ('UCS_over_laboratory', 'UCS', :LABORATORY_UCS), ('Brazilian_over_laboratory', 'Brazilian', :LABORATORY_BRAZILIAN)
), told AS (
    SELECT * FROM means_told UNION ALL SELECT * FROM pairs_told UNION ALL SELECT * FROM quotients_told
    UNION ALL SELECT variant, fitted.quantity, n, mean / laboratory, least / laboratory, most / laboratory FROM fitted JOIN means_told ON means_told.quantity = strength WHERE laboratory > 0
)
SELECT variant, row, judgement, told.n AS n, told.mean AS mean, least, most, bounds.low AS low, bounds.high AS high,
    CASE WHEN least >= ifnull(bounds.low, least) AND most <= ifnull(bounds.high, most) THEN 'in' WHEN most < bounds.low OR least > bounds.high THEN 'out' ELSE 'open' END AS verdict,
    bounds.quantity AS quantity
FROM bounds JOIN told USING (quantity) ORDER BY variant, bounds.rowid
