#include "post/table/table_form.hpp"

#include <unistd.h>

#include <iostream>

#include "share/options/command_line.hpp"

namespace graincrack {

void add_form(CLI::App& app, TableForm& form) {
    add_choice<TableForm>(app, "--format", form,
                          {{"table", TableForm::table}, {"tsv", TableForm::tsv}, {"jsonl", TableForm::jsonl}},
                          "form of the table: terminal table (few columns, with units), tab-separated values with one header "
                          "line, or JSON lines; default: table on a terminal, tsv elsewhere");
}

std::optional<TableFormat> format_of(TableForm form, const std::ostream& out) {
    switch (form) {
        case TableForm::table: return std::nullopt;
        case TableForm::tsv: return TableFormat::tsv;
        case TableForm::jsonl: return TableFormat::jsonl;
        case TableForm::automatic: break;
    }
    const bool terminal = out.rdbuf() == std::cout.rdbuf() && ::isatty(STDOUT_FILENO) == 1;
    return terminal ? std::nullopt : std::optional(TableFormat::tsv);
}

}  // namespace graincrack
