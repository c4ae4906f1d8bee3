#include "share/options/completion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "share/base/error.hpp"

namespace graincrack {
namespace {

using Json = nlohmann::ordered_json;

/// What can follow on a command line behind a (sub)command, "" for the tool itself.
struct Position {
    std::string command;  ///< "plot curve"
    std::vector<std::string> words;
    /// Options with their words: "--rate" with "auto", "blocks".
    std::vector<std::pair<std::string, std::vector<std::string>>> choices;
};

/// Adds the position of a command and those of its subcommands. \param position with the options of the commands above it
void add_positions(const Json& own, const std::string& command, Position position, std::vector<Position>& positions) {
    position.command = command;
    for (const Json& option : own["options"]) {
        if (option.contains("positional")) continue;
        const std::string name = "--" + option["name"].get<std::string>();
        position.words.push_back(name);
        if (option.contains("choices")) position.choices.emplace_back(name, option["choices"].get<std::vector<std::string>>());
    }
    const std::size_t at = positions.size();
    positions.push_back(position);
    for (const Json& sub : own["commands"]) {
        const auto name = sub["name"].get<std::string>();
        positions[at].words.push_back(name);
        add_positions(sub, command.empty() ? name : command + " " + name, position, positions);
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

std::string completion_script(const Json& tool, const std::string& shell) {
    if (shell != "bash" && shell != "zsh") {
        throw UsageError(fmt::format("--completion: unknown shell \"{}\"; one of bash|zsh fits", shell));
    }
    std::vector<Position> positions;
    add_positions(tool, "", {}, positions);
    const auto name = tool["name"].get<std::string>();
    return shell == "bash" ? bash_script(name, positions) : zsh_script(name, positions);
}

}  // namespace graincrack
