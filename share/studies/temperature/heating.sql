-- Cracks of one heated specimen, before its test: points that have lost half of their cohesion. Their length over the area by the pair of
-- minerals, mm/cm²; the temperature that heating had reached with the first of them, with 1 and with 10 %, °C.
WITH cooled AS (
    SELECT max(time_s) FILTER (WHERE temperature_K > 0.01) AS at FROM history
), cracks AS (
    SELECT time_damaged_50_s AS time_s, length_m, class, row_number() OVER (ORDER BY time_damaged_50_s) AS nth, count(*) OVER () AS n
    FROM log JOIN cooled ON time_damaged_50_s <= at
), told(quantity, share) AS (
    VALUES ('onset_first_C', 0.0), ('onset_1_percent_C', 0.01), ('onset_10_percent_C', 0.1)
), onset AS (
    SELECT quantity, min(time_s) AS time_s FROM told JOIN cracks ON nth >= share * n GROUP BY quantity
)
SELECT :FILE AS file, quantity, 20 + (SELECT temperature_K FROM history WHERE history.time_s >= onset.time_s ORDER BY history.time_s LIMIT 1) AS value FROM onset
UNION ALL SELECT :FILE, 'cracks', 1000 * total(length_m) / (:AREA / 100) FROM cracks
UNION ALL SELECT :FILE, 'cracks_' || CASE WHEN class LIKE 'within%' THEN 'within' ELSE class END, 1000 * total(length_m) / (:AREA / 100) FROM cracks GROUP BY 2
