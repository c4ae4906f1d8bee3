// A plane of weakness between smooth platens, loaded with default options.
//
// A joint at an angle β from the horizontal without cohesion slides at Jaeger's strength (Jaeger, Cook & Zimmerman, Fundamentals
// of Rock Mechanics, §4.8, there with the angle of its normal):
//
//   σ1 = σ3 + 2 σ3 tan φ / ((1 − tan φ/tan β) sin 2β)
#pragma once

#include <cmath>

#include "solver/run/simulation.hpp"
#include "tests/support/augig_granite.hpp"
#include "tests/support/specimens.hpp"

namespace graincrack::test {

struct JointedTest {
    double angle = 0;     ///< of the joint from the horizontal, rad
    double pressure = 0;  ///< σ3, Pa
    double friction_angle = 30 * degree;

    [[nodiscard]] double strength() const {
        const double t = std::tan(friction_angle);
        return pressure + 2 * pressure * t / ((1 - t / std::tan(angle)) * std::sin(2 * angle));
    }
    /// The test of the solver to 1.3 times the strain at which an elastic specimen would slide. Only the joint can fail.
    [[nodiscard]] SimulationRequest request() const {
        SimulationRequest request;
        request.loading.test = TestKind::triaxial;
        request.loading.rate = RateKind::automatic;
        request.loading.confining_pressure = pressure;
        request.material = augig_granite();
        request.contact = augig_contact();
        request.contact.tensile_strength = 1000 * MPa;
        request.contact.cohesion = request.contact.open_shear_strength = 3000 * MPa;
        request.contact.friction_angle = friction_angle;
        const double e = 2.718281828459045;
        request.contact.critical_opening = e * request.contact.tensile_strength / request.contact.normal_stiffness;
        request.contact.critical_sliding = e * request.contact.cohesion / request.contact.shear_stiffness;
        request.contact.fracture_energy = request.contact.mode_ii_fracture_energy = 1e6;
        request.loading.max_strain = 1.3 * strength() / request.material.rock.young_modulus;
        request.frames = 0;
        return request;
    }
};

}  // namespace graincrack::test
