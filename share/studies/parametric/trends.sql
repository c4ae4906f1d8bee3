-- Straight lines of strength, in MPa, over the level of each series, with 95 % intervals.
SELECT test || ', ' || series AS "group", count(*) AS n, count(DISTINCT level) AS levels, intercept(level, strength_MPa) AS intercept,
    intercept_low(level, strength_MPa) AS intercept_low, intercept_high(level, strength_MPa) AS intercept_high, slope(level, strength_MPa) AS slope,
    slope_low(level, strength_MPa) AS slope_low, slope_high(level, strength_MPa) AS slope_high,
    slope(level, strength_MPa) * mean(level) / mean(strength_MPa) AS elasticity, lack_of_fit(level, strength_MPa) AS lack_of_fit_p
FROM series WHERE strength_MPa IS NOT NULL GROUP BY test, series ORDER BY min(rowid)
