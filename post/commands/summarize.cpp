#include "post/commands/summarize.hpp"

#include "post/option_parts.hpp"
#include "post/summary/summarize.hpp"
#include "share/command_line.hpp"

namespace graincrack {

Command summarize_command() {
    using summary::SummaryOptions;
    return make_command<SummaryOptions>(
        "summarize", "statistics of the rows of tables by groups: means, deviations, intervals, fits",
        {"strength.tsv --by test --column 'runs=n(file)' --column 'mean_MPa=mean(tensile_strength_MPa)'",
         "strength.tsv --where test!=brazilian --by confining_pressure_MPa --sort --column 'cracks=mean(tensile_cracks + "
         "shear_cracks)'"},
        trend_tables,
        [](CLI::App& app, SummaryOptions& options) {
            add_names(app, "--by", options.by, "COLUMN|NAME=EXPRESSION",
                      "a row for each different entry of this column; may be given again");
            app.add_option("--join", options.join, "rows of the tables with one entry in this column are one row")
                ->type_name("COLUMN");
            add_names(app, "--where", options.where, "CONDITION",
                      "only rows that meet COLUMN=VALUE, or !=, <, <=, >, >=; may be given again");
            add_names(app, "--column", options.columns, "NAME=EXPRESSION",
                      "a column: statistics such as mean(A), n(A where B=x), slope(X, Y), with + - * / | and numbers; or a text "
                      "that has them as {mean(A):.1f}; may be given again");
            app.add_flag("--sort", options.sort, "rows by rising entries of the columns of --by");
            app.add_option("--label", options.label, "tables are given as LABEL=FILE, and this new column has the label")
                ->type_name("COLUMN");
            add_names(app, "--look-up", options.look_up, "TABLE",
                      "columns of this table are added to each row with the same entry in its first column; may be given again");
            add_choice<TableFormat>(
                app, "--format", options.format,
                {{"table", TableFormat::aligned},
                 {"tsv", TableFormat::tsv},
                 {"jsonl", TableFormat::jsonl},
                 {"markdown", TableFormat::markdown}},
                "form of the table: aligned columns, tab-separated with one header line, JSON lines, or Markdown");
        },
        [](const SummaryOptions& options, const Call& call) { summary::write_summary(call.out, call.files, options); });
}

}  // namespace graincrack
