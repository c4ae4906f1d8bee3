#include "post/measure/moduli.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numeric>

#include "post/measure/terminal_tables.hpp"
#include "post/measure/thresholds.hpp"
#include "post/statistics/statistics.hpp"
#include "share/base/error.hpp"

namespace graincrack {

namespace {

const std::vector<std::string> columns{"file",
                                       "young_modulus_GPa",
                                       "poisson_ratio",
                                       "plane_young_modulus_GPa",
                                       "plane_poisson_ratio",
                                       "platen_young_modulus_GPa",
                                       "predicted_young_modulus_GPa",
                                       "predicted_poisson_ratio",
                                       "voigt_young_modulus_GPa",
                                       "reuss_young_modulus_GPa",
                                       "tangent_young_modulus_GPa",
                                       "tangent_poisson_ratio",
                                       "plane_tangent_young_modulus_GPa",
                                       "plane_tangent_poisson_ratio",
                                       "average_young_modulus_GPa",
                                       "average_poisson_ratio",
                                       "plane_average_young_modulus_GPa",
                                       "plane_average_poisson_ratio",
                                       "secant_young_modulus_GPa",
                                       "secant_poisson_ratio",
                                       "plane_secant_young_modulus_GPa",
                                       "plane_secant_poisson_ratio",
                                       "post_peak_slope_over_young_modulus",
                                       "peak_kind",
                                       "crack_initiation_crack_strain_2d_MPa",
                                       "crack_initiation_lateral_response_2d_MPa",
                                       "crack_damage_2d_MPa",
                                       "crack_initiation_crack_strain_pseudo_3d_MPa",
                                       "crack_initiation_lateral_response_pseudo_3d_MPa",
                                       "crack_damage_pseudo_3d_MPa",
                                       "crack_initiation_count_MPa",
                                       "threshold_note",
                                       "warning",
                                       "crack_initiation_count_damage_10_MPa",
                                       "crack_initiation_count_damage_50_MPa",
                                       "crack_initiation_count_damage_90_MPa",
                                       "plane"};
constexpr std::size_t n_damage_columns = std::tuple_size_v<InitiationByDamage>;

void append(std::vector<Cell>& row, const ElasticPair& pair) {
    for (const Cell& cell : {Cell(pair.young_modulus * 1e-9), Cell(pair.poisson_ratio), Cell(pair.plane_young_modulus * 1e-9),
                             Cell(pair.plane_poisson_ratio)}) {
        row.push_back(cell);
    }
}

Cell megapascal(const std::optional<double>& stress) { return stress ? Cell(*stress * 1e-6) : Cell(); }

/// Thresholds of a compression test that had a peak, by both definitions of volumetric strain, with the name of each definition.
void append_thresholds(std::vector<Cell>& row, const RunData& run, const LoadCurve& curve) {
    for (const VolumeKind kind : {VolumeKind::plane, VolumeKind::pseudo_3d}) {
        const Thresholds thresholds = measure_thresholds(curve, kind);
        row.push_back(megapascal(thresholds.initiation_by_crack_strain));
        row.push_back(megapascal(thresholds.initiation_by_lateral_response));
        row.push_back(megapascal(thresholds.damage));
    }
    row.push_back(megapascal(initiation_by_count(run, curve)));
    row.emplace_back(std::string("plane ") + std::string(name_of(run.header.plane)) +
                     ": thresholds by 2D strains do not compare with laboratory ones directly");
}

/// Caveats of the moduli of a run; empty if there are none.
std::string warning(const Moduli& moduli, const std::string& kind) {
    std::string label;
    const auto add = [&](const std::string& more) { label += (label.empty() ? "" : "; ") + more; };
    if (kind != "drop") add("no peak: fractions are of the largest stress");
    const double difference = moduli.chord.young_modulus / moduli.platen_young_modulus - 1;
    if (std::abs(difference) > gauge_tolerance) {
        add(
            fmt::format("E from the gauges is {:.0f} % {} than E from the platens: the specimen is not in equilibrium, or its "
                        "strain is not uniform",
                        100 * std::abs(difference), difference > 0 ? "larger" : "smaller"));
    }
    return label;
}

std::vector<Cell> moduli_row(const std::string& path) {
    const RunReader reader(path);
    const RunData run = run_data(reader);
    const std::optional<Moduli> measured = measure_moduli(run);
    const Specimen specimen = reader.specimen();
    const fpz::AssemblageModuli predicted = predict_moduli(run.header, specimen);
    const GrainModuli grains = grain_moduli(run.header, specimen);
    const LoadCurve curve = load_curve(run);
    const std::string kind = peak_kind(run, curve);
    std::vector<Cell> row{run.name};
    if (measured) append(row, measured->chord);
    row.resize(5);
    row.push_back(measured ? Cell(measured->platen_young_modulus * 1e-9) : Cell());
    row.emplace_back(predicted.young_modulus * 1e-9);
    row.emplace_back(predicted.poisson_ratio);
    row.emplace_back(grains.voigt * 1e-9);
    row.emplace_back(grains.reuss * 1e-9);
    if (measured) {
        for (const ElasticPair& pair : {measured->tangent, measured->average, measured->secant}) append(row, pair);
        row.push_back(cell(measured->post_peak_slope_ratio));
    }
    row.resize(23);
    row.emplace_back(kind);
    if (is_compression(run.header) && !kind.empty()) append_thresholds(row, run, curve);
    row.resize(columns.size() - n_damage_columns - 2);
    row.push_back(measured ? Cell(warning(*measured, kind)) : Cell());
    if (is_compression(run.header) && !kind.empty()) {
        for (const auto& stress : initiation_by_damage(run, curve, reader.cracks())) row.push_back(megapascal(stress));
    }
    row.resize(columns.size() - 1);
    row.emplace_back(std::string(name_of(run.header.plane)));
    return row;
}

/// Slopes of a curve: stress and lateral strain, each by axial strain.
struct Slopes {
    double stress = 0;
    double lateral = 0;
};

Slopes chord(const LoadCurve& curve, const CurvePoint& end, const std::vector<double>& axial) {
    const auto change = [&](const std::vector<double>& column) { return end.of(column) - column[curve.start]; };
    return {change(curve.stress) / change(axial), change(curve.gauge_lateral_strain) / change(axial)};
}

Slopes regression(const LoadCurve& curve, double low_share, double high_share) {
    const RowRange rows = rows_between(curve, low_share, high_share);
    const auto part = [&](const std::vector<double>& column) {
        return std::span(column).subspan(rows.begin, rows.end - rows.begin);
    };
    const auto stress = fit_line(part(curve.gauge_axial_strain), part(curve.stress));
    const auto lateral = fit_line(part(curve.gauge_axial_strain), part(curve.gauge_lateral_strain));
    return stress && lateral ? Slopes{stress->slope, lateral->slope} : Slopes{std::nan(""), std::nan("")};
}

/// In a tension test the specimen narrows while it lengthens.
ElasticPair elastic_pair(const Slopes& slopes, const RunHeader& header) {
    ElasticPair pair;
    pair.plane_young_modulus = slopes.stress;
    pair.plane_poisson_ratio = header.test == "tension" ? -slopes.lateral : slopes.lateral;
    const bool strain = header.plane == PlaneCondition::strain;
    pair.poisson_ratio = strain ? fpz::material_poisson_ratio(pair.plane_poisson_ratio) : pair.plane_poisson_ratio;
    pair.young_modulus = strain ? fpz::material_young_modulus(slopes.stress, pair.plane_poisson_ratio) : pair.plane_young_modulus;
    return pair;
}

std::optional<double> post_peak_slope(const RunData& run, const LoadCurve& curve) {
    const double level = (1 - decisive_drop(run.header)) * curve.peak_stress();
    for (std::size_t row = curve.peak + 1; row < curve.stress.size(); ++row) {
        if (curve.stress[row] > level) continue;
        return (curve.peak_stress() - curve.stress[row]) / (curve.axial_strain[row] - curve.axial_strain[curve.peak]);
    }
    return std::nullopt;
}

}  // namespace

std::optional<Moduli> measure_moduli(const RunData& run) {
    if (run.header.test == "brazilian") return std::nullopt;
    const LoadCurve curve = load_curve(run);
    const CurvePoint half = half_peak(curve);
    const auto grows = [&](const std::vector<double>& strain) { return half.of(strain) > strain[curve.start]; };
    if (!grows(curve.gauge_axial_strain) || !grows(curve.axial_strain)) {
        throw InputError(run.name + ": the axial strain does not grow up to half the peak; no modulus can be measured");
    }
    Moduli moduli;
    moduli.chord = elastic_pair(chord(curve, half, curve.gauge_axial_strain), run.header);
    moduli.tangent = elastic_pair(regression(curve, 0.4, 0.6), run.header);
    moduli.average = elastic_pair(regression(curve, 0.2, 0.8), run.header);
    moduli.secant = elastic_pair(chord(curve, {curve.peak, 0}, curve.gauge_axial_strain), run.header);
    const double platen = chord(curve, half, curve.axial_strain).stress;
    moduli.platen_young_modulus = run.header.plane == PlaneCondition::strain
                                      ? fpz::material_young_modulus(platen, moduli.chord.plane_poisson_ratio)
                                      : platen;
    if (const auto slope = post_peak_slope(run, curve)) moduli.post_peak_slope_ratio = *slope / platen;
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

GrainModuli grain_moduli(const RunHeader& header, const Specimen& specimen) {
    const std::vector<double> fractions = phase_fractions(specimen);
    GrainModuli grains;
    double compliance = 0;
    for (std::size_t p = 0; p < fractions.size(); ++p) {
        const Phase& phase = header.fabric.phases.at(p);
        grains.voigt += fractions[p] * phase.young_modulus;
        compliance += fractions[p] / phase.young_modulus;
        grains.poisson_ratio += fractions[p] * phase.poisson_ratio;
    }
    grains.reuss = 1 / compliance;
    return grains;
}

namespace {

/// Stiffness of all contacts in series over their number: one of many classes by its mean compliance.
double mean_stiffness(const RunHeader& header, const std::vector<std::uint8_t>& classes, ContactValue stiffness) {
    double compliance = 0;
    for (const std::uint8_t each : classes) compliance += 1 / (header.fabric.contacts.at(each).*stiffness);
    return static_cast<double>(classes.size()) / compliance;
}

}  // namespace

fpz::AssemblageModuli predict_moduli(const RunHeader& header, const Specimen& specimen) {
    Rock rock = header.rock;
    double normal = header.contact.normal_stiffness;
    double shear = header.contact.shear_stiffness;
    if (header.fabric.phases.size() > 1) {
        const GrainModuli grains = grain_moduli(header, specimen);
        rock.young_modulus = grains.hill();
        rock.poisson_ratio = grains.poisson_ratio;
        const std::vector<std::uint8_t> classes = contact_classes(specimen);
        if (!classes.empty()) {
            normal = mean_stiffness(header, classes, &ContactParameters::normal_stiffness);
            shear = mean_stiffness(header, classes, &ContactParameters::shear_stiffness);
        }
    }
    return fpz::assemblage_moduli(rock, header.plane, normal, shear, contact_length_per_area(specimen));
}

void write_moduli_table(std::ostream& out, const std::vector<std::string>& runs, std::optional<TableFormat> format) {
    if (format) {
        write_file_rows(out, columns, runs, moduli_row, *format);
        return;
    }
    std::vector<std::vector<Cell>> rows;
    for (const std::string& run : runs) rows.push_back(moduli_row(run));
    write_moduli_to_terminal(out, {columns, rows});
}

}  // namespace graincrack
