#include "post/cracks/class_counts.hpp"

#include <fmt/format.h>

#include <cmath>

#include "post/run/contact_classes.hpp"
#include "post/table/terminal_table.hpp"
#include "share/base/units.hpp"

namespace graincrack {

namespace {

void write_for_scripts(std::ostream& out, const std::vector<RunClasses>& runs, TableFormat format) {
    TableWriter table(out,
                      {"file", "class", "contacts", "length_m", "length_share", "tensile_cracks", "shear_cracks",
                       "tensile_cracks_at_end", "shear_cracks_at_end"},
                      format);
    for (const RunClasses& run : runs) {
        for (const ClassCounts& each : run.classes) {
            const auto& peak = each.at_peak;
            table.row({run.run, each.name, static_cast<std::int64_t>(each.contacts), each.length, each.length / run.length(),
                       peak ? count_cell(peak->tensile) : Cell(), peak ? count_cell(peak->shear) : Cell(),
                       count_cell(each.at_end.tensile), count_cell(each.at_end.shear)});
        }
    }
}

/// All classes together.
ClassCounts sum_of(const RunClasses& run) {
    ClassCounts sum{"all", 0, run.length()};
    for (const ClassCounts& each : run.classes) {
        sum.contacts += each.contacts;
        sum.at_end += each.at_end;
        if (!each.at_peak) continue;
        if (!sum.at_peak) sum.at_peak.emplace();
        *sum.at_peak += *each.at_peak;
    }
    return sum;
}

void write_to_terminal(std::ostream& out, const std::vector<RunClasses>& runs) {
    TerminalTable terminal({{"contacts", ""},
                            {"number", ""},
                            {"length", "%"},
                            {"tensile", "at peak"},
                            {"shear", "at peak"},
                            {"tensile", "at end"},
                            {"shear", "at end"}});
    for (const RunClasses& run : runs) {
        terminal.group(run.run + ", " + run.definition);
        const auto row = [&](const ClassCounts& each) {
            const auto& peak = each.at_peak;
            terminal.row({each.name, std::to_string(each.contacts), format_number(100 * each.length / run.length(), 3),
                          peak ? format_number(peak->tensile, 6) : "", peak ? format_number(peak->shear, 6) : "",
                          format_number(each.at_end.tensile, 6), format_number(each.at_end.shear, 6)});
        };
        for (const ClassCounts& each : run.classes) row(each);
        row(sum_of(run));
    }
    terminal.write(out);
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
        const auto& from = specimen.node_position[static_cast<std::size_t>(specimen.contact_nodes[c][0])];
        const auto& to = specimen.node_position[static_cast<std::size_t>(specimen.contact_nodes[c][1])];
        own.contacts += 1;
        own.length += std::hypot(to[0] - from[0], to[1] - from[1]);
    }
    for (const Crack& crack : cracks) {
        ClassCounts& own = counts[classes.of_contact[static_cast<std::size_t>(crack.contact)]];
        own.at_end.add(crack);
        if (peak && crack.time <= *peak) own.at_peak->add(crack);
    }
    return counts;
}

RunClasses read_classes(const RunReader& run, const CrackLabelChoice& label) {
    const Specimen specimen = run.specimen();
    const RunData data = run_data(run);
    const std::optional<LoadCurve> curve = load_curve_if_any(data);
    const std::optional<double> peak = curve ? std::optional(data.history[HistoryColumn::time][curve->peak]) : std::nullopt;
    return {data.name, definition_of(label.of(run.header())),
            count_by_class(specimen, read_labelled_cracks(run, specimen, label), peak)};
}

void write_class_counts(std::ostream& out, const std::vector<RunClasses>& runs, const std::optional<TableFormat>& format) {
    if (format) {
        write_for_scripts(out, runs, *format);
    } else {
        write_to_terminal(out, runs);
    }
}

}  // namespace graincrack
