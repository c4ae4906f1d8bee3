#include "post/measure/toughness.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "post/measure/moduli.hpp"
#include "post/measure/strength.hpp"
#include "post/run/crystals.hpp"
#include "post/table/column.hpp"
#include "share/base/error.hpp"
#include "share/base/events.hpp"
#include "share/base/text.hpp"
#include "share/base/units.hpp"
#include "share/file/specimen_measures.hpp"

namespace graincrack {

double nominal_bending_stress(double load, double span, double height) { return 1.5 * load * span / (height * height); }

double notched_beam_intensity(double load, double notch, double span, double height) {
    const double a = notch / height;
    const double b = 1 - a;
    const double four_heights = 1.9 - a * (-0.089 + 0.603 * b - 0.441 * b * b + 1.223 * b * b * b);
    const double pure_bending = 1.989 - a * b * (0.448 - 0.458 * b + 1.226 * b * b);
    const double p = pure_bending + 4 * height / span * (four_heights - pure_bending);
    const double shape = std::sqrt(a) * p / (std::pow(b, 1.5) * (1 + 2 * a));
    return nominal_bending_stress(load, span, height) * std::sqrt(height) * shape;
}

double half_disc_intensity(double load, double notch, double span, double radius) {
    const double s = span / (2 * radius);
    const double b = notch / radius;
    const double shape = -1.297 + 9.516 * s - (0.47 + 16.457 * s) * b + (1.071 + 34.401 * s) * b * b;
    return load * std::sqrt(std::numbers::pi * notch) / (2 * radius) * shape;
}

double total_fracture_energy(const ContactParameters& contact) {
    const double tc = contact.tensile_strength;
    const double bridge = contact.bridging_strength;
    const double brittle_end = 2 * contact.fracture_energy / tc;
    const double bridge_end = bridge > 0 ? 2 * contact.bridging_energy / bridge : 0;
    if (bridge_end <= brittle_end) return contact.fracture_energy;
    const double crossing = (tc - bridge) / (tc / brittle_end - bridge / bridge_end);
    return contact.fracture_energy + bridge * fpz::square(bridge_end - crossing) / (2 * bridge_end) -
           tc * fpz::square(brittle_end - crossing) / (2 * brittle_end);
}

namespace {

/// How far the middle of a notch may lie from that of the specimen, as a share of the width.
constexpr double central = 0.1;

/// The specimen of a measured toughness, to the longest crack for which its formula may serve.
CrackedSpecimen cracked_specimen(const Toughness& toughness, const std::string& shape, double span) {
    constexpr double of_beam = 0.9;       // Guinea et al.: any notch
    constexpr double of_half_disc = 0.8;  // beyond the suggested method's 0.6, where Y' is a parabola
    constexpr double of_plate = 0.7;      // Feddersen
    const double a = toughness.crack_length;
    const double size = toughness.size;
    if (shape == "beam") return {a, of_beam * size, [=](double x) { return notched_beam_intensity(1, x, span, size); }};
    if (shape == "half-disc") {
        return {a, of_half_disc * size / 2, [=](double x) { return half_disc_intensity(1, x, span, size / 2); }};
    }
    return {a, of_plate * size / 2, [=](double x) { return centre_crack_intensity(1, 2 * x, size); }};
}

/// The slit that the mesher was asked for, m; empty if the run does not say.
std::optional<double> requested_slit(const RunData& run) {
    const double length = number_of(run.specimen.settings, "slit");
    return std::isfinite(length) ? std::optional(length) : std::nullopt;
}

/// Notch, ligament and stress intensity at the largest load of a plate in tension.
Toughness of_plate(const RunData& run, const Specimen& specimen, const Strength& strength) {
    const auto ends = notch_ends(specimen);
    if (!ends || std::abs((*ends)[0] + (*ends)[1]) > 2 * central * specimen.width) {
        throw InputError(run.name +
                         ": toughness needs a tension test of a rectangle with a notch through its middle "
                         "(graincrack-mesh rectangle --slit)");
    }
    Toughness toughness;
    toughness.notch_length = (*ends)[1] - (*ends)[0];
    if (!(toughness.notch_length < (1 - 1e-9) * specimen.width)) {
        throw InputError(run.name + ": a joint through the whole width has no toughness; a shorter --slit has one");
    }
    toughness.crack_length = toughness.notch_length / 2;
    toughness.size = specimen.width;
    toughness.ligament = (specimen.width - toughness.notch_length) / 2;
    toughness.mode_i_toughness = centre_crack_intensity(strength.peak.stress, toughness.notch_length, specimen.width);
    return toughness;
}

/// The same of a beam or half-disc in bending.
Toughness of_bending(const RunData& run, const Specimen& specimen, const Strength& strength) {
    const bool is_beam = specimen.shape == "beam";
    const auto notch = edge_notch(specimen);
    if (!notch || std::abs(notch->mouth[0]) > central * specimen.height ||
        std::abs(notch->tip[0] - notch->mouth[0]) > central * specimen.height) {
        throw InputError(
            fmt::format("{}: toughness needs a {} with a notch from the middle of its lower side (graincrack-mesh {} --slit)",
                        run.name, specimen.shape, specimen.shape));
    }
    Toughness toughness;
    toughness.notch_length = toughness.crack_length = notch->length();
    toughness.ligament = specimen.height - toughness.notch_length;
    toughness.size = is_beam ? specimen.height : specimen.width;
    if (!(toughness.ligament > 1e-9 * specimen.height)) {
        throw InputError(run.name + ": a joint through the whole height has no toughness; a shorter notch has one");
    }
    const double span = run.header.span;
    if (is_beam) {
        toughness.mode_i_toughness = notched_beam_intensity(strength.peak.load, toughness.notch_length, span, specimen.height);
        if (span < least_span_of_beam * specimen.height) {
            toughness.outside = fmt::format("the span is {:.2g} heights; the formula is for {:g} at least",
                                            span / specimen.height, least_span_of_beam);
        }
        return toughness;
    }
    const double radius = specimen.width / 2;
    toughness.mode_i_toughness = half_disc_intensity(strength.peak.load, toughness.notch_length, span, radius);
    const double share = span / (2 * radius);
    const double notch_share = toughness.notch_length / radius;
    const auto is_within = [](double value, double low, double high) { return value > low - 0.01 && value < high + 0.01; };
    if (!is_within(share, least_span_of_half_disc, largest_span_of_half_disc) ||
        !is_within(notch_share, least_notch_of_half_disc, largest_notch_of_half_disc)) {
        toughness.outside = fmt::format(
            "span/2R is {:.2f} and a/R {:.2f}; the suggested method has {:g} to {:g} and {:g} to {:g}", share, notch_share,
            least_span_of_half_disc, largest_span_of_half_disc, least_notch_of_half_disc, largest_notch_of_half_disc);
    }
    return toughness;
}

/// Root of the mean of K_I² over cracks from a to a + ρ, over K_I of a.
double mean_intensity(const CrackedSpecimen& specimen, double zone) {
    constexpr int n = 64;
    double sum = 0;
    for (int i = 0; i < n; ++i) sum += std::pow(specimen.intensity(specimen.crack + (i + 0.5) / n * zone), 2);
    return std::sqrt(sum / n) / specimen.intensity(specimen.crack);
}

struct ToughnessRow {
    RunData run;
    Toughness toughness;
};

const Columns<ToughnessRow>& toughness_columns() {
    using R = ToughnessRow;
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
        {"plane", none, [](const R& r) { return name_of(r.run.header.plane); }},
        {"test", none, [](const R& r) { return r.run.header.test; }},
        {"shape", none, [](const R& r) { return r.run.specimen.shape; }},
        {"peak_load", kilonewton_per_metre, [](const R& r) { return r.toughness.peak_load; }},
        {"span", millimetre, [](const R& r) { return r.run.header.span > 0 ? Cell(r.run.header.span) : Cell(); }},
        {"ligament_over_characteristic_length", none, [](const R& r) { return r.toughness.ligament_ratio(); }},
        {"size", millimetre, [](const R& r) { return r.toughness.size; }},
        {"zone", millimetre, [](const R& r) { return r.toughness.zone; }},
        {"strip_yield_mode_i_toughness", unit::toughness, [](const R& r) { return r.toughness.by_strip_yield; }},
        {"mode_i_toughness_at_infinite_size", unit::toughness, [](const R& r) { return r.toughness.at_infinite_size; }}};
    return all;
}

const Columns<ToughnessRow>& toughness_terminal_columns() {
    using R = ToughnessRow;
    using namespace unit;
    static const Columns<R> all{{"run", none, [](const R& r) { return r.run.name; }},
                                {"test", none, [](const R& r) { return r.run.header.test; }},
                                {"seed", none, [](const R& r) { return r.run.specimen.seed; }},
                                {"size", millimetre, [](const R& r) { return r.toughness.size; }},
                                {"notch", millimetre, [](const R& r) { return r.toughness.notch_length; }},
                                {"peak load", kilonewton_per_metre, [](const R& r) { return r.toughness.peak_load; }},
                                {"K_IC", unit::toughness, [](const R& r) { return r.toughness.mode_i_toughness; }},
                                {"at infinite size", unit::toughness, [](const R& r) { return r.toughness.at_infinite_size; }},
                                {"of a straight crack", unit::toughness, [](const R& r) { return r.toughness.predicted; }},
                                {"that at this size", unit::toughness, [](const R& r) { return r.toughness.by_strip_yield; }},
                                {"zone", millimetre, [](const R& r) { return r.toughness.zone; }},
                                {"notch / process zone", none, [](const R& r) { return r.toughness.notch_ratio(); }}};
    return all;
}

}  // namespace

