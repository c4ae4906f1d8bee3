// The table of contact laws: options, files, dispatch and tests take the list of laws from here.
//
// A law is a type with static pure functions; share/doc/laws.md tells how to add one:
//
// - `description`: its row of the table
// - `min_energies(law)`: the least Gf (G_I) and G_II with which the law works; 0 where it has none
// - `complete(law)`: sets the constants that are its own; `stiffest_shear` in any case, `softens_in_shear` if it does
// - `advance(law, to, r)`: a point moves to a motion on its side of δn = 0: sets r.traction, brings r.history up to date, adds to
//   r.dissipation
// - `close(law, r)`: an open point has arrived at δn = 0 (as r.history.motion says) and is about to be closed
// - `stored_energy(law, history)`: recoverable energy per area, a function of state
// - `damage(law, history)`: 0 to 1
// - `remaining_cohesion(law, history)`, if it is not 1 − `damage`: fraction of its peak that the cohesion of a failed point can
// bear
// - `intact(law, point)`: the response of a point that has not failed, without a branch
// - `is_residual(law, history)`: true if friction while closed is all that is left, as in `residual_response`; a law may always
//   answer false
// - `softening(law, point)`, if the law has it: the response of a point past its peak, with cohesion left, without a branch;
//   with it `remembers_largest`: true if it changes the largest motions; `bridged_softening`, if it may have bridges, the same
//   with its bridge
// - `damages_intact`: true if `intact` changes the integrity or dissipates fracture energy
#pragma once

#include <array>
#include <cstddef>

#include "solver/law/cohesive_frictional.hpp"
#include "solver/law/combined.hpp"
#include "solver/law/consistent.hpp"
#include "solver/law/coulomb_slip.hpp"
#include "solver/law/literal.hpp"

namespace graincrack {
namespace contact_law {

template <class... Laws>
struct Table {
    static constexpr std::array<LawDescription, sizeof...(Laws)> descriptions{Laws::description...};
};
using AllLaws = Table<Literal, Consistent, CoulombSlip, Combined, CohesiveFrictional>;

template <class First, class... Rest, class Action>
constexpr auto with_law(Table<First, Rest...> /*table*/, LawVariant variant, const Action& action) {
    if constexpr (sizeof...(Rest) == 0) {
        return action(First{});
    } else {
        return variant == First::description.variant ? action(First{}) : with_law(Table<Rest...>{}, variant, action);
    }
}
/// Calls `action` with an object of the law's type.
template <class Action>
constexpr auto with_law(LawVariant variant, const Action& action) {
    return with_law(AllLaws{}, variant, action);
}

constexpr bool is_in_order(const auto& descriptions) {
    for (std::size_t i = 0; i < descriptions.size(); ++i) {
        if (static_cast<std::size_t>(descriptions[i].variant) != i) return false;
    }
    return true;
}
static_assert(is_in_order(AllLaws::descriptions), "the table lists the laws in the order of LawVariant");

}  // namespace contact_law

/// Every law there is, in the order of `LawVariant`.
constexpr const auto& all_contact_laws() { return contact_law::AllLaws::descriptions; }
constexpr const LawDescription& description_of(LawVariant variant) {
    return all_contact_laws()[static_cast<std::size_t>(variant)];
}
/// Name of a law as options and files spell it.
constexpr std::string_view name_of(LawVariant variant) { return description_of(variant).name; }

}  // namespace graincrack
