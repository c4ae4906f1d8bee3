#include "solver/run/sensitivity.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "share/base/error.hpp"
#include "solver/setup/setup.hpp"

namespace graincrack {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Middles of sides, each made once: a side belongs to one grain, as its nodes do.
class Middles {
public:
    explicit Middles(Specimen& specimen) : specimen_(specimen) {}
    std::int32_t of(std::int32_t a, std::int32_t b) {
        const auto next = static_cast<std::int32_t>(specimen_.n_nodes());
        const auto [place, is_new] = nodes_.try_emplace(std::minmax(a, b), next);
        if (is_new) {
            const std::array<double, 2> p = specimen_.node_position[a];
            const std::array<double, 2> q = specimen_.node_position[b];
            specimen_.node_position.push_back({0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1])});
        }
        return place->second;
    }

private:
    Specimen& specimen_;
    std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> nodes_;
};

void divide_elements(const Specimen& s, Middles& middle, Specimen& fine) {
    for (std::size_t e = 0; e < s.n_elements(); ++e) {
        const auto [n0, n1, n2] = s.element_nodes[e];
        const std::int32_t m0 = middle.of(n0, n1);
        const std::int32_t m1 = middle.of(n1, n2);
        const std::int32_t m2 = middle.of(n2, n0);
        fine.element_nodes.insert(fine.element_nodes.end(), {{n0, m0, m2}, {m0, n1, m1}, {m2, m1, n2}, {m0, m1, m2}});
        fine.element_grain.insert(fine.element_grain.end(), 4, s.element_grain[e]);
    }
}

void divide_contacts(const Specimen& s, Middles& middle, Specimen& fine) {
    for (std::size_t c = 0; c < s.n_contacts(); ++c) {
        const auto [a1, a2, b1, b2] = s.contact_nodes[c];
        const std::int32_t a = middle.of(a1, a2);
        const std::int32_t b = middle.of(b1, b2);
        fine.contact_nodes.insert(fine.contact_nodes.end(), {{a1, a, b1, b}, {a, a2, b, b2}});
        fine.contact_grain_boundary.insert(fine.contact_grain_boundary.end(), 2, s.contact_grain_boundary[c]);
        fine.contact_kind.insert(fine.contact_kind.end(), 2, s.contact_kind[c]);
        if (!s.contact_flaw.empty()) fine.contact_flaw.insert(fine.contact_flaw.end(), 2, s.contact_flaw[c]);
        if (s.contact_strength_factor.empty()) continue;
        fine.contact_strength_factor.insert(fine.contact_strength_factor.end(), 2, s.contact_strength_factor[c]);
    }
}

void divide_boundary(const Specimen& s, Middles& middle, Specimen& fine) {
    for (std::size_t b = 0; b < s.n_boundary_edges(); ++b) {
        const auto [from, to] = s.boundary_edges[b];
        const std::int32_t m = middle.of(from, to);
        fine.boundary_edges.insert(fine.boundary_edges.end(), {{from, m}, {m, to}});
        fine.boundary_part.insert(fine.boundary_part.end(), 2, s.boundary_part[b]);
    }
}

}  // namespace

Specimen refined(const Specimen& s) {
    Specimen fine = s;
    fine.elements_per_edge = 2 * s.elements_per_edge;
    fine.element_nodes.clear();
    fine.contact_nodes.clear();
    fine.contact_strength_factor.clear();
    fine.boundary_edges.clear();
    for (auto* groups : {&fine.element_grain, &fine.contact_grain_boundary}) groups->clear();
    for (auto* kinds : {&fine.contact_kind, &fine.contact_flaw, &fine.boundary_part}) kinds->clear();
    Middles middle(fine);
    divide_elements(s, middle, fine);
    divide_contacts(s, middle, fine);
    divide_boundary(s, middle, fine);
    return fine;
}

std::vector<SensitivityCase> sensitivity_cases(const SimulationRequest& test, const Program& program,
                                               double mass_scaling_factor) {
    std::vector<SensitivityCase> cases;
    SimulationRequest request = test;
    request.restart = request.program ? request.program->start_from : "";  // and no checkpoint of it
    if (program.why_dynamic().empty()) {
        cases.push_back({"half the rate", request});
        cases.back().request.program = at_half_the_rate(program);
    }
    cases.push_back({"half the step", request});
    cases.back().request.time_step_fraction /= 2;
    if (request.damping > 0) {
        cases.push_back({"half the damping", request});
        cases.back().request.damping /= 2;
    }
    if (mass_scaling_factor > 0) {
        cases.push_back({"a quarter of the mass scaling", request});
        cases.back().request.mass_scaling_factor = mass_scaling_factor / 4;
    }
    cases.push_back({"twice the elements along an edge", request, true});
    return cases;
}

SensitivityRow sensitivity_row(const std::string& changed, const RunHeader& header, const History& history) {
    const std::vector<double>& stress = history[HistoryColumn::axial_stress];
    const std::vector<double>& strain = history[HistoryColumn::axial_strain];
    const std::size_t peak = peak_row(header, history);
    const double sign = sign_of_strength(header, history);
    SensitivityRow row{changed,
                       header.peak_axial_stress,
                       sign * strain[peak],
                       nan,
                       history[HistoryColumn::tensile_cracks][peak],
                       history[HistoryColumn::shear_cracks][peak]};
    if (header.stop_reason == "peak drop") row.post_peak_slope = (stress.back() - stress[peak]) / (strain.back() - strain[peak]);
    return row;
}

std::vector<SensitivityRow> find_sensitivity(const Specimen& specimen, const SimulationRequest& request,
                                             const TestOutcome& as_it_is, const RunTest& run) {
    std::vector<SensitivityRow> rows{sensitivity_row("as it is", as_it_is.header, as_it_is.history)};
    for (const SensitivityCase& each :
         sensitivity_cases(request, program_of(request, specimen), as_it_is.header.mass_scaling_factor)) {
        try {
            const TestOutcome outcome = run(each.refine ? refined(specimen) : specimen, each.request, each.changed);
            SensitivityRow row = sensitivity_row(each.changed, outcome.header, outcome.history);
            if (each.refine) {  // contacts are half as long
                row.tensile_cracks /= 2;
                row.shear_cracks /= 2;
            }
            rows.push_back(row);
        } catch (const NumericalError&) {
            rows.push_back({each.changed, nan, nan, nan, nan, nan});
        }
    }
    return rows;
}

}  // namespace graincrack
