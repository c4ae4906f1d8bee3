-- Moduli of one uniaxial test by its gauges: tangent from the start to a tenth of the largest stress, and about half of it, GPa, as material values.
WITH curve AS (
    SELECT time_s, -axial_stress_Pa / 1e9 AS stress, -gauge_axial_strain AS axial, gauge_lateral_strain AS lateral FROM history WHERE axial_stress_Pa < 0
), peak AS (
    SELECT time_s AS at, max(stress) AS peak FROM curve
), parts AS (
    SELECT CASE WHEN stress < 0.1 * peak THEN 'start' WHEN stress BETWEEN 0.45 * peak AND 0.55 * peak THEN 'half' END AS part, axial, lateral, stress
    FROM curve JOIN peak ON time_s <= at
), slopes AS (
    SELECT part, slope(axial, stress) AS plane_E, slope(axial, lateral) AS plane_nu FROM parts WHERE part IS NOT NULL GROUP BY part
), moduli AS (
    SELECT total(plane_E * (1 - power(plane_nu / (1 + plane_nu), 2))) FILTER (WHERE part = 'start') AS start,
        total(plane_E * (1 - power(plane_nu / (1 + plane_nu), 2))) FILTER (WHERE part = 'half') AS half FROM slopes
)
SELECT :FILE AS file, 'E_at_start' AS quantity, start AS value FROM moduli
UNION ALL SELECT :FILE, 'E_at_half', half FROM moduli
UNION ALL SELECT :FILE, 'E_at_start_over_half', start / half FROM moduli
