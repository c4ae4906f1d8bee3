#include "post/cracks/crack_counts.hpp"

#include <algorithm>
#include <functional>

#include "post/cracks/fragments.hpp"
#include "post/run/contact_classes.hpp"
#include "post/run/crystals.hpp"
#include "post/run/run_state.hpp"
#include "post/table/column.hpp"
#include "share/base/units.hpp"
#include "share/file/specimen_measures.hpp"

#include <fmt/format.h>

namespace graincrack {

namespace {

/// A class of a run, or all of them.
struct ClassRow {
    const RunClasses& run;
    ClassCounts counts;
    [[nodiscard]] double length_share() const { return counts.length / run.length(); }
    [[nodiscard]] std::string length_share_text() const {
        return counts.length > 0 ? format_number(100 * length_share(), 3) : "";
    }
    [[nodiscard]] Cell at_peak(double ModeCounts::*mode) const {
        return counts.at_peak ? count_cell((*counts.at_peak).*mode) : Cell();
    }
    [[nodiscard]] Cell at_end(double ModeCounts::*mode) const { return count_cell(counts.at_end.*mode); }
};

const Columns<ClassRow>& class_columns() {
    using R = ClassRow;
    using namespace unit;
    static const Columns<R> all{{"file", none, [](const R& r) { return r.run.run; }},
                                {"class", none, [](const R& r) { return r.counts.name; }},
                                {"contacts", none, [](const R& r) { return r.counts.contacts; }},
                                {"length", metre, [](const R& r) { return r.counts.length; }},
                                {"length_share", none, [](const R& r) { return r.length_share(); }},
                                {"tensile_cracks", none, [](const R& r) { return r.at_peak(&ModeCounts::tensile); }},
                                {"shear_cracks", none, [](const R& r) { return r.at_peak(&ModeCounts::shear); }},
                                {"tensile_cracks_at_end", none, [](const R& r) { return r.at_end(&ModeCounts::tensile); }},
                                {"shear_cracks_at_end", none, [](const R& r) { return r.at_end(&ModeCounts::shear); }}};
    return all;
}

const Columns<ClassRow>& class_terminal_columns() {
    using R = ClassRow;
    static constexpr ColumnUnit at_peak{"at peak"}, at_end{"at end"};
    static const Columns<R> all{{"contacts", unit::none, [](const R& r) { return r.counts.name; }},
                                {"number", unit::none, [](const R& r) { return r.counts.contacts; }},
                                {"length", unit::percent, [](const R& r) { return r.length_share_text(); }},
                                {"tensile", at_peak, [](const R& r) { return r.at_peak(&ModeCounts::tensile).text(); }},
                                {"shear", at_peak, [](const R& r) { return r.at_peak(&ModeCounts::shear).text(); }},
                                {"tensile", at_end, [](const R& r) { return r.at_end(&ModeCounts::tensile).text(); }},
                                {"shear", at_end, [](const R& r) { return r.at_end(&ModeCounts::shear).text(); }}};
    return all;
}

/// Classes together: all of a run, or those within crystals, or those between them.
ClassCounts sum_of(const RunClasses& run, const std::string& name, const std::function<bool(const std::string&)>& counts) {
    ClassCounts sum{name};
    for (const ClassCounts& each : run.classes) {
        if (!counts(each.name)) continue;
        sum.length += each.length;
        sum.contacts += each.contacts;
        sum.at_end += each.at_end;
        if (!each.at_peak) continue;
        if (!sum.at_peak) sum.at_peak.emplace();
        *sum.at_peak += *each.at_peak;
    }
    return sum;
}

}  // namespace

double RunClasses::length() const {
    double whole = 0;
    for (const ClassCounts& each : classes) whole += each.length;
    return whole;
}

std::vector<ClassCounts> count_by_class(const Specimen& specimen, const std::vector<Crack>& cracks,
                                        const std::optional<double>& peak) {
    const ContactClasses classes = classes_of(specimen);
    std::vector<ClassCounts> counts;
    for (const std::string& name : classes.names) {
        counts.push_back({name});
        if (peak) counts.back().at_peak.emplace();
    }
    for (std::size_t c = 0; c < specimen.n_contacts(); ++c) {
        ClassCounts& own = counts[classes.of_contact[c]];
        own.contacts += 1;
        own.length += contact_length(specimen, c);
    }
    for (const Crack& crack : cracks) {
        ClassCounts& own = counts[classes.of_contact[static_cast<std::size_t>(crack.contact)]];
        own.at_end.add(crack);
        if (peak && crack.time <= *peak) own.at_peak->add(crack);
    }
    return counts;
}

RunClasses classes_of_run(const std::string& run, const Specimen& specimen, const std::vector<Crack>& cracks,
                          const CrackLabel& label, const std::optional<double>& peak) {
    RunClasses classes{run, definition_of(label), count_by_class(specimen, cracks, peak)};
    if (specimen.grain_crystal.empty()) return classes;
    classes.crystals = ClassCounts{"crystals cracked", number_of_crystals(specimen)};
    if (peak) classes.crystals->at_peak = count_cracked_crystals(specimen, cracks, peak);
    classes.crystals->at_end = count_cracked_crystals(specimen, cracks);
    return classes;
}

RunClasses read_classes(const RunReader& run, const CrackLabelChoice& label) {
    const Specimen specimen = run.specimen();
    const RunData data = run_data(run);
    const std::optional<LoadCurve> curve = load_curve_if_any(data);
    const std::optional<double> peak = curve ? std::optional(data.history[HistoryColumn::time][curve->peak]) : std::nullopt;
    return classes_of_run(data.name, specimen, read_labelled_cracks(run, specimen, label), label.of(run.header()), peak);
}

void write_class_counts(std::ostream& out, const std::vector<RunClasses>& runs, TableFormat format) {
    if (format != TableFormat::aligned) {
        std::vector<ClassRow> rows;
        for (const RunClasses& run : runs) {
            for (const ClassCounts& each : run.classes) rows.push_back({run, each});
        }
        return write_table(out, class_columns(), rows, format);
    }
    TerminalTable table(class_terminal_columns());
    for (const RunClasses& run : runs) {
        table.group(run.run + ", " + run.definition);
        for (const ClassCounts& each : run.classes) table.row(cells_of(class_terminal_columns(), {run, each}));
        const auto is_within = [](const std::string& name) { return !phase_of_within_class(name).empty(); };
        const auto sum = [&](const std::string& name, const auto& is_meant) {
            table.row(cells_of(class_terminal_columns(), {run, sum_of(run, name, is_meant)}));
        };
        if (std::any_of(run.classes.begin(), run.classes.end(), [&](const ClassCounts& each) { return is_within(each.name); })) {
            sum("within crystals", is_within);
            sum("between crystals", [&](const std::string& name) { return !is_within(name); });
        }
        sum("all", [](const std::string& /*name*/) { return true; });
        if (run.crystals) table.row(cells_of(class_terminal_columns(), {run, *run.crystals}));
    }
    table.write(out);
}

CrackBalance balance_cracks(const std::vector<Crack>& cracks, double time) {
    CrackBalance balance;
    for (const Crack& crack : cracks) {
        if (crack.time > time) continue;
        balance.add(crack);
        if (crack.separated.time <= time) balance.separated += 0.5;
    }
    return balance;
}

}  // namespace graincrack
