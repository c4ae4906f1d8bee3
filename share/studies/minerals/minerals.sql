-- One row per quantity and variant: entries, mean, half of its 95 % interval, coefficient of variation. Cracks are those at the peak.
WITH tests AS (
    SELECT runs.rowid AS place, *,
        CASE WHEN test = 'brazilian' THEN tensile_strength_MPa END AS brazilian,
        CASE WHEN test = 'tension' THEN tensile_strength_MPa END AS direct
    FROM runs JOIN strength USING (file) LEFT JOIN moduli USING (file)
), uniaxial AS (
    SELECT *, peak_compressive_stress_MPa AS ucs FROM tests WHERE test = 'uniaxial'
), triaxial AS (
    SELECT *, text('_at_{}_MPa', confining_pressure_MPa) AS at FROM tests WHERE test = 'triaxial'
), measured AS (
    SELECT 1 AS nth, 'young_modulus_GPa' AS quantity, young_modulus_GPa AS value, 0 AS pressure, place, variant FROM uniaxial
    UNION ALL SELECT 2, 'UCS_MPa', ucs, 0, place, variant FROM uniaxial
    UNION ALL SELECT 3, 'first_peak' || at, first_peak_MPa, confining_pressure_MPa, place, variant FROM triaxial
    UNION ALL SELECT 3, 'largest' || at, peak_compressive_stress_MPa, confining_pressure_MPa, place, variant FROM triaxial
    UNION ALL SELECT 3, 'residual' || at, residual_MPa, confining_pressure_MPa, place, variant FROM triaxial
    UNION ALL SELECT 4, 'Brazilian_MPa', brazilian, 0, place, variant FROM tests WHERE test = 'brazilian'
    UNION ALL SELECT 5, 'direct_tension_MPa', direct, 0, place, variant FROM tests WHERE test = 'tension'
    UNION ALL SELECT 6, 'CI_over_UCS', crack_initiation_count_MPa / ucs, 0, place, variant FROM uniaxial
    UNION ALL SELECT 7, 'CD_over_UCS', crack_damage_2d_MPa / ucs, 0, place, variant FROM uniaxial
    UNION ALL SELECT 8, 'tensile_share_by_sign', tensile_cracks_by_sign / (tensile_cracks_by_sign + shear_cracks_by_sign), 0,
        place, variant FROM uniaxial
    UNION ALL SELECT 9, 'tensile_share_by_traction', tensile_cracks / (tensile_cracks + shear_cracks), 0, place, variant FROM uniaxial
), summed AS (
    SELECT nth, pressure, min(place) AS place, variant, quantity, count(value) AS n, mean(value) AS mean,
        half_interval(value) AS half_interval, deviation(value) / mean(value) AS coefficient_of_variation
    FROM measured GROUP BY quantity, variant
    -- The ratio of two means; its interval is that of both where their errors add up.
    UNION ALL SELECT 10, 0, min(place), variant, 'direct_over_Brazilian', count(brazilian), mean(direct) / mean(brazilian),
        mean(direct) / mean(brazilian) * (half_interval(direct) / mean(direct) + half_interval(brazilian) / mean(brazilian)), NULL
    FROM tests GROUP BY variant
)
SELECT variant, quantity, n, mean, half_interval, coefficient_of_variation FROM summed ORDER BY nth, pressure, quantity, place
