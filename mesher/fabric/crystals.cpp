#include "mesher/fabric/crystals.hpp"

#include <algorithm>

namespace graincrack::mesher {

void name_crystals(Specimen& specimen, std::span<const int> crystal_of_grain) {
    specimen.grain_crystal.assign(crystal_of_grain.begin(), crystal_of_grain.end());
    specimen.contact_flaw.assign(specimen.n_contacts(), 0);
    specimen.flaw_names.clear();
    for (const std::string& phase : specimen.phase_names) specimen.flaw_names.push_back(within_class(phase));
    const auto grain = grain_of_nodes(specimen);
    for (std::size_t c = 0; c < specimen.n_contacts(); ++c) {
        const auto a = static_cast<std::size_t>(grain[static_cast<std::size_t>(specimen.contact_nodes[c][0])]);
        const auto b = static_cast<std::size_t>(grain[static_cast<std::size_t>(specimen.contact_nodes[c][2])]);
        if (crystal_of_grain[a] != crystal_of_grain[b]) continue;
        specimen.contact_kind[c] = static_cast<std::uint8_t>(ContactKind::within_crystal);
        specimen.contact_flaw[c] = static_cast<std::uint8_t>(specimen.grain_phase[a] + 1);
    }
}

}  // namespace graincrack::mesher
