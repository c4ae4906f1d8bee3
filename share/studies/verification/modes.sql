-- Cracks at the peak by pressure, with half of the 95 % intervals; tensile are those that were open when they failed, as in the paper.
WITH tests AS (
    SELECT *, tensile_cracks_by_sign + shear_cracks_by_sign AS cracks FROM strength LEFT JOIN moduli USING (file) WHERE test <> 'brazilian'
)
SELECT confining_pressure_MPa, count(*) AS specimens, count(*) FILTER (WHERE peak_kind <> 'drop') AS without_peak,
    mean(tensile_cracks_by_sign) AS tensile_cracks, mean(shear_cracks_by_sign) AS shear_cracks,
    mean(tensile_cracks_by_sign / cracks) AS tensile_share, half_interval(tensile_cracks_by_sign / cracks) AS tensile_share_half,
    mean(cracks) AS all_cracks, half_interval(cracks) AS all_cracks_half, 100 * mean(strain_at_peak) AS strain_at_peak_percent,
    100 * half_interval(strain_at_peak) AS strain_at_peak_half,
    mean(post_peak_slope_over_young_modulus) AS post_peak_slope_over_young_modulus
FROM tests GROUP BY confining_pressure_MPa ORDER BY confining_pressure_MPa
