#include "post/plot/law.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "post/chart/chart.hpp"
#include "post/chart/numbers.hpp"
#include "post/plot/make_plot.hpp"
#include "share/command_line.hpp"
#include "share/error.hpp"
#include "share/run_file.hpp"
#include "solver/law/contact_law.hpp"

namespace graincrack {

namespace {

/// A path of motions and the tractions on it, in µm and MPa.
struct Path {
    std::vector<double> displacement;
    std::vector<double> traction;
};

/// Leads a contact in straight legs of equal steps.
class Walk {
public:
    explicit Walk(const ContactLaw& law) : law_(law) {}
    void go(const ContactMotion& end, const std::function<void(const ContactMotion&, const ContactTraction&)>& visit) {
        constexpr int steps = 600;
        const ContactMotion from = history_.motion;
        for (int i = 1; i <= steps; ++i) {
            const double share = static_cast<double>(i) / steps;
            const ContactMotion to{from.opening + share * (end.opening - from.opening),
                                   from.sliding + share * (end.sliding - from.sliding)};
            const ContactResponse response = update_contact(law_, to, history_);
            history_ = response.history;
            visit(to, response.traction);
        }
    }

private:
    ContactLaw law_;
    ContactHistory history_;
};

constexpr double micro = 1e6;
constexpr double mega = 1e-6;

/// Opens a contact to `reach`, with an unloading from half the softening down if that lies before.
Path open_path(const ContactLaw& law, const ContactParameters& contact, double reach) {
    Path path{{0}, {0}};
    const auto keep = [&](const ContactMotion& motion, const ContactTraction& traction) {
        path.displacement.push_back(motion.opening * micro);
        path.traction.push_back(traction.normal * mega);
    };
    const double half = (contact.critical_opening + contact.ultimate_opening) / 2;
    Walk walk(law);
    walk.go({std::min(2 * contact.critical_opening, reach), 0}, keep);
    if (half < reach) {
        walk.go({half, 0}, keep);
        walk.go({0.2 * half, 0}, keep);
    }
    walk.go({reach, 0}, keep);
    return path;
}

Path shear_path(const ContactLaw& law, const ContactParameters& contact, double compression, double reach) {
    Path path;
    const auto keep = [&](const ContactMotion& motion, const ContactTraction& traction) {
        path.displacement.push_back(motion.sliding * micro);
        path.traction.push_back(traction.shear * mega);
    };
    const double opening = -compression / contact.normal_stiffness;
    Walk walk(law);
    walk.go({opening, 0}, [](const ContactMotion&, const ContactTraction&) {});
    walk.go({opening, reach}, keep);
    return path;
}

std::vector<LawDescription> chosen(const std::vector<std::string>& names) {
    const auto& all = all_contact_laws();
    if (names.empty()) return {all.begin(), all.end()};
    std::vector<LawDescription> laws;
    for (const std::string& name : names) {
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

/// Whether curves over the same displacements cannot be told apart in the picture: within half a percent of the largest traction.
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

/// Sets of curves that cannot be told apart, each by the index of its first.
std::vector<std::vector<std::size_t>> like_curves(const std::vector<Path>& paths) {
    std::vector<std::vector<std::size_t>> sets;
    for (std::size_t i = 0; i < paths.size(); ++i) {
        const auto same = std::find_if(sets.begin(), sets.end(), [&](const auto& s) { return agree({paths[s[0]], paths[i]}); });
        if (same != sets.end()) same->push_back(i);
        if (same == sets.end()) sets.push_back({i});
    }
    return sets;
}

/// One curve a law; the largest set of indistinguishable ones is a single black curve. Returns whether there is such a set.
bool draw_paths(Chart& chart, const std::vector<Path>& paths, double thinner = 1) {
    const auto sets = like_curves(paths);
    const auto most =
        std::max_element(sets.begin(), sets.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); });
    for (auto set = sets.begin(); set != sets.end(); ++set) {
        const bool joint = set == most && set->size() > 1;
        for (std::size_t k = 0; k < (joint ? 1 : set->size()); ++k) {
            const Path& path = paths[(*set)[k]];
            const double width = 4 + 3 * static_cast<double>(joint ? 0 : set->size() - 1 - k);  // earlier ones show at the sides
            Stroke stroke = joint ? Stroke{} : series_stroke((*set)[k]);
            stroke.width = thinner * width;
            chart.line(path.displacement, path.traction, stroke);
        }
    }
    return most->size() > 1;
}

/// Height of a frame on a page: three stand below one another in a column, side by side over two.
double frame_height(const PictureStyle& style) { return style.page_width < 700 ? 340 : 290; }

Drawing draw_open(const std::vector<ContactLaw>& laws, const ContactParameters& contact, const std::string& caption, double reach,
                  const PictureStyle& style) {
    Chart chart(style, {"", {caption}}, up_to("opening, µm", reach * micro),
                up_to("normal traction, MPa", 1.12 * contact.tensile_strength * mega), {.height = frame_height(style)});
    std::vector<Path> paths;
    for (const ContactLaw& law : laws) paths.push_back(open_path(law, contact, reach));
    draw_paths(chart, paths);
    return chart.finish();
}

/// \param joint is set if several laws share a curve
Drawing draw_shear(const std::vector<ContactLaw>& laws, const ContactParameters& contact, double compression,
                   const PictureStyle& style, bool& joint) {
    const double reach = std::max(3 * contact.critical_sliding, 1.2 * contact.ultimate_opening);
    double highest = 0;
    std::vector<Path> open;
    std::vector<Path> closed;
    for (const ContactLaw& law : laws) {
        open.push_back(shear_path(law, contact, 0, reach));
        closed.push_back(shear_path(law, contact, compression, reach));
        highest = std::max({highest, largest(open.back().traction), largest(closed.back().traction)});
    }
    Chart chart(style, {"", {fmt::format("sliding under {:.3g} MPa, thin: δn = 0", compression * mega)}},
                up_to("sliding, µm", reach * micro), up_to("shear traction, MPa", 1.12 * highest),
                {.height = frame_height(style)});
    const bool all_closed = draw_paths(chart, closed);
    const bool all_open = draw_paths(chart, open, 0.45);
    joint = all_closed || all_open;
    return chart.finish();
}

}  // namespace

Drawing draw_laws(const ContactParameters& contact, const std::string& title, const LawPlotOptions& options,
                  const PictureStyle& style) {
    const Coupling coupling = options.coupling == "none" ? Coupling::none : Coupling::full;
    std::vector<ContactLaw> laws;
    for (const LawDescription& d : chosen(options.laws)) laws.push_back(make_contact_law(contact, d.variant, coupling));
    const bool wide = style.page_width >= 1400;
    const PictureStyle part = style.of_part(wide ? std::floor(style.page_width / 3) : style.page_width);
    const ChartText heading{
        style.title.empty() ? title : style.title,
        {fmt::format("opening: δct {:.3g} µm, δut {:.3g} µm, Gf {:.4g} J/m²; sliding: δcs {:.3g} µm, cc {:.4g} MPa",
                     contact.critical_opening * micro, contact.ultimate_opening * micro, contact.fracture_energy,
                     contact.critical_sliding * micro, contact.cohesion * mega)}};
    Drawing page(static_cast<int>(style.page_width), 0);
    const Column column{page_margin, page.width() - page_margin};
    page.set_height(draw_heading(page, heading, column, 14));
    bool joint = false;
    const std::vector<Drawing> charts{
        draw_open(laws, contact, "opening, unloaded half-way", 1.05 * contact.ultimate_opening, part),
        draw_open(laws, contact, "the same near the peak", 4 * contact.critical_opening, part),
        draw_shear(laws, contact, options.normal_stress, part, joint)};
    page = stacked({page, wide ? side_by_side(charts) : stacked(charts)});
    std::vector<LegendEntry> legend;
    for (std::size_t i = 0; i < laws.size(); ++i) legend.push_back({series_stroke(i), std::string(name_of(laws[i].variant))});
    if (joint) legend.push_back({Stroke{}, "one curve for all laws without one of their own"});
    page.set_height(draw_legend(page, legend, column, page.height()).bottom + 14);
    return page;
}

Drawing draw_lennard_jones(const PictureStyle& style) {
    // The corners and the middle of Table 9.
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
        const Stroke stroke = series_stroke(i, 3.5);
        chart.line(path.displacement, path.traction, stroke);
        chart.legend(stroke, fmt::format("m {}, n {}: b = {:.3f}", m, n, fpz::lennard_jones_b(m, n)));
    }
    return chart.finish();
}

