-- Exponents of σt in grain size with their intervals.
SELECT "group", n AS discs, ifnull(text('{:.2f} ({:.2f} to {:.2f})', elasticity, elasticity_low, elasticity_high), '-') AS exponent
FROM exponents
