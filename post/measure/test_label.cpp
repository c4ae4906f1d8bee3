#include "post/measure/test_label.hpp"

#include <fmt/format.h>

#include <cmath>

namespace graincrack {

std::string test_title(const RunHeader& header) {
    std::string test = header.test;
    if (test == "uniaxial") test = "Uniaxial compression";
    if (test == "triaxial") test = fmt::format("Compression under {:.4g} MPa", header.confining_pressure * 1e-6);
    if (test == "brazilian") test = "Brazilian test";
    if (test == "tension") test = "Direct tension";
    return header.material.empty() ? test : test + ", " + header.material;
}

std::string series_label(const std::string& test, double confining_pressure) {
    if (test == "triaxial") return fmt::format("σ3 = {:.4g} MPa", confining_pressure * 1e-6);
    if (test == "brazilian") return "Brazilian";
    if (test == "tension") return "direct tension";
    return test;
}

std::string whole_contacts(double contacts) { return fmt::format("{:.0f}", std::ceil(contacts)); }

std::string counted(std::size_t n, const std::string& what) { return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s"); }

std::string peak_label(const RunData& run) { return peak_kind(run, load_curve(run)) == "drop" ? "peak" : "largest stress"; }

}  // namespace graincrack
