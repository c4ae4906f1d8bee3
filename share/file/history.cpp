#include "share/file/history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string>

#include "share/base/error.hpp"
#include "share/file/file_checks.hpp"
#include "share/file/schema.hpp"

namespace graincrack {

// clang-format off
const std::array<HistoryDataset, static_cast<std::size_t>(HistoryColumn::count)> history_datasets{{
    {"time", Dimension::time, "time"},
    {"step", Dimension::one, "step"},
    {"axial_strain", Dimension::one, "platen approach over specimen height, elongation positive"},
    {"lateral_strain", Dimension::one, "mean widening of the lateral boundary over its width, elongation positive"},
    {"gauge_axial_strain", Dimension::one, "axial strain of the central half, elongation positive"},
    {"gauge_lateral_strain", Dimension::one, "lateral strain of the central half, elongation positive"},
    {"axial_stress", Dimension::stress, "mean platen force over the specimen's width, tension positive"},
    {"force_top", Dimension::force, "axial force of the top platen on the specimen per metre of thickness, tension positive"},
    {"force_bottom", Dimension::force, "axial force of the bottom platen on the specimen per metre of thickness, tension positive"},
    {"confining_pressure", Dimension::stress, "achieved pressure: lateral membrane force over the distance of the platens"},
    {"energy_external", Dimension::energy, "work of platens and membrane on the specimen"},
    {"energy_kinetic", Dimension::energy, "kinetic energy"},
    {"energy_strain", Dimension::energy, "strain energy of the elements"},
    {"energy_contact", Dimension::energy, "energy stored in the contacts"},
    {"energy_fracture_tension", Dimension::energy, "energy dissipated by contacts that failed in tension"},
    {"energy_fracture_shear", Dimension::energy, "energy dissipated by contacts that failed in shear, without friction"},
    {"energy_friction", Dimension::energy, "energy dissipated by friction in failed contacts"},
    {"energy_damping", Dimension::energy, "energy absorbed by damping"},
    {"energy_platen", Dimension::energy, "energy stored in platen springs and dissipated by platen friction"},
    {"non_conservative_work", Dimension::energy, "energy lost (positive) or made (negative) where the law has no potential"},
    {"energy_balance_error", Dimension::one, "(external - sum of the others) / largest stored energy so far"},
    {"unbalanced_ratio", Dimension::one, "mean unbalanced nodal force over mean magnitude of the forces at a node"},
    {"tensile_cracks", Dimension::one, "contacts that failed while open (points / 2)"},
    {"shear_cracks", Dimension::one, "contacts that failed while closed (points / 2)"},
    {"platen_speed", Dimension::speed, "speed of each platen, approach positive"},
    {"damping_load", Dimension::one, "load that damping carries by holding the mean motion back, over that of the platens"},
    {"energy_numerical", Dimension::energy, "lost by mass scaling where clusters of nodes meet or leave platens"},
    {"temperature", Dimension::temperature, "temperature of the specimen above that of the state without stress"},
}};
// clang-format on

namespace {

std::string history_path(std::size_t column) {
    return std::string(schema::history_group) + "/" + std::string(history_datasets[column].name);
}

}  // namespace

void append_rows(H5Output& file, const History& history, std::size_t first) {
    const std::size_t n = history.size() - first;
    for (std::size_t i = 0; i < history.n_columns(); ++i) {
        const std::span<const double> rows(history.columns[i].data() + first, n);
        file.append<double>(history_path(i), rows, {n}, si_unit(history_datasets[i].dimension), history_datasets[i].description);
    }
}

History read_history(const H5Input& file) {
    History history;
    const std::size_t rows = rows_of(file, history_path(0));
    history[HistoryColumn::temperature].resize(rows);
    history.has_temperature = file.has(history_path(static_cast<std::size_t>(HistoryColumn::temperature)));
    for (std::size_t i = 0; i < history.n_columns(); ++i) history.columns[i] = read_finite(file, history_path(i), {rows});
    const std::vector<double>& time = history[HistoryColumn::time];
    if (!std::is_sorted(time.begin(), time.end())) {
        throw InputError(fmt::format("{}: the times of {} do not ascend", file.name(), history_path(0)));
    }
    return history;
}

}  // namespace graincrack
