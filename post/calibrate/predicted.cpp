#include "post/calibrate/predicted.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <regex>

#include "share/base/text.hpp"
#include "share/base/toml_document.hpp"

namespace graincrack::calibrate {

namespace {

constexpr const char *predicted_table = "predicted", *of_values = "of";

/// What predictions of a material depend on: its coordinates of the kind.
std::string coordinates_text(const Material& material) {
    const KindCoordinates at = kind_coordinates(material);
    return fmt::format("{:.8g} {:.8g} {:.8g} {:.8g} {:.8g} {:.8g} {:.8g} {:.8g} {:.8g} {:.8g}", at.tensile_strength,
                       at.grain_size, at.cohesion, at.friction_angle, at.residual_friction_angle, at.process_zone,
                       at.mode_ii_fracture_energy, at.bridging_strength, at.bridging_energy, at.contact_strain);
}

}  // namespace

std::string with_predictions(const std::string& text, const Material& at, const std::vector<Prediction>& predictions) {
    const std::string name = at.file.string();
    TomlDocument file(text, name);
    for (const TomlEntry& entry : parse_toml(text, name).entries) {
        if (entry.section == TomlDocument::Path{predicted_table}) file.remove({predicted_table, entry.key});
    }
    if (!file.has_table({predicted_table})) {
        file.add_table({predicted_table}, "median and 95 % of new specimens, by the kind and the runs of this rock");
    }
    file.set({predicted_table, of_values}, toml_string(coordinates_text(at)));
    for (const Prediction& p : predictions) {
        const Property& property = p.target.property;
        file.set({predicted_table, p.target.name()},
                 toml_string(with_interval(p.specimen, property.si) + (property.unit.empty() ? "" : " ") + property.unit));
    }
    return file.text();
}

std::map<std::string, KindPrediction> predictions_in(const Material& material) {
    if (material.file.empty() || !std::filesystem::exists(material.file)) return {};
    static const std::regex form(R"((\S+) \((\S+) to (\S+)\).*)");
    std::map<std::string, KindPrediction> all;
    for (const TomlEntry& entry : read_toml(material.file.string()).entries) {
        if (entry.section != TomlDocument::Path{predicted_table} || entry.values.empty()) continue;
        const std::string& text = entry.values.front().text;
        if (entry.key == of_values && text != coordinates_text(material)) return {};
        std::smatch found;
        if (entry.key == of_values || !std::regex_match(text, found, form)) continue;
        const auto value = parse_number(found[1].str());
        const auto low = parse_number(found[2].str());
        const auto high = parse_number(found[3].str());
        if (!value || !low || !high || !(0 < *low && *low < *high)) continue;
        const double si = target_of(entry.key, material.file.string() + ": predicted").property.si;
        all[entry.key] = {*value * si, NAN, std::log(*high / *low) / (2 * deviations_of_95_percent)};
    }
    return all;
}

}  // namespace graincrack::calibrate
