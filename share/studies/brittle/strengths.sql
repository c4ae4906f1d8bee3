-- For --pivot: strengths of the variants of :PART, in MPa, and what breaking takes.
WITH shown(nth, quantities, heading, format) AS (VALUES
    (1, 'UCS_MPa', 'UCS, MPa', '{:.0f}'), (2, 'Brazilian_MPa', 'Brazilian', '{:.1f}'), (3, 'direct_tension_MPa', 'direct tension', '{:.1f}'),
    (4, 'first_peak_at_%', NULL, '{:.0f}'), (5, 'end_at_%', NULL, '{:.0f}'), (6, 'K_IC_at_%', NULL, '{:.2f}'),
    (7, 'work_of_fracture_J/m2', 'work of fracture, J/m²', '{:.0f}'), (8, 'young_modulus_GPa', 'E, GPa', '{:.1f}'), (9, 'poisson_ratio', 'ν', '{:.3f}'))
SELECT variant, ifnull(heading, replace(quantity, '_', ' ')), coalesce(text(format || ' ± ' || format, mean, half_interval), text(format, mean))
FROM variants JOIN brittle USING (variant) JOIN shown ON quantity LIKE quantities WHERE part = :PART ORDER BY variants.rowid, nth, brittle.rowid
