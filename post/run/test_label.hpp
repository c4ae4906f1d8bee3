// Labels of tests and states in titles and tables.
#pragma once

#include <cstddef>
#include <string>

#include "post/run/load_curve.hpp"

namespace graincrack {

/// "Uniaxial compression, Augig granite"; triaxial names its confinement.
std::string test_title(const RunSettings& header);

/// "uniaxial", "Brazilian", "σ3 = 4 MPa", "direct tension", "bending"; with a shape "Brazilian, ring".
std::string series_label(const std::string& test, double confining_pressure, const std::string& shape = "");
/// The shape by which the strengths of a run are told apart from others of its test: "ring", "disc with a hole" or "cracked
/// disc" of a Brazilian test, "beam", "notched beam" or "half-disc" of bending; else "".
std::string distinct_shape(const RunData& run);
inline std::string series_label(const RunData& run) {
    return series_label(run.header.test, run.header.confining_pressure, distinct_shape(run));
}

/// Contacts as a whole number: one of whose two points only one has failed counts as one.
std::string whole_contacts(double contacts);

/// "1 fragment", "2 fragments". \param what in the singular
std::string counted(std::size_t n, const std::string& what);

}  // namespace graincrack
