#include "post/measure/moduli.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "post/measure/thresholds.hpp"
#include "post/statistics/statistics.hpp"
#include "post/table/column.hpp"
#include "share/base/error.hpp"
#include "share/base/events.hpp"
#include "share/base/text.hpp"

namespace graincrack {

namespace {

/// Caveats of the moduli of a run; empty if there are none.
std::string warning(const Moduli& moduli, const std::string& kind) {
    std::string label;
    const auto add = [&](const std::string& more) { label += (label.empty() ? "" : "; ") + more; };
    if (kind != "drop") add("did not fail: fractions are of the largest stress");
    const double difference = moduli.chord.young_modulus / moduli.platen_young_modulus - 1;
    if (std::abs(difference) > gauge_tolerance) {
        add(
            fmt::format("E from the gauges is {:.0f} % {} than E from the platens: the specimen is not in equilibrium, or its "
                        "strain is not uniform",
                        100 * std::abs(difference), difference > 0 ? "larger" : "smaller"));
    }
    return label;
}

/// A row of the table.
struct ModuliRow {
    std::string file;
    std::string plane;
    std::optional<Moduli> measured;
    fpz::AssemblageModuli predicted;
    GrainModuli grains;
    std::string peak_kind;
    std::optional<AllThresholds> thresholds;  ///< of a compression test that had a peak

