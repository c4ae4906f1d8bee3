// What a report says of specimens with several phases: what they consist of, and which of their contacts cracked.
#pragma once

#include <optional>
#include <string>

#include "post/cracks/class_counts.hpp"
#include "post/measure/moduli.hpp"
#include "post/report/html.hpp"
#include "share/rock/material.hpp"

namespace graincrack {

class Minerals {
public:
    /// Adds what a specimen consists of. \param kind what it is called \param material for the fractions that were asked for
    void add_phases(const std::string& kind, const Specimen& specimen, const RunHeader& header,
                    const std::optional<Material>& material);
    /// Adds contacts and cracks of a run. \param kind of the test
    void add_classes(const std::string& kind, const RunClasses& run);
    /// Both tables; empty if no specimen has several phases.
    [[nodiscard]] std::string str() const;

private:
    html::Table phases_{{"specimen", "phase", "asked for, % of area", "reached, %", "grains", "E, GPa", "ν", "density, kg/m³"}};
    html::Table classes_{
        {"test", "contacts", "number", "% of length", "tensile cracks at peak", "shear", "tensile at end", "shear"}};
};

/// "61.61 to 65.55": the bounds of E of the grains alone, GPa; one number where they agree.
std::string bounds_of(const GrainModuli& grains);

}  // namespace graincrack
