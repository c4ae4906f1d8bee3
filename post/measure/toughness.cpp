#include "post/measure/toughness.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "post/measure/moduli.hpp"
#include "post/measure/strength.hpp"
#include "share/error.hpp"

namespace graincrack {

namespace {

/// How far the middle of a notch may lie from that of the specimen, as a share of the width.
constexpr double central = 0.1;

/// Ends of the notch along x, m; the first above the second if there is none.
std::pair<double, double> notch_ends(const Specimen& s) {
    double left = std::numeric_limits<double>::infinity();
    double right = -left;
    for (std::size_t c = 0; c < s.n_contacts(); ++c) {
        if (s.contact_kind[c] != static_cast<std::uint8_t>(ContactKind::pre_existing_crack)) continue;
        for (const std::int32_t node : s.contact_nodes[c]) {
            const double x = s.node_position[static_cast<std::size_t>(node)][0];
            left = std::min(left, x);
            right = std::max(right, x);
        }
    }
    return {left, right};
}

std::vector<Cell> toughness_row(const std::string& path) {
    const RunReader reader(path);
    const RunData run = run_data(reader);
    const Toughness toughness = measure_toughness(run, reader.specimen());
    return {run.name,
            run.specimen.seed,
            run.specimen.grains,
            run.specimen.mean_edge * 1e3,
            toughness.notch_length * 1e3,
            toughness.strength * 1e-6,
            toughness.mode_i_toughness * 1e-6,
            toughness.predicted * 1e-6};
}

}  // namespace

double centre_crack_intensity(double stress, double length, double width) {
    const double half = 0.5 * length;
    return stress * std::sqrt(std::numbers::pi * half / std::cos(std::numbers::pi * half / width));
}

Toughness measure_toughness(const RunData& run, const Specimen& specimen) {
    const auto [left, right] = notch_ends(specimen);
    if (run.header.test != "tension" || !(left < right) || std::abs(left + right) > 2 * central * specimen.width) {
        throw InputError(run.name +
                         ": toughness needs a tension test of a rectangle with a notch through its middle "
                         "(graincrack-mesh rectangle --notch)");
    }
    const Strength strength = measure_strength(run);
    stopped_at_strain_limit(run, strength, StrainLimitRuns::refuse, "a toughness");
    Toughness toughness;
    toughness.notch_length = right - left;
    toughness.strength = strength.value();
    toughness.mode_i_toughness = centre_crack_intensity(toughness.strength, toughness.notch_length, specimen.width);
    toughness.predicted =
        std::sqrt(predict_moduli(run.header, specimen).plane_young_modulus * run.header.contact.fracture_energy);
    return toughness;
}

void write_toughness_table(std::ostream& out, const std::vector<std::string>& runs, TableFormat format) {
    static const std::vector<std::string> columns{"file",
                                                  "seed",
                                                  "grains",
                                                  "mean_edge_mm",
                                                  "notch_mm",
                                                  "strength_MPa",
                                                  "mode_i_toughness_MPa.m^0.5",
                                                  "predicted_mode_i_toughness_MPa.m^0.5"};
    write_file_rows(out, columns, runs, toughness_row, format);
}

}  // namespace graincrack
