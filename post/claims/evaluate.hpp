// A claim against tables of results: our number with its interval, and the verdict.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "post/claims/claim.hpp"
#include "post/claims/verdict.hpp"
#include "post/table/table_file.hpp"

namespace graincrack::claims {

/// Tables by the stems of their file names.
class Tables {
public:
    /// \throws InputError if one cannot be read, or two have the same stem
    explicit Tables(const std::vector<std::string>& files);
    /// \throws InputError naming `where` if there is no such table
    [[nodiscard]] const TableFile& at(const std::string& stem, const std::string& where) const;

private:
    std::map<std::string, TableFile> tables_;
};

struct Finding {
    Verdict verdict = Verdict::open;
    std::optional<Estimate> ours;  ///< in the unit of the paper; of an equality over levels: the largest difference, in percent
    std::string text;              ///< the same as shown
    std::string difference;        ///< from the paper, empty where it has no number
    std::string reason;            ///< of an open verdict
    std::string paper;             ///< what the paper has, where a column has it; else empty
};

/// Empty if the claim has no number to compare with: its laboratory value is empty, or it is left out unless measured.
/// \throws InputError naming the claim if a table or column is missing
std::optional<Finding> evaluate(const Claim& claim, const Tables& tables);

}  // namespace graincrack::claims
