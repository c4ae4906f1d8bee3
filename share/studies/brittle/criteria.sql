-- One row per variant and criterion: whether its mean lies in the range, and whether the interval of the mean reaches across a bound.
-- A quantity that was not reached in any test does not hold.
WITH variants AS (SELECT variant, min(rowid) AS place FROM brittle GROUP BY variant)
SELECT variant, criterion, n, mean, half_interval, low, high, ifnull(mean BETWEEN low AND high, 0) AS holds,
    half_interval IS NULL OR abs(mean - low) < half_interval OR abs(mean - high) < half_interval AS undecided,
    CASE WHEN criterion NOT LIKE 'fall%' THEN abs(mean - (low + high) / 2) / ((high - low) / 2) END AS distance
FROM variants JOIN bounds LEFT JOIN brittle USING (variant, quantity) ORDER BY place, bounds.rowid
