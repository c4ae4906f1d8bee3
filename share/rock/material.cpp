#include "share/rock/material.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <utility>

#include "share/base/error.hpp"
#include "share/base/printable.hpp"
#include "share/base/shared_file.hpp"
#include "share/base/toml_file.hpp"
#include "share/base/toml_keys.hpp"
#include "share/base/units.hpp"
#include "share/rock/incomplete_material.hpp"

namespace graincrack {
namespace {

namespace fs = std::filesystem;

/// Round orders of magnitude that hold all rocks of share/materials, from soils to ores, and what is derived from them for
/// contacts. A warning needs a value a thousand times beyond them, so that they need not be known to a factor.
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
std::vector<TomlKeys> tables_of(Material& material) {
    const auto to = [](double& target) { return [&target](double value) { target = value; }; };
    Rock& rock = material.rock;
    std::vector<TomlKeys> tables{
        {"rock",
         {{"young_modulus", quantity::young_modulus, to(rock.young_modulus), true},
          {"poisson_ratio", quantity::poisson_ratio, to(rock.poisson_ratio), true},
          {"density", quantity::density, to(rock.density), true},
          {"mode_i_toughness", quantity::mode_i_toughness, to(rock.mode_i_toughness), true},
          {"mode_ii_toughness", quantity::mode_ii_toughness, to(rock.mode_ii_toughness), true},
          {"tensile_strength", quantity::tensile_strength, to(rock.tensile_strength), true}}},
        {"contact", contact_keys(material.contact)},
        {"ratios", ratio_keys(material.ratios)},
        {"platen", {{"friction_angle", quantity::platen_friction, to(material.platen_friction_angle), false}}},
        {"fabric", grain_keys(material.grains)},
        {"laboratory", {}},
    };
    for (const Quantity& quantity : laboratory_quantities()) {
        const std::string name(quantity.name);
        tables.back().keys.push_back({name, quantity, [&material, name](double v) { material.laboratory[name] = v; }, false});
    }
    TomlKey law{"law", {}, {}};
    law.set_word = [&material](const std::string& word) { material.law = word; };
    tables[1].keys.push_back(law);
    return tables;
}

/// The keys of a table by its path, one of `tables_of` or of the fabric; nothing if there is no such table.
std::optional<TomlKeys> table_at(Material& material, const std::vector<std::string>& path) {
    for (TomlKeys& table : tables_of(material)) {
        if (path == std::vector<std::string>{table.path}) return table;
    }
    return fabric_table(material.fabric, path);
}

/// "phases.quartz.fraction" as the path of its table and its name.
std::pair<std::vector<std::string>, std::string> path_of(const std::string& key) {
    std::vector<std::string> parts{""};
    for (const char c : key) {
        if (c == '.') {
            parts.emplace_back();
        } else {
            parts.back() += c;
        }
    }
    const std::string name = parts.back();
    parts.pop_back();
    return {parts, name};
}

/// Tables that a calibration reads or writes: how it is done, and what was fitted. No property of the rock.
bool is_of_calibration(const std::string& table) {
    return table == "targets" || table == "parameters" || table == "study" || table == "fitted";
}

/// Is a key of [contact] given by [ratios]?
bool is_by_ratio(const Material& material, const std::string& contact_key) {
    const auto rows = all_contact_parameters();
    return std::any_of(rows.begin(), rows.end(), [&](const ContactParameter& row) {
        return row.key() == contact_key && (material.ratios.*row.given).has_value();
    });
}

/// The key that a ratio needs.
const char* const grain_size_of_ratio = "fabric.grain_size";

/// "mass density of the rock, in kg/m3": what a needed key is.
std::string meaning_of(const std::string& key) {
    const Quantity quantity = material_quantity(key);
    return fmt::format("{}, in {}{}", quantity.meaning, quantity.unit(),
                       key == grain_size_of_ratio ? ", over which ratios.process_zone is" : "");
}

/// Adds the phases of a file of phases to those that a material gives itself. \param where the material's file
void add_phases_of(const std::string& name, MaterialFabric& fabric, const std::string& where) {
    std::error_code ignored;
    for (const fs::path& folder : materials().places()) {
        const fs::path file = folder / "phases" / (name + ".toml");
        if (!fs::is_regular_file(file, ignored)) continue;
        const TomlFile toml = read_toml(file.string());
        MaterialFabric read;
        for (const TomlEntry& entry : toml.entries) {
            std::optional<TomlKeys> table = entry.section.empty() ? std::nullopt : fabric_table(read, entry.section);
            if (!table) {
                throw InputError(fmt::format("{}: line {}: only tables of phases are allowed here", toml.file, entry.line));
            }
            table->read(toml.file, entry);
        }
        fabric.phases.merge(read.phases);
        return;
    }
    throw InputError(fmt::format("{}: phases.from: there is no file phases/{}.toml beside the materials", where, name));
}

/// \param missing gets the needed keys that are not there \param values gets what is there, by key
Material read_material_file(const fs::path& file, std::vector<std::string>& missing, std::map<std::string, double>& values) {
    const TomlFile toml = read_toml(file.string());
    Material material;
    material.file = file;
    std::vector<TomlKeys> tables = tables_of(material);
    std::vector<std::string> table_names;
    table_names.reserve(tables.size());
    for (const TomlKeys& table : tables) table_names.push_back(table.path);
    for (const char* table : {"phases", "pairs", "flaws", "strength"}) table_names.emplace_back(table);

    const auto find_table = [&](const std::vector<std::string>& section) -> TomlKeys* {
        const std::string path = fmt::format("{}", fmt::join(section, "."));
        const auto found = std::find_if(tables.begin(), tables.end(), [&](const TomlKeys& t) { return t.path == path; });
        return found != tables.end() ? &*found : nullptr;
    };
    for (const TomlSection& section : toml.sections) {
        if (find_table(section.name) != nullptr) continue;
        const std::string& first = section.name.front();
        if (is_of_calibration(first)) continue;
        if (std::optional<TomlKeys> table = fabric_table(material.fabric, section.name)) {
            tables.push_back(*std::move(table));
            continue;
        }
        throw InputError(
            fmt::format("{}: line {}: unknown table [{}]{}; known are {}", toml.file, section.line, fmt::join(section.name, "."),
                        section.name.size() == 1 ? did_you_mean(first, table_names) : "", fmt::join(table_names, ", ")));
    }
    for (const TomlEntry& entry : toml.entries) {
        if (!entry.section.empty() && is_of_calibration(entry.section.front())) {
            if (entry.section.front() == "fitted" && !entry.values.empty()) {
                material.fitted[entry.key] = entry.values.front().text;
            }
            continue;
        }
        if (entry.section.empty()) {
            if (entry.key != "name") {
                throw InputError(fmt::format("{}: line {}: unknown key {}; known outside of tables is only name", toml.file,
                                             entry.line, entry.key));
            }
            if (entry.is_array || entry.values.front().kind != TomlValue::Kind::text || entry.values.front().text.empty()) {
                throw InputError(fmt::format("{}: line {}: name: a text is needed", toml.file, entry.line));
            }
            material.name = entry.values.front().text;
            continue;
        }
        TomlKeys& table = *find_table(entry.section);  // exists: all sections were checked above
        if (const std::optional<double> value = table.read(toml.file, entry)) {
            const std::string name = table.path + "." + entry.key;
            values[name] = *value;
            note_value(entry, table.find(entry.key)->quantity, *value,
                       fmt::format("{}: line {}: {}", toml.file, entry.line, name), material.notes);
        }
    }
    if (material.name.empty()) throw InputError(fmt::format("{}: name is missing; give the material a name", toml.file));
    for (const auto& [table, keys] : tables) {
        for (const TomlKey& key : keys) {
            if (!key.needed || key.found || (table == "contact" && is_by_ratio(material, key.name))) continue;
            missing.push_back(table + "." + key.name);
        }
    }
    if (material.ratios.fracture_energy && !material.grains.grain_size) missing.emplace_back(grain_size_of_ratio);
    if (!material.fabric.from.empty()) add_phases_of(material.fabric.from, material.fabric, toml.file);
    require_sound_grains(material.grains, toml.file);
    require_sound_fabric(material.fabric, material.rock, toml.file);
    return material;
}

/// All at once, so that a file is completed in one go.
void refuse_missing(const fs::path& file, const std::vector<std::string>& missing) {
    if (missing.empty()) return;
    if (missing.size() == 1) {
        throw InputError(fmt::format("{}: {} is missing; it is the {}", file.string(), missing[0], meaning_of(missing[0])));
    }
    std::string list;
    for (const std::string& key : missing) list += fmt::format("{}{} ({})", list.empty() ? "" : ", ", key, meaning_of(key));
    throw InputError(
        fmt::format("{}: {} keys are missing: {}; what [laboratory] has counts for [rock]; graincrack-post material init "
                    "--kind every-key writes a template with every key",
                    file.string(), missing.size(), list));
}

}  // namespace

const std::vector<Quantity>& laboratory_quantities() {
    static const std::vector<Quantity> quantities{quantity::young_modulus,
                                                  quantity::poisson_ratio,
                                                  quantity::density,
                                                  quantity::tensile_strength,
                                                  quantity::compressive_strength,
                                                  quantity::internal_cohesion,
                                                  quantity::internal_friction_angle,
                                                  quantity::confined_strength,
                                                  quantity::confining_pressure,
                                                  quantity::mode_i_toughness,
                                                  quantity::direct_tensile_strength,
                                                  quantity::crack_initiation,
                                                  quantity::crack_damage,
                                                  quantity::grain_size,
                                                  quantity::min_grain_size,
                                                  quantity::max_grain_size};
    return quantities;
}

namespace {

fs::path find_material(const std::string& name_or_file) {
    if (name_or_file.empty()) throw InputError("no material given; name one, such as augig-granite, or a TOML file");
    return materials().find(name_or_file);
}

}  // namespace

Material read_material(const std::string& name_or_file) {
    IncompleteMaterial read = read_incomplete_material(name_or_file);
    take_laboratory(read);
    refuse_missing(read.material.file, read.missing);
    return std::move(read.material);
}

void write_notes(std::ostream& out, std::string_view program, const Material& material) {
    for (const std::string& note : material.notes) out << program << ": " << printable(note) << '\n';
}

IncompleteMaterial read_incomplete_material(const std::string& name_or_file) {
    IncompleteMaterial read;
    read.material = read_material_file(find_material(name_or_file), read.missing, read.values);
    return read;
}

std::vector<std::string> material_keys() {
    Material material;
    std::vector<std::string> names;
    for (const auto& [table, keys] : tables_of(material)) {
        for (const TomlKey& key : keys) names.push_back(table + "." + key.name);
    }
    return names;
}

TomlKey material_key(const std::string& key) {
    static Material unused;  // what the key would set
    const auto [path, name] = path_of(key);
    if (!path.empty()) {
        if (std::optional<TomlKeys> table = table_at(unused, path)) {
            if (const TomlKey* found = table->find(name)) return *found;
        }
    }
    throw UsageError(fmt::format("{}: unknown key{}; known are {}", key, did_you_mean(key, material_keys()),
                                 fmt::join(material_keys(), ", ")));
}

Quantity material_quantity(const std::string& key) {
    const TomlKey found = material_key(key);
    if (found.is_word()) throw UsageError(fmt::format("{}: is a word; a quantity is needed", key));
    return found.quantity;
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
    return {Kind::value, parse_quantity(text, contact_parameter(&ContactParameters::fracture_energy).quantity, where)};
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
    const std::optional<double> own = given_contact(material, PlaneCondition::strain, std::nullopt).fracture_energy;
    if (own) return {FractureEnergyChoice::Kind::value, *own};
    return {FractureEnergyChoice::Kind::mode_i, 0};
}

GivenContact given_contact(const Material& material, PlaneCondition plane, const std::optional<FractureEnergyChoice>& choice) {
    GivenContact given = material.contact;
    if (choice) {
        switch (choice->kind) {
            case FractureEnergyChoice::Kind::mixed:
                given.fracture_energy = fpz::mixed_mode_fracture_energy(material.rock, plane);
                break;
            case FractureEnergyChoice::Kind::mode_i:
                given.fracture_energy = fpz::mode_i_fracture_energy(material.rock, plane);
                break;
            case FractureEnergyChoice::Kind::value: given.fracture_energy = choice->value; break;
        }
    }
    return with_ratios(given, material.ratios, material.rock, material.grains.grain_size, plane);
}

ContactParameters contact_parameters(const Material& material, PlaneCondition plane,
                                     const std::optional<FractureEnergyChoice>& choice) {
    return derived_contact(given_contact(material, plane, choice), material.rock, plane);
}

}  // namespace graincrack
