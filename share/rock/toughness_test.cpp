#include "share/rock/toughness_test.hpp"

#include <fmt/format.h>

#include <cmath>

namespace graincrack {

namespace {

constexpr const char* half_disc = "half-disc";
constexpr const char* beam = "beam";
constexpr double in_millimetres = 1e3;

bool is_made_here(const std::string& method) { return method == half_disc || method == beam; }

}  // namespace

ToughnessTest usual_half_disc(double diameter) { return completed({half_disc, diameter}); }

ToughnessTest completed(ToughnessTest test) {
    if (!is_made_here(test.method)) return test;
    if (test.notch == 0) test.notch = test.size * (test.method == beam ? 0.5 : 0.25);
    if (test.span == 0) test.span = test.size * (test.method == beam ? 4 : 0.6);
    return test;
}

bool ToughnessTest::is_known() const { return is_made_here(method) && size > 0 && notch > 0 && span > 0; }

std::string ToughnessTest::text() const {
    if (is_known()) {
        return fmt::format("{}, {} {:.4g} mm, notch {:.4g} mm, span {:.4g} mm", method, method == beam ? "height" : "diameter",
                           size * in_millimetres, notch * in_millimetres, span * in_millimetres);
    }
    if (method.empty() || is_made_here(method)) {
        return method + (method.empty() ? "" : " ") + "of a size that the material does not name";
    }
    return method + ", of which no specimen is made here";
}

std::string ToughnessTest::caveat(const ToughnessTest& tested) const {
    const auto near = [](double a, double b) { return std::abs(a - b) <= 0.05 * b; };
    if (!is_known()) return method.empty() || is_made_here(method) ? "size not known" : "other specimen";
    const bool is_like =
        method == tested.method && near(tested.size, size) && near(tested.notch, notch) && near(tested.span, span);
    return is_like ? "" : "other specimen";
}

std::vector<TomlKey> toughness_test_keys(ToughnessTest& test) {
    const auto length = [](const char* name, const char* meaning, double& target) {
        return TomlKey{name, {name, Dimension::length, 1e-3, 10, meaning}, to(target)};
    };
    // In the words of the methods suggested by ISRM and of the literature.
    const std::vector<std::string> methods{half_disc,
                                           beam,
                                           "chevron-bend",
                                           "short-rod",
                                           "cracked-chevron-disc",
                                           "cracked-straight-disc",
                                           "ring",
                                           "compact-tension",
                                           "double-torsion"};
    return {word_key("method", methods, [&test](const std::string& word) { test.method = word; }),
            length("diameter", "diameter of the specimen that K_IC was measured on", test.size),
            length("height", "height of the beam that K_IC was measured on", test.size),
            length("notch", "length of its notch", test.notch), length("span", "distance of its lower rollers", test.span)};
}

}  // namespace graincrack
