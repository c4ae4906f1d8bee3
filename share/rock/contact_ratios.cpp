#include "share/rock/contact_ratios.hpp"

namespace graincrack {

std::vector<TomlKey> ratio_keys(ContactRatios& ratios) {
    const auto key = [](const char* name, std::optional<double>& to, const char* meaning) {
        return TomlKey{name, {name, Dimension::one, 0, 1e6, meaning, true}, [&to](double value) { to = value; }};
    };
    return {
        key("tensile_strength", ratios.tensile_strength, "tensile strength of a contact over that of the rock"),
        key("cohesion", ratios.cohesion, "cohesion of a contact over its tensile strength"),
        key("process_zone", ratios.fracture_energy, "E G_I/tc^2 of a contact over the grain size"),
        key("mode_ii_fracture_energy", ratios.mode_ii_fracture_energy, "G_II of a contact over its G_I"),
        key("open_shear_strength", ratios.open_shear_strength, "shear strength of an open contact over its tensile strength")};
}

GivenContact with_ratios(GivenContact given, const ContactRatios& ratios, const Rock& rock, std::optional<double> grain_size,
                         PlaneCondition plane) {
    const auto follow = [&](std::optional<double> GivenContact::*key, const std::optional<double>& from) {
        if (!(given.*key) && ratios.*key && from) given.*key = *(ratios.*key) * *from;
    };
    follow(&GivenContact::tensile_strength, rock.tensile_strength);
    const std::optional<double>& tc = given.tensile_strength;
    follow(&GivenContact::cohesion, tc);
    follow(&GivenContact::open_shear_strength, tc);
    if (tc && grain_size) follow(&GivenContact::fracture_energy, *grain_size * *tc * *tc / rock.young_modulus);
    follow(&GivenContact::mode_ii_fracture_energy, given.fracture_energy.value_or(fpz::mode_i_fracture_energy(rock, plane)));
    return given;
}

}  // namespace graincrack
