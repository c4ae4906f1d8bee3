#include "post/measure/toughness.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <sstream>

#include "post/measure/moduli.hpp"
#include "post/measure/strength.hpp"
#include "post/table/column.hpp"
#include "share/base/error.hpp"
#include "share/base/printable.hpp"
#include "share/base/units.hpp"
#include "share/file/notch.hpp"
#include "share/file/schema.hpp"

namespace graincrack {

namespace {

/// How far the middle of a notch may lie from that of the specimen, as a share of the width.
constexpr double central = 0.1;

/// The notch that the mesher was asked for, m; empty if the run does not say, or not so that it can be read.
std::optional<double> requested_notch(const RunReader& reader) {
    const std::string key = "notch = \"";
    try {
        std::istringstream lines(reader.file().attribute_or<std::string>(schema::provenance_group, "specimen_configuration", ""));
        for (std::string line; std::getline(lines, line);) {
            if (!line.starts_with(key)) continue;
            const std::string value = line.substr(key.size(), line.find('"', key.size()) - key.size());
            return parse_quantity(value, quantity::notch, "notch");
        }
    } catch (const Error&) {
        return std::nullopt;
    }
    return std::nullopt;
}

struct ToughnessRow {
    RunData run;
    Toughness toughness;
};

using R = ToughnessRow;

const Columns<R>& columns() {
    using namespace unit;
    static const Columns<R> all{
        {"file", none, [](const R& r) { return r.run.name; }},
        {"seed", none, [](const R& r) { return r.run.specimen.seed; }},
        {"grains", none, [](const R& r) { return r.run.specimen.grains; }},
        {"mean_edge", millimetre, [](const R& r) { return r.run.specimen.mean_edge; }},
        {"notch", millimetre, [](const R& r) { return r.toughness.notch_length; }},
        {"strength", megapascal, [](const R& r) { return r.toughness.strength; }},
        {"mode_i_toughness", unit::toughness, [](const R& r) { return r.toughness.mode_i_toughness; }},
        {"predicted_mode_i_toughness", unit::toughness, [](const R& r) { return r.toughness.predicted; }},
        {"requested_notch", millimetre, [](const R& r) { return r.toughness.requested_notch_length; }},
        {"characteristic_length", millimetre, [](const R& r) { return r.toughness.characteristic_length; }},
        {"half_notch_over_characteristic_length", none, [](const R& r) { return r.toughness.notch_ratio(); }},
        {"warning", none, [](const R& r) { return r.toughness.warning(); }},
        {"plane", none, [](const R& r) { return name_of(r.run.header.plane); }}};
    return all;
}

}  // namespace

double centre_crack_intensity(double stress, double length, double width) {
    const double half = 0.5 * length;
    return stress * std::sqrt(std::numbers::pi * half / std::cos(std::numbers::pi * half / width));
}

Toughness measure_toughness(const RunData& run, const Specimen& specimen) {
    const auto ends = notch_ends(specimen);
    if (run.header.test != "tension" || !ends || std::abs((*ends)[0] + (*ends)[1]) > 2 * central * specimen.width) {
        throw InputError(run.name +
                         ": toughness needs a tension test of a rectangle with a notch through its middle "
                         "(graincrack-mesh rectangle --notch)");
    }
    if (!((*ends)[1] - (*ends)[0] < (1 - 1e-9) * specimen.width)) {
        throw InputError(run.name + ": a joint through the whole width has no toughness; a shorter --notch has one");
    }
    const Strength strength = measure_strength(run);
    stopped_at_strain_limit(run, strength, StrainLimitRuns::refuse, "a toughness");
    Toughness toughness;
    toughness.notch_length = (*ends)[1] - (*ends)[0];
    toughness.strength = strength.value();
    toughness.mode_i_toughness = centre_crack_intensity(toughness.strength, toughness.notch_length, specimen.width);
    toughness.predicted =
        std::sqrt(predict_moduli(run.header, specimen).plane_young_modulus * run.header.contact.fracture_energy);
    toughness.characteristic_length = std::pow(toughness.predicted / run.header.contact.tensile_strength, 2);
    return toughness;
}

Toughness measure_toughness(const RunReader& reader, const RunData& run) {
    Toughness toughness = measure_toughness(run, reader.specimen());
    toughness.requested_notch_length = requested_notch(reader);
    return toughness;
}

std::string Toughness::warning() const {
    std::string label;
    const auto add = [&](const std::string& more) { label += (label.empty() ? "" : "; ") + more; };
    if (!(notch_ratio() >= min_notch_ratio)) {
        add(
            fmt::format("a/l_ch is {:.2g}, below {:g}: the process zone is not small against the notch, so that the measured "
                        "toughness is not K_IC; use a longer notch or a smaller fracture energy",
                        notch_ratio(), min_notch_ratio));
    }
    if (requested_notch_length && std::abs(notch_length / *requested_notch_length - 1) > notch_tolerance) {
        add(fmt::format("the notch is {:.1f} mm long, where {:.1f} mm was requested; K_IC is computed with {:.1f} mm",
                        notch_length * 1e3, *requested_notch_length * 1e3, notch_length * 1e3));
    }
    return label;
}

void write_toughness_table(std::ostream& out, const std::vector<std::string>& runs, TableFormat format,
                           std::ostream& diagnostics) {
    std::vector<ToughnessRow> rows;
    for (const std::string& path : runs) {
        const RunReader reader(path);
        ToughnessRow& row = rows.emplace_back(ToughnessRow{run_data(reader), {}});
        row.toughness = measure_toughness(reader, row.run);
    }
    write_table(out, columns(), rows, format);
    out.flush();
    if (!out) return;  // the command says so
    for (const ToughnessRow& row : rows) {
        const std::string warning = row.toughness.warning();
        if (!warning.empty()) diagnostics << "toughness: " << printable(row.run.name) << ": warning: " << warning << '\n';
    }
}

}  // namespace graincrack
