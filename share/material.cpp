#include "share/material.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <map>
#include <utility>

#include "share/error.hpp"
#include "share/incomplete_material.hpp"
#include "share/toml_file.hpp"
#include "share/units.hpp"

namespace graincrack {
namespace {

namespace fs = std::filesystem;

/// A key of a table: the quantity it holds, where its value is stored, and whether it is required.
struct Key {
    std::string name;
    Quantity quantity;
    std::function<void(double)> set;
    bool needed;
    bool found = false;
};
using Table = std::pair<std::string, std::vector<Key>>;

std::vector<std::string> names_of(const std::vector<Key>& keys) {
    std::vector<std::string> names;
    names.reserve(keys.size());
    for (const Key& key : keys) names.push_back(key.name);
    return names;
}

/// " (did you mean …?)" or nothing.
std::string suggestion(const std::string& word, const std::vector<std::string>& known) {
    const std::string nearest = nearest_word(word, known);
    return nearest.empty() ? "" : fmt::format(" (did you mean {}?)", nearest);
}

double read_value(const TomlEntry& entry, const Key& key, const std::string& where) {
    if (entry.is_array || entry.values.front().kind == TomlValue::Kind::boolean) {
        throw InputError(fmt::format("{}: {} is no quantity; a text with a unit or a bare number in {} fits", where,
                                     entry.is_array ? "an array" : entry.values.front().text, key.quantity.unit()));
    }
    try {
        return parse_quantity(entry.values.front().text, key.quantity, where);
    } catch (const UsageError& error) {
        throw InputError(error.what());
    }
}

/// Orders of magnitude of rocks, from the weakest to the strongest and from soils to ores (Schön 2015, Physical Properties of
/// Rocks); of what is derived from them for contacts.
struct Magnitudes {
    double low;
    double high;
};
std::optional<Magnitudes> magnitudes_of(const Quantity& quantity) {
    if (quantity.name == quantity::young_modulus.name) return Magnitudes{1e8, 2e11};
    switch (quantity.dimension) {
        case Dimension::stress: return Magnitudes{1e5, 1e9};
        case Dimension::toughness: return Magnitudes{1e4, 1e7};
        case Dimension::density: return Magnitudes{1e3, 1e4};
        case Dimension::stiffness: return Magnitudes{1e11, 1e17};
        case Dimension::fracture_energy: return Magnitudes{0.1, 1e4};
        case Dimension::length: return Magnitudes{1e-6, 0.1};
        default: return std::nullopt;
    }
}

/// Adds what a value makes doubtful.
void note_value(const TomlEntry& entry, const Quantity& quantity, double value, const std::string& where,
                std::vector<std::string>& notes) {
    constexpr double far = 1000;
    const std::string bare = bare_number_note(entry.values.front().text, quantity, where);
    if (!bare.empty()) notes.push_back("note: " + bare);
    const auto rocks = magnitudes_of(quantity);
    if (!rocks || value == 0 || (value > rocks->low / far && value < rocks->high * far)) return;
    notes.push_back(fmt::format("warning: {}: {} is more than {} times {} any rock's; is its unit right?", where,
                                format_quantity(value, quantity.dimension), far, value < rocks->low ? "below" : "above"));
}

/// The keys of a material file, bound to a material.
std::vector<Table> tables_of(Material& material) {
    const auto to = [](double& target) { return [&target](double value) { target = value; }; };
    const auto to_optional = [](std::optional<double>& target) { return [&target](double value) { target = value; }; };
    Rock& rock = material.rock;
    ContactMaterial& contact = material.contact;
    std::vector<Table> tables{
        {"rock",
         {{"young_modulus", quantity::young_modulus, to(rock.young_modulus), true},
          {"poisson_ratio", quantity::poisson_ratio, to(rock.poisson_ratio), true},
          {"density", quantity::density, to(rock.density), true},
          {"mode_i_toughness", quantity::mode_i_toughness, to(rock.mode_i_toughness), true},
          {"mode_ii_toughness", quantity::mode_ii_toughness, to(rock.mode_ii_toughness), true},
          {"tensile_strength", quantity::tensile_strength, to(rock.tensile_strength), true}}},
        {"contact",
         {{"tensile_strength", quantity::contact_tensile_strength, to(contact.tensile_strength), true},
          {"cohesion", quantity::contact_cohesion, to(contact.cohesion), true},
          {"friction_angle", quantity::contact_friction_angle, to(contact.friction_angle), true},
          {"normal_stiffness", quantity::contact_normal_stiffness, to_optional(contact.normal_stiffness), false},
          {"shear_stiffness", quantity::contact_shear_stiffness, to_optional(contact.shear_stiffness), false},
          {"fracture_energy", quantity::fracture_energy, to_optional(contact.fracture_energy), false},
          {"mode_ii_fracture_energy", quantity::mode_ii_fracture_energy, to_optional(contact.mode_ii_fracture_energy), false},
          {"open_shear_strength", quantity::contact_open_shear_strength, to_optional(contact.open_shear_strength), false},
          {"residual_tensile_strength", quantity::contact_residual_tensile_strength,
           to_optional(contact.residual_tensile_strength), false},
          {"residual_cohesion", quantity::contact_residual_cohesion, to_optional(contact.residual_cohesion), false},
          {"residual_friction_angle", quantity::contact_residual_friction_angle, to_optional(contact.residual_friction_angle),
           false}}},
        {"platen", {{"friction_angle", quantity::platen_friction, to(material.platen_friction_angle), false}}},
        {"laboratory", {}},
    };
    for (const Quantity& quantity : laboratory_quantities()) {
        const std::string name(quantity.name);
        tables.back().second.push_back({name, quantity, [&material, name](double v) { material.laboratory[name] = v; }, false});
    }
    return tables;
}

/// Tables that a calibration reads or writes: how it is done, and what was fitted. No property of the rock.
bool is_of_calibration(const std::string& table) { return table == "study" || table == "fitted"; }

/// A needed key that is not there.
struct MissingKey {
    std::string name;     ///< "rock.density"
    std::string meaning;  ///< "mass density of the rock, in kg/m3"
};

/// \param missing gets the needed keys that are not there \param values gets what is there, by key
Material read_material_file(const fs::path& file, std::vector<MissingKey>& missing, std::map<std::string, double>& values) {
    const TomlFile toml = read_toml(file.string());
    Material material;
    material.file = file;
    std::vector<Table> tables = tables_of(material);
    std::vector<std::string> table_names;
    table_names.reserve(tables.size());
    for (const Table& table : tables) table_names.push_back(table.first);

    const auto find_table = [&](const std::vector<std::string>& section) -> Table* {
        const auto found = std::find_if(tables.begin(), tables.end(), [&](const Table& t) { return t.first == section.front(); });
        return section.size() == 1 && found != tables.end() ? &*found : nullptr;
    };
    for (const TomlSection& section : toml.sections) {
        if (find_table(section.name) != nullptr) continue;
        const std::string& first = section.name.front();
        if (section.name.size() == 1 && is_of_calibration(first)) continue;
        if (first == "phases" || first == "pairs") {
            throw InputError(fmt::format(
                "{}: line {}: table [{}]: several minerals are not built yet; describe one rock by [rock] and [contact]",
                toml.file, section.line, first));
        }
        throw InputError(fmt::format("{}: line {}: unknown table [{}]{}; known are {}", toml.file, section.line,
                                     fmt::join(section.name, "."), section.name.size() == 1 ? suggestion(first, table_names) : "",
                                     fmt::join(table_names, ", ")));
    }
    for (const TomlEntry& entry : toml.entries) {
        if (!entry.section.empty() && is_of_calibration(entry.section.front())) {
            if (entry.section.front() == "fitted" && !entry.values.empty())
                material.fitted[entry.key] = entry.values.front().text;
            continue;
        }
        if (entry.section.empty()) {
            if (entry.key != "name") {
                throw InputError(fmt::format("{}: line {}: unknown key {}; known outside of tables is only name", toml.file,
                                             entry.line, entry.key));
            }
            if (entry.is_array || entry.values.front().kind != TomlValue::Kind::text || entry.values.front().text.empty()) {
                throw InputError(fmt::format("{}: line {}: name: a text is wanted", toml.file, entry.line));
            }
            material.name = entry.values.front().text;
            continue;
        }
        Table* table = find_table(entry.section);  // exists: all sections were checked above
        std::vector<Key>& keys = table->second;
        const auto key = std::find_if(keys.begin(), keys.end(), [&](const Key& k) { return k.name == entry.key; });
        if (key == keys.end()) {
            throw InputError(fmt::format("{}: line {}: unknown key {}.{}{}; known are {}", toml.file, entry.line, table->first,
                                         entry.key, suggestion(entry.key, names_of(keys)), fmt::join(names_of(keys), ", ")));
        }
        const std::string name = table->first + "." + key->name;
        const double value = read_value(entry, *key, fmt::format("{}: line {}: {}", toml.file, entry.line, name));
        note_value(entry, key->quantity, value, fmt::format("{}: line {}: {}", toml.file, entry.line, name), material.notes);
        key->set(value);
        values[name] = value;
        key->found = true;
    }
    if (material.name.empty()) throw InputError(fmt::format("{}: name is missing; give the material a name", toml.file));
    for (const auto& [table, keys] : tables) {
        for (const Key& key : keys) {
            if (!key.needed || key.found) continue;
            missing.push_back({table + "." + key.name, fmt::format("{}, in {}", key.quantity.meaning, key.quantity.unit())});
        }
    }
    return material;
}

/// All at once, so that a file is completed in one go.
void refuse_missing(const fs::path& file, const std::vector<MissingKey>& missing) {
    if (missing.empty()) return;
    if (missing.size() == 1) {
        throw InputError(fmt::format("{}: {} is missing; it is the {}", file.string(), missing[0].name, missing[0].meaning));
    }
    std::string list;
    for (const MissingKey& key : missing) list += fmt::format("{}{} ({})", list.empty() ? "" : ", ", key.name, key.meaning);
    throw InputError(fmt::format("{}: {} keys are missing: {}; graincrack-post material init writes a template with every key",
                                 file.string(), missing.size(), list));
}

/// Folders in which a name is looked up. An installation finds its folder relative to the program, so that it may be moved.
std::vector<fs::path> material_folders() {
    std::vector<fs::path> folders;
    if (const char* own = std::getenv("GRAINCRACK_MATERIALS"); own != nullptr && *own != '\0') folders.emplace_back(own);
    std::error_code unknown;
    const fs::path program = fs::read_symlink("/proc/self/exe", unknown);
    if (!unknown) folders.push_back((program.parent_path() / GRAINCRACK_MATERIALS_FROM_PROGRAM).lexically_normal());
    folders.emplace_back(GRAINCRACK_SOURCE_MATERIALS);
    return folders;
}

}  // namespace

const std::vector<Quantity>& laboratory_quantities() {
    static const std::vector<Quantity> quantities{
        quantity::young_modulus,        quantity::poisson_ratio,     quantity::tensile_strength,
        quantity::compressive_strength, quantity::internal_cohesion, quantity::internal_friction_angle,
        quantity::grain_size,           quantity::min_grain_size,    quantity::max_grain_size};
    return quantities;
}

namespace {

/// The file of a material.
fs::path find_material(const std::string& name_or_file) {
    if (name_or_file.empty()) throw InputError("no material given; name one, such as augig-granite, or a TOML file");
    std::error_code ignored;
    fs::path path(name_or_file);
    if (name_or_file.find('/') != std::string::npos || path.extension() == ".toml" || fs::is_regular_file(path, ignored)) {
        return path;
    }
    std::vector<std::string> known;
    for (const fs::path& folder : material_folders()) {
        fs::path file = folder / (name_or_file + ".toml");
        if (fs::is_regular_file(file, ignored)) return file;
        for (fs::directory_iterator entry(folder, ignored); entry != fs::directory_iterator(); entry.increment(ignored)) {
            if (ignored) break;
            if (entry->path().extension() == ".toml") known.push_back(entry->path().stem().string());
        }
    }
    std::sort(known.begin(), known.end());
    known.erase(std::unique(known.begin(), known.end()), known.end());
    std::vector<std::string> folders;
    for (const fs::path& folder : material_folders()) folders.push_back(folder.string());
    throw InputError(fmt::format("material {}: not found{}; known are {} (looked in {}); a path to a TOML file fits too",
                                 name_or_file, suggestion(name_or_file, known),
                                 known.empty() ? "none" : fmt::format("{}", fmt::join(known, ", ")), fmt::join(folders, ", ")));
}

}  // namespace

Material read_material(const std::string& name_or_file) {
    const fs::path file = find_material(name_or_file);
    std::vector<MissingKey> missing;
    std::map<std::string, double> values;
    Material material = read_material_file(file, missing, values);
    refuse_missing(file, missing);
    return material;
}

IncompleteMaterial read_incomplete_material(const std::string& name_or_file) {
    std::vector<MissingKey> missing;
    std::map<std::string, double> values;
    IncompleteMaterial read{read_material_file(find_material(name_or_file), missing, values), {}, {}};
    read.values = std::move(values);
    for (const MissingKey& key : missing) read.missing.push_back(key.name);
    return read;
}

std::vector<std::string> material_keys() {
    Material material;
    std::vector<std::string> names;
    for (const auto& [table, keys] : tables_of(material)) {
        for (const Key& key : keys) names.push_back(table + "." + key.name);
    }
    return names;
}

Quantity material_quantity(const std::string& key) {
    Material material;
    for (const auto& [table, keys] : tables_of(material)) {
        for (const Key& each : keys) {
            if (table + "." + each.name == key) return each.quantity;
        }
    }
    const std::string nearest = nearest_word(key, material_keys());
    throw UsageError(fmt::format("{}: unknown key{}; known are {}", key,
                                 nearest.empty() ? "" : fmt::format(" (did you mean {}?)", nearest),
                                 fmt::join(material_keys(), ", ")));
}

FractureEnergyChoice parse_fracture_energy(std::string_view text, std::string_view where) {
    using Kind = FractureEnergyChoice::Kind;
    if (text == "mixed") return {Kind::mixed, 0};
    if (text == "mode-i") return {Kind::mode_i, 0};
    const char first = text.empty() ? ' ' : text.front();
    const bool word = (first >= 'a' && first <= 'z') || (first >= 'A' && first <= 'Z');
    if (word && text != "nan" && text != "inf") {
        throw UsageError(fmt::format("{}: unknown choice \"{}\"; mixed, mode-i or a value such as 90J/m2 fits", where, text));
    }
    return {Kind::value, parse_quantity(text, quantity::fracture_energy, where)};
}

std::string_view name_of(FractureEnergyChoice::Kind kind) {
    switch (kind) {
        case FractureEnergyChoice::Kind::mixed: return "mixed";
        case FractureEnergyChoice::Kind::mode_i: return "mode-i";
        case FractureEnergyChoice::Kind::value: return "value";
    }
    return "?";
}

FractureEnergyChoice effective_fracture_energy(const Material& material, const std::optional<FractureEnergyChoice>& choice) {
    if (choice) return *choice;
    if (material.contact.fracture_energy) return {FractureEnergyChoice::Kind::value, *material.contact.fracture_energy};
    return {FractureEnergyChoice::Kind::mode_i, 0};
}

ContactParameters contact_parameters(const Material& material, PlaneCondition plane,
                                     const std::optional<FractureEnergyChoice>& choice) {
    const Rock& rock = material.rock;
    const ContactMaterial& contact = material.contact;
    ContactParameters p;
    p.normal_stiffness = contact.normal_stiffness.value_or(fpz::normal_stiffness(rock, plane));
    p.shear_stiffness = contact.shear_stiffness.value_or(fpz::shear_stiffness(rock, plane));
    p.tensile_strength = contact.tensile_strength;
    p.cohesion = contact.cohesion;
    p.friction_angle = contact.friction_angle;
    const FractureEnergyChoice chosen = effective_fracture_energy(material, choice);
    switch (chosen.kind) {
        case FractureEnergyChoice::Kind::mixed: p.fracture_energy = fpz::mixed_mode_fracture_energy(rock, plane); break;
        case FractureEnergyChoice::Kind::mode_i: p.fracture_energy = fpz::mode_i_fracture_energy(rock, plane); break;
        case FractureEnergyChoice::Kind::value: p.fracture_energy = chosen.value; break;
    }
    p.critical_opening = fpz::critical_displacement(p.tensile_strength, p.normal_stiffness);
    p.critical_sliding = fpz::critical_displacement(p.cohesion, p.shear_stiffness);
    p.ultimate_opening = fpz::ultimate_displacement(p.fracture_energy, p.tensile_strength, p.critical_opening);
    p.mode_ii_fracture_energy = contact.mode_ii_fracture_energy.value_or(fpz::mode_ii_fracture_energy(rock, plane));
    p.open_shear_strength =
        contact.open_shear_strength.value_or(p.tensile_strength * std::sqrt(p.shear_stiffness / p.normal_stiffness));
    p.residual_tensile_strength = contact.residual_tensile_strength.value_or(0);
    p.residual_cohesion = contact.residual_cohesion.value_or(0);
    p.residual_friction_angle = contact.residual_friction_angle.value_or(contact.friction_angle);
    return p;
}

}  // namespace graincrack
