-- What new specimens of a rock with bridges have: mean, 95 % interval and number of them, by the properties of rocks-targets.tsv. E in GPa, K_IC in
-- MPa√m, the others in MPa.
WITH of_specimens(nth, property, value) AS (
    SELECT 1, 'E', young_modulus_GPa FROM moduli
    UNION ALL SELECT 2, 'Brazilian_strength', tensile_strength_MPa FROM strength WHERE test = 'brazilian'
    UNION ALL SELECT 3, 'direct_tensile_strength', tensile_strength_MPa FROM strength WHERE test = 'tension'
    UNION ALL SELECT 4, 'UCS', first_peak_MPa FROM strength WHERE test = 'uniaxial'
    UNION ALL SELECT 5, 'crack_initiation', crack_initiation_MPa FROM moduli
    UNION ALL SELECT 6, 'crack_damage', crack_damage_MPa FROM moduli
    UNION ALL SELECT 7, text('first_peak_at_{:g}_MPa', confining_pressure_MPa), first_peak_MPa FROM strength WHERE test = 'triaxial'
    UNION ALL SELECT 8, 'K_IC', "mode_i_toughness_MPa.m^0.5" FROM toughness)
SELECT property, mean(value) AS mean, low(value) AS low, high(value) AS high, count(value) AS specimens FROM of_specimens GROUP BY nth, property ORDER BY nth
