#include "share/rock/material.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <utility>

#include "share/base/error.hpp"
#include "share/base/shared_file.hpp"
#include "share/base/text.hpp"
#include "share/base/toml_file.hpp"
#include "share/base/toml_table.hpp"
#include "share/base/units.hpp"

namespace graincrack {
namespace {

namespace fs = std::filesystem;

constexpr double mode_ii_over_mode_i = 3.0 / 1.5;  // of Augig granite

bool has(const std::vector<std::string>& keys, const std::string& key) {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
}

std::vector<TomlKey> rock_keys(Rock& rock) {
    return {{"young_modulus", quantity::young_modulus, to(rock.young_modulus), true},
            {"poisson_ratio", quantity::poisson_ratio, to(rock.poisson_ratio), true},
            {"density", quantity::density, to(rock.density), true},
            {"mode_i_toughness", quantity::mode_i_toughness, to(rock.mode_i_toughness), true},
            {"mode_ii_toughness", quantity::mode_ii_toughness, to(rock.mode_ii_toughness), true},
            {"tensile_strength", quantity::tensile_strength, to(rock.tensile_strength), true}};
}

/// What [laboratory] has of [rock]. \param notes gets a sentence for each value
void take_measured_rock(IncompleteMaterial& read, std::vector<std::string>& notes) {
    for (const TomlKey& key : rock_keys(read.material.rock)) {
        const auto found = read.material.laboratory.find(key.name);
        if (found == read.material.laboratory.end() || std::erase(read.missing, "rock." + key.name) == 0) continue;
        key.set(read.values["rock." + key.name] = found->second);
        notes.push_back(fmt::format("{} of the rock is that of [laboratory]", key.name));
    }
}

/// \param notes gets a sentence for each value
void assume_toughness(IncompleteMaterial& read, std::vector<std::string>& notes) {
    Rock& rock = read.material.rock;
    const auto assume = [&](const std::string& key, double& to, double value, const char* source) {
        if (std::erase(read.missing, "rock." + key) == 0) return;
        to = read.values["rock." + key] = value;
        notes.push_back(fmt::format("{} was not measured: {} {}", key, format_quantity(value, Dimension::toughness), source));
    };
    assume("mode_i_toughness", rock.mode_i_toughness, rock.tensile_strength / fpz::tensile_strength_from_toughness(1),
           "is tensile_strength/6.88, an empirical mean over many rocks (Zhang 2002)");
    assume("mode_ii_toughness", rock.mode_ii_toughness, mode_ii_over_mode_i * rock.mode_i_toughness,
           "is 2 K_IC, the ratio of Augig granite");
}

/// Round orders of magnitude that hold all rocks of share/materials, from soils to ores, and what is derived from them for
/// contacts. A warning needs a value a thousand times beyond them, so that they need not be known to a factor.
struct Magnitudes {
    double low, high;
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

/// Adds what a value makes doubtful. \param text as it stands in the file
void note_value(const std::string& text, const Quantity& quantity, double value, const std::string& where,
                std::vector<Remark>& notes) {
    constexpr double far = 1000;
    const std::string bare = bare_number_note(text, quantity, where);
    if (!bare.empty()) notes.emplace_back(bare);
    const auto rocks = magnitudes_of(quantity);
    if (!rocks || value == 0 || (value > rocks->low / far && value < rocks->high * far)) return;
    notes.emplace_back(fmt::format("{}: {} is more than {} times {} any rock's; is its unit right?", where,
                                   format_quantity(value, quantity.dimension), far, value < rocks->low ? "below" : "above"),
                       "unusual_value");
}

/// The keys of [ratios], bound to `ratios`, which must stay where it is; the ratio of the fracture energy is "process_zone".
std::vector<TomlKey> ratio_keys(ContactRatios& ratios) {
    const auto key = [](const char* name, std::optional<double>& target, const char* meaning) {
        return TomlKey{name, {name, Dimension::one, 0, 1e6, meaning, true}, to(target)};
    };
    return {key("tensile_strength", ratios.tensile_strength, "tensile strength of a contact over that of the rock"),
            key("cohesion", ratios.cohesion, "cohesion of a contact over its tensile strength"),
            key("process_zone", ratios.fracture_energy, "E G_I/tc^2 of a contact over the grain size"),
            key("mode_ii_fracture_energy", ratios.mode_ii_fracture_energy, "G_II of a contact over its G_I"),
            key("open_shear_strength", ratios.open_shear_strength, "shear strength of an open contact over its tensile strength"),
            key("bridging_strength", ratios.bridging_strength, "bridging strength of a contact over its tensile strength"),
            key("bridging_energy", ratios.bridging_energy, "bridging energy of a contact over K_IC^2/E~ of the rock")};
}

/// `given`, and where it has no value what the ratios make of the values before it in the table of contact parameters; a value
/// stays unset if what it follows from is unset. \param grain_size mean equal-area diameter of the grains, m
GivenContact with_ratios(GivenContact given, const ContactRatios& ratios, const Rock& rock, std::optional<double> grain_size,
                         PlaneCondition plane) {
    const auto follow = [&](std::optional<double> GivenContact::*key, const std::optional<double>& from) {
        if (!(given.*key) && ratios.*key && from) given.*key = *(ratios.*key) * *from;
    };
    follow(&GivenContact::tensile_strength, rock.tensile_strength);
    const std::optional<double>& tc = given.tensile_strength;
    follow(&GivenContact::cohesion, tc);
    follow(&GivenContact::open_shear_strength, tc);
    follow(&GivenContact::bridging_strength, tc);
    follow(&GivenContact::bridging_energy, fpz::mode_i_fracture_energy(rock, plane));
    if (tc && grain_size) follow(&GivenContact::fracture_energy, *grain_size * *tc * *tc / rock.young_modulus);
    follow(&GivenContact::mode_ii_fracture_energy, given.fracture_energy.value_or(fpz::mode_i_fracture_energy(rock, plane)));
    return given;
}

/// Values that [laboratory] may hold, by the names of its keys, in the order of the template.
constexpr std::array laboratory_quantities{quantity::young_modulus,
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

/// The keys of a material file, bound to a material.
std::vector<TomlKeys> tables_of(Material& material) {
    std::vector<TomlKeys> tables{
        {"rock", rock_keys(material.rock)},
        {"contact", contact_keys(material.contact)},
        {"ratios", ratio_keys(material.ratios)},
        {"platen", {{"friction_angle", quantity::platen_friction, to(material.platen_friction_angle), false}}},
        {"fabric", grain_keys(material.grains)},
        {"laboratory", {}},
    };
    for (const Quantity& quantity : laboratory_quantities) {
        const std::string name(quantity.name);
        tables.back().keys.push_back({name, quantity, [&material, name](double v) { material.laboratory[name] = v; }, false});
    }
    tables[1].keys.push_back(word_key("law", {}, [&material](const std::string& word) { material.law = word; }));
    return tables;
}

/// The keys of a table by its path, one of `tables_of`, of K_IC or of the fabric; nothing if there is no such table.
std::optional<TomlKeys> table_at(Material& material, const std::vector<std::string>& path) {
    if (fmt::format("{}", fmt::join(path, ".")) == measured_toughness) {
        TomlKeys table{measured_toughness, toughness_test_keys(material.toughness_test)};
        const auto set = [&material](double value) { material.laboratory["mode_i_toughness"] = value; };
        table.keys.push_back({"value", quantity::mode_i_toughness, set});
        return table;
    }
    for (TomlKeys& table : tables_of(material)) {
        if (path == std::vector<std::string>{table.path}) return table;
    }
    return fabric_table(material.fabric, path);
}

/// Tables that a calibration reads or writes: how it is done, what was fitted, and is predicted. No property of the rock.
bool is_of_calibration(const std::string& table) {
    return table == "targets" || table == "parameters" || table == "study" || table == "fitted" || table == "predicted";
}

/// The key that a ratio needs.
const char* const grain_size_of_ratio = "fabric.grain_size";

/// "mass density of the rock, in kg/m3": what a needed key is.
std::string meaning_of(const std::string& key) {
    const Quantity quantity = material_quantity(key);
    return fmt::format("{}, in {}{}", quantity.meaning, quantity.unit(),
                       key == grain_size_of_ratio ? ", over which ratios.process_zone is" : "");
}

/// Reads a key of a table of a material, if the table has it as a value: what is a table has been read.
void read_key(TomlTable& table, const TomlKey& key, IncompleteMaterial& read) {
    if (table.has(key.name) && !table.has_value(key.name)) return;
    if (key.is_word()) {
        std::string word;
        table.given(key.name, word);
        if (!table.has_value(key.name)) return;
        key.require_word(word, table.where(key.name));
        return key.set_word(word);
    }
    const bool is_array = key.values != nullptr && (!key.set || table.has_array(key.name));
    if (is_array) {
        table.given(key.name, key.quantity, *key.values);
        if (table.has_value(key.name) && key.values->empty()) table.refuse(key.name, "has no value; give one at least");
        return;
    }
    double value = 0;
    table.given(key.name, key.quantity, value);
    if (!table.has_value(key.name)) return;
    key.set(value);
    read.values[table.path() + "." + key.name] = value;
    note_value(table.shown(key.name), key.quantity, value, table.where(key.name), read.material.notes);
}

/// What the keys of a measured K_IC mean together. \throws InputError
void finish_toughness(const TomlTable& table, IncompleteMaterial& read) {
    if (!table.has_value("value")) table.refuse("value", "missing; K_IC is needed, such as value = \"1.5 MPa.m^0.5\"");
    read.values[table.path()] = *read.material.laboratory_value("mode_i_toughness");
    ToughnessTest& test = read.material.toughness_test;
    if (test.method.empty() && (test.size > 0 || test.notch > 0 || test.span > 0)) {
        table.refuse("method", "missing; a size belongs to a test, such as method = \"half-disc\"");
    }
    const char* const wrong = test.method == "beam" ? "diameter" : "height";
    if (table.has_value(wrong)) table.refuse(wrong, "does not belong to the method; a beam has a height, others a diameter");
    test = completed(test);
    const double whole = test.method == "beam" ? test.size : test.size / 2;
    if (!test.is_known() || test.notch < whole) return;
    table.refuse("notch", fmt::format("{} leaves no ligament; less than {:.4g} mm fits", table.shown("notch"), 1e3 * whole));
}

/// Reads a table of a material and those in it. \param read lacks the needed keys that tables of the fabric do not have
void read_table(TomlTable table, IncompleteMaterial& read) {
    const std::optional<TomlKeys> keys = table_at(read.material, table.section());
    if (!keys) {
        std::vector<std::string> known{"phases", "pairs", "flaws", "strength", "temperature"};
        for (const TomlKeys& each : tables_of(read.material)) known.push_back(each.path);
        table.refuse("", fmt::format("unknown table{}; known are {}", did_you_mean(table.name(), known), fmt::join(known, ", ")));
    }
    for (const TomlTable& below : table.tables()) read_table(below, read);
    for (const TomlKey& key : keys->keys) {
        read_key(table, key, read);
        if (key.needed && !table.has_value(key.name) && table.section().front() == "phases") {
            read.missing.push_back(table.path() + "." + key.name);
        }
    }
    table.refuse_others();
    if (table.path() == measured_toughness) finish_toughness(table, read);
}

/// Gives a material the phases of a file of phases, but for the values that it gives itself.
void add_phases_of(const std::string& name, IncompleteMaterial& to) {
    Material& material = to.material;
    const fs::path file = materials().below(fmt::format("phases/{}.toml", name));
    if (file.empty()) {
        throw InputError(
            fmt::format("{}: phases.from: there is no file phases/{}.toml beside the materials", material.file.string(), name));
    }
    TomlTable toml(read_toml(file.string()));
    IncompleteMaterial read;
    if (const auto phases = toml.table("phases")) read_table(*phases, read);
    toml.refuse_others();
    for (auto& [phase, of_file] : read.material.fabric.phases) {
        const auto own = material.fabric.phases.find(phase);
        if (own != material.fabric.phases.end()) of_file = overlay(own->second, of_file);
        material.fabric.phases[phase] = of_file;
        std::erase(to.missing, fmt::format("phases.{}.fraction", phase));
    }
}

/// The needed keys that are not there and that no ratio gives, in the order of tables_of, before those of phases.
void find_missing(IncompleteMaterial& read) {
    ContactRatios& ratios = read.material.ratios;
    std::vector<std::string> missing;
    for (const auto& [table, keys] : tables_of(read.material)) {
        for (const TomlKey& key : keys) {
            const std::string name = table + "." + key.name;
            if (key.needed && !read.values.contains(name)) missing.push_back(name);
        }
    }
    for (const ContactParameter& row : all_contact_parameters()) {
        if (ratios.*row.given) std::erase(missing, "contact." + row.key());
    }
    read.missing.insert(read.missing.begin(), missing.begin(), missing.end());
    if (ratios.fracture_energy && !read.material.grains.grain_size) read.missing.emplace_back(grain_size_of_ratio);
}

/// Adds what values of the laboratory make doubtful together. The moduli of rocks are 100 to 1000 times their compressive
/// strength (Deere & Miller 1966): less than half and more than twice of that is told.
void note_order(Material& material) {
    const auto strength = material.laboratory_value("compressive_strength");
    const auto note = [&material](const std::string& text) { material.notes.emplace_back(text, "unusual_value"); };
    const auto shown = [](double value) { return format_quantity(value, Dimension::stress); };
    if (!strength) return;
    const double tension = material.laboratory_value("tensile_strength").value_or(material.rock.tensile_strength);
    if (tension > 0 && *strength < tension) {
        note(fmt::format("laboratory: the compressive strength of {} is below the tensile strength of {}; are they exchanged?",
                         shown(*strength), shown(tension)));
    }
    constexpr double least_ratio = 50, most_ratio = 2000;
    const double modulus = material.laboratory_value("young_modulus").value_or(material.rock.young_modulus);
    const double ratio = modulus / *strength;
    if (modulus > 0 && (ratio < least_ratio || ratio > most_ratio)) {
        note(
            fmt::format("laboratory: a Young's modulus of {} is {:.3g} times the compressive strength of {}; rocks have 100 to "
                        "1000 times; are their units right?",
                        shown(modulus), ratio, shown(*strength)));
    }
}

/// All at once, so that a file is completed in one go.
void refuse_missing(const fs::path& file, const std::vector<std::string>& missing) {
    if (missing.empty()) return;
    std::string list;
    for (const std::string& key : missing) list += fmt::format("{}{} ({})", list.empty() ? "" : ", ", key, meaning_of(key));
    throw InputError(
        fmt::format("{}: {} missing: {}; what [laboratory] has counts for [rock]; graincrack-post material init --kind every-key "
                    "writes a template with every key",
                    file.string(), missing.size() == 1 ? "a key is" : fmt::format("{} keys are", missing.size()), list));
}

}  // namespace

IncompleteMaterial read_incomplete_material(const std::string& name_or_file) {
    if (name_or_file.empty()) throw InputError("no material given; name one, such as augig-granite, or a TOML file");
    IncompleteMaterial read;
    Material& material = read.material;
    material.file = materials().find(name_or_file);
    const TomlFile toml = read_toml(material.file.string());
    TomlTable file(toml);
    file.given("name", material.name);
    file.given("kind", material.kind);
    for (const TomlTable& table : file.tables()) {
        if (!is_of_calibration(table.name())) read_table(table, read);
    }
    file.refuse_others();
    for (const TomlEntry& entry : toml.entries) {
        const bool is_fitted = !entry.section.empty() && entry.section.front() == "fitted" && !entry.values.empty();
        if (is_fitted) material.fitted[entry.key] = entry.values.front().text;
    }
    if (material.name.empty()) throw InputError(fmt::format("{}: name is missing; give the material a name", toml.file));
    find_missing(read);
    if (!material.fabric.from.empty()) add_phases_of(material.fabric.from, read);
    require_sound_grains(material.grains, toml.file);
    require_sound_fabric(material.fabric, material.rock, toml.file);
    note_order(material);
    return read;
}

void take_laboratory(IncompleteMaterial& read) {
    Material& material = read.material;
    const bool is_of_laboratory = has(read.missing, "rock.tensile_strength") && material.laboratory.contains("tensile_strength");
    std::vector<std::string> sentences;  // which `material init` and `fpz` say
    take_measured_rock(read, sentences);
    if (is_of_laboratory) assume_toughness(read, sentences);
    const auto size = material.laboratory.find("grain_size");
    if (material.grains.tessellation.empty() || material.grains.grain_size || size == material.laboratory.end()) return;
    material.grains.grain_size = read.values["fabric.grain_size"] = size->second;
    std::erase(read.missing, "fabric.grain_size");
}

Rock rock_of_laboratory(const IncompleteMaterial& incomplete, std::vector<std::string>& notes) {
    IncompleteMaterial read = incomplete;
    take_measured_rock(read, notes);
    for (const char* key : {"young_modulus", "poisson_ratio", "tensile_strength"}) {
        if (!has(read.missing, std::string("rock.") + key)) continue;
        throw InputError(fmt::format("{}: neither rock.{} nor laboratory.{} is there; one of them is needed",
                                     read.material.file.string(), key, key));
    }
    assume_toughness(read, notes);
    return read.material.rock;
}

Material read_material(const std::string& name_or_file) {
    IncompleteMaterial read = read_incomplete_material(name_or_file);
    take_laboratory(read);
    refuse_missing(read.material.file, read.missing);
    return std::move(read.material);
}

void write_notes(std::ostream& out, std::string_view program, const Material& material) {
    for (const Remark& note : material.notes) {
        if (note.code.empty()) {
            say(out, fmt::format("{}: note: {}", program, printable(note.text)));
        } else {
            warn(out, std::string(program), note, material.file.string());
        }
    }
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
    const auto parts = split(key, '.');
    const std::vector<std::string> path(parts.begin(), parts.end() - 1);
    const std::string_view name = parts.back();
    if (const auto table = path.empty() ? std::nullopt : table_at(unused, path)) {
        for (const TomlKey& each : table->keys) {
            if (each.name == name) return each;
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
    try {
        return {Kind::value, parse_quantity(text, contact_parameter(&ContactParameters::fracture_energy).quantity, where)};
    } catch (const UsageError& error) {
        throw UsageError(fmt::format("{}; the words mixed and mode-i fit too", error.what()));
    }
}

std::string_view name_of(FractureEnergyChoice::Kind kind) { return name_in({"mixed", "mode-i", "value"}, kind); }

FractureEnergyChoice effective_fracture_energy(const Material& material, const std::optional<FractureEnergyChoice>& choice) {
    if (choice) return *choice;
    const std::optional<double> own = given_contact(material, PlaneCondition::strain, std::nullopt).fracture_energy;
    if (own) return {FractureEnergyChoice::Kind::value, *own};
    return {FractureEnergyChoice::Kind::mode_i, 0};
}

GivenContact given_contact(const Material& material, PlaneCondition plane, const std::optional<FractureEnergyChoice>& choice) {
    GivenContact given = material.contact;
    if (choice) {
        using Kind = FractureEnergyChoice::Kind;
        given.fracture_energy = choice->kind == Kind::value   ? choice->value
                                : choice->kind == Kind::mixed ? fpz::mixed_mode_fracture_energy(material.rock, plane)
                                                              : fpz::mode_i_fracture_energy(material.rock, plane);
    }
    return with_ratios(given, material.ratios, material.rock, material.grains.grain_size, plane);
}

ContactParameters contact_parameters(const Material& material, PlaneCondition plane,
                                     const std::optional<FractureEnergyChoice>& choice) {
    return derived_contact(given_contact(material, plane, choice), material.rock, plane);
}

std::optional<double> Material::laboratory_value(const std::string& key) const {
    const auto found = laboratory.find(key);
    return found == laboratory.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace graincrack