namespace {

struct LawOptions : PlotOptions {
    std::string material;
    PlaneCondition plane = PlaneCondition::strain;
    std::optional<FractureEnergyChoice> fracture_energy;
    LawPlotOptions law;
};

void add_options(CLI::App& app, LawOptions& options) {
    constexpr Quantity normal_stress{"normal_stress", Dimension::stress, 0, 1e12, "compression across a contact"};
    app.add_option("--material", options.material, "material: a name of share/materials or a TOML file");
    add_names(app, "--contact-law", options.law.laws, "NAME", "law to draw; may be given again; all unless given");
    add_choice(app, "--coupling", options.law.coupling, {"full", "none"}, "whether failure in one mode takes the other");
    add_choice<PlaneCondition>(app, "--plane", options.plane,
                               {{"strain", PlaneCondition::strain}, {"stress", PlaneCondition::stress}}, "plane condition");
    add_fracture_energy(app, options.fracture_energy, "fracture energy of the contacts: mixed (Eq 32), mode-i or a value");
    add_quantity(app, "--normal-stress", options.law.normal_stress, normal_stress, "compression for the curve of shear", "20MPa");
    add_picture(app, options);
}

Drawing draw_laws_of_run(const LawOptions& options, const RunReader& run) {
    LawPlotOptions law = options.law;
    if (law.laws.empty()) law.laws = {run.header().contact_law};
    law.coupling = run.header().coupling;
    return draw_laws(run.header().contact, fmt::format("{}, {}", run.header().material, run.header().contact_law), law,
                     options.style);
}

Drawing draw_laws_of_material(const LawOptions& options, const Call& call) {
    const Material material = read_material_of(call, options.material);
    const ContactParameters contact = contact_parameters(material, options.plane, options.fracture_energy);
    return draw_laws(contact, fmt::format("{}, plane {}", material.name, name_of(options.plane)), options.law, options.style);
}

}  // namespace

Command law_plot() {
    return make_plot<LawOptions>(
        "law", "curves of the contact laws, by a material or as in a run",
        {"--material augig-granite -o law.png", "uniaxial.h5 --normal-stress 50MPa -o law.svg"},
        FileArguments{"run", "run file", false}, add_options, [](const LawOptions& options, const Call& call) {
            if (!call.files.empty()) return draw_laws_of_run(options, RunReader(call.file()));
            if (!options.material.empty()) return draw_laws_of_material(options, call);
            throw UsageError("plot law: neither a run nor a material; give a run file or --material NAME");
        });
}

Command lennard_jones_plot() {
    return make_plot<PlotOptions>("lennard-jones", "the potential of Eqs 20-22 (Fig 11)",
                                  {"-o potential.png", "-o potential.svg"}, std::nullopt, add_chart,
                                  [](const PlotOptions& options, const Call&) { return draw_lennard_jones(options.style); });
}

}  // namespace graincrack
