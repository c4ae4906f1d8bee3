-- For --pivot: the criteria of each variant, those that hold in bold, those that are undecided with a question mark.
SELECT variant, heading, value FROM (
    SELECT variant, criterion AS heading, CASE WHEN holds THEN '**' ELSE '' END || ifnull(text('{:.2f}', mean), 'none') || ifnull(text(' ± {:.2f}', half_interval), '') ||
        CASE WHEN holds THEN '**' ELSE '' END || CASE WHEN undecided THEN ' ?' ELSE '' END AS value, criteria.rowid AS place, 1 AS nth FROM criteria
    UNION ALL SELECT variant, 'hold', text('{:.0f} of {:.0f}', sum(holds), count(*)), min(criteria.rowid), 2 FROM criteria GROUP BY variant
    UNION ALL SELECT variant, 'distance', text('{:.2f}', mean(distance)), min(criteria.rowid), 3 FROM criteria GROUP BY variant
) ORDER BY nth, place
