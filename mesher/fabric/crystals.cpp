#include "mesher/fabric/crystals.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "mesher/plane/geometry.hpp"

namespace graincrack::mesher {

std::vector<std::pair<int, int>> crystals_of_contacts(const Specimen& specimen, std::span<const int> crystal_of_grain) {
    const std::vector<std::int32_t> grain = grain_of_nodes(specimen);
    const auto crystal = [&](std::int32_t node) { return crystal_of_grain[index(grain[index(node)])]; };
    std::vector<std::pair<int, int>> crystals;
    crystals.reserve(specimen.n_contacts());
    for (const auto& nodes : specimen.contact_nodes) crystals.push_back(std::minmax({crystal(nodes[0]), crystal(nodes[2])}));
    return crystals;
}

void name_crystals(Specimen& specimen, std::span<const int> crystal_of_grain) {
    specimen.grain_crystal.assign(crystal_of_grain.begin(), crystal_of_grain.end());
    specimen.contact_flaw.resize(specimen.n_contacts(), 0);
    std::vector<std::uint8_t> number;  // class within crystals of each phase
    for (const std::string& phase : specimen.phase_names) {
        std::vector<std::string>& names = specimen.flaw_names;
        auto known = std::find(names.begin(), names.end(), within_class(phase));
        if (known == names.end()) known = names.insert(known, within_class(phase));
        number.push_back(static_cast<std::uint8_t>(known - names.begin() + 1));
    }
    const auto grain = grain_of_nodes(specimen);
    const auto crystals = crystals_of_contacts(specimen, crystal_of_grain);
    for (std::size_t c = 0; c < specimen.n_contacts(); ++c) {
        const bool is_flaw =
            specimen.contact_flaw[c] != 0 || specimen.contact_kind[c] != static_cast<std::uint8_t>(ContactKind::grain_boundary);
        if (is_flaw || crystals[c].first != crystals[c].second) continue;
        specimen.contact_kind[c] = static_cast<std::uint8_t>(ContactKind::within_crystal);
        specimen.contact_flaw[c] = number[specimen.grain_phase[index(grain[index(specimen.contact_nodes[c][0])])]];
    }
}

}  // namespace graincrack::mesher
