// A claim against tables of results: our number with its interval, and the verdict.
#pragma once

#include <optional>
#include <string>

#include "post/claims/claim.hpp"
#include "post/claims/verdict.hpp"
#include "post/summary/database.hpp"

namespace graincrack::claims {

struct Finding {
    Verdict verdict = Verdict::open;
    std::optional<Estimate> ours;  ///< in the unit of the paper; of an equality over levels: the largest difference, in percent
    std::string text;              ///< the same as shown
    std::string difference;        ///< from the paper, empty where it has no number
    std::string reason;            ///< of an open verdict
    std::string paper;             ///< what the paper has, where a column has it; else empty
};

/// Empty if the claim has no number to compare with: its laboratory value is empty, or it is left out unless measured.
/// \throws InputError naming the claim if a table or column is missing, or its SQL cannot be understood
std::optional<Finding> evaluate(const Claim& claim, const summary::Database& tables);

}  // namespace graincrack::claims
