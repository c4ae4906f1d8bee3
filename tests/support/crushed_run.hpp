// A small specimen that is crushed until grains come into contact that were not neighbours, alone or over several ranks.
#pragma once

#include "tests/support/phases.hpp"
#include "tests/support/small_run.hpp"

namespace graincrack::test {

/// What is crushed, and how.
struct Crush {
    LawVariant law = LawVariant::consistent;
    double mass_scaling_factor = 60;  ///< 0: none
    bool has_phases = false;          ///< three, with classes of contacts for each pair of them
    double confining_pressure = 0;    ///< Pa, amplitude 0 of the lateral boundary
    double speed = 6;                 ///< of each platen, m/s
    std::int64_t n_steps = 400;
    VectorTarget vector_target = widest_vector_target();
};

inline Specimen crushed_specimen() { return jittered_grid(9, 18, 0.04, 0.08, 0.25); }

/// The run on a rank, before its first step.
inline SmallRun run_to_crush(const Crush& crush, const Ranks& ranks) {
    SmallRun run =
        crush.has_phases ? varied_phases(crushed_specimen()).run(crush.law) : SmallRun(crushed_specimen(), augig_law(crush.law));
    run.assemblage.vector_target = crush.vector_target;
    LoadingRequest loading;
    loading.platen_friction = 0.1;
    loading.max_strain = 0.05;
    run.parameters.damping = 0.8;
    run.parameters.mass_scaling = make_mass_scaling(run.assemblage, crush.mass_scaling_factor);
    Boundary boundary = boundary_of_test(run.assemblage, run.specimen, loading, augig_contact());
    if (crush.confining_pressure > 0) {
        boundary = with_pressure(std::move(boundary), {BoundaryPart::left, BoundaryPart::right}, run.assemblage, run.specimen);
    }
    run.set_boundary(boundary, 0.7);
    run.share(ranks);
    return run;
}

/// The run on a rank, at its end.
inline SmallRun crushed_run(const Crush& crush, const Ranks& ranks = Ranks::alone(), int threads = 1) {
    SmallRun run = run_to_crush(crush, ranks);
    run.begin();
    const double duration = static_cast<double>(crush.n_steps) * run.parameters.time_step;
    LinearPressure pressure;
    IntervalLoading loading = pressure.to(crush.confining_pressure, 0, duration);
    loading.velocity_begin = loading.velocity_end = {crush.speed, -crush.speed};
    run.steps(crush.n_steps, loading, threads);
    return run;
}

inline std::ptrdiff_t n_active_contacts(const ContactPairList& list) {
    return std::count_if(list.contacts.begin(), list.contacts.end(), [](const NodeEdgeContact& c) { return c.active; });
}

/// Whether two arrays have the same bytes.
template <class Value>
bool same_bytes(const std::vector<Value>& l, const std::vector<Value>& r) {
    const auto l_bytes = std::as_bytes(std::span(l));
    const auto r_bytes = std::as_bytes(std::span(r));
    return std::equal(l_bytes.begin(), l_bytes.end(), r_bytes.begin(), r_bytes.end());
}

}  // namespace graincrack::test
