#include "solver/setup/test_boundary.hpp"

#include <array>
#include <cmath>

namespace graincrack {

Boundary make_test_boundary(const Assemblage& a, const Specimen& s, const LoadingRequest& request,
                            const ContactParameters& contact) {
    const bool pulls = request.test == TestKind::tension;
    std::array<Platen, 2> platens;
    for (std::size_t p = 0; p < 2; ++p) {
        platens[p].side = p == top_platen ? 1 : -1;
        platens[p].position = platens[p].side * s.height / 2;
        platens[p].normal_stiffness = contact.normal_stiffness;
        platens[p].shear_stiffness = pulls ? 0 : contact.shear_stiffness;
        platens[p].tan_friction = std::tan(request.platen_friction);
        platens[p].bonded = pulls;
    }
    // A platen can be met by whatever its own approach and a loose grain's turn can bring to it.
    const double reach = 2 * s.statistics.mean_edge + request.max_strain * s.height;
    std::vector<std::uint8_t> membrane;
    if (request.confining_pressure > 0) {
        membrane = {static_cast<std::uint8_t>(BoundaryPart::left), static_cast<std::uint8_t>(BoundaryPart::right)};
    }
    return make_boundary(a, s, platens, reach, membrane);
}

}  // namespace graincrack
