// The update of the pair list between two steps: which contacts are released, which pairs are listed and watched.
#pragma once

#include <cstdint>

#include "solver/model/assemblage.hpp"
#include "solver/model/contact_pairs.hpp"
#include "solver/model/state.hpp"
#include "solver/model/step_parameters.hpp"

namespace graincrack {

/// What follows from an update of the pair list.
struct PairListUpdate {
    /// With mass scaling: a node–edge contact begins or a contact is to be released. Mass scaling has to end, and the list is to
    /// be updated again without it.
    bool must_end_mass_scaling = false;
    std::int64_t integrations_to_next = 0;  ///< steps, or substeps, to the next update; of no use if mass scaling must end
};

/// Updates the list between two steps: finds points that have debonded, releases contacts that have moved far, searches anew
/// where that or the travel of the nodes since the last search makes it necessary, and chooses the watched pairs. Serial; the
/// result depends on the state only.
///
/// With mass scaling there are no node–edge contacts: it changes nothing but the list.
/// \param shortest least number of integrations to the next update
PairListUpdate update_pair_list(const Assemblage& assemblage, const StepParameters& parameters, std::int64_t shortest,
                                State& state);

}  // namespace graincrack
