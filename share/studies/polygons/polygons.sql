-- One row per variant and confining pressure: means over seeds, with 95 % intervals from three seeds on. Stresses are σ1; the end is the strain
-- limit.
WITH fractures AS (
    SELECT file, sum(CASE WHEN class LIKE 'within%' THEN tensile_cracks_at_end + shear_cracks_at_end ELSE 0 END) AS within,
        sum(CASE WHEN class LIKE 'within%' THEN 0 ELSE tensile_cracks_at_end + shear_cracks_at_end END) AS between_crystals
    FROM cracks GROUP BY file
), tests AS (
    SELECT runs.rowid AS place, runs.variant, runs.confining_pressure + 0 AS pressure, ifnull(first_peak_MPa, peak_compressive_stress_MPa) AS peak,
        first_peak_MPa IS NULL AS has_none, peak_compressive_stress_MPa AS largest, -axial_stress_Pa / 1e6 AS end_stress,
        100 * (axial_strain + lateral_strain) AS volume, within, between_crystals, strength.wall_time_s AS seconds
    FROM runs JOIN strength USING (file) JOIN ends USING (file) JOIN fractures USING (file)
)
SELECT variant, pressure AS "σ3, MPa", count(*) AS "n", text('{:.0f}', mean(peak)) ||
        CASE WHEN count(*) > 2 THEN text(' ± {:.0f}', half_interval(peak)) ELSE '' END ||
        CASE WHEN sum(has_none) > 0 THEN text(' ({} without)', sum(has_none)) ELSE '' END AS "first peak, MPa",
    text('{:.0f}', mean(largest)) AS "largest, MPa", text('{:.0f}', mean(end_stress)) ||
        CASE WHEN count(*) > 2 THEN text(' ± {:.0f}', half_interval(end_stress)) ELSE '' END AS "end, MPa",
    text('{:.2f}', mean(end_stress / peak)) AS "end / first peak", text('{:.2f}', mean(volume)) AS "volume at the end, %",
    text('{:.0f} : {:.0f}', mean(within), mean(between_crystals)) AS "cracks within : between", text('{:.0f}', mean(seconds)) AS "s"
FROM tests GROUP BY variant, pressure ORDER BY min(place)
