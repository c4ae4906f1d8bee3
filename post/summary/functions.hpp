// Functions that queries of `summarize` have in addition to those of SQLite: statistics, and texts with numbers.
#pragma once

struct sqlite3;

namespace graincrack::summary {

/// Adds to a database:
/// - of one argument, over the rows that have an entry: mean, median, deviation (n − 1), low and high (the 95 % interval of the
///   mean by Student's t), half_interval;
/// - of two arguments (x, y), over the rows that have both: intercept and slope of the straight line by least squares, exponent
///   of the power law y ~ x^b through logarithms, each with the ends of its 95 % interval as slope_low and slope_high;
///   lack_of_fit, the p of the line's lack of fit against the scatter at equal x; rank_correlation by Spearman; with x = σ3 and
///   y = σ1, in one unit, cohesion (in that unit) and friction_angle (deg) of the line. NULL if there is no such fit;
/// - mean_and_half(x, '.1f'): "9.0 ± 12.7", a mean with half of its 95 % interval; of one entry the entry alone, of none "-";
/// - entries(x): the entries of a column, each once, with "; " between them;
/// - text('{:.1f} of {}', x, y): a text with numbers in the formats of fmt, or with seven digits.
/// Rows without an entry do not count; if none is left, or the argument of text is empty, the result is NULL. A text in place of
/// a number fails with SQLITE_MISMATCH.
void add_functions(sqlite3* database);

}  // namespace graincrack::summary
