// A small specimen with everything that a time step needs; tests call `advance` and `measure` on it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "solver/loading/platen_control.hpp"
#include "solver/program/standard_tests.hpp"
#include "solver/run/frame_output.hpp"
#include "solver/run/measure.hpp"
#include "solver/setup/regions.hpp"
#include "solver/setup/stable_time_step.hpp"
#include "solver/step/step.hpp"
#include "tests/support/augig_granite.hpp"
#include "tests/support/specimens.hpp"

namespace graincrack::test {

/// Platens at these heights.
inline std::vector<Platen> two_platens(double bottom, double top) {
    std::vector<Platen> platens(2);
    platens[bottom_platen].motion = bottom_platen;
    platens[bottom_platen].side = -1;
    platens[bottom_platen].position = bottom;
    platens[top_platen].position = top;
    return platens;
}
/// A boundary without a platen within reach and without pressure.
inline Boundary no_boundary(const Assemblage& a, const Specimen& s) { return make_boundary(a, s, two_platens(-1e6, 1e6), 0); }

/// Platens and membrane of a standard test.
inline Boundary boundary_of_test(const Assemblage& a, const Specimen& s, const LoadingRequest& request,
                                 const ContactParameters& contact) {
    constexpr double peak_drop = 0.3;  // does not influence the boundary
    return make_program_boundary(a, s, standard_test(request, peak_drop, s, augig_granite().rock), contact,
                                 request.platen_friction);
}

/// A boundary of which some parts carry a pressure, amplitude 0.
inline Boundary with_pressure(Boundary boundary, const std::vector<BoundaryPart>& parts, const Assemblage& a, const Specimen& s) {
    for (std::size_t e = 0; e < s.n_boundary_edges(); ++e) {
        if (std::find(parts.begin(), parts.end(), static_cast<BoundaryPart>(s.boundary_part[e])) != parts.end()) {
            LoadedEdge edge{.pressure = 0};
            edge.nodes = {a.node_of_specimen[s.boundary_edges[e][0]], a.node_of_specimen[s.boundary_edges[e][1]]};
            const auto part = static_cast<BoundaryPart>(s.boundary_part[e]);
            edge.is_lateral = part == BoundaryPart::left || part == BoundaryPart::right;
            edge.length = length(a.position[edge.nodes[1]] - a.position[edge.nodes[0]]);
            boundary.prescribed.edges.push_back(edge);
        }
    }
    arrange_prescribed(a, boundary.prescribed);
    return boundary;
}

/// Platens with the motion of a standard test at a fixed rate.
class TestPlatens {
public:
    TestPlatens(const LoadingRequest& request, const Specimen& specimen)
        : TestPlatens(standard_test(request, 0.3, specimen, augig_granite().rock), specimen) {}
    IntervalLoading next(double time, double duration) {
        const PlatenSpeeds speeds = platens_.next({.time = time}, duration);
        return {{speeds.begin, -speeds.begin}, {speeds.end, -speeds.end}, nullptr};
    }

private:
    TestPlatens(const Program& test, const Specimen& specimen) : platens_(specimen, augig_granite().rock, *test.platens) {
        platens_.set(*test.stages.back().platens, 0);
    }
    PlatenControl platens_;
};

/// A pressure that rises and falls linearly, as amplitude 0.
class LinearPressure {
public:
    [[nodiscard]] double present() const { return present_; }
    void set(double value) { present_ = value; }
    /// Loading of the next steps of a run, in which the pressure changes to `end`. It is valid as long as this object.
    IntervalLoading to(double end, double time, double duration) {
        amplitudes_ = {{{.kind = TimeFunction::Kind::table, .times = {0, duration}, .values = {present_, end}}, time}};
        present_ = end;
        return {{}, {}, &amplitudes_};
    }

private:
    double present_ = 0;
    std::vector<Amplitude> amplitudes_;
};

/// Equal contacts between all phases.
inline ContactLaws same_of_every_class(const ContactLaw& law, std::size_t n_phases) {
    ContactLaws laws;
    laws.of_class.assign(n_contact_classes(n_phases), law);
    return laws;
}

struct SmallRun {
    Specimen specimen;
    Assemblage assemblage;
    Boundary boundary;
    StepParameters parameters;
    State state;

