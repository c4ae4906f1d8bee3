#include "post/calibrate/target.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "post/fit/mohr_coulomb.hpp"
#include "share/base/error.hpp"
#include "share/base/text.hpp"
#include "share/base/toml_table.hpp"
#include "share/base/units.hpp"

namespace graincrack::calibrate {

namespace {

constexpr double MPa = 1e6;
constexpr Quantity part{"part", Dimension::one, 0, 1, "part", true};

double column(const Measures& measures, const std::string& name) {
    const auto found = measures.find(name);
    return found == measures.end() ? NAN : found->second;
}

}  // namespace

double Target::read(const Measures& measures) const {
    const double first = column(measures, property.column);
    return property.other.empty() ? first * property.column_si : first / (first + column(measures, property.other));
}

std::string pressure_text(double pascal) { return pascal > 0 ? fmt::format("{:.7g}MPa", pascal / MPa) : ""; }

std::string Target::name() const {
    return property.name + (confining_pressure > 0 ? "_" + pressure_text(confining_pressure) : "");
}

std::string Target::fitted_name() const { return property.key + name().substr(property.name.size()); }

std::string Target::symbol() const {
    return property.symbol + (confining_pressure > 0 ? fmt::format(" at {:.7g} MPa", confining_pressure / MPa) : "");
}

std::string Target::test() const {
    const auto& tests = all_tests();
    const auto test = std::ranges::find_if(tests, [&](const TestDescription& t) {
        return t.loading == property.loading && t.is_confined == (confining_pressure > 0);
    });
    return std::string(test->name);
}

std::string Target::caveat(const ToughnessTest& tested) const { return measured_on ? measured_on->caveat(tested) : ""; }

double Target::usual_deviation() const { return property.deviation * (property.absolute ? 1 : value); }

double Target::logarithm(double value_in_si) const {
    const double of = base(value_in_si);
    return of > 0 ? std::log(of) : NAN;
}

double Target::of_logarithm(double logarithm) const { return base(std::exp(logarithm)); }

std::string Target::text(double value_in_si) const {
    return fmt::format("{:.4g}{}{}", value_in_si / property.si, property.unit.empty() ? "" : " ", property.unit);
}

std::string name_of(Agreement agreement) { return name_in({"", "within", "outside", "undecided"}, agreement); }

Agreement agreement_of(const Target& target, const Estimate& computed) {
    const double off = std::abs(computed.value - target.value);
    if (!std::isfinite(off) || !std::isfinite(target.deviation)) return Agreement::unknown;
    if (!computed.high) return Agreement::undecided;
    const double half = *computed.high - computed.value;
    if (off + half <= target.deviation) return Agreement::within;
    return off - half > target.deviation ? Agreement::outside : Agreement::undecided;
}

Target target_of(const std::string& name, const std::string& where) {
    std::vector<std::string> known;
    for (const Property& property : all_properties()) {
        if (name == property.name && property.pressure != PressureOf::name) return {property};
        if (property.pressure == PressureOf::none) {
            known.push_back(property.name);
            continue;
        }
        known.push_back(property.name + "_8MPa");
        if (!name.starts_with(property.name + "_")) continue;
        return {property, parse_quantity(name.substr(property.name.size() + 1), quantity::confining_pressure, where)};
    }
    throw InputError(fmt::format("{}: unknown target{}; known are {} (of any pressure)", where, did_you_mean(name, known),
                                 fmt::join(known, ", ")));
}

namespace {

double needed(const Material& rock, const std::string& key) {
    if (const auto value = rock.laboratory_value(key)) return *value;
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

/// The strength that the laboratory measured at a confining pressure.
std::optional<double> measured_strength_at(const Material& rock, double pressure) {
    return rock.laboratory_value("confining_pressure") == pressure ? rock.laboratory_value("confined_strength") : std::nullopt;
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
        target.is_on_line = confining > 0 && !measured_strength_at(rock, confining);
    };
    const double ucs = needed(rock, "compressive_strength");
    const double slope = needed_slope(rock);
    const auto measured = [&rock](const char* key) { return rock.laboratory_value(key).value_or(NAN); };
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

/// A row of [targets].
Target given_target(TomlTable row) {
    Target target = target_of(row.name(), row.where());
    const Quantity& quantity = target.property.quantity;
    target.value = target.deviation = NAN;
    row.given("value", quantity, target.value);
    // A deviation of a strength may be a part of it.
    const bool is_part = row.shown("deviation").ends_with("%") && quantity.dimension != Dimension::one;
    row.given("deviation", is_part ? part : quantity, target.deviation);
    const bool is_fitted = row.is_word("use", "fit") || !row.has("use");
    if (!is_fitted && !row.is_word("use", "predict")) row.refuse("use", row.shown("use") + " is neither fit nor predict");
    row.refuse_others();
    if (std::isnan(target.value) && is_fitted) {
        row.refuse("", "value is missing; only a target with use = \"predict\" needs none");
    }
    target.use = is_fitted ? Use::fit : Use::predict;
    if (std::isnan(target.deviation)) {
        target.deviation = target.usual_deviation();
    } else if (is_part) {
        target.deviation *= target.value;
    }
    return target;
}

}  // namespace

void set_toughness_test(Target& target, const Material& material) {
    if (target.property.name == "toughness") target.measured_on = material.toughness_test;
}

std::string disagreement_text(const Material& rock) {
    const auto angle = rock.laboratory_value("friction_angle");
    const auto cohesion = rock.laboratory_value("cohesion");
    const auto ucs = rock.laboratory_value("compressive_strength");
    if (!angle || !cohesion || !ucs) return "";
    const double off = 2 * *cohesion * std::sqrt(mohr_coulomb_slope(*angle)) / *ucs - 1;
    if (std::abs(off) <= 0.03) return "";
    return fmt::format("C and φ of the laboratory imply a UCS that differs by {:+.1f} % from the measured one", 100 * off);
}

void take_laboratory_entry(const Material& material, Target& target) {
    const auto take = [&target](const std::optional<double>& value) { target.value = value.value_or(NAN); };
    if (target.property.pressure != PressureOf::name) return take(material.laboratory_value(target.property.key));
    if (const auto measured = measured_strength_at(material, target.confining_pressure)) return take(measured);
    const auto ucs = material.laboratory_value("compressive_strength");
    const auto slope = laboratory_slope(material);
    target.is_on_line = ucs && slope;
    if (target.is_on_line) take(*ucs + *slope * target.confining_pressure);
}

std::vector<Target> given_targets(const TomlFile& file) {
    std::vector<Target> targets;
    auto table = TomlTable(file).table("targets");
    if (!table) return targets;
    for (TomlTable& row : table->tables()) targets.push_back(given_target(std::move(row)));
    for (const TomlEntry& entry : file.entries) {
        if (entry.section != table->section()) continue;
        table->refuse(entry.key, "a row is needed, such as {value = \"8.8 MPa\", deviation = \"5 %\"}");
    }
    return targets;
}

std::vector<Target> targets_of(const Material& rock, const TomlFile& file, double confining_pressure,
                               const std::vector<double>& predicted_pressures) {
    std::vector<Target> targets = given_targets(file);
    if (targets.empty()) targets = laboratory_targets(rock, confining_pressure, predicted_pressures);
    for (Target& target : targets) set_toughness_test(target, rock);
    if (std::ranges::none_of(targets, [](const Target& t) { return t.use == Use::fit; })) {
        throw InputError(fmt::format("{}: [targets] has none to be fitted", file.file));
    }
    return targets;
}

}  // namespace graincrack::calibrate
