#include "share/options/completion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "share/base/error.hpp"

namespace graincrack {
namespace {

/// What can follow on a command line behind a (sub)command, "" for the tool itself.
struct Position {
    std::string command;  ///< "plot curve"
    std::vector<std::string> words;
    /// Options with their words: "--rate" with "auto", "blocks".
    std::vector<std::pair<std::string, std::vector<std::string>>> choices;
};

/// The words among "auto|blocks|SPEED"; placeholders are in capitals.
std::vector<std::string> words_of(const std::string& type_name) {
    std::vector<std::string> words;
    for (const std::string& word : CLI::detail::split(type_name, '|')) {
        if (!word.empty() && std::none_of(word.begin(), word.end(), [](char c) { return c >= 'A' && c <= 'Z'; })) {
            words.push_back(word);
        }
    }
    return words;
}

void add_options(const CLI::App& app, Position& position) {
    for (const CLI::Option* option : app.get_options()) {
        if (option->get_group().empty() || !option->nonpositional()) continue;
        const std::vector<std::string> words = words_of(option->get_type_name());
        for (const std::string& name : option->get_lnames()) {
            position.words.push_back("--" + name);
            if (option->get_type_size() != 0 && !words.empty()) position.choices.emplace_back("--" + name, words);
        }
    }
}

/// Adds the position of a command and those of its subcommands. \param above the options of the commands above it
void add_positions(const CLI::App& app, const std::string& command, const Position& above, std::vector<Position>& positions) {
    Position position = above;
    position.command = command;
    add_options(app, position);
    const Position own = position;
    const auto subcommands = app.get_subcommands(nullptr);
    for (const CLI::App* sub : subcommands) position.words.push_back(sub->get_name());
    positions.push_back(position);
    for (const CLI::App* sub : subcommands) {
        add_positions(*sub, command.empty() ? sub->get_name() : command + " " + sub->get_name(), own, positions);
    }
}

/// The three case lists that both shells share. \param offer a command that offers words, with {} for them
struct Cases {
    std::string commands, choices, words;
};
Cases cases_of(const std::vector<Position>& positions, const std::string& offer) {
    Cases cases;
    for (const Position& position : positions) {
        if (!position.command.empty()) {
            cases.commands += (cases.commands.empty() ? "" : " | ") + fmt::format("\"{}\"", position.command);
        }
        for (const auto& [option, words] : position.choices) {
            cases.choices += fmt::format("        \"{} {}\") {}; return ;;\n", position.command, option,
                                         fmt::format(fmt::runtime(offer), fmt::join(words, " ")));
        }
        cases.words += fmt::format("        \"{}\") {} ;;\n", position.command,
                                   fmt::format(fmt::runtime(offer), fmt::join(position.words, " ")));
    }
    return cases;
}

std::string bash_script(const std::string& tool, const std::vector<Position>& positions) {
    const Cases cases = cases_of(positions, R"(mapfile -t COMPREPLY < <(compgen -W "{}" -- "$current"))");
    std::string name = tool;
    std::replace(name.begin(), name.end(), '-', '_');
    return fmt::format(R"(# Completion of {0} for bash, made by {0} --completion bash.
_{1}() {{
    local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD - 1]}} command= word
    for word in "${{COMP_WORDS[@]:1:COMP_CWORD-1}}"; do
        word=${{command:+$command }}$word
        case $word in
            {2}) command=$word ;;
        esac
    done
    case "$command $previous" in
{3}    esac
    case $command in
{4}    esac
}}
complete -o default -F _{1} {0}
)",
                       tool, name, cases.commands, cases.choices, cases.words);
}

std::string zsh_script(const std::string& tool, const std::vector<Position>& positions) {
    const Cases cases = cases_of(positions, "compadd -- {}");
    return fmt::format(R"(#compdef {0}
# Completion of {0} for zsh, made by {0} --completion zsh.
local command= word
for word in ${{words[2,CURRENT-1]}}; do
    word=${{command:+$command }}$word
    case $word in
        {1}) command=$word ;;
    esac
done
case "$command ${{words[CURRENT-1]}}" in
{2}esac
case $command in
{3}esac
_files
)",
                       tool, cases.commands, cases.choices, cases.words);
}

}  // namespace

std::string completion_script(const CLI::App& app, const std::string& shell) {
    if (shell != "bash" && shell != "zsh") {
        throw UsageError(fmt::format("--completion: unknown shell \"{}\"; one of bash|zsh fits", shell));
    }
    std::vector<Position> positions;
    add_positions(app, "", {}, positions);
    return shell == "bash" ? bash_script(app.get_name(), positions) : zsh_script(app.get_name(), positions);
}

}  // namespace graincrack
