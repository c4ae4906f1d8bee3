// A grain that turns around its neighbour on the last bond between them.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/detection/pair_list.hpp"
#include "tests/support/check.hpp"
#include "tests/support/linear_statics.hpp"

namespace graincrack {
namespace {

using test::augig_law;
using test::SmallRun;

/// Two grains of one contact, the second of which is turned about the contact's first end.
struct Hinge {
    SmallRun run;
    explicit Hinge(LawVariant variant) : run(test::one_diagonal_grid(1, 1, 0.01, 0.01), augig_law(variant)) { run.begin(); }

    /// Evaluates contacts and updates the list of pairs, as steps do.
    void turn_to(double degrees) {
        const double angle = degrees * std::numbers::pi / 180;
        const auto& nodes = run.assemblage.contacts[0].nodes;
        const Vector2 centre = run.assemblage.position[static_cast<std::size_t>(nodes[0])];
        const auto& grain = run.assemblage.surface.grain_of_node;
        for (std::size_t i = 0; i < run.state.displacement.size(); ++i) {
            if (grain[i] != grain[static_cast<std::size_t>(nodes[2])]) continue;
            const Vector2 r = run.assemblage.position[i] - centre;
            run.state.displacement[i] = {(std::cos(angle) - 1) * r.x - std::sin(angle) * r.y,
                                         std::sin(angle) * r.x + (std::cos(angle) - 1) * r.y};
        }
        run.begin();
        update_pair_list(run.assemblage, run.parameters, run.state);
    }
    [[nodiscard]] double largest_force() const {
        double most = 0;
        for (const Vector2& f : forces_at(run, run.state, run.state.displacement)) most = std::max(most, length(f));
        return most;
    }
};

constexpr LawVariant laws_that_lose_frames[] = {LawVariant::consistent, LawVariant::cohesive_frictional};

TEST(LostFrame, ABondOnWhichAGrainTurnsOverBreaks) {
    for (const LawVariant law : laws_that_lose_frames) {
        Hinge hinge(law);
        const ContactPairList& list = hinge.run.state.contact_pairs;
        // The sense in which the contact opens.
        hinge.turn_to(1e-4);
        const double sense = hinge.run.state.opening[1] > 0 ? 1 : -1;
        for (double degrees = 1; degrees <= 150; ++degrees) hinge.turn_to(sense * degrees);
        EXPECT_EQ(list.debonded[1], 1) << "the far end has opened";
        EXPECT_EQ(list.debonded[0], 0) << "the near end has not moved";
        EXPECT_EQ(list.released[0], 0);
        for (double degrees = 151; degrees <= 210; ++degrees) {
            hinge.turn_to(sense * degrees);
            // A thousandth of what the contact bears; turned over, the far end would overlap by the diagonal of the square.
            EXPECT_LT(hinge.largest_force(), 1e-3 * 24e6 * hinge.run.assemblage.contacts[0].point_area) << degrees;
        }
        EXPECT_EQ(list.debonded[0], 1);
        EXPECT_EQ(list.released[0], 1);
        // What was left of the fracture energy is dissipated, whatever the opening that stands for the lost frame.
        const ContactLaw& constants = hinge.run.parameters.laws[0];
        const double whole = constants.gf * hinge.run.assemblage.contacts[0].point_area;
        EXPECT_GT(hinge.run.state.fracture_energy[0], 0.5 * whole);
        EXPECT_LT(hinge.run.state.fracture_energy[0], 1.1 * whole);
    }
}

}  // namespace
}  // namespace graincrack
