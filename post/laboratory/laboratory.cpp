#include "post/laboratory/laboratory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <regex>

#include "post/fit/mohr_coulomb.hpp"
#include "post/run/comparability.hpp"
#include "post/table/table.hpp"
#include "share/base/error.hpp"
#include "share/base/text.hpp"

namespace graincrack {

namespace {

using calibrate::Target;
using calibrate::Use;

std::string laboratory_name(const Target& target) {
    std::string name = target.property.laboratory;
    if (target.confining_pressure > 0) name += fmt::format(" at σ3 = {:.7g} MPa", target.confining_pressure * 1e-6);
    return name;
}

bool has_targets(const Material& material) { return !material.file.empty() && std::filesystem::exists(material.file); }

PropertyOrigin origin_of(const Material& material, const Target& target, bool is_target) {
    if (!material.fitted.empty()) {
        return material.fitted.count(target.fitted_name()) > 0 ? PropertyOrigin::fitted : PropertyOrigin::predicted;
    }
    if (!is_target) return PropertyOrigin::unknown;
    return target.use == Use::fit ? PropertyOrigin::to_fit : PropertyOrigin::predicted;
}

/// The target that an entry of [fitted] is of; empty for a key of another program.
std::optional<Target> fitted_target(const std::string& key) {
    for (const Property& property : all_properties()) {
        if (key != property.key && !key.starts_with(property.key + "_")) continue;
        try {
            return calibrate::target_of(property.name + key.substr(property.key.size()), key);
        } catch (const InputError&) {
            continue;
        }
    }
    return std::nullopt;
}

/// True if a name that stands in a file is that of a material, or of a regular file: others may have no end, or wait for input.
bool is_harmless(const std::string& name) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(name, error);
    return std::filesystem::exists(status) ? std::filesystem::is_regular_file(status) : name.find('/') == std::string::npos;
}

/// The words of an entry of [fitted]: the value that was asked for, the computed one, its interval if there is one, the number of
/// specimens. False for other texts.
bool read_fitted(const std::string& text, std::smatch& found) {
    // As the calibration writes it: "122 MPa; 124.6 (117.59 to 131.62) on 6 new specimens".
    static const std::regex form(R"(([^;]*); (\S+)(?: \((\S+) to (\S+)\))? on (\d+) new specimens?)");
    return std::regex_match(text, found, form);
}

/// s of specimens, from the interval t s/√n of the mean of n; its lower end may be cut off at 0.
std::optional<Scatter> fitted_scatter(const Material& material, const Target& target) {
    const auto entry = material.fitted.find(target.fitted_name());
    std::smatch found;
    if (entry == material.fitted.end() || !read_fitted(entry->second, found) || !found[3].matched) return std::nullopt;
    const auto mean = parse_number(found[2]);
    const auto high = parse_number(found[4]);
    const auto n = parse_number(found[5]);
    if (!mean || !high || !n || *n < 2) return std::nullopt;
    const int freedom = static_cast<int>(*n) - 1;
    return Scatter{(*high - *mean) * std::sqrt(*n) / student_t_95(freedom) * target.property.si, freedom};
}

/// σ1 = 2C√b + b σ3
std::optional<double> strength_on_line(const Material& material, double pressure) {
    const auto cohesion = material.laboratory_value("cohesion");
    const auto angle = material.laboratory_value("friction_angle");
    if (!cohesion || !angle) return std::nullopt;
    const double b = mohr_coulomb_slope(*angle);
    return 2 * *cohesion * std::sqrt(b) + b * pressure;
}

}  // namespace

std::string name_of(PropertyOrigin origin) { return name_in({"", "to be fitted", "fitted", "predicted"}, origin); }

bool LaboratoryProperty::is_measured() const { return std::isfinite(target.value); }

std::string LaboratoryProperty::name() const { return laboratory_name(target); }

std::optional<Material> material_of_run(const RunSettings& run, const std::string& name) {
    if (name.empty() || !is_harmless(name)) return std::nullopt;
    try {
        Material material = read_material(name);
        const Rock& rock = material.rock;
        const bool is_same = material.name == run.material && rock.young_modulus == run.rock.young_modulus &&
                             rock.poisson_ratio == run.rock.poisson_ratio && rock.density == run.rock.density;
        return is_same ? std::optional(std::move(material)) : std::nullopt;
    } catch (const InputError&) {
        return std::nullopt;
    }
}

