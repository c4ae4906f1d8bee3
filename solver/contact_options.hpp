// The options of graincrack-solve that make the contacts: material, law and parameters.
#pragma once

#include <optional>
#include <string>

#include "share/options/option_set.hpp"
#include "solver/setup/request.hpp"

namespace graincrack {

/// Values that end in a request only together with the material.
struct ContactOptions {
    std::string material;
    std::string plane;                                    ///< "strain", "stress" or empty: strain, but stress for brazilian
    std::string law;                                      ///< "": the material's, else that of a request
    GivenContact given;                                   ///< in place of the material's; its fracture energy is the next
    std::optional<FractureEnergyChoice> fracture_energy;  ///< --fracture-energy
};

void add_contact_options(OptionSet command, ContactOptions& options);

/// Reads the material and sets material, contact, plane and law of a request whose test is known.
/// \throws InputError; UsageError for a parameter that the law does not use or that does not fit it
void apply_contact_options(const ContactOptions& options, SimulationRequest& request);

}  // namespace graincrack
