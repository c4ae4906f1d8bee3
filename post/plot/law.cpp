#include "post/plot/plots.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "post/chart/axis.hpp"
#include "post/chart/chart.hpp"
#include "post/table/column.hpp"
#include "share/base/error.hpp"
#include "share/file/run_file.hpp"
#include "solver/law/contact_law.hpp"

namespace graincrack {

namespace {

/// A path of displacements (µm) and tractions (MPa).
struct Path {
    std::vector<double> displacement;
    std::vector<double> traction;
};

constexpr double micro = 1e6;

/// Moves a contact along straight legs in equal steps.
class Walk {
public:
    explicit Walk(const ContactLaw& law) : law_(law) {}
    /// \param path receives each step of sliding, or of opening, unless it is null
    void go(const ContactMotion& end, Path* path = nullptr, bool sliding = false) {
        constexpr int steps = 600;
        const ContactMotion from = history_.motion;
        for (int i = 1; i <= steps; ++i) {
            const double share = static_cast<double>(i) / steps;
            const ContactMotion to{from.opening + share * (end.opening - from.opening),
                                   from.sliding + share * (end.sliding - from.sliding)};
            const ContactResponse response = update_contact(law_, to, history_);
            history_ = response.history;
            if (path == nullptr) continue;
            path->displacement.push_back((sliding ? to.sliding : to.opening) * micro);
            path->traction.push_back((sliding ? response.traction.shear : response.traction.normal) * in_megapascals);
        }
    }

private:
    ContactLaw law_;
    ContactHistory history_;
};

/// Opens a contact to `reach`, with an unloading half-way down the softening if that lies before.
Path open_path(const ContactLaw& law, const ContactParameters& contact, double reach) {
    Path path{{0}, {0}};
    const double half = (contact.critical_opening + contact.ultimate_opening) / 2;
    Walk walk(law);
    walk.go({std::min(2 * contact.critical_opening, reach), 0}, &path);
    if (half < reach) {
        walk.go({half, 0}, &path);
        walk.go({0.2 * half, 0}, &path);
    }
    walk.go({reach, 0}, &path);
    return path;
}

Path shear_path(const ContactLaw& law, const ContactParameters& contact, double compression, double reach) {
    Path path;
    const double opening = -compression / contact.normal_stiffness;
    Walk walk(law);
    walk.go({opening, 0});
    walk.go({opening, reach}, &path, true);
    return path;
}

std::vector<LawDescription> chosen(const LawPlotOptions& options) {
    const auto& all = all_contact_laws();
    if (options.all) return {all.begin(), all.end()};
    std::vector<LawDescription> laws;
    for (const std::string& name : options.laws.empty() ? std::vector{options.own} : options.laws) {
        const auto found = std::find_if(all.begin(), all.end(), [&](const LawDescription& d) { return d.name == name; });
        if (found == all.end()) {
            std::vector<std::string_view> known;
            for (const LawDescription& d : all) known.push_back(d.name);
            throw UsageError(fmt::format("--contact-law {}: unknown; one of {} fits", name, fmt::join(known, ", ")));
        }
        laws.push_back(*found);
    }
    return laws;
}

Axis up_to(const std::string& label, double high) { return {label, 0, high}; }

/// True if curves over equal displacements look alike in the picture: within half a percent of the largest traction.
bool agree(const std::vector<Path>& paths) {
    double highest = 0;
    double apart = 0;
    for (const Path& path : paths) {
        for (std::size_t i = 0; i < path.traction.size(); ++i) {
            highest = std::max(highest, std::abs(path.traction[i]));
            apart = std::max(apart, std::abs(path.traction[i] - paths[0].traction[i]));
        }
    }
    return apart < 0.005 * highest;
}

/// Sets of curves that look alike, as indices.
std::vector<std::vector<std::size_t>> like_curves(const std::vector<Path>& paths) {
    std::vector<std::vector<std::size_t>> sets;
    for (std::size_t i = 0; i < paths.size(); ++i) {
        const auto same = std::find_if(sets.begin(), sets.end(), [&](const auto& s) { return agree({paths[s[0]], paths[i]}); });
        if (same != sets.end()) same->push_back(i);
        if (same == sets.end()) sets.push_back({i});
    }
    return sets;
}

/// Curves of laws in addition to that of the own law, which is black and covers those that look alike.
struct LawCurves {
    std::vector<ContactLaw> laws;
    std::size_t own = 0;
    [[nodiscard]] Stroke stroke(std::size_t i) const { return i == own ? Stroke{} : series_stroke(i); }
};

void draw_paths(Chart& chart, const LawCurves& curves, const std::vector<Path>& paths, double thinner = 1) {
    const auto draw = [&](std::size_t i, double width) {
        Stroke stroke = curves.stroke(i);
        stroke.width = thinner * width;
        chart.line(paths[i].displacement, paths[i].traction, stroke);
    };
    for (const auto& set : like_curves(paths)) {
        if (std::find(set.begin(), set.end(), curves.own) != set.end()) continue;
        for (std::size_t k = 0; k < set.size(); ++k) {  // earlier ones remain visible at the sides
            draw(set[k], 4 + 1.8 * static_cast<double>(set.size() - 1 - k));
        }
    }
    draw(curves.own, 4);
}

/// Height of a frame on a page, pixels: three are in one column below one another, or side by side over two columns.
double frame_height(const PictureStyle& style) { return style.page_width < 700 ? 340 : 290; }

Drawing draw_open(const LawCurves& curves, const ContactParameters& contact, const std::string& caption, double reach,
                  const PictureStyle& style) {
    Chart chart(style, {"", {caption}}, up_to("opening, µm", reach * micro),
                up_to("normal traction, MPa", 1.12 * contact.tensile_strength * in_megapascals), {.height = frame_height(style)});
    std::vector<Path> paths;
    for (const ContactLaw& law : curves.laws) paths.push_back(open_path(law, contact, reach));
    draw_paths(chart, curves, paths);
    return chart.finish();
}

Drawing draw_shear(const LawCurves& curves, const ContactParameters& contact, double compression, const PictureStyle& style) {
    const double reach = std::max(3 * contact.critical_sliding, 1.2 * contact.ultimate_opening);
    double highest = 0;
    std::vector<Path> open;
    std::vector<Path> closed;
    for (const ContactLaw& law : curves.laws) {
        open.push_back(shear_path(law, contact, 0, reach));
        closed.push_back(shear_path(law, contact, compression, reach));
        highest = std::max({highest, largest(open.back().traction), largest(closed.back().traction)});
    }
    Chart chart(style, {"", {fmt::format("sliding under {:.3g} MPa, thin: δn = 0", compression * in_megapascals)}},
                up_to("sliding, µm", reach * micro), up_to("shear traction, MPa", 1.12 * highest),
                {.height = frame_height(style)});
    draw_paths(chart, curves, closed);
    draw_paths(chart, curves, open, 0.45);
    return chart.finish();
}

}  // namespace

Drawing draw_laws(const ContactParameters& contact, const std::string& title, const LawPlotOptions& options,
                  const PictureStyle& style) {
    LawCurves curves;
    for (const LawDescription& d : chosen(options)) {
        if (d.name == options.own) curves.own = curves.laws.size();
        curves.laws.push_back(make_contact_law(contact, d.variant));
    }
    const bool is_bridged = curves.laws[curves.own].bridge > 0;
    const bool wide = style.page_width >= 1400;
    const PictureStyle part = style.of_part(wide ? std::floor(style.page_width / 3) : style.page_width);
    ChartText heading{style.title.empty() ? title : style.title,
                      {fmt::format("opening: δct {:.3g} µm, δut {:.3g} µm, Gf {:.4g} J/m²", contact.critical_opening * micro,
                                   contact.ultimate_opening * micro, contact.fracture_energy),
                       fmt::format("sliding: δcs {:.3g} µm, cc {:.4g} MPa", contact.critical_sliding * micro,
                                   contact.cohesion * in_megapascals)}};
    if (is_bridged) {
        heading.subtitle.push_back(
            fmt::format("bridges: {:.4g} MPa, {:.4g} J/m²", contact.bridging_strength * in_megapascals, contact.bridging_energy));
    }
    Drawing page(static_cast<int>(style.page_width), 0);
    const TextColumn column{page_margin, page.width() - page_margin};
    page.set_height(draw_heading(page, heading, column, 14));
    const double last = is_bridged ? 2 * contact.bridging_energy / contact.bridging_strength : 0;
    const std::vector<Drawing> charts{
        draw_open(curves, contact, "opening, unloaded half-way", 1.05 * std::max(contact.ultimate_opening, last), part),
        draw_open(curves, contact, "the same near the peak", 4 * contact.critical_opening, part),
        draw_shear(curves, contact, options.normal_stress, part)};
    page = stacked({page, wide ? side_by_side(charts) : stacked(charts)});
    std::vector<LegendEntry> legend;
    for (std::size_t i = 0; i < curves.laws.size(); ++i) {
        const std::string name(name_of(curves.laws[i].variant));
        const bool of_material = i == curves.own && name == options.own;
        legend.push_back({curves.stroke(i), name + (of_material ? " (the material's own)" : "")});
    }
    double end = draw_legend(page, legend, column, page.height()).bottom;
    if (curves.laws.size() > 1) {
        end = draw_heading(page, {"", {"a law without a curve of its own has the black one"}}, column, end);
    }
    page.set_height(end + 14);
    return page;
}

Drawing draw_lennard_jones(const PictureStyle& style) {
    // corners and middle of Table 9
    static constexpr std::array<std::array<int, 2>, 5> pairs{{{8, 13}, {8, 18}, {10, 15}, {12, 13}, {12, 18}}};
    Chart chart(style, {"Lennard-Jones potential", {"P(z)/X = a [(ζ/z)ⁿ − (ζ/z)ᵐ], Eqs 20–22; b gives w = Gf/(b σt)"}},
                Axis{"z/ζ", 0.9, 1.6}, Axis{"P/X", -1.1, 1});
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const auto [m, n] = pairs[i];
        Path path;
        for (double z = 0.9; z <= 1.6; z += 0.002) {
            path.displacement.push_back(z);
            path.traction.push_back(fpz::lennard_jones_potential(z, m, n));
        }
        chart.line(path.displacement, path.traction, series_stroke(i, 3.5),
                   fmt::format("m {}, n {}: b = {:.3f}", m, n, fpz::lennard_jones_b(m, n)));
    }
    return chart.finish();
}

}  // namespace graincrack
