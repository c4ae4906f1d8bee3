-- Ratios of granite-crystals to the unheated state with their 95 % intervals, a column for each temperature.
WITH shown(nth, quantity, heading) AS (VALUES (1, 'E_at_start', 'E at start'), (3, 'nu', 'ν'), (4, 'velocity', 'velocity'), (5, 'UCS', 'UCS'), 
    (8, 'Brazilian', 'Brazilian'), (9, 'K_IC', 'K_IC'))
SELECT heading AS 'ratio', text('{} °C', state), coalesce(text('{:.2f} ({:.2f}–{:.2f})', ratio, ratio_low, ratio_high), text('{:.2f}', ratio), '-')
FROM temperature JOIN shown USING (quantity) WHERE rock = 'granite-crystals' AND part = 'heat' AND text('{}', state) NOT IN ('20', '250') ORDER BY nth
