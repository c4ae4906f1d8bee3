-- Means over seeds.
SELECT test, series, level, count(strength_MPa) AS runs, mean(strength_MPa) AS strength_MPa, deviation(strength_MPa) AS deviation_MPa,
    low(strength_MPa) AS low_MPa, high(strength_MPa) AS high_MPa, mean(normalised) AS normalised,
    count(*) FILTER (WHERE peak_kind <> 'drop') AS without_peak
FROM series GROUP BY test, series, level ORDER BY test, series, level
