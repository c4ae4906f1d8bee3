-- For --pivot, from `graincrack-post kind --rocks` (rocks) and share/results/rocks-values.tsv: what the design expects of calibrated rocks over the means of
-- their specimens, less 1, in % with 95 % intervals, without pressure and at 8 and 20 MPa.
WITH strengths AS (SELECT rock, CAST(value AS REAL) AS tc FROM rocks_values WHERE parameter = 'contact.tensile_strength')
SELECT replace(property, '_', ' ') || iif(confining_pressure > 0, text(' at {:.0f} MPa', confining_pressure * tc), '') AS quantity, rock,
    text('{:+.0f} ({:+.0f} to {:+.0f})', off_percent, low_percent, high_percent)
FROM rocks JOIN strengths USING (rock) WHERE predicted IS NOT NULL AND round(confining_pressure * tc) IN (0, 8, 20)
ORDER BY confining_pressure * tc, rocks.rowid
