// The applications, options and keys of a command line by their names; for command_line.cpp and configuration_file.cpp.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace graincrack {

/// The name of an option in a configuration file: "edge" of "-e,--edge".
inline std::string key_of(const CLI::Option& option) {
    if (!option.get_lnames().empty()) return option.get_lnames().front();
    if (option.get_positional()) return option.get_name(true);
    return option.get_snames().front();
}

/// The application and the subcommands that were called, from the top.
template <class App>
std::vector<App*> running(App& app) {
    std::vector<App*> chain{&app};
    while (!chain.back()->get_subcommands().empty()) chain.push_back(chain.back()->get_subcommands().front());
    return chain;
}

/// An option by its key in a configuration file; nullptr if there is none.
inline CLI::Option* find_key(CLI::App& app, const std::string& key) {
    for (CLI::Option* option : app.get_options()) {
        if (key_of(*option) == key) return option;
    }
    return nullptr;
}

inline std::vector<std::string> subcommand_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* sub : app.get_subcommands({})) names.push_back(sub->get_name());
    return names;
}

}  // namespace graincrack
