// The history of a run: the measures of its rows, stored as /history of a run file.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "share/base/quantities.hpp"
#include "share/file/h5_file.hpp"

namespace graincrack {

/// Columns of /history, in the order of `history_datasets`.
enum class HistoryColumn : std::size_t {
    time,
    step,
    axial_strain,
    lateral_strain,
    gauge_axial_strain,
    gauge_lateral_strain,
    axial_stress,
    force_top,
    force_bottom,
    confining_pressure,
    energy_external,
    energy_kinetic,
    energy_strain,
    energy_contact,
    energy_fracture_tension,
    energy_fracture_shear,
    energy_friction,
    energy_damping,
    energy_platen,
    non_conservative_work,
    energy_balance_error,
    unbalanced_ratio,
    tensile_cracks,
    shear_cracks,
    platen_speed,
    damping_load,
    energy_numerical,
    temperature,
    count
};
struct HistoryDataset {
    std::string_view name;
    Dimension dimension;
    std::string_view description;
};
extern const std::array<HistoryDataset, static_cast<std::size_t>(HistoryColumn::count)> history_datasets;

/// A history has columns of equal length. Tension and elongation are positive. Crack columns count contacts (half of the points).
struct History {
    std::array<std::vector<double>, static_cast<std::size_t>(HistoryColumn::count)> columns;
    bool has_temperature = false;  ///< if false, the temperature is 0 and files do not have its column
    [[nodiscard]] const std::vector<double>& operator[](HistoryColumn c) const { return columns[static_cast<std::size_t>(c)]; }
    [[nodiscard]] std::vector<double>& operator[](HistoryColumn c) { return columns[static_cast<std::size_t>(c)]; }
    /// Number of columns in a file or table, which may lack the last one, the temperature.
    [[nodiscard]] std::size_t n_columns() const { return columns.size() - (has_temperature ? 0 : 1); }
    [[nodiscard]] std::size_t size() const { return columns[0].size(); }
};

/// Appends the rows from `first` on to the file of a run.
void append_rows(H5Output& file, const History& history, std::size_t first);
/// Reads /history of a finished or unfinished run. \throws InputError if it is missing or damaged
History read_history(const H5Input& file);

}  // namespace graincrack
