#include "post/report/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "post/report/html.hpp"
#include "post/table/column.hpp"

namespace graincrack {

namespace {

using calibrate::Agreement;
using html::number;

std::vector<double> tested_pressures(const std::vector<SeedGroup>& groups) {
    std::set<double> pressures;
    for (const SeedGroup& group : groups) {
        const RunSettings& settings = group.first().data.header;
        if (settings.description().is_confined) pressures.insert(settings.confining_pressure);
    }
    return {pressures.begin(), pressures.end()};
}

std::string unit_of(const ComparisonRow& row) {
    const std::string& unit = row.laboratory.target.property.unit;
    return unit.empty() ? "" : "\u00a0" + (unit == unit::degree.name ? "°" : unit);
}

std::string in_unit(const ComparisonRow& row, double value, int digits = 4) {
    return number(value / row.laboratory.target.property.si, digits);
}

std::string laboratory_cell(const ComparisonRow& row) {
    const auto& [target, has_own_deviation, origin, scatter] = row.laboratory;
    if (!row.laboratory.is_measured()) return "";
    std::string text = in_unit(row, target.value);
    if (std::isfinite(target.deviation)) text += " ± " + in_unit(row, target.deviation, 2) + (has_own_deviation ? "" : "*");
    text += unit_of(row) + (target.is_on_line ? std::string("\n") + calibrate::no_test : "");
    return text + (target.measured_on ? "\n" + target.measured_on->text() : "");
}

/// In the unit of the property with four significant digits of the laboratory's value, or in per cent.
std::string difference_cell(const ComparisonRow& row) {
    const auto& [property, pressure, value, deviation, use, measured_on, is_on_line] = row.laboratory.target;
    if (!row.laboratory.is_measured() || !std::isfinite(row.ours.value)) return "";
    if (!property.absolute) return fmt::format("{:+.1f}\u00a0%", *row.off_laboratory_percent());
    const double known = std::abs(value / property.si);
    const int decimals = known == 0 ? 0 : std::clamp(3 - static_cast<int>(std::floor(std::log10(known))), 0, 6);
    return fmt::format("{:+.{}f}", (row.ours.value - value) / property.si, decimals);
}

/// "132.4 MPa\n125 to 140 (4 runs)"
std::string computed_cell(const ComparisonRow& row) {
    if (!std::isfinite(row.ours.value)) return row.is_mean ? did_not_fail : not_determined(row.specimens);
    const Estimate computed = row.computed();
    std::string text = in_unit(row, computed.value) + unit_of(row) + "\n";
    if (computed.low) text += in_unit(row, *computed.low) + " to " + in_unit(row, *computed.high) + " ";
    if (!row.is_mean) return text + "(line)";
    return text + fmt::format("({}\u00a0run{}{})", row.specimens, row.specimens == 1 ? "" : "s",
                              row.is_pooled() ? ", scatter of the calibration" : "");
}

/// "within", "outside", "not decided (3 runs)", "not decided by one run", or why there is no verdict.
std::string verdict_cell(const ComparisonRow& row) {
    if (row.agreement != Agreement::undecided) return row.caveat.empty() ? name_of(row.agreement) : row.caveat;
    return row.specimens == 1 ? "not decided by one run" : fmt::format("not decided ({} runs)", row.specimens);
}

/// Median and 95 % of a new specimen by the kind, and what that is; "" if it predicts nothing.
std::string kind_cell(const ComparisonRow& row) {
    if (!row.kind) return "";
    const auto at = [&](double deviations) { return in_unit(row, row.kind->specimen_at(deviations)); };
    return at(0) + unit_of(row) + "\n" + at(-deviations_of_95_percent) + " to " + at(deviations_of_95_percent) +
           (row.kind_specimen.empty() ? "" : "\n") + row.kind_specimen;
}

/// The rows that a page shows: tested ones, and values of the laboratory that no run is compared with.
std::vector<ComparisonRow> shown(std::vector<ComparisonRow> rows) {
    std::erase_if(rows, [](const ComparisonRow& row) {
        // The rule for tensile cracks is not that of the page.
        const bool is_of_another_rule = !row.laboratory.is_measured() && !row.laboratory.target.property.other.empty();
        return row.name.empty() || is_of_another_rule || !(row.is_tested() || row.laboratory.is_measured());
    });
    return rows;
}

std::string table_of(const std::vector<ComparisonRow>& rows, bool with_laboratory, bool with_kind) {
    std::vector<std::string> columns{"property", "computed: mean,\n95\u00a0% interval"};
    if (with_laboratory) {
        columns.insert(columns.begin() + 1, "laboratory\n± deviation");
        columns.insert(columns.end(), {"difference", "within or outside", "fitted or predicted"});
    }
    if (with_kind) columns.emplace_back("a specimen, by the kind:\nmedian, 95\u00a0%");
    html::Table table(columns);
    for (const ComparisonRow& row : rows) {
        std::vector<std::string> cells{row.name};
        if (with_laboratory) cells.push_back(laboratory_cell(row));
        cells.push_back(row.is_tested() ? computed_cell(row) : "not tested");
        if (with_laboratory && (row.is_tested() || with_kind)) {
            const bool is_tested = row.is_tested();
            cells.insert(cells.end(), {is_tested ? difference_cell(row) : "", is_tested ? verdict_cell(row) : "",
                                       is_tested ? name_of(row.laboratory.origin) : ""});
        }
        if (with_kind) cells.push_back(kind_cell(row));
        table.row(std::move(cells), row.is_tested() ? name_of(row.agreement) : "untested");
    }
    return table.str();
}

/// How many properties agree, as one sentence.
std::string summary_of(const std::vector<ComparisonRow>& rows) {
    std::string counts;
    for (const Agreement agreement : {Agreement::within, Agreement::outside, Agreement::undecided}) {
        const auto n = std::count_if(rows.begin(), rows.end(), [&](const auto& row) { return row.agreement == agreement; });
        if (n == 0) continue;
        counts += fmt::format("{}{} {}", counts.empty() ? "" : ", ", n,
                              agreement == Agreement::undecided ? "not decided" : name_of(agreement));
    }
    return counts.empty() ? "" : html::paragraph("Beside the laboratory's values and their deviations: " + counts + ".", "lead");
}

/// What the columns of kind and agreement hold, or why there is none.
std::string explanation_of(const std::vector<ComparisonRow>& rows, const MaterialPrediction& prediction) {
    std::string text;
    if (!prediction.why.empty()) {
        text += html::paragraph("The kind predicts nothing of this material: " + prediction.why + ".");
    } else if (prediction.surface) {
        text += html::paragraph(
            fmt::format("A specimen, by the kind: what a new specimen has by the surface of {} (graincrack-post kind), {}; "
                        "K_IC is that of a half-disc of 20 crystals' diameter.",
                        prediction.surface->kind(),
                        prediction.of_calibration.empty() ? "without a run of this material"
                                                          : "and by the runs of its calibration where these measured it"));
    }
    const auto any = [&](const auto& is) { return std::any_of(rows.begin(), rows.end(), is); };
    if (any([](const ComparisonRow& row) { return row.agreement == Agreement::undecided; })) {
        text += html::paragraph(
            "Within, outside: so is the whole 95 % interval of the mean. Not decided: a part of it is, or there is none, as of "
            "one run of a material that does not tell its scatter; more seeds decide.");
    }
    if (any([](const ComparisonRow& row) { return laboratory_cell(row).find('*') != std::string::npos; })) {
        text += html::paragraph("* The material gives no deviation of this value: the usual one of such a measurement.");
    }
    if (any([](const ComparisonRow& row) { return row.is_heated; })) {
        text += html::paragraph("Heated specimens stand beside neither the laboratory's values nor the kind's.");
    }
    return text;
}

}  // namespace

std::string fitted_table(const std::optional<Material>& material) {
    if (!material || material->fitted.empty()) return "";
    const auto rounded = [](const std::string& text) {
        const auto value = parse_number(text);
        return value ? number(*value) : text;
    };
    html::Table table({"property", "fitted to", "computed on new specimens", "95\u00a0% interval of the mean", "specimens"});
    for (const FittedEntry& entry : fitted_entries(*material)) {
        if (!entry.text.empty()) {
            table.row({entry.name, entry.text});
            continue;
        }
        table.row({entry.name, entry.asked, rounded(entry.computed) + (entry.unit.empty() ? "" : "\u00a0" + entry.unit),
                   entry.low.empty() ? "" : rounded(entry.low) + " to " + rounded(entry.high), entry.specimens});
    }
    return table.str();
}

std::string comparison(const std::vector<SeedGroup>& groups, const std::vector<FabricEnvelope>& envelopes,
                       const std::optional<Material>& material, const std::string& caveats) {
    const MaterialPrediction prediction = material ? prediction_of(*material) : MaterialPrediction{};
    const std::vector<ComparisonRow> rows =
        shown(compare(groups, envelopes, laboratory_properties(material, tested_pressures(groups)), material, prediction));
    std::string text = summary_of(rows) + table_of(rows, material.has_value(), prediction.surface.has_value()) +
                       explanation_of(rows, prediction) + caveats;
    if (!material) {
        text += html::paragraph("With --material FILE the laboratory's values of that material stand beside these.");
    } else {
        if (material->fitted.empty()) {
            text += html::paragraph("This material has no [fitted]: no calibration says which values it was fitted to.");
        }
        text += html::paragraph("Laboratory: [targets] and [laboratory] of " + material->file.filename().string() + ".");
    }
    text += html::paragraph(
        "CI and CD as strain gauges tell them, by the volumetric strain ε1 + 2 ε3 over the central half. CI: stress at which the "
        "crack volumetric strain sets in, which is that strain less its elastic line. CD: stress at which the volume begins to "
        "grow. E and ν: chord to half the peak. C and φ: line through the compression tests. UCS and σ1: first peaks; a "
        "test that did not fail has none.");
    if (const std::string fitted = fitted_table(material); !fitted.empty()) {
        text += "<h3>What the calibration fitted</h3>\n" + fitted;
    }
    return text;
}

}  // namespace graincrack
