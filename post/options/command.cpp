#include "post/options/command.hpp"

#include <fmt/format.h>

#include <unistd.h>
#include <iostream>

#include "share/base/error.hpp"
#include "share/options/option_set.hpp"

namespace graincrack {

const std::string& Call::file() const {
    if (files.size() == 1) return files.front();
    throw UsageError(fmt::format("{}: takes one file, not {}", command, files.size()));
}

std::ostream& Call::diagnostics() const { return graincrack::diagnostics(verbosity); }

void add_format(OptionSet set, TableFormat& format) {
    add_choice<TableFormat>(set, "--format", format,
                            {{"table", TableFormat::aligned}, {"tsv", TableFormat::tsv}, {"jsonl", TableFormat::jsonl}},
                            "form of the table: aligned columns, tab-separated values with one header line, or JSON lines");
}

void add_format(OptionSet set, std::optional<TableFormat>& format) {
    add_choice<std::optional<TableFormat>>(
        set, "--format", format, {{"table", TableFormat::aligned}, {"tsv", TableFormat::tsv}, {"jsonl", TableFormat::jsonl}},
        "form of the table: terminal table (few columns, with units), tab-separated values with one header line, or JSON lines; "
        "default: table on a terminal, tsv elsewhere");
}

void add_columns(OptionSet set, ColumnOptions& options) {
    add_format(set, options.format);
    add_flag(
        set, "--all-columns", [&options] { options.columns = ColumnChoice::all; },
        "all columns of the table for scripts, not only those that most people want; see share/doc/tables.md");
}

TableFormat format_for(const std::optional<TableFormat>& format, const std::ostream& out) {
    const bool is_terminal = out.rdbuf() == std::cout.rdbuf() && ::isatty(STDOUT_FILENO) == 1;
    return format.value_or(is_terminal ? TableFormat::aligned : TableFormat::tsv);
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
