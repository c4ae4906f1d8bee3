// Mohr circles of a set of tests with the envelopes fitted to them.
#pragma once

#include <string>

#include "post/envelope.hpp"
#include "post/picture/drawing.hpp"

namespace graincrack {

/// Half circles of all tests, a colour a confining pressure; tension by its circle from −σt to 0, brazilian by that of the
/// disc's centre, from −σt to 3σt. Mohr–Coulomb as a line, Hoek–Brown (compression only) as a dashed curve.
Drawing draw_envelope(const EnvelopeTests& tests, const std::string& title);

}  // namespace graincrack
