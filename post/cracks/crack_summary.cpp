#include "post/cracks/crack_summary.hpp"

#include <numeric>
#include <optional>
#include <string>

#include "post/cracks/crack_counts.hpp"
#include "post/cracks/cracked_crystals.hpp"
#include "post/cracks/rosette.hpp"
#include "post/run/crack_label.hpp"
#include "post/run/run_state.hpp"
#include "post/table/column.hpp"

namespace graincrack {

namespace {

/// A moment of a run, and at its end what it has become.
struct SummaryRow {
    std::string file, at;
    double time = 0;  ///< s
    std::optional<double> axial_strain;
    CrackBalance balance;
    std::optional<std::size_t> fragments, single_grains, events;
    std::optional<GutenbergRichter> fit;  ///< of the events
    Cell peak_kind;
    OtherCounts counts;
    Rosette rosette;
    ModeCounts crystals;  ///< that are cracked
    [[nodiscard]] Cell of_fit(double GutenbergRichter::*value) const { return fit ? Cell((*fit).*value) : Cell(); }
};

const Columns<SummaryRow>& summary_columns() {
    using R = SummaryRow;
    using namespace unit;
    static const Columns<R> all = [] {
        Columns<R> list{{"file", none, [](const R& r) { return r.file; }},
                        {"at", none, [](const R& r) { return r.at; }},
                        {"time", second, [](const R& r) { return r.time; }},
                        {"axial_strain", none, [](const R& r) { return r.axial_strain; }},
                        {"tensile_cracks", none, [](const R& r) { return count_cell(r.balance.tensile); }},
                        {"shear_cracks", none, [](const R& r) { return count_cell(r.balance.shear); }},
                        {"separated", none, [](const R& r) { return count_cell(r.balance.separated); }},
                        {"fragments", none, [](const R& r) { return r.fragments; }},
                        {"single_grains", none, [](const R& r) { return r.single_grains; }},
                        {"events", none, [](const R& r) { return r.events; }},
                        {"b_value", none, [](const R& r) { return r.of_fit(&GutenbergRichter::b); }},
                        {"b_value_error", none, [](const R& r) { return r.of_fit(&GutenbergRichter::error); }},
                        {"b_value_completeness", none, [](const R& r) { return r.of_fit(&GutenbergRichter::completeness); }},
                        {"b_value_events", none, [](const R& r) { return r.fit ? Cell(r.fit->events) : Cell(); }},
                        {"peak_kind", none, [](const R& r) { return r.peak_kind; }}};
        append_other_counts<R>(list, [](const R& r) -> const OtherCounts& { return r.counts; });
        const auto sum = [](const R& r) { return std::accumulate(r.rosette.tensile.begin(), r.rosette.tensile.end(), 0.0); };
        list.push_back({"tensile_length", metre, sum});
        list.push_back({"tensile_share_within_30_deg", none, [](const R& r) { return share_along_load(r.rosette.tensile); }});
        list.push_back({"facet_share_within_30_deg", none, [](const R& r) { return share_along_load(r.rosette.facet); }});
        list.push_back({"tensile_cracked_crystals", none, [](const R& r) { return count_cell(r.crystals.tensile); }});
        list.push_back({"shear_cracked_crystals", none, [](const R& r) { return count_cell(r.crystals.shear); }});
        return list;
    }();
    return all;
}

}  // namespace

CrackBalance balance_cracks(const std::vector<Crack>& cracks, double time) {
    CrackBalance balance;
    for (const Crack& crack : cracks) {
        if (crack.time > time) continue;
        balance.add(crack);
        if (crack.separated.time <= time) balance.separated += 0.5;
    }
    return balance;
}

void write_crack_summary(std::ostream& out, const RunData& run, const std::optional<LoadCurve>& curve, const CrackRows& log,
                         const std::vector<EmissionEvent>& events, const Fragments& fragments, TableFormat format) {
    const std::vector<Crack> cracks = labelled(log.all, log.label);
    const auto row_at = [&](const char* at, std::size_t index) {
        SummaryRow row{run.name, at, run.history[HistoryColumn::time][index], {}, {}, {}, {}, {}, {}, {}, {}, {}, {}};
        if (curve) {
            row.axial_strain = curve->axial_strain[index];
            row.peak_kind = peak_kind(run, *curve);
        }
        row.balance = balance_cracks(cracks, row.time);
        row.counts = count_other_labels(log.all, run.header.crack_event, row.time);
        row.crystals = count_cracked_crystals(log.specimen, cracks, row.time);
        row.rosette = crack_rosette(cracks_until(cracks, row.time), log.specimen);
        return row;
    };
    std::vector<SummaryRow> rows;
    if (curve) rows.push_back(row_at("peak", curve->peak));
    SummaryRow& end = rows.emplace_back(row_at("end", run.history.size() - 1));
    end.fragments = fragments.all.size();
    end.single_grains = fragments.single_grains();
    end.events = events.size();
    const std::vector<double> magnitudes = magnitudes_of(events);
    if (!magnitudes.empty()) end.fit = fit_gutenberg_richter(magnitudes, completeness_of(magnitudes));
    write_table(out, summary_columns(), rows, format);
}

}  // namespace graincrack
