-- One row per criterion, of Augig granite per state: the value with its interval, and whether the whole interval lies in the range (holds), outside
-- (differs) or neither (open). Of heated granite ratios to the unheated state, but for the onset and for E over that of the state before.
WITH told AS (
    SELECT part, state, quantity, n, CASE WHEN absolute THEN mean ELSE ratio END AS value, CASE WHEN absolute THEN mean - half_interval ELSE ratio_low END AS least,
        CASE WHEN absolute THEN mean + half_interval ELSE ratio_high END AS most
    FROM (SELECT *, part = 'minerals' OR quantity LIKE 'onset%' OR quantity LIKE '%_over_%' AS absolute FROM temperature)
)
SELECT question, criterion, told.state AS state, n, value, least, most, bounds.low AS low, bounds.high AS high,
    CASE WHEN least >= bounds.low AND most <= bounds.high THEN 'holds' WHEN most < bounds.low OR least > bounds.high THEN 'differs'
        WHEN value BETWEEN bounds.low AND bounds.high THEN 'open, mean inside' ELSE 'open, mean outside' END AS verdict
FROM bounds JOIN told ON told.quantity = bounds.quantity
    AND (question = 'heat' AND part = 'heat' AND told.state = text('{}', bounds.state) OR question <> 'heat' AND part = 'minerals')
ORDER BY bounds.rowid
