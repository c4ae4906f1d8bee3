#include "post/run/test_label.hpp"

#include <fmt/format.h>

#include <cmath>

namespace graincrack {

std::string test_title(const RunSettings& header) {
    const TestDescription& description = header.description();
    std::string test(description.title);
    if (description.is_confined) test += fmt::format(" under {:.4g} MPa", header.confining_pressure * 1e-6);
    if (header.heat != 0) test += ", " + header.heat_label();
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
    return shape == "ring" ? shape : run.specimen.holes > 0 ? "disc with a hole" : run.specimen.is_cracked ? "cracked disc" : "";
}

std::string whole_contacts(double contacts) { return fmt::format("{:.0f}", std::ceil(contacts)); }

std::string counted(std::size_t n, const std::string& what) { return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s"); }

}  // namespace graincrack
