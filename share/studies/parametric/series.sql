-- The tests of each series with what varies in them as `level`: those whose other contact values are those of the series.
WITH levels AS (
    SELECT 1 AS nth, 'tc_over_BTS' AS series, contact_tensile_strength_MPa / :BTS AS level, * FROM strength
    WHERE contact_cohesion_MPa = :UCS AND contact_friction_angle_deg = :PHI AND :TC_LEVELS IS NOT NULL
    UNION ALL SELECT 2, 'cc_over_UCS', contact_cohesion_MPa / :UCS, * FROM strength
    WHERE contact_tensile_strength_MPa = :TC_FIXED AND contact_friction_angle_deg = :PHI AND :CC_LEVELS IS NOT NULL
    UNION ALL SELECT 3, 'phic_over_phi', contact_friction_angle_deg / :PHI, * FROM strength
    WHERE contact_tensile_strength_MPa = :TC_FIXED AND contact_cohesion_MPa = :UCS AND :PHIC_LEVELS IS NOT NULL
)
SELECT series, level, seed, test, ifnull(tensile_strength_MPa, peak_compressive_stress_MPa) AS strength_MPa,
    ifnull(tensile_strength_MPa / :BTS, peak_compressive_stress_MPa / :UCS) AS normalised, peak_kind, tensile_cracks, shear_cracks, file
FROM levels ORDER BY nth
