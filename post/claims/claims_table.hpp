// The table of claims with their verdicts: TSV, JSON lines, Markdown or a page of HTML.
#pragma once

#include <map>
#include <ostream>
#include <string>
#include <vector>

#include "post/table/table.hpp"

namespace graincrack::claims {

enum class ClaimsFormat { tsv, jsonl, markdown, html, aligned };

struct ClaimsOptions {
    std::string study;                            ///< first column of every row
    std::map<std::string, std::string> settings;  ///< what {NAME} in the claims stands for
    ClaimsFormat format = ClaimsFormat::tsv;
};

/// one row per claim: study, claim, paper, ours, difference, verdict, explanation, low, high. All claims are evaluated before the
/// first row is written. \param claims the file of claims \param tables of results \throws InputError
void write_claims(std::ostream& out, const std::string& claims, const std::vector<std::string>& tables,
                  const ClaimsOptions& options);

}  // namespace graincrack::claims
