#include "share/rock/material_kinds.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

#include "share/base/error.hpp"
#include "share/base/shared_file.hpp"
#include "share/base/toml_file.hpp"
#include "share/rock/incomplete_material.hpp"

namespace graincrack {
namespace {

namespace fs = std::filesystem;

RockKind read_kind(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    const std::size_t end = text.find('\n');
    if (!text.starts_with("# ") || end == std::string::npos || text.find("\nname = \"") == std::string::npos) {
        throw InputError(
            fmt::format("{}: a kind of rock begins with a comment that describes it, and has a name", file.string()));
    }
    return {file.stem().string(), text.substr(2, end - 2), text};
}

}  // namespace

std::vector<RockKind> rock_kinds() {
    std::map<std::string, RockKind> kinds;
    std::error_code ignored;
    for (const fs::path& place : materials().places()) {
        for (fs::directory_iterator entry(place / "kinds", ignored); entry != fs::directory_iterator();
             entry.increment(ignored)) {
            if (ignored) break;
            if (entry->path().extension() != ".toml" || kinds.contains(entry->path().stem().string())) continue;
            kinds.emplace(entry->path().stem().string(), read_kind(entry->path()));
        }
    }
    std::vector<RockKind> all;
    all.reserve(kinds.size());
    for (auto& [name, kind] : kinds) all.push_back(std::move(kind));
    return all;
}

std::string material_of_kind(const std::string& kind, const std::string& name) {
    if (kind == every_key) return material_template(name);
    const std::vector<RockKind> kinds = rock_kinds();
    const auto found = std::find_if(kinds.begin(), kinds.end(), [&](const RockKind& each) { return each.name == kind; });
    if (found == kinds.end()) {
        std::vector<std::string> known;
        for (const RockKind& each : kinds) known.push_back(each.name);
        known.emplace_back(every_key);
        throw UsageError(
            fmt::format("--kind {}: unknown kind{}; known are {}", kind, did_you_mean(kind, known), fmt::join(known, ", ")));
    }
    std::string text = found->text;
    const std::size_t from = text.find("\nname = \"") + 1;
    return text.replace(from, text.find('\n', from) - from, fmt::format("name = \"{}\"", name));
}

}  // namespace graincrack