std::string difference_from(const Material& material, const RunSettings& run) {
    const std::string names = fmt::format("material ({}, {})", run.material, material.name);
    RunSettings made = run;
    made.rock = material.rock;
    made.contact = contact_parameters(material, run.plane, std::nullopt);
    std::vector<std::string> phases;
    for (std::size_t p = 0; p < run.fabric.phases.size(); ++p) {
        const std::string& pair = run.class_names.at(contact_class(p, p));  // "quartz-quartz"
        phases.push_back(pair.substr(0, pair.size() / 2));
    }
    try {
        const Fabric fabric = fabric_of(material, run.plane, std::nullopt, phases);
        const auto& own = run.fabric.feels_temperature() ? fabric.phases : without_expansion(fabric.phases);
        std::copy(own.begin(), own.end(), made.fabric.phases.begin());
        std::copy(fabric.contacts.begin(), fabric.contacts.end(), made.fabric.contacts.begin());
    } catch (const InputError&) {
        return material.name == run.material ? "minerals" : names;
    }
    ComparedSettings as_run = compared_material(run);
    constexpr double as_written = 1e-5;  // by calibrations and `material value`, to six digits
    for (ComparedSetting& each : as_run) each.tolerance = as_written;
    const std::string values = differences(as_run, compared_material(made));
    return values.empty() || material.name == run.material ? values : names;
}

std::vector<LaboratoryProperty> laboratory_properties(const std::optional<Material>& material,
                                                      const std::vector<double>& pressures, LaboratorySource source) {
    std::vector<LaboratoryProperty> all;
    const bool is_line = source == LaboratorySource::line;
    if (material && !is_line && has_targets(*material)) {
        for (const Target& target : calibrate::given_targets(read_toml(material->file.string()))) {
            all.push_back({target, true, origin_of(*material, target, true)});
        }
    }
    std::vector<std::string> usual;
    for (const Property& property : all_properties()) {
        if (property.is_usual) usual.push_back(property.name);
    }
    for (const double pressure : pressures) usual.push_back("first_peak_" + calibrate::pressure_text(pressure));
    for (const std::string& name : usual) {
        Target target = calibrate::target_of(name, "report");
        target.value = NAN;
        const bool is_there = std::ranges::any_of(all, [&](const auto& p) { return p.target.name() == target.name(); });
        if (is_there) continue;
        all.push_back({target, false, material ? origin_of(*material, target, false) : PropertyOrigin::unknown});
    }
    for (LaboratoryProperty& property : all) {
        Target& target = property.target;
        if (material && !property.is_measured()) {
            if (is_line && target.confining_pressure > 0) {
                target.value = strength_on_line(*material, target.confining_pressure).value_or(NAN);
            } else {
                calibrate::take_laboratory_entry(*material, target);
            }
            property.target.deviation = property.target.usual_deviation();
            property.has_own_deviation = false;
        }
        if (!property.is_measured()) property.origin = PropertyOrigin::unknown;
        if (!material) continue;
        property.scatter = fitted_scatter(*material, property.target);
        calibrate::set_toughness_test(property.target, *material);
    }
    std::ranges::stable_sort(all, {}, [](const LaboratoryProperty& each) {
        return std::pair(order_of(each.target.property), each.target.confining_pressure);
    });
    return all;
}

bool has_fitted_confined_strength(const std::optional<Material>& material) {
    return material &&
           std::ranges::any_of(material->fitted, [](const auto& entry) { return entry.first.starts_with("confined_strength"); });
}

std::vector<FittedEntry> fitted_entries(const Material& material) {
    std::vector<std::pair<std::pair<std::size_t, double>, FittedEntry>> entries;
    for (const auto& [key, text] : material.fitted) {
        const std::optional<Target> target = fitted_target(key);
        FittedEntry entry;
        entry.name = target ? laboratory_name(*target) : key;
        if (!target) std::ranges::replace(entry.name, '_', ' ');
        if (target) entry.unit = target->property.unit;
        std::smatch found;
        if (read_fitted(text, found)) {
            entry.asked = found[1];
            entry.computed = found[2];
            entry.low = found[3];
            entry.high = found[4];
            entry.specimens = found[5];
        } else {
            entry.text = text;
        }
        const std::size_t order = target ? order_of(target->property) : all_properties().size();
        entries.emplace_back(std::pair(order, target ? target->confining_pressure : 0.0), std::move(entry));
    }
    std::ranges::stable_sort(entries, [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<FittedEntry> sorted;
    for (auto& [order, entry] : entries) sorted.push_back(std::move(entry));
    return sorted;
}

}  // namespace graincrack
