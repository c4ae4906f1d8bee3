-- One row per specimen and variant: the peak with the variant :FIRST, and its change by the other in per cent.
WITH tests AS (
    SELECT runs.rowid AS place, *, ifnull(tensile_strength_MPa, peak_compressive_stress_MPa) AS peak FROM runs JOIN strength USING (file)
)
SELECT tests.test, tests.confining_pressure_MPa, tests.seed, first.peak AS peak_MPa, tests.variant,
    100 * (tests.peak / first.peak - 1) AS change_percent
FROM tests JOIN tests AS first USING (test, confining_pressure_MPa, seed)
WHERE first.variant = :FIRST AND tests.variant <> :FIRST ORDER BY tests.place
