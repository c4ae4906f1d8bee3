-- Ratios to the unheated state against temperature, beside published ones.
SELECT state AS temperature_C, quantity, ratio FROM temperature
WHERE part = 'heat' AND state <> '250' AND quantity IN ('E_at_start', 'UCS', 'Brazilian', 'K_IC', 'velocity')
UNION ALL SELECT temperature_C, quantity, ratio FROM published ORDER BY 1