    [[nodiscard]] Cell pair(ElasticPair Moduli::*convention, double ElasticPair::*value) const {
        return measured ? Cell((*measured).*convention.*value) : Cell();
    }
    /// \param stress of `AllThresholds`
    template <class Stress>
    [[nodiscard]] Cell threshold(const Stress& stress) const {
        return thresholds ? Cell(std::invoke(stress, *thresholds)) : Cell();
    }
    [[nodiscard]] std::string caveat() const { return measured ? warning(*measured, peak_kind) : ""; }
};

ModuliRow read_moduli_row(const std::string& path) {
    const RunReader reader(path);
    const RunData run = run_data(reader);
    const Specimen specimen = reader.specimen();
    const LoadCurve curve = load_curve(run);
    ModuliRow row{run.name,
                  std::string(name_of(run.header.plane)),
                  measure_moduli(run),
                  predict_moduli(run.header, specimen),
                  grain_moduli(run.header, specimen),
                  peak_kind(run.header, curve.strength.has_value()),
                  {}};
    if (is_compression(run.header) && !row.peak_kind.empty()) {
        row.thresholds = measure_all_thresholds(run, curve, reader.cracks());
    }
    return row;
}

/// The four values by one convention, each under a prefix: "secant_", "plane_secant_".
void append_pair(Columns<ModuliRow>& columns, const std::string& prefix, ElasticPair Moduli::*convention) {
    const auto add = [&](const std::string& name, const ColumnUnit& unit, double ElasticPair::*value) {
        columns.push_back(
            {name, unit, [convention, value](const ModuliRow& r) { return r.pair(convention, value); }, !prefix.empty()});
    };
    add(prefix + "young_modulus", unit::gigapascal, &ElasticPair::young_modulus);
    add(prefix + "poisson_ratio", unit::none, &ElasticPair::poisson_ratio);
    add("plane_" + prefix + "young_modulus", unit::gigapascal, &ElasticPair::plane_young_modulus);
    add("plane_" + prefix + "poisson_ratio", unit::none, &ElasticPair::plane_poisson_ratio);
}

void append_thresholds(Columns<ModuliRow>& columns, const std::string& strain, Thresholds AllThresholds::*by_strain) {
    const auto add = [&](const std::string& name, std::optional<double> Thresholds::*stress) {
        columns.push_back({name + strain, unit::megapascal,
                           [by_strain, stress](const ModuliRow& r) {
                               return r.threshold([&](const AllThresholds& t) { return t.*by_strain.*stress; });
                           },
                           further});
    };
    add("crack_initiation_crack_strain_", &Thresholds::initiation_by_crack_strain);
    add("crack_damage_", &Thresholds::damage);
}

Cell initiation_of(const ModuliRow& r) { return r.threshold(&AllThresholds::initiation); }
Cell damage_of(const ModuliRow& r) { return r.threshold(&AllThresholds::damage); }
Cell of_platens(const ModuliRow& r) { return r.measured ? Cell(r.measured->platen_young_modulus) : Cell(); }

Columns<ModuliRow> all_columns() {
    using R = ModuliRow;
    using namespace unit;
    Columns<R> columns{{"file", none, [](const R& r) { return r.file; }}};
    append_pair(columns, "", &Moduli::chord);
    columns.insert(columns.end(), {{"platen_young_modulus", gigapascal, of_platens},
                                   {"predicted_young_modulus", gigapascal, [](const R& r) { return r.predicted.young_modulus; }},
                                   {"predicted_poisson_ratio", none, [](const R& r) { return r.predicted.poisson_ratio; }},
                                   {"voigt_young_modulus", gigapascal, [](const R& r) { return r.grains.voigt; }, further},
                                   {"reuss_young_modulus", gigapascal, [](const R& r) { return r.grains.reuss; }, further}});
    append_pair(columns, "tangent_", &Moduli::tangent);
    append_pair(columns, "average_", &Moduli::average);
    append_pair(columns, "secant_", &Moduli::secant);
    columns.push_back({"post_peak_slope_over_young_modulus", none,
                       [](const R& r) { return r.measured ? Cell(r.measured->post_peak_slope_ratio) : Cell(); }, further});
    columns.push_back({"peak_kind", none, [](const R& r) { return r.peak_kind; }, further});
    columns.push_back({"crack_initiation", megapascal, initiation_of});
    columns.push_back({"crack_damage", megapascal, damage_of});
    append_thresholds(columns, "2d", &AllThresholds::plane);
    append_thresholds(columns, "pseudo_3d", &AllThresholds::pseudo_3d);
    columns.push_back({"crack_initiation_count", megapascal,
                       [](const R& r) { return r.threshold(&AllThresholds::initiation_by_count); }, further});
    columns.push_back({"warning", none, [](const R& r) { return r.caveat(); }, further});
    columns.push_back({"crack_initiation_count_damage_10", megapascal,
                       [](const R& r) { return r.threshold(&AllThresholds::initiation_by_damage); }, further});
    columns.push_back({"plane", none, [](const R& r) { return r.plane; }, further});
    return columns;
}

const Columns<ModuliRow>& moduli_terminal_columns() {
    using R = ModuliRow;
    using namespace unit;
    static const Columns<R> all{
        {"run", none, [](const R& r) { return r.file; }},
        {"E", gigapascal, [](const R& r) { return r.pair(&Moduli::chord, &ElasticPair::young_modulus); }},
        {"ν", none, [](const R& r) { return r.pair(&Moduli::chord, &ElasticPair::poisson_ratio); }},
        {"E in the plane", gigapascal, [](const R& r) { return r.pair(&Moduli::chord, &ElasticPair::plane_young_modulus); }},
        {"ν in the plane", none, [](const R& r) { return r.pair(&Moduli::chord, &ElasticPair::plane_poisson_ratio); }},
        {"E by platens", gigapascal, of_platens},
        {"E predicted", gigapascal, [](const R& r) { return r.predicted.young_modulus; }},
        {"ν predicted", none, [](const R& r) { return r.predicted.poisson_ratio; }},
        {"E Voigt", gigapascal, [](const R& r) { return r.grains.voigt; }},
        {"E Reuss", gigapascal, [](const R& r) { return r.grains.reuss; }},
        {"crack initiation", megapascal, initiation_of},
        {"crack damage", megapascal, damage_of}};
    return all;
}

void write_moduli_to_terminal(std::ostream& out, const std::vector<ModuliRow>& rows) {
    TerminalTable table(moduli_terminal_columns());
    for (const std::string plane : {"strain", "stress"}) {
        const auto is_own = [&](const ModuliRow& r) { return r.plane == plane; };
        if (std::ranges::none_of(rows, is_own)) continue;
        table.group("plane " + plane +
                    (plane == "strain" ? ": E and ν are material values, converted from those in the plane" : ""));
        for (const ModuliRow& r : rows) {
            if (is_own(r)) table.row(cells_of(moduli_terminal_columns(), r));
        }
    }
    table.write(out);
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
ElasticPair elastic_pair(const Slopes& slopes, const RunSettings& header) {
    ElasticPair pair;
    pair.plane_young_modulus = slopes.stress;
    pair.plane_poisson_ratio = header.loading() == Loading::tension ? -slopes.lateral : slopes.lateral;
    const bool strain = header.plane == PlaneCondition::strain;
    pair.poisson_ratio = strain ? fpz::material_poisson_ratio(pair.plane_poisson_ratio) : pair.plane_poisson_ratio;
    pair.young_modulus = strain ? fpz::material_young_modulus(slopes.stress, pair.plane_poisson_ratio) : pair.plane_young_modulus;
    return pair;
}

std::optional<double> post_peak_slope(const RunData& run, const LoadCurve& curve) {
    const double level = (1 - decisive_drop(run.header)) * curve.stress[curve.peak];
    for (std::size_t row = curve.peak + 1; row < curve.stress.size(); ++row) {
        if (curve.stress[row] > level) continue;
        return (curve.stress[curve.peak] - curve.stress[row]) / (curve.axial_strain[row] - curve.axial_strain[curve.peak]);
    }
    return std::nullopt;
}

/// Stiffness of all contacts in series: their length over the sum of their lengths over their stiffnesses.
double mean_stiffness(const RunSettings& header, const Specimen& specimen, const std::vector<std::uint8_t>& classes,
                      ContactValue stiffness) {
    double whole = 0;
    double compliance = 0;
    for (std::size_t c = 0; c < classes.size(); ++c) {
        const double length = contact_length(specimen, c);
        whole += length;
        compliance += length / (header.fabric.contacts.at(classes[c]).*stiffness);
    }
    return whole / compliance;
}

}  // namespace

std::optional<Moduli> measure_moduli(const RunData& run) {
    if (run.header.loading() == Loading::splitting || run.header.loading() == Loading::bending) return std::nullopt;
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
    for (std::size_t c = 0; c < specimen.n_contacts(); ++c) length += contact_length(specimen, c);
    return length / std::accumulate(specimen.grain_area.begin(), specimen.grain_area.end(), 0.0);
}

GrainModuli grain_moduli(const RunSettings& header, const Specimen& specimen) {
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

fpz::AssemblageModuli predict_moduli(const RunSettings& header, const Specimen& specimen) {
    Rock rock = header.rock;
    double normal = header.contact.normal_stiffness;
    double shear = header.contact.shear_stiffness;
    if (header.fabric.contacts.size() > 1) {
        const GrainModuli grains = grain_moduli(header, specimen);
        rock.young_modulus = grains.hill();
        rock.poisson_ratio = grains.poisson_ratio;
        const std::vector<std::uint8_t> classes = contact_classes(specimen);
        if (!classes.empty()) {
            normal = mean_stiffness(header, specimen, classes, &ContactParameters::normal_stiffness);
            shear = mean_stiffness(header, specimen, classes, &ContactParameters::shear_stiffness);
        }
    }
    return fpz::assemblage_moduli(rock, header.plane, normal, shear, contact_length_per_area(specimen));
}

void write_moduli_table(std::ostream& out, const std::vector<std::string>& runs, TableFormat format, std::ostream& diagnostics,
                        ColumnChoice columns) {
    std::vector<ModuliRow> rows;
    for (const std::string& run : runs) rows.push_back(read_moduli_row(run));
    if (format == TableFormat::aligned) {
        write_moduli_to_terminal(out, rows);
    } else {
        write_table(out, all_columns(), rows, format, columns);
    }
    out.flush();
    if (!out) return;  // the command says so
    for (const ModuliRow& r : rows) {
        if (const std::string caveat = r.caveat(); !caveat.empty()) {
            warn(diagnostics, "moduli: " + printable(r.file), {caveat, "moduli"}, r.file);
        }
    }
}

}  // namespace graincrack
