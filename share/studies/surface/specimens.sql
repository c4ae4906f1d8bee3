-- One row per specimen and quantity: stresses over the tensile strength :TC of contacts, MPa, K_IC over :TC √d, with the grain size :GRAIN_SIZE d, mm.
WITH measured AS (
    SELECT file, CASE series WHEN 'tension' THEN 'direct_tension' WHEN 'low' THEN 'first_peak' WHEN 'high' THEN 'first_peak' ELSE series END AS property,
        coalesce(first_peak_MPa, tensile_strength_MPa) AS value
    FROM strength JOIN runs USING (file) WHERE series <> 'half-disc'
    UNION ALL SELECT file, 'crack_initiation', crack_initiation_MPa FROM moduli
    UNION ALL SELECT file, 'crack_damage', crack_damage_MPa FROM moduli
    UNION ALL SELECT file, 'toughness', "mode_i_toughness_MPa.m^0.5" / sqrt(:GRAIN_SIZE / 1000) FROM toughness
)
SELECT kind, point, variant, series, cohesion, friction_angle_deg, residual_friction_angle_deg, process_zone, mode_ii_fracture_energy,
    bridging_strength, bridging_energy, CASE series WHEN 'low' THEN low_pressure WHEN 'high' THEN high_pressure ELSE 0 END AS confining_pressure,
    property, value / :TC AS value
FROM runs JOIN measured USING (file) JOIN design USING (point) WHERE value IS NOT NULL ORDER BY runs.rowid, property
