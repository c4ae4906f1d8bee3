// A small specimen with everything a step needs, to be led by a test through `advance` and `measure`.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "solver/loading/standard_tests.hpp"
#include "solver/run/measure.hpp"
#include "solver/setup/stable_time_step.hpp"
#include "solver/step/step.hpp"
#include "tests/support/augig_granite.hpp"
#include "tests/support/specimens.hpp"

namespace graincrack::test {

/// No platen within reach, no membrane.
inline Boundary no_boundary(const Assemblage& a, const Specimen& s) {
    std::array<Platen, 2> platens;
    platens[bottom_platen].side = -1;
    platens[bottom_platen].position = -1e6;
    platens[top_platen].position = 1e6;
    return make_boundary(a, s, platens, 0, {});
}

struct SmallRun {
    Specimen specimen;
    Assemblage assemblage;
    Boundary boundary;
    StepParameters parameters;
    State state;

    /// Free of supports, undamped, at `fraction` of the stable step.
    SmallRun(Specimen s, const ContactLaw& law, PlaneCondition plane = PlaneCondition::strain, double fraction = 0.5,
             const Rock& rock = augig_granite().rock)
        : specimen(std::move(s)),
          assemblage(make_assemblage(specimen, rock, plane)),
          boundary(no_boundary(assemblage, specimen)),
          parameters{law, 0, 0} {
        set_boundary(boundary, fraction);
    }
    /// Other supports, and the state at rest.
    void set_boundary(const Boundary& b, double fraction) {
        boundary = b;
        const SubcycledStep step = stable_subcycled_step(assemblage, boundary, parameters.law, parameters.mass_scaling.factor);
        parameters.substeps = step.parts;
        parameters.time_step = fraction * step.time_step;
        state = make_state(assemblage, boundary, specimen);
    }
    /// Velocities as a function of the reference position.
    template <class Field>
    void set_velocity(Field&& field) {
        for (std::size_t i = 0; i < state.velocity.size(); ++i) {
            state.velocity[i] = field(assemblage.position[i]);
        }
    }
    void begin() { start(assemblage, parameters, state); }
    void steps(std::int64_t n, const IntervalLoading& loading = {}, int threads = 1) {
        ThreadTeam team(threads);
        advance(assemblage, boundary, parameters, loading, n, team, state);
    }
    [[nodiscard]] Measurement measured() { return measure(assemblage, boundary, parameters, state); }
    [[nodiscard]] std::size_t failed_points() const {
        std::size_t n = 0;
        for (std::size_t i = 0; i < 2 * assemblage.contacts.size(); ++i) {
            n += point_history(state, i).failed() ? 1U : 0U;
        }
        return n;
    }
    [[nodiscard]] double mass() const {
        double sum = 0;
        for (const double m : assemblage.mass) {
            sum += m;
        }
        return sum;
    }
    /// Mean of a nodal field, by mass.
    [[nodiscard]] Vector2 mean(const std::vector<Vector2>& field) const {
        Vector2 sum;
        for (std::size_t i = 0; i < field.size(); ++i) {
            sum += assemblage.mass[i] * field[i];
        }
        return (1 / mass()) * sum;
    }
};

/// The vector units this machine has.
inline std::vector<VectorTarget> available_vector_targets() {
    std::vector<VectorTarget> targets;
    for (const VectorTarget target : {VectorTarget::plain, VectorTarget::avx2, VectorTarget::avx512}) {
        if (is_available(target)) {
            targets.push_back(target);
        }
    }
    return targets;
}

inline ContactLaw augig_law(LawVariant variant = LawVariant::scaled, Coupling coupling = Coupling::full,
                            FractureEnergyChoice::Kind energy = FractureEnergyChoice::Kind::mode_i) {
    return make_contact_law(augig_contact(PlaneCondition::strain, energy), variant, coupling);
}

}  // namespace graincrack::test
