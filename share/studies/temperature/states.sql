-- States of granite of minerals with their own moduli, and of bridged granite (:PART), mean ± half of the 95 % interval; - where that is wider than the mean.
WITH shown(nth, quantity, heading, format) AS (VALUES (1, 'E', 'E, GPa', '{:.0f}'), (2, 'E_at_start_over_half', 'tangents, 5 over 50 %', '{:.2f}'), (3, 'nu', 'ν', '{:.2f}'),
    (4, 'UCS', 'UCS, MPa', '{:.0f}'), (5, 'CI_over_UCS', 'CI / UCS', '{:.2f}'), (7, 'UCS_over_Brazilian', 'UCS / Brazilian', '{:.0f}'),
    (8, 'K_IC', 'K_IC', '{:.2f}'))
SELECT CASE WHEN state LIKE 'open%' THEN text('{:.0f} % open', 100 * substr(state, 6)) WHEN state LIKE 'cold%' THEN text('without stress at {:.0f} °C', 20 + substr(state, 6))
    WHEN text('{}', state) = '20' THEN 'fresh' ELSE text('heated to {} °C', state) END AS state, heading, CASE WHEN half_interval > mean THEN '-' ELSE coalesce(text(format || ' ± ' || format, mean, half_interval), text(format, mean)) END
FROM temperature JOIN shown USING (quantity) WHERE part = :PART AND state <> 'open 0.3' AND (part = 'bridged' OR quantity <> 'K_IC') AND rock = 'granite-crystals' ORDER BY nth, temperature.rowid
