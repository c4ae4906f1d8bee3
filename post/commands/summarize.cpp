#include "post/commands/commands.hpp"

#include "post/fit/fit_options.hpp"
#include "post/options/command.hpp"
#include "post/summary/summarize.hpp"
#include "share/options/option_set.hpp"

namespace graincrack {

Command summarize_command() {
    using summary::SummaryOptions;
    return make_command<SummaryOptions>(
        "summarize", "tables queried by SQL, with means, deviations, intervals and fits",
        {"strength.tsv --sql 'SELECT test, count(*) AS runs, mean(tensile_strength_MPa) AS mean_MPa FROM strength GROUP BY test'",
         "strength.tsv --sql \"SELECT test, mean_and_half(energy_balance_error, '.1e') FROM strength GROUP BY test\" --pivot "
         "--format markdown"},
        FileArguments{"tables", "tables as FILE, named by the stem of the file, or NAME=FILE; those of one name are combined"},
        [](OptionSet set, SummaryOptions& options) {
            add_text(
                set, "--sql", options.sql,
                "a SELECT as SQLite has it, or a file *.sql with one. Further aggregates: mean, median, deviation (n-1), low, "
                "high, half_interval (95 %, Student's t), slope(x, y), intercept, exponent, each with _low and _high, "
                "lack_of_fit, rank_correlation, cohesion(s3, s1), friction_angle, mean_and_half(x, '.1f'), entries; "
                "text('{:.1f} of {}', x, y) formats numbers. "
                "Default: all of the first table")
                .type_name("QUERY|FILE.sql");
            add_texts(set, "--set", options.settings, "NAME=VALUE", "value of :NAME in the query; may be given again");
            add_flag(set, "--pivot", options.pivot,
                     "the last two columns of the query are a name and a value: make a column for each name");
            add_text(set, "--label", options.label, "add this column to each table: the name of the row's file without its end")
                .type_name("COLUMN");
            add_choice<TableFormat>(
                set, "--format", options.format,
                {{"table", TableFormat::aligned},
                 {"tsv", TableFormat::tsv},
                 {"jsonl", TableFormat::jsonl},
                 {"markdown", TableFormat::markdown}},
                "form of the table: aligned columns, tab-separated values with one header line, JSON lines, or Markdown");
        },
        [](const SummaryOptions& options, const Call& call) { summary::write_summary(call.out, call.files, options); });
}

}  // namespace graincrack
