// The fast step against the plain one: the same fields to round-off, for every law.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mesher/mesh.hpp"
#include "tests/support/naive_step.hpp"
#include "tests/support/phases.hpp"
#include "tests/support/small_run.hpp"
#include "tests/support/verify.hpp"

namespace graincrack::test {
namespace {

/// Largest difference of two fields over the largest value of the second.
double difference(const std::vector<Vector2>& fast, const std::vector<NaiveRun::Vector>& naive) {
    double worst = 0, largest = 0;
    for (std::size_t i = 0; i < fast.size(); ++i) {
        worst = std::max({worst, std::abs(fast[i].x - naive[i].x()), std::abs(fast[i].y - naive[i].y())});
        largest = std::max(largest, naive[i].cwiseAbs().maxCoeff());
    }
    return worst / largest;
}

/// What grains and contacts are made of: one phase, or several whose values and strengths all differ.
enum class Grains { of_one_phase, of_three_phases };

PhasedSpecimen make(Grains grains) {
    const Specimen s = mesher::mesh({.region = mesher::rectangle(0.02, 0.04), .fabric = {.grains = 80}});
    return grains == Grains::of_three_phases ? varied_phases(s)
                                             : PhasedSpecimen{s, uniform_fabric(augig_granite().rock, augig_contact(), 1)};
}

/// The law of each contact by place, made of its own values.
std::vector<ContactLaw> laws_of_contacts(const PhasedSpecimen& made, const Assemblage& a, LawVariant variant) {
    std::vector<ContactLaw> laws(a.contacts.size());
    for_each_contact(a, [&](std::int32_t place, std::int32_t /*contact_class*/) {
        const auto c = static_cast<std::size_t>(a.specimen_contact[place]);
        const auto phase_at = [&](std::size_t k) {
            const auto node = static_cast<std::size_t>(made.specimen.contact_nodes[c][k]);
            return made.specimen.grain_phase[grain_of_nodes(made.specimen)[node]];
        };
        const ContactParameters& of_class = made.fabric.contacts[contact_class(phase_at(0), phase_at(2))];
        const auto& strength = made.specimen.contact_strength_factor;
        laws[place] = make_contact_law(scaled_contact(of_class, strength.empty() ? 1 : strength[c]), variant);
    });
    return laws;
}

/// A compressed, shaken rectangle after `n` steps by both. Both laws of platens stick and slide.
void expect_equal_fields(const LawDescription& description, std::int64_t n, bool damaged, VectorTarget target, DampingForm form,
                         Grains grains = Grains::of_one_phase) {
    const PhasedSpecimen made = make(grains);
    SmallRun run = made.run(description.variant);
    run.load_by({.platen_friction = 0.1}, 0.5);
    run.parameters.damping = 0.3;
    run.parameters.damping_form = form;
    run.assemblage.vector_target = target;
    const double speed = damaged ? 5.0 : 0.5;
    run.set_velocity([&](const Vector2& x) { return Vector2{0.1 * std::sin(200 * x.y), -speed * x.y / 0.02}; });
    NaiveRun naive(run.assemblage, run.boundary, laws_of_contacts(made, run.assemblage, description.variant),
                   run.parameters.time_step, run.parameters.damping, form);
    for (std::size_t i = 0; i < run.state.velocity.size(); ++i) naive.set_velocity(i, run.state.velocity[i]);
    run.begin();
    run.steps(n, {{speed, -speed}, {speed, -speed}, nullptr});
    std::array<double, 2> platens{};
    for (std::int64_t k = 0; k < n; ++k) {
        naive.step(platens);
        platens[bottom_platen] += run.parameters.time_step * speed;
        platens[top_platen] -= run.parameters.time_step * speed;
    }
    EXPECT_EQ(naive.failed_points() > 0, damaged);
    const std::string name = std::string(description.name) + (damaged ? ", damaged, " : ", ") + std::string(name_of(target)) +
                             ", damping " + std::string(name_of(form)) +
                             (grains == Grains::of_three_phases ? ", three phases" : "");
    // Round-off of 1e-16 a step adds up over the steps: 1e-9 of the field's maximum is far above that.
    verify("elements: displacements of the fast step against a plain one, " + name,
           difference(run.state.displacement, naive.displacement()), 0, 1e-9, "the equations, one by one", 1);
    verify("elements: velocities of the fast step against a plain one, " + name, difference(run.state.velocity, naive.velocity()),
           0, 1e-9, "the equations, one by one", 1);
}

// The same equations one by one, in another order: round-off alone, 1e-9 of the largest value.
TEST(NaiveStep, AgreesOnIntactFieldsForEveryLawOnEveryVectorUnit) {
    for (const LawDescription& description : all_contact_laws()) {
        for (const VectorTarget target : available_vector_targets()) {
            SCOPED_TRACE(description.name);
            SCOPED_TRACE(name_of(target));
            // What opens and closes in `literal` meets another shear stiffness on either side of δn = 0 and chatters: round-off
            // grows e-fold within some tens of steps.
            expect_equal_fields(description, description.variant == LawVariant::literal ? 200 : 1000, false, target,
                                DampingForm::local);
            // The sign of a change of force that is hardly one is round-off's too, and turns a share of the force over.
            expect_equal_fields(description, 200, false, target, DampingForm::combined);
        }
    }
}

// The same past failure, as long as round-off has not grown.
TEST(NaiveStep, AgreesOnDamagedFieldsForLawsWithAnEnergy) {
    for (const LawVariant law : {LawVariant::consistent, LawVariant::combined, LawVariant::cohesive_frictional}) {
        expect_equal_fields(description_of(law), law == LawVariant::combined ? 800 : 400, true, widest_vector_target(),
                            DampingForm::local);
        // Not over the 800 steps of `combined`, whose peaks come later: see above.
        if (law != LawVariant::combined) {
            expect_equal_fields(description_of(law), 400, true, widest_vector_target(), DampingForm::combined);
        }
    }
}

// Six classes of contacts, each with its own values, and a strength factor on every contact.
TEST(NaiveStep, AgreesOnFieldsOfThreePhasesForEveryLaw) {
    for (const LawDescription& description : all_contact_laws()) {
        SCOPED_TRACE(description.name);
        expect_equal_fields(description, 200, false, widest_vector_target(), DampingForm::local, Grains::of_three_phases);
    }
    for (const LawVariant law : {LawVariant::consistent, LawVariant::combined, LawVariant::cohesive_frictional}) {
        expect_equal_fields(description_of(law), law == LawVariant::combined ? 800 : 400, true, widest_vector_target(),
                            DampingForm::local, Grains::of_three_phases);
    }
}

}  // namespace
}  // namespace graincrack::test
