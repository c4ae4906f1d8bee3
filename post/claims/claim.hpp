// Claims of a paper as a table: one row per claim. share/doc/studies.md describes its columns.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "post/claims/verdict.hpp"

namespace graincrack::claims {

enum class Kind {
    value,    ///< a number, within a tolerance
    sign,     ///< above or below zero
    trend,    ///< rises or falls from the lowest to the highest level
    order,    ///< above or below a bound; also the rank correlation of two columns
    equality  ///< equal when rounded as printed; or equal at all levels; or two columns equal row by row
};

/// How far a number may be off.
struct Tolerance {
    enum class Kind { absolute, relative, interval, standard_errors } kind = Kind::absolute;
    double amount = 0;
};

struct Claim {
    std::string name;
    Kind kind = Kind::value;
    std::string table;   ///< name of a table in SQL
    std::string where;   ///< which of its rows: a condition in SQL; empty: all
    std::string column;  ///< an expression in SQL
    std::string paper;   ///< what the paper has, as shown
    std::string value;   ///< the same as a number, bound, sign or direction; "=COLUMN": a column of the table has it
    Tolerance tolerance;
    std::vector<std::string> interval;  ///< columns of the low and high end, or of half the interval
    std::string by;                     ///< column of levels, or by which rows of two tables are joined
    std::string pair;                   ///< column of specimens: levels are compared on the same ones
    std::string against;                ///< TABLE:COLUMN of a second quantity
    std::string needs;                  ///< a condition in SQL, without which the claim is open
    bool only_if_measured = false;      ///< left out if there are no rows
    double factor = 1;                  ///< of our number, to the unit of the paper
    std::string unit;
    std::string note;  ///< why, if it does not hold
    int row = 0;       ///< of the file, from 1
};

/// Reads claims. `settings` replace {NAME} in any field.
/// \throws InputError naming row and column if one cannot be understood or a {NAME} is not set
std::vector<Claim> read_claims(const std::string& file, const std::map<std::string, std::string>& settings);

}  // namespace graincrack::claims
