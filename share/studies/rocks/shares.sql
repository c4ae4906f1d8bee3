-- For --pivot: thresholds over UCS and direct over Brazilian tension, of new specimens and of the laboratory.
WITH shares(nth, share, above, below) AS (VALUES (1, 'direct / Brazilian', 'direct_tensile_strength', 'Brazilian_strength'),
    (2, 'crack initiation / UCS', 'crack_initiation', 'UCS'), (3, 'crack damage / UCS', 'crack_damage', 'UCS'))
SELECT a.rock, share, text('{:.2f}', a.new_specimens / b.new_specimens) || ' / ' || ifnull(text('{:.2f}', a.laboratory / b.laboratory), '-')
FROM shares JOIN rocks_targets AS a ON a.target = above JOIN rocks_targets AS b ON b.target = below AND b.rock = a.rock ORDER BY a.rowid, nth
