-- What would falsify the bridge: one row per line of README.md and variant. Of variants that differ in one value, values of the same specimen are compared.
WITH sized AS (SELECT variant FROM zones WHERE variant LIKE 'bridge%' AND series = 'half-disc R25' GROUP BY variant),
measured AS (
    SELECT variant, seed, 'K at Ø 80 mm' AS quantity, K AS value FROM zones WHERE series = 'half-disc 0.5'
    UNION ALL SELECT variant, strength.seed, 'direct tension', tensile_strength_MPa FROM strength JOIN runs USING (file) WHERE series = 'tension'
    UNION ALL SELECT variant, strength.seed, 'CI by gauges', crack_initiation_MPa FROM strength JOIN moduli USING (file) JOIN runs USING (file)
    UNION ALL SELECT variant, strength.seed, 'CI by count', crack_initiation_count_MPa FROM strength JOIN moduli USING (file) JOIN runs USING (file)
    UNION ALL SELECT variant, strength.seed, 'CI by 10 % lost', crack_initiation_count_damage_10_MPa FROM strength JOIN moduli USING (file) JOIN runs USING (file)
), bridges AS (SELECT *, substr(variant, 7, 4) AS strength, CAST(substr(variant, 12) AS REAL) AS energy FROM measured WHERE variant LIKE 'bridge%'),
compared AS (
    SELECT a.variant || ' to ' || b.variant AS variant, a.quantity, 100 * mean(b.value / a.value - 1) AS mean, 100 * half_interval(b.value / a.value - 1) AS half
    FROM bridges AS a JOIN bridges AS b USING (strength, quantity, seed) WHERE b.energy = 2 * a.energy GROUP BY a.variant, a.quantity
), resolved AS (
    SELECT b.variant, 100 * mean(b.value / a.value - 1) AS mean, 100 * half_interval(b.value / a.value - 1) AS half
    FROM measured AS a JOIN measured AS b USING (quantity, seed) WHERE a.variant = :MIDDLE AND a.quantity LIKE 'K%' AND b.variant = 'some-open' GROUP BY b.variant
), of_size AS (SELECT variant, series, mean(K) AS K, half_interval(K) AS half FROM zones GROUP BY variant, series)
SELECT 1 AS line, big.variant, 'K at R 150 mm over K at R 25 mm' AS quantity, big.K / small.K AS value, big.K / small.K * small.half / small.K AS half, 1.3 AS low, 2.2 AS high,
    big.K / small.K BETWEEN 1.3 AND 2.2 AS stands
FROM of_size AS big JOIN of_size AS small USING (variant) JOIN sized USING (variant) WHERE big.series = 'half-disc R150' AND small.series = 'half-disc R25'
UNION ALL SELECT 2, variant, quantity || ', change in %', mean, half, -limit_of, limit_of, abs(mean) <= limit_of
    FROM (SELECT *, CASE WHEN quantity LIKE 'K%' THEN 10 ELSE 3 END AS limit_of FROM compared)
UNION ALL SELECT 3, variant, 'longest bridged zone, mm', max(zone_mm), NULL, 0, 100, max(zone_mm) <= 100 FROM zones JOIN sized USING (variant) GROUP BY variant
UNION ALL SELECT 3, variant, 'width of the bridged zone, mm', mean(zone_width_mm), half_interval(zone_width_mm), 0, 14, mean(zone_width_mm) <= 14
    FROM zones JOIN sized USING (variant) GROUP BY variant
UNION ALL SELECT 4, variant, 'share of the crack within crystals', total(cut_mm) / total(crack_mm), NULL, 0.3, 1, total(cut_mm) / total(crack_mm) >= 0.3
    FROM zones JOIN sized USING (variant) GROUP BY variant
UNION ALL SELECT 5, variant, 'K with 5 % of boundaries open, change in %', mean, half, -10, NULL, mean >= -10 FROM resolved
UNION ALL SELECT 6, a.variant, 'K of beams over K of half-discs', b.K / a.K, b.K / a.K * sqrt(power(a.half / a.K, 2) + power(b.half / b.K, 2)), 0.9, 1.1, b.K / a.K BETWEEN 0.9 AND 1.1
    FROM of_size AS a JOIN of_size AS b USING (variant) WHERE a.series = 'half-disc 0.5' AND b.series = 'beam'
UNION ALL SELECT 7, b.variant, 'K over that of 8 elements', b.K / a.K, b.K / a.K * sqrt(power(a.half / a.K, 2) + power(b.half / b.K, 2)), 0.9, 1.1, b.K / a.K BETWEEN 0.9 AND 1.1
    FROM of_size AS a JOIN of_size AS b USING (series) WHERE series = 'half-disc 0.5' AND a.variant = :MIDDLE AND b.variant LIKE 'elements%'
ORDER BY line
