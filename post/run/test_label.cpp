#include "post/run/test_label.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>

namespace graincrack {

std::string test_title(const RunHeader& header) {
    const TestDescription& description = header.description();
    std::string test(description.title);
    if (description.is_confined) test += fmt::format(" under {:.4g} MPa", header.confining_pressure * 1e-6);
    return header.material.empty() ? test : test + ", " + header.material;
}

std::string series_label(const std::string& test, double confining_pressure, const std::string& shape) {
    const TestDescription& description = test_named(test);
    const std::string label =
        description.is_confined ? fmt::format("σ3 = {:.4g} MPa", confining_pressure * 1e-6) : std::string(description.label);
    return shape.empty() ? label : label + ", " + shape;
}

std::string distinct_shape(const RunData& run) {
    const std::string& shape = run.specimen.shape;
    if (run.header.loading() == Loading::bending) return shape == "beam" && run.specimen.is_cracked ? "notched beam" : shape;
    if (run.header.loading() != Loading::splitting) return "";
    return shape == "ring" ? shape : run.specimen.is_cracked ? "cracked disc" : "";
}

std::vector<std::string> names_apart(const std::vector<RunData>& runs) {
    using Trait = std::function<std::string(const RunData&)>;
    static const std::vector<Trait> traits{
        [](const RunData& run) { return fmt::format("edge {:.2g} mm", 1e3 * run.specimen.mean_edge); },
        [](const RunData& run) { return "law " + run.header.contact_law; },
        [](const RunData& run) { return "plane " + std::string(name_of(run.header.plane)); },
        [](const RunData& run) {
            return run.header.rate == "auto" ? "automatic rate" : fmt::format("{:.3g} mm/s", 1e3 * run.header.platen_speed);
        },
        [](const RunData& run) { return fmt::format("seed {}", run.specimen.seed); },
        [](const RunData& run) { return std::filesystem::path(run.name).filename().string(); }};
    std::vector<std::string> names;
    for (const RunData& run : runs) names.push_back(series_label(run));
    // A trait is added to runs of one name that it tells apart.
    for (const Trait& trait : traits) {
        std::map<std::string, std::vector<std::size_t>> same;
        for (std::size_t i = 0; i < runs.size(); ++i) same[names[i]].push_back(i);
        for (const auto& [name, members] : same) {
            const std::string first = trait(runs[members.front()]);
            const bool differs =
                std::any_of(members.begin(), members.end(), [&](std::size_t i) { return trait(runs[i]) != first; });
            for (const std::size_t i : members) names[i] += differs ? ", " + trait(runs[i]) : "";
        }
    }
    return names;
}

std::string whole_contacts(double contacts) { return fmt::format("{:.0f}", std::ceil(contacts)); }

std::string counted(std::size_t n, const std::string& what) { return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s"); }

std::string peak_label(const RunData& run) { return peak_kind(run, load_curve(run)) == "drop" ? "peak" : "largest stress"; }

}  // namespace graincrack
