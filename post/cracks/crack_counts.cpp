#include "post/cracks/crack_counts.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "post/run/contact_classes.hpp"

namespace graincrack {

namespace {

/// Rows of the history at evenly spaced strains and at the peak, ascending.
std::vector<std::size_t> moments_of(const LoadCurve& curve, std::size_t n) {
    const double last = *std::max_element(curve.axial_strain.begin(), curve.axial_strain.end());
    std::vector<std::size_t> rows{curve.peak};
    for (std::size_t i = 0; i <= n; ++i) {
        const double wanted = last * static_cast<double>(i) / static_cast<double>(n);
        const auto at = std::find_if(curve.axial_strain.begin(), curve.axial_strain.end(), [&](double e) { return e >= wanted; });
        if (at != curve.axial_strain.end()) rows.push_back(static_cast<std::size_t>(at - curve.axial_strain.begin()));
    }
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    return rows;
}

CrackCounts count_at(const std::vector<std::size_t>& rows, const RunData& run, const LoadCurve& curve, const Specimen& specimen,
                     std::vector<Crack> cracks) {
    std::stable_sort(cracks.begin(), cracks.end(), [](const Crack& a, const Crack& b) { return a.time < b.time; });
    const ContactClasses classes = classes_of(specimen);
    const auto& times = run.history[HistoryColumn::time];
    CrackCounts counts{classes.names, {}};
    CrackCounts::Moment now;
    now.by_class.resize(classes.names.size());
    auto next = cracks.begin();
    for (const std::size_t row : rows) {
        for (; next != cracks.end() && next->time <= times[row]; ++next) {
            now.all.add(*next);
            now.by_class[classes.of_contact[static_cast<std::size_t>(next->contact)]].add(*next);
        }
        now.time = times[row];
        now.axial_strain = curve.axial_strain[row];
        now.stress = curve.stress[row];
        now.is_peak = row == curve.peak;
        counts.moments.push_back(now);
    }
    return counts;
}

}  // namespace

CrackCounts count_cracks(const RunData& run, const LoadCurve& curve, const Specimen& specimen, std::vector<Crack> cracks,
                         std::size_t n_moments) {
    return count_at(moments_of(curve, n_moments), run, curve, specimen, std::move(cracks));
}

CrackCounts count_cracks_by_row(const RunData& run, const LoadCurve& curve, const Specimen& specimen, std::vector<Crack> cracks) {
    std::vector<std::size_t> rows(curve.stress.size());
    std::iota(rows.begin(), rows.end(), 0);
    return count_at(rows, run, curve, specimen, std::move(cracks));
}

void write_crack_counts(std::ostream& out, const CrackCounts& counts, TableFormat format) {
    std::vector<std::string> columns{"time_s", "axial_strain", "stress_MPa", "is_peak", "tensile_cracks", "shear_cracks"};
    for (const std::string& name : counts.classes) {
        columns.push_back("tensile_cracks_" + name);
        columns.push_back("shear_cracks_" + name);
    }
    TableWriter table(out, columns, format);
    for (const CrackCounts::Moment& m : counts.moments) {
        std::vector<Cell> row{m.time,
                              m.axial_strain,
                              m.stress * 1e-6,
                              std::int64_t{m.is_peak ? 1 : 0},
                              count_cell(m.all.tensile),
                              count_cell(m.all.shear)};
        for (const ModeCounts& each : m.by_class) {
            row.push_back(count_cell(each.tensile));
            row.push_back(count_cell(each.shear));
        }
        table.row(row);
    }
}

}  // namespace graincrack
