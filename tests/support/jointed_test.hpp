// A plane of weakness between smooth platens, loaded with default options.
//
// A plane at an angle β from the horizontal, which is the direction of σ3, so that its normal is at β from σ1, slides at Jaeger's
// strength (Jaeger 1960, Geological Magazine 97; Jaeger, Cook & Zimmerman, Fundamentals of Rock Mechanics, §4.8):
//
//   σ1 = σ3 + 2 (c + σ3 tan φ) / ((1 − tan φ/tan β) sin 2β)
//
// It is a joint, broken from the start, without cohesion; or it is where two phases meet, and has the law and the values of their
// class.
#pragma once

#include <cmath>

#include "solver/run/simulation.hpp"
#include "tests/support/augig_granite.hpp"
#include "tests/support/specimens.hpp"

namespace graincrack::test {

struct JointedTest {
    double angle = 0;     ///< of the plane from the horizontal, rad
    double pressure = 0;  ///< σ3, Pa
    double friction_angle = 30 * degree;
    double cohesion = 0;  ///< of the class of the plane, Pa; 0: the plane is a joint

    [[nodiscard]] double strength() const {
        const double t = std::tan(friction_angle);
        return pressure + 2 * (cohesion + pressure * t) / ((1 - t / std::tan(angle)) * std::sin(2 * angle));
    }
    /// Rectangle of nx × 2 ny cells with the plane.
    [[nodiscard]] Specimen specimen(int nx, int ny, Blocks blocks) const {
        Specimen s = jointed_rectangle(nx, ny, 0.06, 0.2, angle, blocks);
        if (cohesion > 0) {
            s.phase_names = {"lower", "upper"};
            for (std::size_t g = s.n_grains() / 2; g < s.n_grains(); ++g) s.grain_phase[g] = 1;
            s.contact_kind.assign(s.n_contacts(), static_cast<std::uint8_t>(ContactKind::grain_boundary));
        }
        return s;
    }
    /// The test of the solver to 1.3 times the strain at which an elastic specimen would slide. Only the plane can fail.
    [[nodiscard]] SimulationRequest request() const {
        SimulationRequest request;
        request.loading = {.test = TestKind::triaxial, .rate = RateKind::automatic, .confining_pressure = pressure};
        request.material = augig_granite();
        GivenContact& contact = request.material.contact;
        contact.tensile_strength = 1000 * MPa;
        contact.cohesion = contact.open_shear_strength = 3000 * MPa;
        contact.friction_angle = friction_angle;
        contact.fracture_energy = contact.mode_ii_fracture_energy = 1e6;
        request.contact = contact_parameters(request.material, request.plane, {});
        if (cohesion > 0) {
            MaterialFabric& fabric = request.material.fabric;
            fabric.phases["lower"].fraction = fabric.phases["upper"].fraction = 0.5;
            GivenContact& plane = fabric.pairs["lower-upper"];
            plane.cohesion = cohesion;
            plane.friction_angle = friction_angle;
            contact.friction_angle = 50 * degree;
        }
        request.loading.max_strain = 1.3 * strength() / request.material.rock.young_modulus;
        request.frames = 0;
        return request;
    }
};

}  // namespace graincrack::test
