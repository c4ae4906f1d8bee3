-- One row per claim of a study: our number beside the paper's and the verdict of its rule, with 95 % intervals (share/doc/studies.md).
-- A claim of several numbers has the worst of their verdicts and shows the number that is farthest off.
WITH numbers AS (
    SELECT criteria.rowid AS nth, criteria.*, value, low, high, shown, told_difference, remark, doubt, stated, ifnull(bound, stated) AS claimed,
        (high - low) / 2 AS half, ifnull((high - low) / 2, abs(value - low)) AS reach, abs(value - ifnull(bound, stated)) AS off,
        CASE WHEN tolerance LIKE '%\%' ESCAPE '\' THEN CAST(tolerance AS REAL) / 100 * abs(ifnull(bound, stated)) ELSE tolerance END AS most
    FROM criteria LEFT JOIN measured USING (quantity) WHERE measured.quantity IS NOT NULL OR optional IS NULL
), judged AS (
    SELECT *, CASE
        WHEN value IS NULL THEN 'open'
        WHEN rule = 'rounds to' THEN iif(off <= 1.001 * most, 'holds', 'differs')  -- a following 5 may be rounded up or down
        WHEN rule = 'within' AND off <= most THEN iif(half > most, 'open', 'holds')
        WHEN rule = 'within' THEN iif(off - reach <= most, 'open', 'differs')
        WHEN rule = 'covers' AND claimed NOT BETWEEN low AND high THEN 'differs'
        WHEN rule = 'covers' THEN iif(half IS NULL OR high - low > most, 'open', 'holds')
        WHEN rule IN ('+', '-') AND (half IS NULL OR low <= 0 AND high >= 0) THEN 'open'
        WHEN rule IN ('+', '-') THEN iif((low > 0) = (rule = '+'), 'holds', 'differs')
        WHEN off < half THEN 'open'
        WHEN rule = '>' AND value > claimed OR rule = '<' AND value < claimed THEN 'holds'
        WHEN rule IN ('>=', '<=') AND (off = 0 OR (rule = '>=') = (value > claimed)) THEN 'holds'
        ELSE 'differs' END AS by_rule
    FROM numbers
), verdicts AS (
    SELECT *, CASE WHEN total(by_rule = 'differs') OVER claims THEN 'differs'
            WHEN total(by_rule = 'open') OVER claims OR doubt IS NOT NULL THEN 'open' ELSE 'holds' END AS verdict,
        row_number() OVER (claims ORDER BY abs(value) DESC) AS place
    FROM judged WINDOW claims AS (PARTITION BY nth)
)
SELECT :STUDY AS study, claim, ifnull(text('{:.4g}', stated) || ifnull(' ' || unit, ''), paper) AS paper,
    CASE WHEN value IS NULL THEN 'not measured' ELSE coalesce(shown, coalesce(text('{:.4g} ({:.4g} to {:.4g})', value, low, high), text('{:.4g}', value)) ||
        ifnull(' ' || unit, '')) || ifnull(remark, '') END AS ours,
    CASE WHEN told_difference IS NOT NULL THEN told_difference WHEN rule = 'within' AND claimed = 0 THEN text('{:+.1f} %', value)
        WHEN rule = 'within' THEN text('{:+.1f} %', 100 * (value / claimed - 1)) WHEN rule = 'covers' THEN text('{:+.2f}', value - claimed)
        WHEN rule = 'rounds to' THEN text('{:+.2f} %', 100 * (value / claimed - 1)) END AS difference,
    verdict, CASE verdict WHEN 'differs' THEN note WHEN 'open' THEN CASE WHEN value IS NULL THEN 'there are no such results'
        ELSE coalesce(doubt, iif(rule IN ('+', '-'), 'the interval has both signs', 'the interval is too wide for a verdict')) END END AS explanation
FROM verdicts WHERE place = 1 ORDER BY nth
