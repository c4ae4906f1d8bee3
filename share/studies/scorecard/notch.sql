-- The share within crystals of the crack of one notch: the length of contacts ahead of its tip, at y = 0, that have lost half of their brittle part, within half of
-- the ligament's breadth :WIDTH, mm, to either side.
SELECT :FILE AS file, 'within_at_notch' AS quantity, total(length_m * (class LIKE 'within%')) / total(length_m) AS value
FROM log WHERE time_damaged_50_s IS NOT NULL AND y_m >= 0 AND abs(x_m) * 1000 < :WIDTH / 2
