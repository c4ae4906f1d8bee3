// Options that several commands of graincrack-post share.
#pragma once

#include <string>
#include <vector>

#include "post/ccd/tables.hpp"
#include "post/cracks/export.hpp"
#include "post/fit/envelope.hpp"
#include "post/fit/trend.hpp"
#include "post/measure/strength.hpp"
#include "post/options/command.hpp"
#include "post/table/table.hpp"
#include "share/rock/incomplete_material.hpp"

namespace graincrack {

/// --format tsv|jsonl
void add_format(CLI::App& app, TableFormat& format);
/// -o, --output, which is required. \param help what is written
void add_output(CLI::App& app, std::string& output, const std::string& help);
/// --capped and --strength: which runs an envelope has, and which stress of them.
void add_envelope_options(CLI::App& app, EnvelopeOptions& options);
/// --capped refuse|accept
void add_strain_limit_runs(CLI::App& app, StrainLimitRuns& strain_limit_runs);
/// An option that may be given again. \param type of its value, as help shows it
void add_names(CLI::App& app, const std::string& option, std::vector<std::string>& target, const std::string& type,
               const std::string& help);
/// --material of a command that shows laboratory values of a rock beside results.
void add_laboratory_material(CLI::App& app, std::string& material);
/// The material of an option; notes on its values go to the diagnostics of the call. \throws InputError as `read_material`
Material read_material_of(const Call& call, const std::string& name_or_file);
/// The same of a material that may lack keys.
IncompleteMaterial read_incomplete_material_of(const Call& call, const std::string& name_or_file);
inline constexpr FileArguments design_table{"table", "table of the runs: x1, x2, … and the responses"};
/// --factor, --model, --alpha: how a model is fitted to the runs of a design.
void add_model(CLI::App& app, ccd::ModelOptions& options);
/// --target, --maximise, --minimise: the goals for the responses.
void add_goals(CLI::App& app, ccd::GoalOptions& options);
inline constexpr FileArguments trend_tables{"tables",
                                            "tables: tab-separated values with one header line; their rows are combined"};
/// --x, --y, --power, --group: a line or power law through columns of tables.
void add_trend(CLI::App& app, TrendOptions& options);
/// --crack-event failed|half-damaged|broken, --crack-mode traction|sign: what counts as a micro-crack, and which are tensile.
void add_crack_label(CLI::App& app, CrackLabelChoice& label);
/// --class PAIR, which may be given again: what a picture of cracks is limited to.
void add_classes(CLI::App& app, std::vector<std::string>& classes);
/// --event-distance, --event-time: the window of an acoustic event.
void add_events(CLI::App& app, EventOptions& options);

}  // namespace graincrack
