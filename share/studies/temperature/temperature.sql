-- One row per state and quantity: mean over specimens with half of its 95 % interval, and the ratio to the unheated state of the same specimens, exp of
-- the mean of logarithms with its 95 % interval. MPa, GPa, MPa√m, km/s, °C; cracks of heating in mm/cm².
WITH tests AS (
    SELECT runs.file, specimen, variant, series, peak_compressive_stress_MPa AS ucs, tensile_strength_MPa AS tensile FROM runs JOIN strength USING (file)
), found AS (
    SELECT file, quantity, value FROM measured
    UNION ALL SELECT file, 'UCS', ucs FROM tests WHERE series = 'uniaxial'
    UNION ALL SELECT file, 'Brazilian', tensile FROM tests WHERE series = 'brazilian'
    UNION ALL SELECT file, 'K_IC', "mode_i_toughness_MPa.m^0.5" FROM toughness
    UNION ALL SELECT file, 'E', young_modulus_GPa FROM moduli
    UNION ALL SELECT file, 'nu', poisson_ratio FROM moduli
    UNION ALL SELECT file, 'CI', crack_initiation_MPa FROM moduli
    -- Without a reversal before the peak the volume begins to grow at the peak.
    UNION ALL SELECT file, 'CD', ifnull(crack_damage_MPa, ucs) FROM moduli JOIN tests USING (file)
    UNION ALL SELECT file, 'CI_over_UCS', crack_initiation_MPa / ucs FROM moduli JOIN tests USING (file)
    UNION ALL SELECT file, 'CD_over_UCS', ifnull(crack_damage_MPa, ucs) / ucs FROM moduli JOIN tests USING (file)
), stated AS (
    SELECT part, variants.rowid AS place, variants.state AS state, specimen, quantity, value
    FROM found JOIN runs USING (file) JOIN variants USING (variant) WHERE value IS NOT NULL
), more AS (
    SELECT part, place, state, specimen, quantity, value FROM stated
    UNION ALL SELECT part, place, state, specimen, 'E_at_start_over_former',
        value / max(value) OVER (PARTITION BY part, specimen ORDER BY place RANGE BETWEEN 1 PRECEDING AND 1 PRECEDING)
    FROM stated WHERE quantity = 'E_at_start'
    UNION ALL SELECT part, max(place) - 0.5, 250, specimen, quantity, exp(mean(ln(value)))
    FROM stated WHERE quantity = 'K_IC' AND state IN (200, 300) GROUP BY part, specimen HAVING count(*) = 2
), paired AS (
    SELECT more.*, ln(more.value / fresh.value) AS change
    FROM more LEFT JOIN stated AS fresh ON fresh.part = more.part AND fresh.specimen = more.specimen AND fresh.quantity = more.quantity AND fresh.state = 20
), summed AS (
    SELECT part, place, text('{}', state) AS state, quantity, count(value) AS n, mean(value) AS mean, half_interval(value) AS half_interval, exp(mean(change)) AS ratio,
        exp(mean(change) - half_interval(change)) AS ratio_low, exp(mean(change) + half_interval(change)) AS ratio_high
    FROM paired WHERE value IS NOT NULL GROUP BY part, place, state, quantity
), strengths AS (
    SELECT a.part, a.place, a.state, a.n, a.mean / b.mean AS mean, power(a.half_interval / a.mean, 2) + power(b.half_interval / b.mean, 2) AS square
    FROM summed AS a JOIN summed AS b USING (part, state) WHERE a.quantity = 'UCS' AND b.quantity = 'Brazilian'
)
SELECT part, state, quantity, n, mean, half_interval, ratio, ratio_low, ratio_high FROM (
    SELECT * FROM summed UNION ALL
    -- The ratio of two independent means.
    SELECT part, place, state, 'UCS_over_Brazilian', n, mean, mean * sqrt(square), NULL, NULL, NULL FROM strengths
) ORDER BY place, quantity
