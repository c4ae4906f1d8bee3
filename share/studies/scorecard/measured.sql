-- One row per specimen and quantity. Strengths are first peaks, MPa; K_IC in MPa√m; thresholds over the peak of the same test; shares within crystals by contacts, of
-- direct tension at the end of the test. The fall at 8 MPa is to the end of the test, that at 50 MPa to the residual strength.
WITH tests AS (
    SELECT runs.rowid AS place, runs.variant AS variant, runs.series AS series, runs.judged AS specimen, file,
        coalesce(first_peak_MPa, peak_compressive_stress_MPa) AS peak, tensile_strength_MPa AS tensile, drop_percent FROM runs JOIN strength USING (file)
), shares AS (
    SELECT file, total(within * (tensile_cracks + shear_cracks)) / total(tensile_cracks + shear_cracks) AS at_peak,
        total(within * (tensile_cracks_at_end + shear_cracks_at_end)) / total(tensile_cracks_at_end + shear_cracks_at_end) AS at_end
    FROM (SELECT *, class LIKE 'within%' AS within FROM classes) GROUP BY file
), found(quantity, file, value) AS (
    SELECT CASE series WHEN 'uniaxial' THEN 'UCS' WHEN 'uniaxial300' THEN 'UCS_300' WHEN 'uniaxial450' THEN 'UCS_450' WHEN 'confined' THEN 'peak_at_20_MPa' WHEN 'low' THEN 'peak_at_8_MPa'
        WHEN 'high' THEN 'peak_at_50_MPa' WHEN 'squeezed' THEN 'peak_at_80_MPa' WHEN 'squeezed450' THEN 'peak_at_80_MPa_450' END, file, peak FROM tests WHERE peak IS NOT NULL
    UNION ALL SELECT CASE series WHEN 'tension' THEN 'direct' WHEN 'brazilian' THEN 'Brazilian' WHEN 'brazilian300' THEN 'Brazilian_300' END, file, tensile FROM tests
        WHERE series IN ('tension', 'brazilian', 'brazilian300')
    UNION ALL SELECT CASE series WHEN 'bend' THEN 'K_IC' WHEN 'bend450' THEN 'K_IC_450' ELSE 'K_IC_' || series END, file, "mode_i_toughness_MPa.m^0.5"
        FROM tests JOIN toughness USING (file)
    UNION ALL SELECT 'CI_over_UCS', file, crack_initiation_MPa / peak FROM tests JOIN moduli USING (file) WHERE series = 'uniaxial'
    UNION ALL SELECT 'CI_by_10_percent_lost_over_UCS', file, crack_initiation_count_damage_10_MPa / peak FROM tests JOIN moduli USING (file) WHERE series = 'uniaxial'
    UNION ALL SELECT 'CI_over_peak_at_20_MPa', file, crack_initiation_MPa / peak FROM tests JOIN moduli USING (file) WHERE series = 'confined'
    -- Without a reversal before the peak the volume begins to grow at the peak.
    UNION ALL SELECT 'CD_over_UCS', file, ifnull(crack_damage_MPa, peak) / peak FROM tests JOIN moduli USING (file) WHERE series = 'uniaxial'
    UNION ALL SELECT CASE series WHEN 'uniaxial' THEN 'E' WHEN 'uniaxial300' THEN 'E_300' END, file, young_modulus_GPa FROM tests JOIN moduli USING (file)
        WHERE series IN ('uniaxial', 'uniaxial300')
    UNION ALL SELECT iif(series = 'tension', 'within_in_tension', 'within_at_UCS'), file, iif(series = 'tension', at_end, at_peak) FROM tests JOIN shares USING (file)
    UNION ALL SELECT 'fall_at_8_MPa', file, 1 - (-axial_stress_Pa / 1e6 - 8) / (peak - 8) FROM tests JOIN ends USING (file)
    UNION ALL SELECT 'fall_at_50_MPa', file, ifnull(drop_percent, 0) / 100 FROM tests WHERE series = 'high'
    UNION ALL SELECT iif(quantity = 'onset_1_percent_C', 'onset', quantity), file, value FROM logs WHERE quantity IN ('onset_1_percent_C', 'within_at_notch')
)
SELECT file, variant, specimen, quantity, value FROM found JOIN tests USING (file) WHERE value IS NOT NULL ORDER BY place, quantity
