#include "post/calibrate/target.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "post/fit/mohr_coulomb.hpp"
#include "share/base/error.hpp"
#include "share/base/text.hpp"
#include "share/base/units.hpp"

namespace graincrack::calibrate {

namespace {

constexpr double MPa = 1e6;

double column(const Measures& measures, const char* name, double si) {
    const auto found = measures.find(name);
    return found == measures.end() ? NAN : found->second * si;
}
double first_peak(const Measures& m) { return column(m, "first_peak_MPa", MPa); }
double tensile_share(const Measures& m) {
    const double tensile = column(m, "tensile_cracks_by_sign", 1);
    return tensile / (tensile + column(m, "shear_cracks_by_sign", 1));
}

constexpr double never = 1;
constexpr double behind_first_peak = 0.1;  // a first peak is one that the stress falls 5 % of σ1 − σ3 behind
constexpr double usual_drop = 0.3;         // the solver's own

constexpr Quantity stress{"stress", Dimension::stress, 0, 1e12, "stress", true};
constexpr Quantity part{"part", Dimension::one, 0, 1, "part", true};

}  // namespace

const std::vector<TargetKind>& target_kinds() {
    using enum PressureOf;
    static const std::vector<TargetKind> kinds{
        {"young_modulus", "E", "compression", none, quantity::young_modulus, "GPa", 1e9, 0.02, false, behind_first_peak, false,
         [](const Measures& m) { return column(m, "young_modulus_GPa", 1e9); }},
        {"poisson_ratio", "ν", "compression", none, quantity::poisson_ratio, "", 1, 0.015, true, behind_first_peak, false,
         [](const Measures& m) { return column(m, "poisson_ratio", 1); }},
        {"brazilian", "Brazilian strength", "brazilian", none, stress, "MPa", MPa, 0.05, false, usual_drop, false,
         [](const Measures& m) { return column(m, "tensile_strength_MPa", MPa); }, "tensile_strength"},
        {"direct_tension", "direct tensile strength", "tension", none, stress, "MPa", MPa, 0.05, false, usual_drop, false,
         [](const Measures& m) { return column(m, "tensile_strength_MPa", MPa); }, "direct_tensile_strength"},
        {"toughness", "K_IC", "bend", none, quantity::mode_i_toughness, "MPa√m", MPa, 0.1, false, usual_drop, false,
         [](const Measures& m) { return column(m, "mode_i_toughness_MPa.m^0.5", MPa); }, "mode_i_toughness"},
        {"uniaxial", "UCS", "compression", none, stress, "MPa", MPa, 0.05, false, behind_first_peak, true, first_peak,
         "compressive_strength"},
        {"first_peak", "first peak", "compression", name, stress, "MPa", MPa, 0.08, false, behind_first_peak, true, first_peak,
         "confined_strength"},
        {"largest", "largest stress", "compression", either, stress, "MPa", MPa, 0.05, false, never, false,
         [](const Measures& m) { return column(m, "peak_compressive_stress_MPa", MPa); }},
        {"residual", "residual strength", "compression", either, stress, "MPa", MPa, 0.1, false, never, false,
         [](const Measures& m) { return column(m, "residual_MPa", MPa); }},
        {"drop", "drop behind the first peak", "compression", either, part, "%", 0.01, 0.2, false, never, false,
         [](const Measures& m) { return column(m, "drop_percent", 0.01); }},
        // Before crack_initiation, with which its name begins.
        {"crack_initiation_count", "crack initiation by count of cracks", "compression", either, stress, "MPa", MPa, 0.1, false,
         behind_first_peak, false, [](const Measures& m) { return column(m, "crack_initiation_count_MPa", MPa); }},
        {"crack_initiation", "crack initiation", "compression", either, stress, "MPa", MPa, 0.1, false, behind_first_peak, false,
         [](const Measures& m) { return column(m, "crack_initiation_MPa", MPa); }},
        {"crack_damage", "crack damage", "compression", either, stress, "MPa", MPa, 0.1, false, behind_first_peak, false,
         [](const Measures& m) { return column(m, "crack_damage_MPa", MPa); }},
        {"tensile_share", "tensile share of cracks", "compression", either, part, "", 1, 0.2, false, behind_first_peak, false,
         tensile_share},
        {"strain_at_peak", "strain at the peak", "compression", either, part, "%", 0.01, 0.1, false, behind_first_peak, false,
         [](const Measures& m) { return column(m, "strain_at_peak", 1); }},
    };
    return kinds;
}

std::string pressure_text(double pascal) { return pascal > 0 ? fmt::format("{:.7g}MPa", pascal / MPa) : ""; }

std::string Target::name() const { return kind.name + (confining_pressure > 0 ? "_" + pressure_text(confining_pressure) : ""); }

std::string Target::fitted_name() const {
    return fmt::format("{}{}", kind.fitted_key.empty() ? kind.name : kind.fitted_key, name().substr(kind.name.size()));
}

std::string Target::symbol() const {
    return kind.symbol + (confining_pressure > 0 ? fmt::format(" at {:.7g} MPa", confining_pressure / MPa) : "");
}

std::string Target::test() const {
    return kind.test != "compression" ? kind.test : confining_pressure > 0 ? "triaxial" : "uniaxial";
}

double Target::usual_deviation() const { return kind.deviation * (kind.absolute ? 1 : value); }

std::string Target::text(double value_in_si) const {
    return fmt::format("{:.4g}{}{}", value_in_si / kind.si, kind.unit.empty() ? "" : " ", kind.unit);
}

Target target_of(const std::string& name, const std::string& where) {
    std::vector<std::string> known;
    for (const TargetKind& kind : target_kinds()) {
        if (name == kind.name && kind.pressure != PressureOf::name) return {kind};
        if (kind.pressure == PressureOf::none) {
            known.push_back(kind.name);
            continue;
        }
        known.push_back(kind.name + "_8MPa");
        if (!name.starts_with(kind.name + "_")) continue;
        return {kind, parse_quantity(name.substr(kind.name.size() + 1), quantity::confining_pressure, where)};
    }
    throw InputError(fmt::format("{}: unknown target{}; known are {} (of any pressure)", where, did_you_mean(name, known),
                                 fmt::join(known, ", ")));
}

namespace {

double needed(const Material& rock, const std::string& key) {
    const auto found = rock.laboratory.find(key);
    if (found != rock.laboratory.end()) return found->second;
    throw InputError(
        fmt::format("{}: [laboratory] has no {}; a calibration without [targets] needs it", rock.file.string(), key));
}

/// \throws InputError
double needed_slope(const Material& rock) {
    if (const auto slope = laboratory_slope(rock)) return *slope;
    throw InputError(
        fmt::format("{}: [laboratory] has neither friction_angle nor cohesion, nor confined_strength with its "
                    "confining_pressure; a calibration without [targets] needs one",
                    rock.file.string()));
}

std::vector<Target> laboratory_targets(const Material& rock, double pressure, const std::vector<double>& predicted_pressures) {
    std::vector<Target> targets;
    const auto add = [&](const std::string& name, double confining, double value, Use use) {
        targets.push_back(target_of(name, "targets"));
        Target& target = targets.back();
        target.confining_pressure = confining;
        target.value = value;
        target.deviation = target.usual_deviation();
        target.use = use;
    };
    const double ucs = needed(rock, "compressive_strength");
    const double slope = needed_slope(rock);
    const auto measured = [&rock](const char* key) {
        const auto found = rock.laboratory.find(key);
        return found == rock.laboratory.end() ? NAN : found->second;
    };
    // A measured strength is better known than the line through it.
    const bool is_measured = measured("confined_strength") > 0 && measured("confining_pressure") > 0;
    if (is_measured) pressure = measured("confining_pressure");
    add("young_modulus", 0, needed(rock, "young_modulus"), Use::fit);
    add("poisson_ratio", 0, needed(rock, "poisson_ratio"), Use::fit);
    add("brazilian", 0, needed(rock, "tensile_strength"), Use::fit);
    add("uniaxial", 0, ucs, Use::fit);
    add("first_peak_1MPa", pressure, is_measured ? measured("confined_strength") : ucs + slope * pressure, Use::fit);
    for (const double p : predicted_pressures) {
        if (p != pressure) add("first_peak_1MPa", p, ucs + slope * p, Use::predict);
    }
    add("direct_tension", 0, measured("direct_tensile_strength"), Use::predict);
    for (const char* name : {"crack_initiation", "crack_damage"}) add(name, 0, measured(name), Use::predict);
    // Half-discs measure nothing else: they are made for those alone who have a value to compare with.
    if (const double toughness = measured("mode_i_toughness"); toughness > 0) add("toughness", 0, toughness, Use::predict);
    return targets;
}

/// A key of a row of [targets].
void set_target(Target& target, const TomlEntry& entry, const std::string& where) {
    const std::string& text = entry.values.empty() ? entry.key : entry.values.front().text;
    if (entry.key == "value") {
        target.value = parse_quantity(text, target.kind.quantity, where);
    } else if (entry.key == "deviation") {
        // A deviation of a strength may be a part of it.
        const bool relative = text.ends_with("%") && target.kind.quantity.dimension != Dimension::one;
        target.deviation = relative ? -parse_quantity(text, part, where) : parse_quantity(text, target.kind.quantity, where);
    } else if (entry.key == "use" && (text == "fit" || text == "predict")) {
        target.use = text == "fit" ? Use::fit : Use::predict;
    } else if (entry.key == "use") {
        throw InputError(fmt::format("{}: {} is neither fit nor predict", where, text));
    } else {
        throw InputError(fmt::format("{}: unknown key; known are value, deviation, use", where));
    }
}

}  // namespace

double disagreement(const Material& rock) {
    const auto angle = rock.laboratory.find("friction_angle");
    const auto cohesion = rock.laboratory.find("cohesion");
    const auto ucs = rock.laboratory.find("compressive_strength");
    const auto none = rock.laboratory.end();
    if (angle == none || cohesion == none || ucs == none) return 0;
    return 2 * cohesion->second * std::sqrt(mohr_coulomb_slope(angle->second)) / ucs->second - 1;
}

std::vector<Target> given_targets(const TomlFile& file) {
    std::vector<Target> targets;
    for (const TomlSection& section : file.sections) {
        if (section.name.front() != "targets" || section.name.size() < 2) continue;
        const std::string where = fmt::format("{}: line {}: targets.{}", file.file, section.line, section.name[1]);
        Target target = target_of(section.name[1], where);
        target.value = target.deviation = NAN;
        for (const TomlEntry& entry : file.entries) {
            if (entry.section == section.name) set_target(target, entry, where + "." + entry.key);
        }
        if (std::isnan(target.value) && target.use == Use::fit) {
            throw InputError(fmt::format("{}: value is missing; only a target with use = \"predict\" needs none", where));
        }
        if (std::isnan(target.deviation)) target.deviation = target.usual_deviation();
        if (target.deviation < 0) target.deviation *= -target.value;
        targets.push_back(target);
    }
    for (const TomlEntry& entry : file.entries) {
        if (entry.section == std::vector<std::string>{"targets"}) {
            throw InputError(
                fmt::format("{}: line {}: targets.{}: a row is needed, such as {{value = \"8.8 MPa\", deviation = \"5 %\"}}",
                            file.file, entry.line, entry.key));
        }
    }
    return targets;
}

std::vector<Target> targets_of(const Material& rock, const TomlFile& file, double confining_pressure,
                               const std::vector<double>& predicted_pressures) {
    std::vector<Target> targets = given_targets(file);
    if (targets.empty()) return laboratory_targets(rock, confining_pressure, predicted_pressures);
    if (std::none_of(targets.begin(), targets.end(), [](const Target& t) { return t.use == Use::fit; })) {
        throw InputError(fmt::format("{}: [targets] has none to be fitted", file.file));
    }
    return targets;
}

}  // namespace graincrack::calibrate
