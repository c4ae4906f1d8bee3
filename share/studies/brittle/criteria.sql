-- One row per variant and criterion: whether its mean lies in the range, and whether the interval of the mean reaches across a bound.
SELECT variant, criterion, n, mean, half_interval, low, high, mean BETWEEN low AND high AS holds,
    half_interval IS NULL OR (abs(mean - low) < half_interval OR abs(mean - high) < half_interval) AS undecided,
    CASE WHEN high < 1 OR criterion = 'K_IC' THEN abs(mean - (low + high) / 2) / ((high - low) / 2) END AS distance
FROM brittle JOIN bounds USING (quantity) ORDER BY brittle.rowid, bounds.rowid
