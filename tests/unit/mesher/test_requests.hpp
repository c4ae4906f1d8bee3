// Requests that tests begin with, what they are refused for, and what is said and measured of the specimens that come out.
#pragma once

#include <cstdint>
#include <functional>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "mesher/mesh.hpp"
#include "share/base/error.hpp"
#include "tests/support/golden.hpp"

namespace graincrack::mesher {

inline Request request_of(Region region, std::int64_t grains, std::uint64_t seed = 1) {
    return {.region = std::move(region), .fabric = {.grains = grains}, .seed = seed};
}
inline Request rectangle_of(std::int64_t grains, std::uint64_t seed = 1) {
    return request_of(rectangle(0.08, 0.16), grains, seed);
}
/// Grains of a mean edge, m.
inline Request request_of_edge(Region region, double edge) { return {.region = std::move(region), .fabric = {.edge = edge}}; }

/// The specimen of a request, which must be valid.
inline Specimen valid_mesh(const Request& request, MeshReport* report = nullptr) {
    const Specimen specimen = mesh(request, {}, report);
    EXPECT_NO_THROW(validate(specimen, request.region.name));
    return specimen;
}

/// Changes of a request, each by its name.
using Changes = std::vector<std::pair<std::string, std::function<void(Request&)>>>;

inline std::function<void(Request&)> graded(const char* text) {
    return [text](Request& request) { request.fabric.grading = parse_grading(text, "--grade"); };
}

/// Fails unless a request has a plan, and once it is changed is refused as the golden file says.
inline void compare_refusals(const Request& good, const Changes& changes, const char* file = __builtin_FILE(),
                             int line = __builtin_LINE()) {
    EXPECT_NO_THROW((void)plan_mesh(good));
    graincrack::test::Refusals refused;
    for (const auto& [what, change] : changes) {
        Request request = good;
        change(request);
        refused.add<UsageError>(
            what, [&] { (void)plan_mesh(request); }, file, line);
    }
    graincrack::test::expect_golden(refused.text(), "", file, line);
}

/// Lines, those of warnings behind their codes.
inline std::string text_of(const std::vector<Remark>& lines) {
    std::string text;
    for (const Remark& line : lines) text += (line.code.empty() ? "" : line.code + ": ") + line.text + "\n";
    return text;
}

/// Every grain its own crystal.
inline std::vector<int> own_crystals(const Specimen& specimen) {
    std::vector<int> crystals(specimen.n_grains());
    std::iota(crystals.begin(), crystals.end(), 0);
    return crystals;
}

inline Point place_of(const Specimen& specimen, std::int32_t node) {
    const auto& [x, y] = specimen.node_position[index(node)];
    return {x, y};
}

/// Length of the contacts that are broken from the start, m.
inline double broken_length(const Specimen& specimen) {
    double sum = 0;
    for (std::size_t c = 0; c < specimen.n_contacts(); ++c) {
        if (starts_broken(specimen.contact_kind[c])) sum += contact_length(specimen, c);
    }
    return sum;
}

}  // namespace graincrack::mesher
