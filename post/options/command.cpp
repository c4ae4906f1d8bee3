#include "post/options/command.hpp"

#include <fmt/format.h>

#include "share/base/error.hpp"
#include "share/options/option_set.hpp"

namespace graincrack {

const std::string& Call::file() const {
    if (files.size() == 1) return files.front();
    throw UsageError(fmt::format("{}: takes one file, not {}", command, files.size()));
}

std::ostream& Call::diagnostics() const { return graincrack::diagnostics(verbosity); }

void add_columns(OptionSet set, ColumnChoice& columns) {
    add_flag(
        set, "--all-columns", [&columns] { columns = ColumnChoice::all; },
        "all columns of the table for scripts, not only those that most people want; see share/doc/tables.md");
}

Option add_output(OptionSet set, std::string& output, const std::string& help, const std::vector<std::string>& endings) {
    return add_output_file(set, output, help, endings).required();
}

Material read_material_of(const Call& call, const std::string& name_or_file) {
    Material material = read_material(name_or_file);
    write_notes(call.diagnostics(), call.command, material);
    return material;
}

IncompleteMaterial read_incomplete_material_of(const Call& call, const std::string& name_or_file) {
    IncompleteMaterial read = read_incomplete_material(name_or_file);
    write_notes(call.diagnostics(), call.command, read.material);
    return read;
}

}  // namespace graincrack
