// Specimens of three phases for the solver's tests.
#pragma once

#include <utility>

#include "share/file/fabric.hpp"
#include "solver/setup/request.hpp"
#include "tests/support/augig_granite.hpp"
#include "tests/support/small_run.hpp"

namespace graincrack::test {

/// A specimen and what its phases and classes are made of.
struct PhasedSpecimen {
    Specimen specimen;
    Fabric fabric;
    [[nodiscard]] SmallRun run(LawVariant law, double fraction = 0.5) const {
        return {specimen, fabric.phases, make_contact_laws(fabric.contacts, law), PlaneCondition::strain, fraction};
    }
};

/// The same grains in three phases, in no pattern, with values that differ from phase to phase and from class to class, and a
/// strength factor on every contact.
inline PhasedSpecimen varied_phases(Specimen specimen) {
    specimen.phase_names = {"quartz", "feldspar", "mica"};
    for (std::size_t g = 0; g < specimen.n_grains(); ++g) specimen.grain_phase[g] = static_cast<std::uint8_t>(g * g % 7 % 3);
    PhasedSpecimen varied{std::move(specimen), uniform_fabric(augig_granite().rock, augig_contact(), 3)};
    for (std::size_t c = 0; c < varied.specimen.n_contacts(); ++c) {
        varied.specimen.contact_strength_factor.push_back(0.6 + 0.1 * static_cast<double>(c * 5 % 9));
    }
    for (std::size_t p = 0; p < varied.fabric.phases.size(); ++p) {
        Phase& phase = varied.fabric.phases[p];
        phase.young_modulus *= 0.5 + 0.5 * static_cast<double>(p);
        phase.poisson_ratio += 0.03 * static_cast<double>(p);
        phase.density *= 1 + 0.1 * static_cast<double>(p);
    }
    for (std::size_t k = 0; k < varied.fabric.contacts.size(); ++k) {
        ContactParameters& contact = varied.fabric.contacts[k];
        contact = scaled_contact(contact, 1 + 0.1 * static_cast<double>(k));
        const double stiffer = 1 + 0.2 * static_cast<double>(k % 3);
        contact.normal_stiffness *= stiffer;
        contact.critical_opening /= stiffer;  // e tc/kt
        contact.friction_angle -= 2 * degree * static_cast<double>(k);
    }
    return varied;
}

/// A test of Augig granite between platens that rub, which threads share however small it is.
inline SimulationRequest augig_request(TestKind test, double platen_speed, double max_strain) {
    SimulationRequest r;
    r.material = augig_granite();
    r.contact = augig_contact(PlaneCondition::strain, FractureEnergyChoice::Kind::mode_i);
    r.loading = {.test = test, .platen_speed = platen_speed, .platen_friction = 5 * degree, .max_strain = max_strain};
    r.elements_per_thread = 1;
    return r;
}

/// A material of those three phases, with contacts of a pair and factors on others.
inline Material granite_of_phases() {
    Material m = augig_granite();
    m.fabric.phases["quartz"].relative_young_modulus = 1.4;
    m.fabric.phases["feldspar"].poisson_ratio = 0.27;
    m.fabric.phases["mica"].relative_young_modulus = 0.4;
    m.fabric.phases["mica"].density = 3000;
    m.fabric.pairs["quartz-mica"].tensile_strength = 12 * MPa;
    m.fabric.pairs["quartz-mica"].cohesion = 40 * MPa;
    m.fabric.heterophase.friction_angle = 0.8;
    return m;
}

}  // namespace graincrack::test
