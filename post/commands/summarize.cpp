#include "post/commands/summarize.hpp"

#include "post/fit/fit_options.hpp"
#include "post/options/common_options.hpp"
#include "post/summary/summarize.hpp"
#include "share/options/command_line.hpp"

namespace graincrack {

Command summarize_command() {
    using summary::SummaryOptions;
    return make_command<SummaryOptions>(
        "summarize", "statistics of tables by groups of rows: means, deviations, intervals, fits",
        {"strength.tsv --by test --column 'runs=n(file)' --column 'mean_MPa=mean(tensile_strength_MPa)'",
         "strength.tsv --where test!=brazilian --by confining_pressure_MPa --sort --column 'cracks=mean(tensile_cracks + "
         "shear_cracks)'"},
        trend_tables,
        [](CLI::App& app, SummaryOptions& options) {
            add_names(app, "--by", options.by, "COLUMN|NAME=EXPRESSION",
                      "one row for each value of this column; may be given again");
            app.add_option("--join", options.join, "merge the rows that have the same value in this column")->type_name("COLUMN");
            add_names(app, "--where", options.where, "CONDITION",
                      "use only rows that meet COLUMN=VALUE, or !=, <, <=, >, >=; may be given again");
            add_names(app, "--column", options.columns, "NAME=EXPRESSION",
                      "a column of the result: statistics such as mean(A), n(A where B=x), slope(X, Y) with + - * / | and "
                      "numbers, or a text with them in braces: {mean(A):.1f}; may be given again");
            app.add_flag("--sort", options.sort, "sort the rows by the columns of --by");
            app.add_option("--label", options.label, "give tables as LABEL=FILE; this new column holds the label")
                ->type_name("COLUMN");
            add_names(app, "--look-up", options.look_up, "TABLE",
                      "add the columns of this table to each row with the same value in its first column; may be given again");
            add_choice<TableFormat>(
                app, "--format", options.format,
                {{"table", TableFormat::aligned},
                 {"tsv", TableFormat::tsv},
                 {"jsonl", TableFormat::jsonl},
                 {"markdown", TableFormat::markdown}},
                "form of the table: aligned columns, tab-separated values with one header line, JSON lines, or Markdown");
        },
        [](const SummaryOptions& options, const Call& call) { summary::write_summary(call.out, call.files, options); });
}

}  // namespace graincrack
