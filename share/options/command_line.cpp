#include "share/options/command_line.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sched.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <thread>

#include "share/base/error.hpp"
#include "share/base/text.hpp"
#include "share/file/provenance.hpp"
#include "share/options/configuration_file.hpp"
#include "share/options/description.hpp"

namespace graincrack {
namespace {

/// The name of an option in a message: "--edge".
std::string shown_name(const CLI::Option& option) {
    return option.get_lnames().empty() ? option.get_name(option.get_positional()) : "--" + option.get_lnames().front();
}

bool is_flag(const CLI::Option& option) { return option.get_expected_min() == 0; }

/// Text for a one-line message.
std::string one_line(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    while (!text.empty() && (text.back() == '.' || text.back() == ' ')) text.pop_back();
    return text;
}

/// The command that shows all options of the subcommand that runs.
std::string help_command(CLI::App& app) {
    std::string command;
    for (const CLI::App* each : running(app)) command += each->get_name() + " ";
    return command + "--help-all";
}

void for_each_app(CLI::App& app, const std::function<void(CLI::App&)>& action) {
    action(app);
    for (CLI::App* sub : app.get_subcommands({})) for_each_app(*sub, action);
}

// --- help ------------------------------------------------------------------------------------------------------------

/// Formats help, which shows the usual options of a command; with --help-all all of them and those of the program.
class HelpFormatter : public CLI::Formatter {
public:
    std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override {
        const bool all = mode == CLI::AppFormatMode::All;
        std::string text = make_description(app) + make_usage(app, std::move(name)) + make_positionals(app) +
                           make_group("Options", false, shown_options(app, all));
        for (const CLI::App* parent = app->get_parent(); parent != nullptr && all; parent = parent->get_parent()) {
            auto options = shown_options(parent, true);
            std::erase_if(options, [parent](const CLI::Option* option) { return is_help(option, parent); });
            text += make_group("Options of " + parent->get_name(), false, options);
        }
        return text + make_subcommands(app, CLI::AppFormatMode::Normal) + "\n" + make_footer(app);
    }

    /// Wraps descriptions into lines of readable length.
    std::string make_option_desc(const CLI::Option* option) const override {
        constexpr std::size_t width = 88;
        std::istringstream words(CLI::Formatter::make_option_desc(option));
        std::string text;
        std::size_t length = 0;
        for (std::string word; words >> word; length += word.size()) {
            if (length > 0 && length + 1 + word.size() > width) {
                text += '\n';
                length = 0;
            } else if (length > 0) {
                text += ' ';
                ++length;
            }
            text += word;
        }
        return text;
    }

