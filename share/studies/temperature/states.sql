-- States of granite of minerals with their own moduli, and of bridged granite (:PART), mean ± half of the 95 % interval.
WITH shown(nth, quantity, heading, format) AS (VALUES (1, 'E', 'E, GPa', '{:.0f}'), (2, 'E_at_start_over_half', 'tangents, 5 over 50 %', '{:.2f}'), (3, 'nu', 'ν', '{:.2f}'),
    (4, 'UCS', 'UCS, MPa', '{:.0f}'), (5, 'CI_over_UCS', 'CI / UCS', '{:.2f}'), (6, 'CD_over_UCS', 'CD / UCS', '{:.2f}'), (7, 'UCS_over_Brazilian', 'UCS / Brazilian', '{:.0f}'),
    (8, 'K_IC', 'K_IC', '{:.2f}'))
SELECT CASE WHEN state LIKE 'open%' THEN text('{:.0f} % open', 100 * substr(state, 6)) WHEN state LIKE 'cold%' THEN text('without stress at {:.0f} °C', 20 + substr(state, 6))
    WHEN text('{}', state) = '20' THEN 'fresh' ELSE text('heated to {} °C', state) END AS state, heading, coalesce(text(format || ' ± ' || format, mean, half_interval), text(format, mean))
FROM temperature JOIN shown USING (quantity) WHERE part = :PART AND rock = 'granite-crystals' ORDER BY nth, temperature.rowid
