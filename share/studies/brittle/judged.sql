-- For --pivot: the criteria of the variants of :PART; those that hold in bold, those that are undecided with a question mark.
WITH judged AS (SELECT criteria.*, variants.rowid AS place, criteria.rowid AS nth FROM variants JOIN criteria USING (variant) WHERE part = :PART)
SELECT variant, heading, value FROM (
    SELECT place, nth, variant, criterion AS heading, CASE WHEN holds THEN '**' ELSE '' END || ifnull(text('{:.2f}', mean), 'none') ||
        ifnull(text(' ± {:.2f}', half_interval), '') || CASE WHEN holds THEN '**' ELSE '' END || CASE WHEN undecided THEN ' ?' ELSE '' END AS value
    FROM judged
    -- of the uniaxial test; discs are twice as many
    UNION ALL SELECT place, 0, variant, 'n', text('{:.0f}', n) FROM judged WHERE criterion = 'CI by gauges'
    UNION ALL SELECT place, 1e6, variant, 'hold', text('{:.0f} of {:.0f}', sum(holds), count(*)) FROM judged GROUP BY variant
    UNION ALL SELECT place, 2e6, variant, 'distance', text('{:.2f}', mean(distance)) FROM judged GROUP BY variant
) ORDER BY place, nth