    /// A run without supports and damping, with `fraction` of the stable time step.
    SmallRun(Specimen s, const ContactLaw& law, PlaneCondition plane = PlaneCondition::strain, double fraction = 0.5,
             const Rock& rock = augig_granite().rock)
        : specimen(std::move(s)),
          assemblage(make_assemblage(specimen, rock, plane)),
          boundary(no_boundary(assemblage, specimen)),
          parameters{law, 0, 0} {
        set_boundary(boundary, fraction);
    }
    /// The same of several phases.
    SmallRun(Specimen s, const std::vector<Phase>& phases, const ContactLaws& laws, PlaneCondition plane = PlaneCondition::strain,
             double fraction = 0.5)
        : specimen(std::move(s)),
          assemblage(make_assemblage(specimen, phases, plane)),
          boundary(no_boundary(assemblage, specimen)),
          parameters{laws, 0, 0} {
        set_boundary(boundary, fraction);
    }
    /// Sets other supports, and the state at rest.
    void set_boundary(const Boundary& b, double fraction) {
        boundary = b;
        parameters.time_step = fraction * stable_time_step(assemblage, boundary, parameters.laws, parameters.mass_scaling.factor);
        state = make_state(assemblage, boundary, specimen);
    }
    /// Sets the platens and the membrane of a standard test, and the state at rest.
    void load_by(const LoadingRequest& request, double fraction, const ContactParameters& contact = augig_contact()) {
        set_boundary(boundary_of_test(assemblage, specimen, request, contact), fraction);
    }
    /// The same with selective mass scaling; factor 0: the one that suffices.
    void scale_masses(const Boundary& b, double fraction, double factor = 0) {
        parameters.mass_scaling =
            make_mass_scaling(assemblage, factor > 0 ? factor : sufficient_mass_scaling(assemblage, b, parameters.laws));
        set_boundary(b, fraction);
    }
    /// Makes this run the part of a rank. It is called before `begin`.
    void share(const Ranks& ranks) { assemblage.part = make_part(assemblage, boundary.prescribed, ranks); }
    /// Sets velocities as a function of the reference position.
    template <class Field>
    void set_velocity(Field&& field) {
        for (std::size_t i = 0; i < state.velocity.size(); ++i) state.velocity[i] = field(assemblage.position[i]);
    }
    void begin() { start(assemblage, parameters, state); }
    void steps(std::int64_t n, const IntervalLoading& loading = {}, int threads = 1) {
        ThreadTeam team(threads);
        advance(assemblage, boundary, parameters, loading, n, team, state);
    }
    /// Runs steps in which a pressure changes linearly to another.
    void steps_under(LinearPressure& pressure, double end, std::int64_t n) {
        steps(n, pressure.to(end, state.time, static_cast<double>(n) * parameters.time_step));
    }
    /// Lets parts of the boundary carry a pressure, and the state at rest.
    void press_on(const std::vector<BoundaryPart>& parts, double fraction) {
        set_boundary(with_pressure(boundary, parts, assemblage, specimen), fraction);
    }
    [[nodiscard]] Measurement measured(int threads = 1) {
        ThreadTeam team(threads);
        return measure(assemblage, boundary, parameters, team, state);
    }
    [[nodiscard]] Frame frame(int threads = 1) const {
        ThreadTeam team(threads);
        return make_frame(assemblage, parameters.laws, state, team);
    }
    [[nodiscard]] std::size_t failed_points() const {
        std::size_t n = 0;
        for (std::size_t i = 0; i < 2 * assemblage.contacts.size(); ++i) n += point_history(state, i).failed() ? 1U : 0U;
        return n;
    }
    [[nodiscard]] double mass() const {
        double sum = 0;
        for (const double m : assemblage.mass) sum += m;
        return sum;
    }
    /// Mean of a nodal field, weighted by mass.
    [[nodiscard]] Vector2 mean(const std::vector<Vector2>& field) const {
        Vector2 sum;
        for (std::size_t i = 0; i < field.size(); ++i) sum += assemblage.mass[i] * field[i];
        return (1 / mass()) * sum;
    }
};

/// Middle of an element of the undisplaced specimen.
inline Vector2 centroid(const Assemblage& a, std::size_t element) {
    Vector2 sum;
    for (const std::int32_t node : a.element_nodes[element]) sum += (1.0 / 3) * a.position[node];
    return sum;
}
inline double largest_length(const std::vector<Vector2>& vectors) {
    double largest = 0;
    for (const Vector2& v : vectors) largest = std::max(largest, length(v));
    return largest;
}

/// Links no grains any more: all contacts are broken and released.
inline void loosen(SmallRun& run) {
    ContactPairList& list = run.state.contact_pairs;
    std::fill(list.debonded.begin(), list.debonded.end(), std::uint8_t{1});
    std::fill(list.released.begin(), list.released.end(), std::uint8_t{1});
}

/// Sums over the nodes of m v and x × m v, and of their magnitudes.
struct Momenta {
    Vector2 linear;
    double angular = 0;
    double linear_scale = 0;
    double angular_scale = 0;
};
/// Angular momentum of central differences: x(n) × m v(n−½), which equals x(n−1) × m v(n−½).
inline Momenta momenta_of(const SmallRun& run) {
    Momenta m;
    for (std::size_t i = 0; i < run.state.velocity.size(); ++i) {
        const Vector2 p = run.assemblage.mass[i] * run.state.velocity[i];
        const Vector2 x = run.assemblage.position[i] + run.state.displacement[i];
        m.linear += p;
        m.angular += x.x * p.y - x.y * p.x;
        m.linear_scale += length(p);
        m.angular_scale += length(x) * length(p);
    }
    return m;
}

/// The vector units that this machine has.
inline std::vector<VectorTarget> available_vector_targets() {
    std::vector<VectorTarget> targets;
    for (const VectorTarget target : {VectorTarget::plain, VectorTarget::avx2, VectorTarget::avx512}) {
        if (is_available(target)) targets.push_back(target);
    }
    return targets;
}

inline ContactLaw augig_law(LawVariant variant = default_law) {
    return make_contact_law(augig_contact(PlaneCondition::strain, FractureEnergyChoice::Kind::mode_i), variant);
}
/// The law with other stiffnesses, which are its greatest too, Pa/m.
inline ContactLaw with_stiffnesses(ContactLaw law, double normal, double shear) {
    law.kt = law.stiffest_normal = normal;
    law.ks = law.stiffest_shear = shear;
    return law;
}

}  // namespace graincrack::test
