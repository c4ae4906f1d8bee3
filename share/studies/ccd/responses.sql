-- One row per point of the design, for --pivot: strengths at each pressure by several measures, and C and φ of the line through them.
-- Run I of the design has seed :FIRST_SEED - 1 + I.
WITH tests AS (
    SELECT design.*, strength.confining_pressure_MPa AS pressure, peak_compressive_stress_MPa AS peak, peak_kind, first_yield_MPa,
        stress_at_1_percent_MPa, stress_at_2_percent_MPa, stress_at_3_percent_MPa
    FROM design JOIN strength ON seed = :FIRST_SEED - 1 + run
), points AS (
    SELECT run, x1, x2, contact_cohesion_MPa, contact_friction_angle_deg, cohesion(pressure, peak) AS C_MPa,
        friction_angle(pressure, peak) AS phi_deg, slope(pressure, peak) AS slope,
        count(*) FILTER (WHERE peak_kind <> 'drop') AS runs_without_peak
    FROM tests GROUP BY run
), measured AS (
    SELECT run, 1 AS nth, 's1' AS measure, pressure, peak AS stress FROM tests
    UNION ALL SELECT run, 2, 'first_yield', pressure, first_yield_MPa FROM tests
    UNION ALL SELECT run, 3, '1_percent', pressure, stress_at_1_percent_MPa FROM tests
    UNION ALL SELECT run, 4, '2_percent', pressure, stress_at_2_percent_MPa FROM tests
    UNION ALL SELECT run, 5, '3_percent', pressure, stress_at_3_percent_MPa FROM tests
), responses AS (
    SELECT run, nth, pressure AS place, text('{}_at_{}_MPa', measure, pressure) AS name, stress AS value FROM measured
    UNION ALL SELECT run, nth, 1e6, text('C_by_{}_MPa', measure), cohesion(pressure, stress) FROM measured
        WHERE measure <> 's1' GROUP BY run, measure
    UNION ALL SELECT run, nth, 2e6, text('phi_by_{}_deg', measure), friction_angle(pressure, stress) FROM measured
        WHERE measure <> 's1' GROUP BY run, measure
)
SELECT points.*, name, value FROM points JOIN responses USING (run) ORDER BY nth, place, run
