-- Exponents of σt in grain size with their intervals.
SELECT variant, count(*) AS discs, ifnull(text('{:.2f} ({:.2f} to {:.2f})', exponent(mean_edge_mm, tensile_strength_MPa),
    exponent_low(mean_edge_mm, tensile_strength_MPa), exponent_high(mean_edge_mm, tensile_strength_MPa)), '-') AS exponent
FROM sized JOIN runs USING (file) WHERE tensile_strength_MPa IS NOT NULL GROUP BY variant ORDER BY min(sized.rowid)
