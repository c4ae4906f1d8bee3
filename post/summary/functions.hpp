// What queries of `summarize` have beside the functions of SQLite: statistics, and texts with numbers in them.
#pragma once

struct sqlite3;

namespace graincrack::summary {

/// Adds to a database:
/// - the aggregates of `statistics()`;
/// - mean_and_half(x, '.1f'): "9.0 ± 12.7", a mean with half of its 95 % interval; of one entry the entry alone, of none "-";
/// - entries(x): the entries of a column, each once, with "; " between them;
/// - text('{:.1f} of {}', x, y): a text with numbers in the formats of fmt, or with seven digits.
/// Rows without an entry do not count; else without any, or with an empty argument of text, the result is NULL. A text where a
/// number is needed fails with SQLITE_MISMATCH.
void add_functions(sqlite3* database);

}  // namespace graincrack::summary
