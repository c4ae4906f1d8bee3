// What a specimen must be to be run.
#pragma once

#include <string>

#include "share/file/specimen.hpp"

namespace graincrack {

/// Checks that the arrays fit each other and the conventions of the schema: lengths, index ranges, counter-clockwise
/// elements of positive area that do not share sides in the same sense, elements of a grain contiguous and ascending, each node
/// of one grain, contacts conforming (a1 on b1, a2 on b2 within 1e-9 of the specimen's size) with grain(a) < grain(b), their
/// edges and those of the boundary outer sides of grains in the right sense and each there once, every grain with a contact (in
/// a specimen that has contacts), known shapes, kinds and parts; size, areas and mean edge within 1 % of those declared, and
/// the middle within 0.1 % of the size at the origin.
/// Takes time in proportion to the size.
/// \throws InputError naming `where` and the first violation.
void validate(const Specimen& specimen, const std::string& where);

}  // namespace graincrack
