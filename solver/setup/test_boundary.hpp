// Platens and membrane of the standard tests.
#pragma once

#include "share/specimen.hpp"
#include "solver/model/boundary.hpp"
#include "solver/setup/request.hpp"

namespace graincrack {

/// Platens and membrane of a test. Platens have the contacts' stiffness per area; the caps of a tension test are glued on
/// and smooth, so that they do not hinder the lateral contraction.
Boundary make_test_boundary(const Assemblage& assemblage, const Specimen& specimen, const LoadingRequest& request,
                            const ContactParameters& contact);

}  // namespace graincrack