    std::string make_option_opts(const CLI::Option* option) const override {
        std::string text;
        if (option->get_type_size() != 0) {
            if (!option->get_type_name().empty()) text += " " + option->get_type_name();
            if (option->get_required()) {
                text += " REQUIRED";
            } else if (const std::string usual = shown_default(*option); !usual.empty()) {
                text += " = " + usual;
            }
            if (option->get_expected_max() == CLI::detail::expected_max_vector_size) text += " ...";
        }
        return text;
    }
};

/// The answer to --describe.
std::string description_of(const CLI::App& app, const WrittenRows& written) {
    using Json = nlohmann::ordered_json;
    const auto values = [](const std::vector<NamedValue>& rows, const char* name) {
        Json all = Json::array();
        for (const NamedValue& row : rows) all.push_back({{name, row.name}, {"unit", row.unit}, {"meaning", row.meaning}});
        return all;
    };
    const Json own = describe(app);
    Json all{{"program", app.get_name()}, {"version", project_version()}, {"schema", 1}};
    for (const char* part : {"description", "options", "commands"}) all[part] = own[part];
    all["tables"] = Json::array();
    for (const TableRow& table : written.tables) {
        Json& row = all["tables"].emplace_back(Json{{"command", table.command}});
        if (!table.file.empty()) row["file"] = table.file;
        row["columns"] = values(table.columns, "name");
    }
    all["datasets"] = values(written.datasets, "path");
    return all.dump();
}

// --- notes -----------------------------------------------------------------------------------------------------------

/// Prints numbers without units that may be wrong and, with --verbose, the options in use; nothing with --quiet.
void print_notes(const CLI::App& app) {
    std::ostream& out = diagnostics(app.count("--quiet") > 0 ? Verbosity::quiet : Verbosity::normal);
    for (const std::string& note : bare_number_notes()) say(out, fmt::format("{}: note: {}", app.get_name(), note));
    if (app.count("--verbose") > 0) std::cerr << effective_configuration(app);
}

// --- errors ----------------------------------------------------------------------------------------------------------

using Arguments = std::vector<std::string>::const_iterator;

/// The parsed call, for messages.
struct Call {
    CLI::App& app;
    std::vector<std::string> arguments;
};

CLI::Option* find_option(const Call& call, const std::string& name) {
    for (CLI::App* each : running(call.app)) {
        if (CLI::Option* option = each->get_option_no_throw(name); option != nullptr) return option;
    }
    return nullptr;
}

bool on_command_line(const Call& call, const CLI::Option& option) {
    const auto given = [&](const std::string& argument) {
        return std::any_of(option.get_lnames().begin(), option.get_lnames().end(),
                           [&](const std::string& name) {
                               return argument == "--" + name || argument.compare(0, name.size() + 3, "--" + name + "=") == 0;
                           }) ||
               std::any_of(option.get_snames().begin(), option.get_snames().end(),
                           [&](const std::string& name) { return argument.compare(0, name.size() + 1, "-" + name) == 0; });
    };
    return std::any_of(call.arguments.begin(), call.arguments.end(), given);
}

/// "--edge" or, if the value was not on the command line, "--edge (from run.toml, line 3)".
std::string with_origin(const Call& call, const CLI::Option& option) {
    std::string name = shown_name(option);
    if (on_command_line(call, option)) return name;
    const ConfigurationFile* file = configuration_file(call.app);
    const std::string origin = file == nullptr ? "" : file->origin(&option);
    return origin.empty() ? name : fmt::format("{} (from {})", name, origin);
}

/// A message "--option: …" with the origin of the value after the option.
std::string with_origin_in(const Call& call, const std::string& message) {
    const auto end = message.find(": ");
    if (end == std::string::npos || message.find(' ') < end) return message;
    const CLI::Option* option = find_option(call, message.substr(0, end));
    return option == nullptr ? message : with_origin(call, *option) + message.substr(end);
}

std::string subcommand_message(const CLI::App& app, const std::string& wrong) {
    const std::vector<std::string> names = subcommand_names(app);
    const std::string given =
        wrong.empty() ? "no subcommand given" : fmt::format("unknown subcommand \"{}\"{}", wrong, did_you_mean(wrong, names));
    return fmt::format("{}; one of {} fits", given, fmt::join(names, ", "));
}

/// The message for unknown options and superfluous arguments.
std::string leftover_message(const Call& call, const std::vector<std::string>& left) {
    const CLI::App* last = running(call.app).back();
    const bool wants_subcommand = !last->get_subcommands({}).empty();
    if (wants_subcommand && left.front().front() != '-') return subcommand_message(*last, left.front());
    for (const std::string& argument : left) {
        if (argument.size() < 2 || argument.front() != '-') continue;
        const std::string name = argument.substr(0, argument.find('='));
        std::vector<std::string> known;
        for (const CLI::App* each : running(call.app)) {
            for (const CLI::Option* option : each->get_options()) {
                for (const std::string& other : option->get_lnames()) known.push_back("--" + other);
            }
        }
        for (const CLI::App* sub : call.app.get_subcommands({})) {
            if (sub->get_option_no_throw(name) != nullptr) {
                return fmt::format("{}: no option of {}, but of {}; see {}", name, running(call.app).back()->get_name(),
                                   sub->get_name(), help_command(call.app));
            }
        }
        return fmt::format("{}: unknown option{}; see {}", name, did_you_mean(name, known), help_command(call.app));
    }
    if (wants_subcommand) return subcommand_message(*last, left.front());
    return fmt::format("unexpected argument \"{}\"; see {}", left.front(), help_command(call.app));
}

// The type of an exception of CLI11 gives the kind of error; only its English text names the option. Each function below
// therefore finds the option from the state of all options. It returns the message, or "" without such an option.

/// The first matching option of the commands that run, from the top; nullptr if there is none.
const CLI::Option* first_option(const Call& call, const std::function<bool(const CLI::Option&)>& fits) {
    for (const CLI::App* each : running(call.app)) {
        for (const CLI::Option* option : each->get_options()) {
            if (fits(*option)) return option;
        }
    }
    return nullptr;
}

std::string missing_message(const Call& call) {
    const CLI::Option* missing =
        first_option(call, [](const auto& option) { return option.get_required() && option.count() == 0; });
    if (missing != nullptr) return fmt::format("{}: missing; give the {}", shown_name(*missing), missing->get_description());
    const CLI::App& last = *running(call.app).back();
    return last.get_require_subcommand_min() > 0 ? subcommand_message(last, "") : "";
}

/// The message for an option with too many values, or one at the end of the command line without its value.
std::string mismatch_message(const Call& call) {
    const CLI::Option* repeated = first_option(call, [](const CLI::Option& option) {
        return option.get_multi_option_policy() == CLI::MultiOptionPolicy::Throw &&
               option.count() > static_cast<std::size_t>(std::max(option.get_items_expected_max(), 1));
    });
    if (repeated != nullptr) return fmt::format("{}: given more than once; give it once", with_origin(call, *repeated));
    if (call.arguments.empty()) return "";
    const std::string& last = call.arguments.back();
    const bool is_short = last.size() > 1 && last[0] == '-' && last[1] != '-';  // "-o", or "-qo" for "-q -o"
    const CLI::Option* bare = find_option(call, is_short ? std::string("-") + last.back() : last);
    if (bare == nullptr || is_flag(*bare)) return "";
    return fmt::format("{}: no value given; write {} {}", shown_name(*bare), shown_name(*bare), bare->get_type_name());
}

bool reads_as_flag(const CLI::Option& option) {
    try {
        (void)option.as<bool>();
        return true;
    } catch (const CLI::ConversionError&) {
        return false;
    }
}

/// The message for a flag with a value that is neither true nor false; own functions read the values of other options.
std::string conversion_message(const Call& call) {
    const CLI::Option* flag = first_option(
        call, [](const CLI::Option& option) { return is_flag(option) && option.count() > 0 && !reads_as_flag(option); });
    if (flag == nullptr) return "";
    const std::string name = shown_name(*flag);
    return fmt::format("{}: \"{}\" does not fit; write {} alone, or {}=true or {}=false", with_origin(call, *flag),
                       flag->results().back(), name, name, name);
}

/// The value of an option of the program before the command line is parsed, whose errors are events; "" if it has none.
std::string value_of(const std::string& option, Arguments begin, Arguments end) {
    for (; begin != end; ++begin) {
        if (begin->starts_with(option + "=")) return begin->substr(option.size() + 1);
        if (*begin == option && begin + 1 != end) return *(begin + 1);
    }
    return "";
}

/// The first of some options that was given (or not); nullptr if there is none.
const CLI::Option* first_of(const std::set<CLI::Option*>& options, bool given) {
    const auto found = std::find_if(options.begin(), options.end(), [given](auto* o) { return (o->count() > 0) == given; });
    return found == options.end() ? nullptr : *found;
}

/// The message for an option with one that it excludes, or without one that it needs.
std::string companion_message(const Call& call, bool excludes) {
    const auto wrong = [excludes](const CLI::Option& option) {
        return first_of(excludes ? option.get_excludes() : option.get_needs(), excludes);
    };
    const CLI::Option* one =
        first_option(call, [&](const CLI::Option& option) { return option.count() > 0 && wrong(option) != nullptr; });
    if (one == nullptr) return "";
    const std::string name = with_origin(call, *one);
    return excludes
               ? fmt::format("{} and {}: only one of them can be given; leave one out", name, with_origin(call, *wrong(*one)))
               : fmt::format("{}: not alone; give {} as well", name, shown_name(*wrong(*one)));
}

std::string file_message(const Call& call) {
    const CLI::Option* config = call.app.get_config_ptr();
    return config == nullptr || config->count() == 0
               ? ""
               : fmt::format("{}: {} cannot be read; a TOML file is needed", shown_name(*config), config->results().back());
}

template <class Kind>
bool is(const CLI::ParseError& error) {
    return dynamic_cast<const Kind*>(&error) != nullptr;
}

/// The error as one line for the user.
std::string message_of(const Call& call, const CLI::ParseError& error) {
    std::string message;
    if (is<CLI::ExtrasError>(error) || is<CLI::RequiredError>(error)) {
        const std::vector<std::string> left = call.app.remaining(true);
        message = left.empty() ? missing_message(call) : leftover_message(call, left);
    } else if (is<CLI::ArgumentMismatch>(error)) {
        message = mismatch_message(call);
    } else if (is<CLI::ConversionError>(error)) {
        message = conversion_message(call);
    } else if (is<CLI::ExcludesError>(error)) {
        message = companion_message(call, true);
    } else if (is<CLI::RequiresError>(error)) {
        message = companion_message(call, false);
    } else if (is<CLI::FileError>(error)) {
        message = file_message(call);
    }
    return message.empty() ? fmt::format("{}; see {}", one_line(error.what()), help_command(call.app)) : message;
}

/// Number of processors of this process's control group quota; a large number without a quota.
double control_group_quota() {
    double least = 1e9;
    const auto take = [&](const std::string& quota, double period) {
        if (quota.empty() || quota == "max" || quota.front() == '-' || !(period > 0)) return;
        least = std::min(least, std::strtod(quota.c_str(), nullptr) / period);
    };
    std::ifstream groups("/proc/self/cgroup");
    for (std::string line; std::getline(groups, line);) {
        if (line.compare(0, 3, "0::") != 0) continue;
        for (std::string path = line.substr(3);; path.erase(path.find_last_of('/'))) {
            std::string quota;
            double period = 0;
            if (std::ifstream file("/sys/fs/cgroup" + path + "/cpu.max"); file >> quota >> period) take(quota, period);
            if (path.find('/') == std::string::npos) break;
        }
    }
    std::string quota;
    double period = 0;
    std::ifstream quota_file("/sys/fs/cgroup/cpu/cpu.cfs_quota_us");  // version 1
    std::ifstream period_file("/sys/fs/cgroup/cpu/cpu.cfs_period_us");
    if (quota_file >> quota && period_file >> period) take(quota, period);
    return least;
}

}  // namespace

CommandLine::CommandLine(const std::string& tool, const std::string& description, CommonOptions& common,
                         const std::string& examples, const std::vector<std::string>& libraries,
                         const std::function<WrittenRows()>& written)
    : app_(std::make_unique<CLI::App>(description)) {
    CLI::App& app = *app_;
    app.name(tool);
    app.option_defaults()->always_capture_default();
    app.formatter(std::make_shared<HelpFormatter>());
    app.get_formatter()->column_width(40);
    app.get_formatter()->label("OPTIONS", "options");
    app.get_formatter()->label("SUBCOMMAND", "subcommand");
    app.footer(
        "Numbers take units (4mm, 24.15MPa, 48.76deg); a bare number is SI. Any option may stand in the file of --config\n"
        "(TOML, by its name); flags win over the file.\n\nExamples:\n" +
        examples);
    app.set_help_flag("-h,--help", "print this and exit");
    app.set_help_all_flag("--help-all", "print all options and exit");
    app.set_version_flag(
        "--version",
        [tool, libraries] {
            const std::string commit = project_commit();
            std::string text =
                fmt::format("{} {}{}", tool, project_version(), commit.empty() ? "" : fmt::format(" ({})", commit));
            for (const std::string& library : library_versions()) text += "\n" + library;
            for (const std::string& library : libraries) text += "\n" + library;
            return text + "\nCLI11 " CLI11_VERSION;
        },
        "print version, commit and libraries and exit");
    app.add_flag_callback(
           "--describe",
           [&app, written] { throw CLI::CallForVersion(description_of(app, written ? written() : WrittenRows()), 0); },
           "print all commands and options, and the columns and datasets that are written, as JSON and exit")
        ->configurable(false);
    app.config_formatter(std::make_shared<ConfigurationFile>(app));
    app.allow_config_extras(CLI::config_extras_mode::error);
    app.set_config("--config", "", "TOML file with options by their names")->type_name("FILE")->configurable(false);
    app.add_flag("--print-config", common.print_config, "print the effective options as TOML for --config and exit")
        ->configurable(false);
    const auto speak = [&common](Verbosity verbosity) { return [&common, verbosity] { common.verbosity = verbosity; }; };
    CLI::Option* quiet = app.add_flag_callback("-q,--quiet", speak(Verbosity::quiet), "print errors only");
    CLI::Option* verbose =
        app.add_flag_callback("-v,--verbose", speak(Verbosity::verbose), "print more: the effective options, as TOML");
    quiet->excludes(verbose);
    app.add_option_function<std::string>(
           "--events", [](const std::string&) {},
           "write progress, warnings and the outcome as JSON lines to a file, or to an open descriptor")
        ->type_name("FILE|NUMBER")
        ->configurable(false);
}

CommandLine::~CommandLine() = default;

bool CommandLine::replace_default(const std::string& option, const std::string& text) {
    bool holds = false;
    for (CLI::App* each : running(*app_)) {
        CLI::Option* found = each->get_option_no_throw(option);
        if (found == nullptr || found->count() > 0 || first_of(found->get_excludes(), true) != nullptr) continue;
        found->default_str(text);
        holds = true;
    }
    return holds;
}

bool CommandLine::parse(int argc, const char* const* argv, const std::function<void()>& complete) {
    CLI::App& app = *app_;
    Call call{app, {argv + std::min(argc, 1), argv + argc}};
    const auto ends = std::find(call.arguments.begin(), call.arguments.end(), "--");
    const bool print_config = std::find(call.arguments.begin(), ends, "--print-config") != ends;
    if (const std::string events = value_of("--events", call.arguments.begin(), ends); !events.empty()) open_events(events);
    std::vector<CLI::Option*> required;
    for_each_app(app, [&](CLI::App& each) {
        if (each.get_parent() != nullptr) each.fallthrough();
        for (CLI::Option* option : each.get_options()) {
            if (print_config && option->get_required()) {
                required.push_back(option);
                option->required(false);
            }
        }
    });
    bare_number_notes().clear();
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& success) {
        app.exit(success, std::cout, std::cerr);
        return false;
    } catch (const CLI::ParseError& error) {
        throw UsageError(message_of(call, error));
    } catch (const UsageError& error) {
        throw UsageError(with_origin_in(call, error.what()));
    }
    if (const ConfigurationFile* file = configuration_file(app); file != nullptr) {
        for (CLI::App* each : running(app)) {
            for (const CLI::Option* option : each->get_options()) file->apply_default(option);
        }
    }
    if (complete) complete();
    if (!print_config) {
        print_notes(app);
        return true;
    }
    for (CLI::Option* option : required) option->required();
    std::cout << effective_configuration();
    return false;
}

Settings CommandLine::settings() const { return configuration_file(*app_)->settings(); }

std::string CommandLine::effective_configuration() const { return graincrack::effective_configuration(*app_); }

int available_processors() {
    int processors = 0;
    cpu_set_t set;
    CPU_ZERO(&set);
    if (sched_getaffinity(0, sizeof set, &set) == 0) processors = CPU_COUNT(&set);
    if (processors < 1) processors = static_cast<int>(std::thread::hardware_concurrency());
    return std::max(1, static_cast<int>(std::min<double>(processors, std::ceil(control_group_quota() - 1e-6))));
}

Option add_threads(OptionSet set, int& threads) {
    threads = available_processors();
    return add_integer<int>(set, "--threads", threads,
                            "most threads, fewer on busy processors; default: the processors this process may use", 1, 4096);
}

Option add_dry_run(OptionSet set, CommonOptions& common, const std::string& help) {
    return add_flag(set, "--dry-run", common.dry_run, help);
}

}  // namespace graincrack
