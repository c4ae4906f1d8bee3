#include "post/plot/crack_state.hpp"

#include <algorithm>
#include <cmath>

#include "post/run/contact_classes.hpp"
#include "post/run/crystals.hpp"
#include "post/run/test_label.hpp"

namespace graincrack {

namespace {

constexpr double within_crystals = 0.55;  ///< width of a crack within a crystal over that of one between two

/// Draws the half facet of a failed contact point: one line midway between its two sides, or, where the crack is open, one on
/// each.
void draw_crack(MapView& map, const Specimen& specimen, const Crack& crack, double width) {
    const auto& nodes = specimen.contact_nodes[static_cast<std::size_t>(crack.contact)];
    const auto at = [&](std::size_t k) { return map.positions()[static_cast<std::size_t>(nodes[k])]; };
    const auto between = [](std::array<double, 2> p, std::array<double, 2> q) {
        return std::array{(p[0] + q[0]) / 2, (p[1] + q[1]) / 2};
    };
    const Colour colour = crack.mode == CrackMode::tensile ? palette::tensile : palette::shear;
    const auto draw = [&](std::array<double, 2> first, std::array<double, 2> second, double stroke) {
        const auto middle = between(first, second);
        map.stroke(crack.point == 0 ? first : middle, crack.point == 0 ? middle : second, stroke, colour);
    };
    const std::size_t end = crack.point;  // a1, b1 or a2, b2
    const auto side_a = at(end);
    const auto side_b = at(end + 2);
    const double gap = std::hypot(side_a[0] - side_b[0], side_a[1] - side_b[1]) * map.pixels_per_metre();
    if (gap <= 2 * width) {
        draw(between(at(0), at(2)), between(at(1), at(3)), width);
    } else {
        draw(at(0), at(1), 0.7 * width);
        draw(at(2), at(3), 0.7 * width);
    }
}

}  // namespace

bool has_platens_to_draw(const RunData& run) { return run.header.loading() != Loading::tension; }

bool has_pre_existing_cracks(const Specimen& specimen) {
    return std::any_of(specimen.contact_kind.begin(), specimen.contact_kind.end(), starts_broken);
}

bool draw_crack_state(MapView& map, const Specimen& specimen, const std::optional<PlatensAtStrain>& platens,
                      const std::vector<Crack>& present) {
    map.draw_grains();
    if (platens) map.draw_platens(platens->faces, -platens->axial_strain * specimen.height / 2);
    const double edge = specimen.statistics.mean_edge * map.pixels_per_metre();
    const double width = edge > 0 ? std::clamp(0.1 * edge, 1.2, 6.0) : 4.0;
    const bool cracked_before = map.draw_pre_existing_cracks(width);
    for (const CrackMode mode : {CrackMode::shear, CrackMode::tensile}) {
        for (const Crack& crack : present) {
            if (crack.mode != mode) continue;
            const bool is_within = is_within_crystal(specimen, static_cast<std::size_t>(crack.contact));
            draw_crack(map, specimen, crack, is_within ? within_crystals * width : width);
        }
    }
    return cracked_before;
}

std::string cracked_contacts(const std::vector<Crack>& cracks, CrackMode mode) {
    const auto points = std::count_if(cracks.begin(), cracks.end(), [mode](const Crack& c) { return c.mode == mode; });
    return whole_contacts(0.5 * static_cast<double>(points));
}

std::vector<std::string> crack_notes(const Specimen& specimen, const CrackLabel& label, const std::vector<std::string>& classes) {
    std::vector<std::string> lines{limited_to(definition_of(label), classes)};
    if (!specimen.grain_crystal.empty()) lines.emplace_back("thin: within crystals; thick: between them");
    return lines;
}

}  // namespace graincrack
