-- share/materials/kinds/surface.tsv: the specimens of the design, a row each and quantity, and the means of the calibrated granites. Stresses are over the
-- tensile strength tc of contacts, K_IC over tc √d; contact_strain is tc/(k d) with the normal stiffness k of
-- contacts, on which crack initiation depends: it is told by an absolute strain.
WITH contacts AS (
    SELECT rock, max(CASE parameter WHEN 'contact.tensile_strength' THEN CAST(value AS REAL) END) AS tc,
        max(CASE parameter WHEN 'ratios.cohesion' THEN CAST(value AS REAL) END) AS cohesion,
        max(CASE parameter WHEN 'contact.friction_angle' THEN CAST(value AS REAL) END) AS friction,
        coalesce(max(CASE parameter WHEN 'ratios.process_zone' THEN CAST(value AS REAL) END), :PROCESS_ZONE) AS zone,
        coalesce(max(CASE parameter WHEN 'ratios.mode_ii_fracture_energy' THEN CAST(value AS REAL) END), :MODE_II) AS shear
    FROM rocks_values WHERE ended IN ('calibrated', 'undecided') GROUP BY rock
), measured AS (
    SELECT rowid AS place, rock, new_specimens AS value, CAST(with_it AS INTEGER) AS specimens, CASE target WHEN 'Brazilian_strength' THEN 'brazilian'
        WHEN 'UCS' THEN 'uniaxial' WHEN 'direct_tensile_strength' THEN 'direct_tension' WHEN 'crack_initiation' THEN target WHEN 'crack_damage' THEN target
        ELSE CASE WHEN target LIKE 'first_peak_at_%' THEN 'first_peak' END END AS property,
        CASE WHEN target LIKE 'first_peak_at_%' THEN CAST(substr(target, 15) AS REAL) ELSE 0 END AS pressure
    FROM rocks_targets
), all_rows AS (
    SELECT specimens.rowid AS place, kind, text('d{:.0f}', point) AS point, 0 AS rock, cohesion, friction_angle_deg, residual_friction_angle_deg, process_zone, mode_ii_fracture_energy,
        bridging_strength, bridging_energy, (SELECT contact_strain FROM stiffnesses WHERE material = 'granite') AS contact_strain, confining_pressure, property, value, 1 AS specimens
    FROM specimens WHERE variant = 'base'
    UNION ALL SELECT 1e6 + place, 'granite', rock, 1, cohesion, friction, stiffnesses.residual, zone, shear, stiffnesses.bridging_strength, stiffnesses.bridging_energy, contact_strain, pressure / tc, property, value / tc, specimens
    FROM measured JOIN contacts USING (rock) JOIN stiffnesses ON material = replace(lower(rock), ' ', '-') || '-calibrated'
    WHERE property IS NOT NULL AND value IS NOT NULL
)
SELECT kind, point, rock, text('{:.5g}', cohesion) AS cohesion, text('{:.5g}', friction_angle_deg) AS friction_angle_deg,
    text('{:.5g}', residual_friction_angle_deg) AS residual_friction_angle_deg, text('{:.5g}', process_zone) AS process_zone,
    text('{:.5g}', mode_ii_fracture_energy) AS mode_ii_fracture_energy, text('{:.5g}', bridging_strength) AS bridging_strength,
    text('{:.5g}', bridging_energy) AS bridging_energy, text('{:.5g}', contact_strain) AS contact_strain, text('{:.5g}', confining_pressure) AS confining_pressure, property,
    text('{:.5g}', value) AS value, specimens
FROM all_rows ORDER BY place
