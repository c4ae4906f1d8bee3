-- One row per variant: means over seeds and their range; cracks at the peak of the uniaxial tests.
WITH tests AS (
    SELECT runs.rowid AS place, variant, energy_balance_error, cracks.*, test = 'brazilian' AS disc, test = 'uniaxial' AS uniaxial,
        confining_pressure_MPa = 8 AS at_8, ifnull(tensile_strength_MPa, peak_compressive_stress_MPa) AS strength
    FROM runs JOIN strength USING (file) LEFT JOIN cracks ON cracks.file = strength.file AND at = 'peak'
)
SELECT variant,
    ifnull(text('{:.1f} ({:.1f}–{:.1f})', mean(strength) FILTER (WHERE disc), min(strength) FILTER (WHERE disc),
        max(strength) FILTER (WHERE disc)), '-') AS "σt, MPa",
    ifnull(text('{:.1f} ({:.1f}–{:.1f})', mean(strength) FILTER (WHERE uniaxial), min(strength) FILTER (WHERE uniaxial),
        max(strength) FILTER (WHERE uniaxial)), '-') AS "UCS, MPa",
    ifnull(text('{:.1f} ({:.1f}–{:.1f})', mean(strength) FILTER (WHERE at_8), min(strength) FILTER (WHERE at_8),
        max(strength) FILTER (WHERE at_8)), '-') AS "σ1 at 8 MPa, MPa",
    ifnull(text('{:.0f} : {:.0f}', mean(tensile_cracks_by_sign), mean(shear_cracks_by_sign)), '-')
        AS "tensile : shear cracks at the UCS peak, by sign",
    ifnull(text('{:.0f} : {:.0f}', mean(tensile_cracks), mean(shear_cracks)), '-') AS "by traction",
    ifnull(text('{:.0e}', max(energy_balance_error) FILTER (WHERE disc)), '-') || ', ' ||
        ifnull(text('{:.0e}', max(energy_balance_error) FILTER (WHERE uniaxial)), '-') || ', ' ||
        ifnull(text('{:.0e}', max(energy_balance_error) FILTER (WHERE at_8)), '-')
        AS "largest error of the energy balance: disc, uniaxial, triaxial"
FROM tests GROUP BY variant ORDER BY min(place)
