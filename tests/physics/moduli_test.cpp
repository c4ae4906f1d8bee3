// What contacts add to the compliance of an assemblage: lattice and bar in closed form, random meshes by the isotropic formula.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mesher/mesh.hpp"
#include "tests/support/linear_statics.hpp"
#include "tests/support/verify.hpp"

namespace graincrack {
namespace {

using test::augig_contact;
using test::SmallRun;
using test::Tensor;
using test::verify;

ContactLaw elastic_law(PlaneCondition plane, double normal = 1, double shear = 1) {
    ContactLaw law = make_contact_law(augig_contact(plane), LawVariant::consistent);
    law.stiffest_normal = law.kt *= normal;
    law.ks *= shear;
    law.stiffest_shear = law.ks;
    return law;
}

struct Moduli {
    double young_modulus, poisson_ratio;
};
/// Plane moduli that a pull along y shows, from the mean strain.
Moduli pulled(const SmallRun& run) {
    const double stress = 1e6;
    const Tensor strain = mean_strain(run, equilibrium(run, tangent_stiffness(run), boundary_load(run, {0, stress, 0})));
    return {stress / strain.yy, -strain.xx / strain.yy};
}
double contact_length_per_area(const SmallRun& run) {
    double area = 0;
    for (const double of_triangle : run.assemblage.element_geometry.area) area += of_triangle;
    return run.assemblage.contact_length / area;
}

// 1/E' = 1/E + Sv (3/(8 kn) + 1/(8 ks)), ν' = [ν/E − (Sv/8)(1/kn − 1/ks)] E' of an endless lattice: strain between points that a
// period of the lattice apart, in a piece of it under uniform traction, where stress and so every jump is uniform.
TEST(Moduli, OfAnEquilateralLattice) {
    const double edge = 0.005;
    const int n = 6;
    const Rock rock = test::augig_granite().rock;
    const double sv = 2 * std::sqrt(3.0) / edge;
    for (const auto& [normal, shear] : {std::pair{1.0, 1.0}, std::pair{0.05, 0.05}, std::pair{0.1, 5.0}}) {
        const ContactLaw law = elastic_law(PlaneCondition::stress, normal, shear);
        const SmallRun run(test::equilateral_lattice(n, n, edge), law, PlaneCondition::stress);
        const Eigen::SparseMatrix<double> stiffness = tangent_stiffness(run);
        const double stress = 1e6;
        for (const bool along_y : {true, false}) {
            const Tensor pull{along_y ? 0 : stress, along_y ? stress : 0, 0};
            const Eigen::VectorXd u = equilibrium(run, stiffness, boundary_load(run, pull));
            // The first node of grain 2 (j n + i) is the lower left corner of cell (i, j).
            const auto corner = [&](int i, int j) {
                const auto element = static_cast<std::size_t>(2 * (j * n + i));
                return run.specimen.element_nodes[element][0];
            };
            const auto at = [&](int i, int j) {
                return test::displacement_of(u, run.assemblage.node_of_specimen[static_cast<std::size_t>(corner(i, j))]);
            };
            const Vector2 along = (1 / (4 * edge)) * (at(5, 1) - at(1, 1));
            const Vector2 rows = (1 / (4 * edge * std::sqrt(0.75))) * (at(1, 5) - at(1, 1) - 0.5 * (at(5, 1) - at(1, 1)));
            const double axial = along_y ? rows.y : along.x;
            const double lateral = along_y ? along.x : rows.y;
            const double expected = 1 / (1 / rock.young_modulus + sv * (3 / (8 * law.kt) + 1 / (8 * law.ks)));
            const double ratio = (rock.poisson_ratio / rock.young_modulus - sv / 8 * (1 / law.kt - 1 / law.ks)) * expected;
            EXPECT_LT(expected, 0.97 * rock.young_modulus);  // the contacts do give way
            const std::string how =
                " with contacts x " + std::to_string(normal).substr(0, 4) + ", " + std::to_string(shear).substr(0, 4);
            verify("elements: equilateral lattice, E" + how + " (GPa)", stress / axial * 1e-9, expected * 1e-9, 1e-9,
                   "1/E + Sv (3/8kn + 1/8ks)");
            verify("elements: equilateral lattice, nu" + how, -lateral / axial, ratio, 1e-9, "[nu/E - Sv/8 (1/kn - 1/ks)] E'");
        }
    }
}

// Random meshes: the contacts' mean compliance is the formula's with their own length per area, and not a bug: −4 % on E.
TEST(Moduli, OfRandomMeshes) {
    struct Case {
        int grains;
        PlaneCondition plane;
        double young_modulus, poisson_ratio;  // GPa; measured on other meshes of the kind
    };
    for (const Case& c : {Case{1152, PlaneCondition::stress, 24.78, 0.248}, Case{1840, PlaneCondition::stress, 24.50, 0.253},
                          Case{1152, PlaneCondition::strain, 24.68, 0.239}}) {
        mesher::Request request;
        request.region = mesher::rectangle(0.08, 0.16);
        request.fabric.grains = c.grains;
        const SmallRun run(mesher::mesh(request), elastic_law(c.plane), c.plane);
        Moduli m = pulled(run);
        if (c.plane == PlaneCondition::strain) {
            m = {fpz::material_young_modulus(m.young_modulus, m.poisson_ratio), fpz::material_poisson_ratio(m.poisson_ratio)};
        }
        const fpz::AssemblageModuli expected =
            fpz::assemblage_moduli(test::augig_granite().rock, c.plane, run.parameters.laws[0].kt, run.parameters.laws[0].ks,
                                   contact_length_per_area(run));
        const std::string what = std::to_string(c.grains) + " grains, plane " + std::string(name_of(c.plane));
        // The formula takes stress to be uniform, which on such meshes it is not by 8 %.
        verify("elements: random mesh, E, " + what + " (GPa)", m.young_modulus * 1e-9, expected.young_modulus * 1e-9, 5e-3,
               "isotropic formula");
        verify("elements: random mesh, nu, " + what, m.poisson_ratio, expected.poisson_ratio, 0.02, "isotropic formula");
        verify("elements: random mesh, E as on other meshes, " + what + " (GPa)", m.young_modulus * 1e-9, c.young_modulus, 5e-3,
               "independent program");
        verify("elements: random mesh, nu as on other meshes, " + what, m.poisson_ratio, c.poisson_ratio, 0.02,
               "independent program");
        EXPECT_LT(m.young_modulus, 0.98 * 25.8e9);
    }
}

}  // namespace
}  // namespace graincrack
