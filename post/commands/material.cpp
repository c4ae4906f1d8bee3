#include "post/commands/commands.hpp"

#include <fmt/ostream.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "post/kind/kind_surface.hpp"
#include "post/options/command.hpp"
#include "post/table/column.hpp"
#include "share/base/error.hpp"
#include "share/base/events.hpp"
#include "share/base/text.hpp"
#include "share/base/units.hpp"
#include "share/file/output_file.hpp"
#include "share/options/option_set.hpp"
#include "share/rock/material.hpp"
#include "share/rock/material_edit.hpp"

namespace graincrack {

namespace {

std::vector<MaterialSetting> settings_of(const std::vector<std::string>& texts) {
    std::vector<MaterialSetting> settings;
    for (const std::string& text : texts) settings.push_back(key_and_value(text, "--set", "KEY=VALUE"));
    return settings;
}

void write_kinds(std::ostream& out) {
    for (const RockKind& kind : rock_kinds()) fmt::print(out, "{:<10} {}\n", kind.name, kind.description);
}

void write_new_material(const std::string& kind, const std::string& name, const std::vector<MaterialSetting>& settings) {
    if (name.empty()) throw UsageError("name: the material needs a name; --list shows the kinds of rock");
    if (name.find_first_of("/\"\\\n") != std::string::npos || name == "-") {
        throw UsageError("name: " + name + ": a plain name is needed, without slashes or quotes");
    }
    const std::string file = name + ".toml";
    if (std::filesystem::exists(file)) throw OutputError(file + ": exists; remove it first, or give another name");
    write_whole_file(file, new_material(kind, name, settings));
}

Command init_command() {
    struct Options {
        std::string name;
        std::string kind;
        bool list = false;
        std::vector<std::string> settings;
    };
    return make_command<Options>(
        "init", "write a material file of a kind of rock, in which laboratory values are to be entered",
        {"my-rock --kind granite", "carrara-marble --kind marble --set 'laboratory.young_modulus=49 GPa'"}, std::nullopt,
        [](OptionSet set, Options& options) {
            add_text(set, "name", options.name, "name of the material; NAME.toml is written, in this folder");
            add_text(set, "--kind", options.kind,
                     fmt::format("kind of rock, whose minerals, grains and ratios it has, or {}, a template with every key; "
                                 "default: {}",
                                 every_key, usual_kind));
            add_flag(set, "--list", options.list, "list the kinds of rock, and write nothing");
            add_texts(set, "--set", options.settings, "KEY=VALUE",
                      "value to enter, with the key and its table, such as laboratory.cohesion; may be given again");
        },
        [](const Options& options, const Call& call) {
            if (options.list) return write_kinds(call.out);
            write_new_material(options.kind.empty() ? usual_kind : options.kind, options.name, settings_of(options.settings));
            if (options.kind.empty()) {
                say(call.diagnostics(),
                    fmt::format("{}.toml: of the kind {}; --kind names another, --list shows all", options.name, usual_kind));
            }
            say(call.diagnostics(), fmt::format("{}.toml: enter your {}values, then use it as --material {}.toml", options.name,
                                                options.settings.empty() ? "" : "other ", options.name));
            say(call.diagnostics(),
                fmt::format("{}.toml: unless measured, K_IC is tensile_strength/6.88 (Zhang 2002), K_IIC twice that",
                            options.name));
        });
}

/// \param unit "": that of tables
void write_value(const Call& call, const std::string& key, const std::string& name_or_file, const std::string& unit) {
    const Quantity quantity = material_quantity(key);
    IncompleteMaterial read = read_incomplete_material_of(call, name_or_file);
    take_laboratory(read);
    const auto value = read.values.find(key);
    if (value == read.values.end()) {
        throw InputError(fmt::format("{}: has no {}; it is the {}", read.material.file.string(), key, quantity.meaning));
    }
    std::vector<std::string_view> symbols;
    for (const Unit& each : units_of(quantity.dimension)) symbols.push_back(each.symbol);
    if (!unit.empty() && std::ranges::find(symbols, unit) == symbols.end()) {
        throw UsageError(fmt::format("--unit {}: {} is a {}; one of {} fits", unit, key, name_of(quantity.dimension),
                                     fmt::join(symbols, ", ")));
    }
    const std::string_view shown = unit.empty() ? unit_in_tables(quantity.dimension).name : std::string_view(unit);
    fmt::print(call.out, "{}\n", format_number(in_unit(value->second, quantity.dimension, shown), 6));
}

Command value_command() {
    struct Options {
        std::string key;
        std::string material;
        std::string unit;
    };
    return make_command<Options>(
        "value", "print one value of a material as a bare number, for scripts",
        {"contact.cohesion augig-granite", "rock.young_modulus augig-granite --unit GPa"}, std::nullopt,
        [](OptionSet set, Options& options) {
            add_text(set, "key", options.key, "table and key, such as contact.cohesion").required();
            add_text(set, "material", options.material, "material: a name of share/materials or a TOML file").required();
            add_text(set, "--unit", options.unit,
                     "unit of the number; default: MPa, deg, mm or MPa.m^0.5, and SI for other quantities");
        },
        [](const Options& options, const Call& call) { write_value(call, options.key, options.material, options.unit); });
}

Command with_command() {
    struct Options {
        std::string material;
        std::vector<std::string> settings;
    };
    return make_command<Options>(
        "with", "print a material file with other values; comments are kept",
        {"augig-granite --set 'contact.cohesion=70 MPa'",
         "augig-granite --set name='Augig granite, stiff' --set 'rock.young_modulus=30 GPa' --set rock.poisson_ratio=0.2"},
        std::nullopt,
        [](OptionSet set, Options& options) {
            add_text(set, "material", options.material, "material: a name of share/materials or a TOML file").required();
            add_texts(set, "--set", options.settings, "KEY=VALUE",
                      "new value of a key with its table, such as contact.cohesion, or of name; may be given again")
                .required();
        },
        [](const Options& options, const Call& call) {
            call.out << material_with(options.material, settings_of(options.settings));
        });
}

}  // namespace

Command material_command() {
    return make_group("material", "material files: begin one of a kind of rock, print a value, change values",
                      {init_command(), value_command(), with_command()});
}

Command kind_command() {
    return make_command<bool>(
        "kind", "what specimens of a kind of rock have in common: strengths over the contacts' tensile strength as a surface",
        {"--format table", "--rocks --format table"},
        FileArguments{"table", "table of specimens; default: kinds/surface.tsv beside the materials", false},
        [](OptionSet set, bool& rocks) {
            add_flag(set, "--rocks", rocks, "how far it is off the calibrated rocks of the table, of which it is not made");
        },
        [](const bool& of_rocks, const Call& call) {
            const std::vector<KindRow> rows = call.files.empty() ? kind_rows() : read_kind_rows(call.file());
            if (rows.empty()) throw InputError("kinds/surface.tsv: not found beside the materials; name a table");
            const KindSurface surface(rows, usual_kind);
            if (of_rocks) return write_kind_rocks(call.out, surface, rows, call.format);
            write_kind_terms(call.out, surface, call.format);
        },
        Prints::terminal_table);
}

}  // namespace graincrack
