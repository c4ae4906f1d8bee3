-- Quantities that criteria.tsv judges: numbers of the equations (fpz) and of Table 4 (tc), by their plane; how many of Table 9 are equal when rounded.
SELECT iif(fpz.table_4 = 'fpz', '', replace(table_4, 'tc', 'tc ') || ' MPa: ') || quantity || ifnull(', plane ' || plane, '') AS quantity, value, NULL AS shown
FROM fpz
UNION ALL SELECT 'zone_length over 4 mm', value / 4, NULL FROM fpz WHERE quantity = 'zone_length' AND table_4 = 'fpz'
UNION ALL SELECT 'lennard_jones_b of Table 9', equal, text('{} equal when rounded', equal) FROM (
    SELECT count(*) FILTER (WHERE abs(value - b) <= 0.005 * 1.001) AS equal
    FROM table9 JOIN fpz ON fpz.table_4 = 'fpz' AND quantity = text('lennard_jones_b({},{})', m, n))
