#include "post/moduli.hpp"

#include <cmath>
#include <limits>
#include <numeric>

#include "share/error.hpp"

namespace graincrack {

namespace {

const std::vector<std::string> columns{"file",
                                       "young_modulus_GPa",
                                       "poisson_ratio",
                                       "plane_young_modulus_GPa",
                                       "plane_poisson_ratio",
                                       "platen_young_modulus_GPa",
                                       "predicted_young_modulus_GPa",
                                       "predicted_poisson_ratio"};

std::vector<Cell> moduli_row(const std::string& path) {
    const RunReader reader(path);
    const RunData run = run_data(reader);
    const std::optional<Moduli> measured = measure_moduli(run);
    const fpz::AssemblageModuli predicted = predict_moduli(run.header, reader.specimen());
    std::vector<Cell> row(columns.size());
    row[0] = run.name;
    if (measured) {
        row[1] = measured->young_modulus * 1e-9;
        row[2] = measured->poisson_ratio;
        row[3] = measured->plane_young_modulus * 1e-9;
        row[4] = measured->plane_poisson_ratio;
        row[5] = measured->platen_young_modulus * 1e-9;
    }
    row[6] = predicted.young_modulus * 1e-9;
    row[7] = predicted.poisson_ratio;
    return row;
}

}  // namespace

std::optional<Moduli> measure_moduli(const RunData& run) {
    if (run.header.test == "brazilian") return std::nullopt;
    const LoadCurve curve = load_curve(run);
    const CurvePoint half = half_peak(curve);
    const auto change = [&](const std::vector<double>& column) { return half.of(column) - column[curve.start]; };
    const double stress = change(curve.stress);
    const double strain = change(curve.gauge_axial_strain);
    const double platen_strain = change(curve.axial_strain);
    if (!(strain > 0) || !(platen_strain > 0)) {
        throw InputError(run.name + ": the axial strain does not grow up to half the peak; no modulus can be measured");
    }
    // Elongation across over shortening along; in a tension test the specimen narrows while it lengthens.
    const double sense = run.header.test == "tension" ? -1 : 1;
    Moduli moduli;
    moduli.plane_young_modulus = stress / strain;
    moduli.plane_poisson_ratio = sense * change(curve.gauge_lateral_strain) / strain;
    moduli.young_modulus = moduli.plane_young_modulus;
    moduli.poisson_ratio = moduli.plane_poisson_ratio;
    moduli.platen_young_modulus = stress / platen_strain;
    if (run.header.plane == PlaneCondition::strain) {
        moduli.poisson_ratio = fpz::material_poisson_ratio(moduli.plane_poisson_ratio);
        moduli.young_modulus = fpz::material_young_modulus(moduli.plane_young_modulus, moduli.plane_poisson_ratio);
        moduli.platen_young_modulus = fpz::material_young_modulus(moduli.platen_young_modulus, moduli.plane_poisson_ratio);
    }
    return moduli;
}

double contact_length_per_area(const Specimen& specimen) {
    double length = 0;
    for (const auto& nodes : specimen.contact_nodes) {
        const auto& from = specimen.node_position[static_cast<std::size_t>(nodes[0])];
        const auto& to = specimen.node_position[static_cast<std::size_t>(nodes[1])];
        length += std::hypot(to[0] - from[0], to[1] - from[1]);
    }
    return length / std::accumulate(specimen.grain_area.begin(), specimen.grain_area.end(), 0.0);
}

fpz::AssemblageModuli predict_moduli(const RunHeader& header, const Specimen& specimen) {
    return fpz::assemblage_moduli(header.rock, header.plane, header.contact.normal_stiffness, header.contact.shear_stiffness,
                                  contact_length_per_area(specimen));
}

void write_moduli_table(std::ostream& out, const std::vector<std::string>& runs, TableFormat format) {
    std::vector<std::vector<Cell>> rows;
    rows.reserve(runs.size());
    for (const std::string& path : runs) rows.push_back(moduli_row(path));
    TableWriter table(out, columns, format);
    for (const auto& row : rows) table.row(row);
}

}  // namespace graincrack
