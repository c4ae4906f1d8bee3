#include "post/commands/material.hpp"

#include <fmt/ostream.h>

#include <filesystem>

#include "post/table/output_file.hpp"
#include "share/command_line.hpp"
#include "share/error.hpp"
#include "share/incomplete_material.hpp"

namespace graincrack {

namespace {

void write_template(const std::string& name) {
    if (name.find_first_of("/\"\\\n") != std::string::npos || name == "-") {
        throw UsageError("name: " + name + ": a plain name is wanted, without slashes or quotes");
    }
    const std::string file = name + ".toml";
    if (std::filesystem::exists(file)) throw OutputError(file + ": exists; remove it first, or give another name");
    write_whole_file(file, material_template(name));
}

Command init_command() {
    struct Options {
        std::string name;
    };
    return make_command<Options>(
        "init", "a commented template of a material file: every key with its unit and default", {"my-rock", "carrara-marble"},
        std::nullopt,
        [](CLI::App& app, Options& options) {
            app.add_option("name", options.name, "name of the material; NAME.toml is written, in this folder")->required();
        },
        [](const Options& options, const Call& call) {
            write_template(options.name);
            fmt::print(call.diagnostics(), "{}.toml: enter your values, then use it as --material {}.toml\n", options.name,
                       options.name);
        });
}

}  // namespace

Command material_command() { return make_group("material", "materials: a template to fill in", {init_command()}); }

}  // namespace graincrack