double centre_crack_intensity(double stress, double length, double width) {
    const double half = 0.5 * length;
    return stress * std::sqrt(std::numbers::pi * half / std::cos(std::numbers::pi * half / width));
}

double strip_yield_zone(double shown, double tensile_strength) {
    return std::numbers::pi / 8 * std::pow(shown / tensile_strength, 2);
}

std::optional<double> toughness_at_infinite_size(double shown, double tensile_strength, const CrackedSpecimen& specimen) {
    const double zone = strip_yield_zone(shown, tensile_strength);
    if (!(specimen.crack + zone <= specimen.deepest)) return std::nullopt;
    return shown * mean_intensity(specimen, zone);
}

std::optional<double> toughness_at_size(double infinite, double tensile_strength, const CrackedSpecimen& specimen) {
    double low = 0;
    double high = infinite;  // a longer crack has no smaller K_I
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        const auto of_middle = toughness_at_infinite_size(middle, tensile_strength, specimen);
        (of_middle && *of_middle < infinite ? low : high) = middle;
    }
    const auto found = toughness_at_infinite_size(low, tensile_strength, specimen);
    constexpr double tolerance = 1e-6;
    return found && std::abs(*found / infinite - 1) < tolerance ? std::optional(low) : std::nullopt;
}

Toughness measure_toughness(const RunData& run, const Specimen& specimen) {
    const bool is_bent = run.header.loading() == Loading::bending;
    if (!is_bent && run.header.loading() != Loading::tension) {
        throw InputError(run.name +
                         ": toughness needs a tension test of a rectangle with a notch through its middle, or bending of a "
                         "beam or half-disc with a notch from below");
    }
    const Strength strength = measure_strength(run);
    Toughness toughness = (is_bent ? of_bending : of_plate)(run, specimen, strength);
    stopped_at_strain_limit(run, strength, StrainLimitRuns::refuse, "a toughness");
    toughness.peak_load = strength.peak.load;
    toughness.strength = strength.peak.stress;
    toughness.predicted =
        std::sqrt(predict_moduli(run.header, specimen).plane_young_modulus * total_fracture_energy(run.header.contact));
    const double tc = run.header.contact.tensile_strength;
    toughness.characteristic_length = std::pow(toughness.predicted / tc, 2);
    const CrackedSpecimen cracked = cracked_specimen(toughness, specimen.shape, run.header.span);
    toughness.zone = strip_yield_zone(toughness.mode_i_toughness, tc);
    toughness.by_strip_yield = toughness_at_size(toughness.predicted, tc, cracked);
    toughness.at_infinite_size = toughness_at_infinite_size(toughness.mode_i_toughness, tc, cracked);
    return toughness;
}

Toughness measure_toughness(const RunReader& reader, const RunData& run) {
    Toughness toughness = measure_toughness(run, reader.specimen());
    toughness.requested_notch_length = requested_slit(run);
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
    if (!(ligament_ratio() >= min_notch_ratio)) {
        add(fmt::format(
            "the ligament is {:.2g} l_ch long, less than {:g}: the process zone is not small against it; use a larger "
            "specimen",
            ligament_ratio(), min_notch_ratio));
    }
    if (!outside.empty()) add(outside);
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
    write_table(out, toughness_columns(), toughness_terminal_columns(), rows, format);
    out.flush();
    if (!out) return;  // the command says so
    for (const ToughnessRow& row : rows) {
        const std::string warning = row.toughness.warning();
        if (!warning.empty()) warn(diagnostics, "toughness: " + printable(row.run.name), {warning, "toughness"}, row.run.name);
    }
}

}  // namespace graincrack
