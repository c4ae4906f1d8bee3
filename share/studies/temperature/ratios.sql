-- Ratios to the unheated state against temperature, beside published ones, with straight lines between their points.
WITH states AS (
    SELECT state + 0 AS temperature_C, quantity, ratio FROM temperature WHERE part = 'heat' AND text('{}', state) <> '250'
), points AS (
    SELECT quantity, temperature_C AS x, ratio AS y, lead(temperature_C) OVER (PARTITION BY quantity ORDER BY temperature_C) AS x2,
        lead(ratio) OVER (PARTITION BY quantity ORDER BY temperature_C) AS y2 FROM published
)
SELECT temperature_C, quantity, ratio FROM states WHERE quantity IN ('E_at_start', 'UCS', 'Brazilian', 'K_IC', 'velocity')
UNION ALL SELECT DISTINCT temperature_C, points.quantity, y + (y2 - y) * (temperature_C - x) / (x2 - x) FROM points JOIN states ON temperature_C BETWEEN x AND x2
ORDER BY 1
