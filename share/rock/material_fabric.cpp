#include "share/rock/material_fabric.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "share/base/error.hpp"
#include "share/base/text.hpp"
#include "share/base/units.hpp"

namespace graincrack {
namespace {

constexpr double whole = 1e-6;                   // by how much fractions may miss 1
constexpr std::size_t most_temperatures = 1000;  // of a table, whose integral is summed at each step that heats
constexpr std::size_t longest_name = 256;        // bytes, of a phase or a class of flaws
constexpr Quantity relative_modulus{
    "relative_young_modulus", Dimension::one, 0, 100, "Young's modulus of a phase over the rock's", true};
constexpr Quantity contrast{"contrast", Dimension::one, 0, 10, "share of the contrast of stiffness that grains have"};
constexpr Quantity correlation{"correlation", Dimension::length, 0, 1e3, "distance over which strengths are alike"};

/// Contact parameters of which none is needed.
std::vector<TomlKey> optional_contact_keys(GivenContact& given) {
    std::vector<TomlKey> keys = contact_keys(given);
    for (TomlKey& key : keys) key.needed = false;
    return keys;
}
std::vector<TomlKey> factor_keys(GivenContact& given) {
    std::vector<TomlKey> keys = optional_contact_keys(given);
    for (TomlKey& key : keys) {  // 0 only where the parameter may be
        key.quantity = {"factor", Dimension::one, 0, 1000, "factor on a contact parameter", key.quantity.open_below};
    }
    return keys;
}

/// What a phase may have other than the rock.
struct PhaseValue {
    const char* key;
    Quantity quantity;
    std::optional<double> PhaseMaterial::*value;
};
constexpr PhaseValue phase_values[] = {{"young_modulus", quantity::young_modulus, &PhaseMaterial::young_modulus},
                                       {"relative_young_modulus", relative_modulus, &PhaseMaterial::relative_young_modulus},
                                       {"poisson_ratio", quantity::poisson_ratio, &PhaseMaterial::poisson_ratio},
                                       {"density", quantity::density, &PhaseMaterial::density}};

std::vector<TomlKey> phase_keys(PhaseMaterial& phase) {
    std::vector<TomlKey> keys{{"fraction", quantity::phase_fraction, to(phase.fraction), true}};
    for (const PhaseValue& row : phase_values) keys.push_back({row.key, row.quantity, to(phase.*row.value)});
    keys.push_back({"thermal_expansion", quantity::thermal_expansion, to(phase.thermal_expansion)});
    return keys;
}

constexpr Quantity softening{
    "young_modulus", Dimension::one, 0, 1, "Young's modulus of grains over that without temperature", true};

/// A key that has an array of values, or, where it has a `set`, an array or one.
TomlKey array_key(const char* name, const Quantity& quantity, std::vector<double>& values,
                  std::function<void(double)> set = nullptr) {
    TomlKey key{name, quantity, std::move(set)};
    key.values = &values;
    return key;
}

/// Expansion that changes with temperature, or that has other values along the axis of a crystal and across it.
constexpr const char* expansion_axes = "thermal_expansion_axes";
std::optional<std::vector<TomlKey>> expansion_keys(const std::string& table, PhaseMaterial& phase) {
    constexpr Quantity expansion = quantity::thermal_expansion;
    ColumnsByTemperature& columns = phase.expansion_by_temperature;
    const TomlKey temperatures = array_key("temperatures", quantity::temperature, columns.temperatures);
    if (table == expansion.name) return {{temperatures, array_key("values", expansion, columns.values)}};
    if (table != expansion_axes) return std::nullopt;
    return {{temperatures, array_key("along", expansion, columns.values, to(phase.expansion_along)),
             array_key("across", expansion, columns.across, to(phase.expansion_across))}};
}

std::vector<TomlKey> rule_keys(MaterialFabric& fabric) {
    const auto set_rule = [&fabric](const std::string& word) {
        fabric.rule = word == "mean" ? SideRule::mean : SideRule::minimum;
    };
    const auto set_stiffness = [&fabric](const std::string& word) {
        fabric.stiffness = word == "rock" ? StiffnessRule::rock : StiffnessRule::sides;
    };
    return {word_key("rule", {"mean", "minimum"}, set_rule), word_key("stiffness", {"rock", "sides"}, set_stiffness)};
}

void require_pairs(const MaterialFabric& fabric, const std::string& where) {
    std::vector<std::string> phases;
    for (const auto& [name, phase] : fabric.phases) phases.push_back(name);
    for (const auto& [pair, given] : fabric.pairs) {
        const std::size_t dash = pair.find('-');
        if (dash == std::string::npos) {
            throw InputError(
                fmt::format("{}: [pairs.{}] is no pair{}; two phases joined by - fit, or homophase, heterophase or within", where,
                            pair, did_you_mean(pair, {"homophase", "heterophase", "within"})));
        }
        const std::string first = pair.substr(0, dash);
        const std::string second = pair.substr(dash + 1);
        for (const std::string& side : {first, second}) {
            if (!fabric.phases.contains(side)) {
                throw InputError(fmt::format("{}: [pairs.\"{}\"]: {} is no phase{}; two of {} joined by - fit", where, pair,
                                             side.empty() ? "nothing" : side, did_you_mean(side, phases),
                                             fmt::join(phases, ", ")));
            }
        }
        if (first != second && fabric.pairs.contains(second + "-" + first)) {
            throw InputError(
                fmt::format("{}: the pair of {} and {} is given twice; leave one of the tables out", where, first, second));
        }
    }
}

void require_columns(const ColumnsByTemperature& columns, const std::string& where) {
    const std::vector<double>& t = columns.temperatures;
    const bool ascends = std::adjacent_find(t.begin(), t.end(), std::greater_equal()) == t.end();
    if (t.size() > most_temperatures) {
        throw InputError(fmt::format("{}: {} temperatures; at most {} fit", where, t.size(), most_temperatures));
    }
    if (!columns.are_given() ||
        (ascends && columns.values.size() == t.size() && (columns.across.empty() || columns.across.size() == t.size()))) {
        return;
    }
    throw InputError(where + ": temperatures that ascend, and as many values as temperatures are needed");
}

void require_sound_expansion(const PhaseMaterial& phase, const std::string& where) {
    const bool has_axes = phase.expansion_along.has_value();
    if (has_axes != phase.expansion_across.has_value()) {
        throw InputError(
            fmt::format("{} has {} alone of {}; give along and across", where, has_axes ? "along" : "across", expansion_axes));
    }
    if (phase.thermal_expansion.has_value() + has_axes + phase.expansion_by_temperature.are_given() > 1) {
        throw InputError(fmt::format("{} has several thermal expansions; give one of them", where));
    }
    require_columns(phase.expansion_by_temperature, where);
}

}  // namespace

PhaseMaterial overlay(PhaseMaterial phase, const PhaseMaterial& of_file) {
    const auto take = [&](auto member) {
        if (!(phase.*member)) phase.*member = of_file.*member;
    };
    if (phase.fraction == 0) phase.fraction = of_file.fraction;
    take(&PhaseMaterial::poisson_ratio);
    take(&PhaseMaterial::density);
    if (!phase.young_modulus && !phase.relative_young_modulus) {
        take(&PhaseMaterial::young_modulus);
        take(&PhaseMaterial::relative_young_modulus);
    }
    if (!phase.gives_expansion()) {
        take(&PhaseMaterial::thermal_expansion);
        phase.expansion_by_temperature = of_file.expansion_by_temperature;
    }
    if (!phase.thermal_expansion && !phase.expansion_by_temperature.are_given()) {
        take(&PhaseMaterial::expansion_along);
        take(&PhaseMaterial::expansion_across);
    }
    phase.contact = overlay(phase.contact, of_file.contact);
    return phase;
}

std::optional<TomlKeys> fabric_table(MaterialFabric& fabric, const std::vector<std::string>& path) {
    const std::string name = fmt::format("{}", fmt::join(path, "."));
    const std::string& first = path.front();
    if (first == "strength" && path.size() == 1) {
        return TomlKeys{name,
                        {{"modulus", quantity::strength_modulus, to(fabric.strength_modulus)},
                         {"correlation", correlation, to(fabric.strength_correlation)}}};
    }
    if (first == "phases" && path.size() == 1) {
        const auto set_from = [&fabric](const std::string& word) { fabric.from = word; };
        return TomlKeys{name, {{"contrast", contrast, to(fabric.contrast)}, word_key("from", {}, set_from)}};
    }
    if (first == "phases" && path.size() == 2) return TomlKeys{name, phase_keys(fabric.phases[path[1]])};
    if (first == "phases" && path.size() == 3 && path[2] == "contact") {
        return TomlKeys{name, optional_contact_keys(fabric.phases[path[1]].contact)};
    }
    if (first == "phases" && path.size() == 3) {
        if (const auto keys = expansion_keys(path[2], fabric.phases[path[1]])) return TomlKeys{name, *keys};
    }
    if (first == "temperature" && path.size() == 1) {
        ColumnsByTemperature& columns = fabric.young_modulus_by_temperature;
        return TomlKeys{name,
                        {array_key("temperatures", quantity::temperature, columns.temperatures),
                         array_key("young_modulus", softening, columns.values)}};
    }
    if (first == "pairs" && path.size() == 1) return TomlKeys{name, rule_keys(fabric)};
    if (first == "pairs" && path.size() == 2) {
        if (path[1] == "homophase") return TomlKeys{name, factor_keys(fabric.homophase)};
        if (path[1] == "heterophase") return TomlKeys{name, factor_keys(fabric.heterophase)};
        if (path[1] == "within") return TomlKeys{name, factor_keys(fabric.within)};
        return TomlKeys{name, optional_contact_keys(fabric.pairs[path[1]])};
    }
    if (first == "flaws" && path.size() == 1) return TomlKeys{name, {}};  // its classes are tables of their own
    if (first == "flaws" && path.size() == 2) return TomlKeys{name, optional_contact_keys(fabric.flaws[path[1]])};
    return std::nullopt;
}

std::vector<TomlKey> grain_keys(GrainFabric& grains) {
    const auto set_tessellation = [&grains](const std::string& word) { grains.tessellation = word; };
    return {word_key("tessellation", {"delaunay", "voronoi", "trigon"}, set_tessellation),
            {"grain_size", quantity::grain_size, to(grains.grain_size)},
            {"size_variation", quantity::size_variation, to(grains.size_variation)},
            {"elements_per_crystal", quantity::elements_per_crystal, to(grains.elements_per_crystal)},
            {"elongation", quantity::elongation, to(grains.elongation)},
            {"elongation_angle", quantity::direction, to(grains.elongation_angle)}};
}

void require_sound_grains(const GrainFabric& grains, const std::string& where) {
    const bool are_triangles = grains.tessellation.empty() || grains.tessellation == "delaunay";
    if (are_triangles && grains.elements_per_crystal) {
        throw InputError(where + ": [fabric] elements_per_crystal is of polygons; give tessellation = \"trigon\" or \"voronoi\"");
    }
    if (are_triangles && grains.size_variation.value_or(0) > quantity::largest_spread_of_triangles) {
        throw InputError(fmt::format("{}: [fabric] size_variation: triangles vary by {} at most, not by {}", where,
                                     format_number(quantity::largest_spread_of_triangles),
                                     format_number(*grains.size_variation)));
    }
    if (grains.elongation_angle && !grains.elongation) {
        throw InputError(where + ": [fabric] has an elongation_angle and no elongation; give both, or none");
    }
}

double relative_young_modulus(const PhaseMaterial& phase, const Rock& rock) {
    return phase.young_modulus ? *phase.young_modulus / rock.young_modulus : phase.relative_young_modulus.value_or(1);
}

double young_modulus_of_grains(const PhaseMaterial& phase, const MaterialFabric& fabric, const Rock& rock) {
    return rock.young_modulus * (1 + fabric.contrast * (relative_young_modulus(phase, rock) - 1));
}

std::vector<FabricValue> fabric_values(const MaterialFabric& fabric) {
    std::vector<FabricValue> all;
    const auto add_contact = [&all](const std::string& table, const GivenContact& given) {
        for (const ContactParameter& row : all_contact_parameters()) {
            if (given.*row.given) all.push_back({table, row.key(), *(given.*row.given)});
        }
    };
    if (!fabric.phases.empty()) all.push_back({"phases", "contrast", fabric.contrast});
    for (const auto& [name, phase] : fabric.phases) {
        all.push_back({"phases." + name, "fraction", phase.fraction});
        for (const PhaseValue& row : phase_values) {
            if (phase.*row.value) all.push_back({"phases." + name, row.key, *(phase.*row.value)});
        }
        add_contact(fmt::format("phases.{}.contact", name), phase.contact);
    }
    if (!fabric.phases.empty()) {
        all.push_back({"pairs", "rule", {}, fabric.rule == SideRule::mean ? "mean" : "minimum"});
        all.push_back({"pairs", "stiffness", {}, fabric.stiffness == StiffnessRule::rock ? "rock" : "sides"});
    }
    add_contact("pairs.homophase", fabric.homophase);
    add_contact("pairs.heterophase", fabric.heterophase);
    add_contact("pairs.within", fabric.within);
    for (const auto& [pair, given] : fabric.pairs) add_contact(fmt::format("pairs.\"{}\"", pair), given);
    for (const auto& [name, given] : fabric.flaws) add_contact("flaws." + name, given);
    if (fabric.strength_modulus) {
        all.push_back({"strength", "modulus", *fabric.strength_modulus});
        if (fabric.strength_correlation > 0) all.push_back({"strength", "correlation", fabric.strength_correlation});
    }
    return all;
}

void require_sound_fabric(const MaterialFabric& fabric, const Rock& rock, const std::string& where) {
    const auto require_name = [&where](const char* table, const std::string& name) {
        const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; };
        if (name.size() > longest_name || !std::all_of(name.begin(), name.end(), is_letter)) {
            throw InputError(fmt::format("{}: [{}.{}]: a name of up to {} small letters, digits and _ is needed", where, table,
                                         shortened(name, 60), longest_name));
        }
    };
    for (const auto& [name, flaw] : fabric.flaws) require_name("flaws", name);
    double sum = 0;
    for (const auto& [name, phase] : fabric.phases) {
        require_name("phases", name);
        if (phase.young_modulus && phase.relative_young_modulus) {
            throw InputError(
                fmt::format("{}: [phases.{}] has young_modulus and relative_young_modulus; give one of them", where, name));
        }
        require_sound_expansion(phase, fmt::format("{}: [phases.{}]", where, name));
        if (rock.young_modulus > 0 && !(young_modulus_of_grains(phase, fabric, rock) > 0)) {
            throw InputError(
                fmt::format("{}: the grains of {} would have a modulus of {:.4g} times the rock's; a smaller contrast than "
                            "{:.4g} fits",
                            where, name, young_modulus_of_grains(phase, fabric, rock) / rock.young_modulus, fabric.contrast));
        }
        sum += phase.fraction;
    }
    if (!fabric.phases.empty() && std::abs(sum - 1) > whole) {
        throw InputError(fmt::format("{}: the fractions of the phases sum up to {:.7g}; 1 is needed", where, sum));
    }
    require_columns(fabric.young_modulus_by_temperature, where + ": [temperature]");
    require_pairs(fabric, where);
    if (fabric.strength_correlation > 0 && !fabric.strength_modulus) {
        throw InputError(fmt::format("{}: [strength] has a correlation and no modulus; give both, or the modulus alone", where));
    }
}

}  // namespace graincrack
