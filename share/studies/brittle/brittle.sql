-- One row per variant and quantity: number of tests that have it, mean, half of its 95 % interval. Strengths in MPa; K_IC in MPa√m; the work of
-- fracture is what tension has lost to cracks and friction when the specimen has parted, over its width.
WITH fractures AS (
    SELECT file, total(CASE WHEN class NOT LIKE 'within%' THEN tensile_cracks + shear_cracks END)
        / total(tensile_cracks + shear_cracks) AS between_share
    FROM cracks GROUP BY file
), tests AS (
    SELECT runs.rowid AS place, runs.variant, runs.series, strength.*, moduli.*, between_share, "mode_i_toughness_MPa.m^0.5" AS toughness,
        -axial_stress_Pa / 1e6 AS end_stress,
        (energy_fracture_tension_J + energy_fracture_shear_J + energy_friction_J) / (:WIDTH / 1000.0) AS work
    FROM runs JOIN strength USING (file) LEFT JOIN moduli USING (file) LEFT JOIN fractures USING (file) LEFT JOIN toughness USING (file)
        LEFT JOIN ends USING (file)
), uniaxial AS (
    SELECT *, peak_compressive_stress_MPa AS ucs FROM tests WHERE series = 'uniaxial'
), confined AS (
    SELECT *, text('_at_{}_MPa', confining_pressure_MPa) AS at FROM tests WHERE test = 'triaxial'
), measured AS (
    SELECT 1 AS nth, 'UCS_MPa' AS quantity, ucs AS value, place, variant FROM uniaxial
    UNION ALL SELECT 2, 'young_modulus_GPa', young_modulus_GPa, place, variant FROM uniaxial
    UNION ALL SELECT 3, 'poisson_ratio', poisson_ratio, place, variant FROM uniaxial
    UNION ALL SELECT 4, 'CI_over_UCS', crack_initiation_MPa / ucs, place, variant FROM uniaxial
    UNION ALL SELECT 6, 'CI_by_count_over_UCS', crack_initiation_count_MPa / ucs, place, variant FROM uniaxial
    UNION ALL SELECT 6.5, 'CI_by_10_percent_lost_over_UCS', crack_initiation_count_damage_10_MPa / ucs, place, variant FROM uniaxial
    -- Without a reversal before the peak the volume begins to grow at the peak.
    UNION ALL SELECT 7, 'CD_over_UCS', ifnull(crack_damage_MPa, ucs) / ucs, place, variant FROM uniaxial
    UNION ALL SELECT 8, 'CD_2d_over_UCS', ifnull(crack_damage_2d_MPa, ucs) / ucs, place, variant FROM uniaxial
    UNION ALL SELECT 9, 'tensile_share_by_traction', tensile_cracks / (tensile_cracks + shear_cracks), place, variant FROM uniaxial
    UNION ALL SELECT 10, 'tensile_share_by_sign', tensile_cracks_by_sign / (tensile_cracks_by_sign + shear_cracks_by_sign), place, variant FROM uniaxial
    UNION ALL SELECT 11, 'share_of_cracks_between_crystals', between_share, place, variant FROM uniaxial
    UNION ALL SELECT 12, 'Brazilian_MPa', tensile_strength_MPa, place, variant FROM tests WHERE series = 'brazilian'
    UNION ALL SELECT 13, 'direct_tension_MPa', tensile_strength_MPa, place, variant FROM tests WHERE series = 'tension'
    UNION ALL SELECT 15, 'work_of_fracture_J/m2', work, place, variant FROM tests
        WHERE series = 'tension' AND abs(end_stress) < 0.1 * tensile_strength_MPa
    UNION ALL SELECT 16, CASE series WHEN 'half-disc 0.5' THEN 'K_IC_MPa.m^0.5' WHEN 'beam' THEN 'K_IC_of_beams' ELSE replace(series, 'half-disc ', 'K_IC_at_') END, toughness, place, variant
        FROM tests WHERE test = 'bend'
    UNION ALL SELECT 17 + confining_pressure_MPa, 'first_peak' || at, ifnull(first_peak_MPa, peak_compressive_stress_MPa), place, variant FROM confined
        WHERE series <> 'to the limit'
    UNION ALL SELECT 100, 'fall' || at, 1 - (end_stress - confining_pressure_MPa) / (ifnull(first_peak_MPa, peak_compressive_stress_MPa) -
        confining_pressure_MPa), place, variant FROM confined WHERE series = 'triaxial8'
    UNION ALL SELECT 101, 'end' || at, end_stress, place, variant FROM confined WHERE series <> 'triaxial8'
), summed AS (
    SELECT nth, min(place) AS place, variant, quantity, count(value) AS n, mean(value) AS mean, half_interval(value) AS half_interval
    FROM measured GROUP BY quantity, variant
), tension AS (
    SELECT min(place) AS place, variant, total(mean) FILTER (WHERE quantity = 'direct_tension_MPa') AS direct,
        total(mean) FILTER (WHERE quantity = 'Brazilian_MPa') AS brazilian,
        sum(half_interval) FILTER (WHERE quantity = 'direct_tension_MPa') AS direct_half,
        sum(half_interval) FILTER (WHERE quantity = 'Brazilian_MPa') AS brazilian_half, min(n) AS n
    FROM summed WHERE quantity IN ('direct_tension_MPa', 'Brazilian_MPa') GROUP BY variant
)
SELECT variant, quantity, n, mean, half_interval FROM (
    SELECT * FROM summed WHERE mean IS NOT NULL
    -- The ratio of two independent means.
    UNION ALL SELECT 14, place, variant, 'direct_over_Brazilian', n, direct / brazilian,
        direct / brazilian * sqrt(power(direct_half / direct, 2) + power(brazilian_half / brazilian, 2))
    FROM tension WHERE direct > 0 AND brazilian > 0
) ORDER BY place, nth
