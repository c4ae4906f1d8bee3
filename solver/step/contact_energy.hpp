// Energy that contacts store.
#pragma once

#include "solver/model/state.hpp"

namespace graincrack {

/// Stored in contacts and in node–edge contacts, J.
double stored_in_contacts(const Assemblage& assemblage, const ContactLaws& laws, const State& state);

}  // namespace graincrack
