#include "mesher/fabric/fabric.hpp"

#include "mesher/fabric/crystals.hpp"

namespace graincrack::mesher {

void give_fabric(Specimen& specimen, std::span<const int> crystal_of_grain, const Fabric& fabric, std::uint64_t seed, double turn,
                 bool can_break) {
    specimen.seed = seed;
    assign_phases(specimen, crystal_of_grain, fabric.phases);
    assign_strength_factors(specimen, crystal_of_grain, turn, fabric.strength);
    open_boundaries(specimen, crystal_of_grain, fabric.open);
    if (can_break) name_crystals(specimen, crystal_of_grain);
}

}  // namespace graincrack::mesher
