#include "post/claims/claims_table.hpp"

#include <fmt/format.h>

#include "post/claims/evaluate.hpp"
#include "post/report/html.hpp"
#include "post/table/number.hpp"

namespace graincrack::claims {

namespace {

const std::vector<std::string> columns{"study", "claim", "paper", "ours", "difference", "verdict", "explanation", "low", "high"};

std::vector<Cell> row_of(const Claim& claim, const Finding& finding, const std::string& study) {
    const bool holds = finding.verdict == Verdict::holds;
    const bool is_number = parse_number(claim.paper).has_value() && !claim.unit.empty();
    const std::optional<Estimate>& ours = finding.ours;
    return {study,
            claim.name,
            !finding.paper.empty() ? finding.paper
            : is_number            ? claim.paper + " " + claim.unit
                                   : claim.paper,
            finding.text,
            finding.difference,
            std::string(name_of(finding.verdict)),
            holds                                                         ? std::string()
            : finding.verdict == Verdict::open && !finding.reason.empty() ? finding.reason
                                                                          : claim.note,
            ours ? cell(ours->low) : Cell(),
            ours ? cell(ours->high) : Cell()};
}

void write_html(std::ostream& out, const std::vector<std::vector<Cell>>& rows, const std::string& study) {
    html::Table table(columns, true);
    for (const auto& row : rows) {
        std::vector<std::string> cells;
        for (const Cell& each : row) cells.push_back(each.text());
        table.row(cells);
    }
    out << html::page(study.empty() ? "Claims" : study + ": claims", table.str());
}

}  // namespace

void write_claims(std::ostream& out, const std::string& claims, const std::vector<std::string>& tables,
                  const ClaimsOptions& options) {
    const summary::Database results(tables, "");
    std::vector<std::vector<Cell>> rows;
    for (const Claim& claim : read_claims(claims, options.settings)) {
        if (const auto finding = evaluate(claim, results)) rows.push_back(row_of(claim, *finding, options.study));
    }
    if (options.format == ClaimsFormat::html) return write_html(out, rows, options.study);
    const std::map<ClaimsFormat, TableFormat> formats{{ClaimsFormat::jsonl, TableFormat::jsonl},
                                                      {ClaimsFormat::markdown, TableFormat::markdown},
                                                      {ClaimsFormat::aligned, TableFormat::aligned}};
    const auto format = formats.find(options.format);
    TableWriter table(out, columns, format == formats.end() ? TableFormat::tsv : format->second);
    for (const auto& row : rows) table.row(row);
}

}  // namespace graincrack::claims
