-- One row per variant: means with half of their 95 % intervals; how many of the tests under pressure have a first peak.
WITH tests AS (
    SELECT runs.rowid AS place, *, tensile_cracks + shear_cracks AS cracks,
        confining_pressure_MPa = 4 AS at_4, confining_pressure_MPa = 8 AS at_8, confining_pressure_MPa = 20 AS at_20,
        CASE WHEN test = 'uniaxial' THEN peak_compressive_stress_MPa END AS ucs,
        CASE WHEN test = 'brazilian' THEN tensile_strength_MPa END AS brazilian,
        CASE WHEN test = 'tension' THEN tensile_strength_MPa END AS direct
    FROM runs JOIN strength USING (file) LEFT JOIN moduli USING (file)
)
SELECT variant,
    mean_and_half(ucs, '.1f') AS "UCS, MPa",
    mean_and_half(first_peak_MPa, '.1f') FILTER (WHERE at_4) ||
        text(' ({} of {})', count(first_peak_MPa) FILTER (WHERE at_4), sum(at_4)) AS "first peak at 4 MPa",
    mean_and_half(first_peak_MPa, '.1f') FILTER (WHERE at_8) ||
        text(' ({} of {})', count(first_peak_MPa) FILTER (WHERE at_8), sum(at_8)) AS "at 8 MPa (tests that have one)",
    mean_and_half(first_peak_MPa, '.1f') FILTER (WHERE at_20) ||
        text(' ({} of {})', count(first_peak_MPa) FILTER (WHERE at_20), sum(at_20)) AS "at 20 MPa",
    mean_and_half(residual_MPa, '.1f') FILTER (WHERE at_8) AS "residual at 8 MPa",
    mean_and_half(rehardening_GPa, '.1f') FILTER (WHERE at_8) AS "re-hardening at 8 MPa, GPa",
    mean_and_half(peak_compressive_stress_MPa, '.1f') FILTER (WHERE at_8) AS "largest at 8 MPa",
    mean_and_half(brazilian, '.1f') AS "Brazilian",
    mean_and_half(direct, '.1f') AS "direct tension",
    ifnull(text('{:.2f}', mean(direct) / mean(brazilian)), '-') AS "direct / Brazilian",
    mean_and_half(post_peak_slope_over_young_modulus, '.1f') AS "fall behind the UCS, E",
    ifnull(text('{:.2f}', mean(crack_initiation_count_MPa) / mean(ucs)), '-') AS "CI / UCS",
    ifnull(text('{:.2f}', mean(crack_damage_2d_MPa) / mean(ucs)), '-') AS "CD / UCS",
    ifnull(text('{:.0f} %, {:.0f} %', 100 * mean(tensile_cracks_by_sign / cracks) FILTER (WHERE test = 'uniaxial'),
        100 * mean(tensile_cracks / cracks) FILTER (WHERE test = 'uniaxial')), '-') AS "tensile cracks at UCS by sign, by traction"
FROM tests GROUP BY variant ORDER BY min(place)
