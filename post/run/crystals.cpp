#include "post/run/crystals.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace graincrack {

std::size_t crystal_of(const Specimen& specimen, std::size_t grain) {
    return specimen.grain_crystal.empty() ? grain : static_cast<std::size_t>(specimen.grain_crystal[grain]);
}

std::size_t n_crystals(const Specimen& specimen) {
    if (specimen.grain_crystal.empty()) return specimen.n_grains();
    return static_cast<std::size_t>(*std::max_element(specimen.grain_crystal.begin(), specimen.grain_crystal.end())) + 1;
}

std::vector<std::array<std::size_t, 2>> grains_of_contacts(const Specimen& specimen) {
    const std::vector<std::int32_t> grain = grain_of_nodes(specimen);
    std::vector<std::array<std::size_t, 2>> grains;
    for (const auto& [a1, a2, b1, b2] : specimen.contact_nodes) {
        grains.push_back({static_cast<std::size_t>(grain[static_cast<std::size_t>(a1)]),
                          static_cast<std::size_t>(grain[static_cast<std::size_t>(b1)])});
    }
    return grains;
}

bool is_within_crystal(const Specimen& specimen, std::size_t contact) {
    return specimen.contact_kind[contact] == static_cast<std::uint8_t>(ContactKind::within_crystal);
}

std::string grains_label(const Specimen& specimen) {
    if (specimen.grain_crystal.empty()) return fmt::format("{} grains", specimen.n_grains());
    return fmt::format("{} crystals of {} grains", n_crystals(specimen), specimen.n_grains());
}

}  // namespace graincrack
