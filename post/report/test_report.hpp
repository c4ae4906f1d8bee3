// The data of one run that a report uses, read in a single pass over its file.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "post/cracks/crack_counts.hpp"
#include "post/cracks/crack_summary.hpp"
#include "post/measure/caveat.hpp"
#include "post/measure/moduli.hpp"
#include "post/measure/strength.hpp"
#include "post/measure/thresholds.hpp"
#include "post/run/load_curve.hpp"

namespace graincrack {

/// Contacts (points ÷ 2) failed by the end, by branch of the law and by mode angle.
struct FailureBranches {
    double open = 0;        ///< failed while open (mode tensile)
    double closed = 0;      ///< failed while closed (mode shear)
    double by_tension = 0;  ///< mode angle below 45°: |τ| < σn
    double by_shear = 0;    ///< mode angle from 45° to 90°, still under tension
    double compressed = 0;  ///< mode angle above 90°
    double separated = 0;
};
FailureBranches count_branches(const std::vector<Crack>& log);

/// The provenance that a file records, as names and values.
using ProvenanceEntries = std::vector<std::pair<std::string, std::string>>;

struct TestReport {
    RunData data;
    LoadCurve curve;
    Strength strength;
    std::optional<Moduli> moduli;
    fpz::AssemblageModuli predicted;
    GrainModuli grains;
    std::vector<std::string> class_names;     ///< of the contacts, in the order of `RunHeader::fabric`
    std::optional<AllThresholds> thresholds;  ///< of compression tests
    std::optional<double> mode_i_toughness;   ///< Pa √m, of half-discs with a slit that have a peak
    std::vector<Caveat> caveats;              ///< caveats of the strength
    CrackBalance at_peak;                     ///< by the event of the run
    CrackBalance at_end;
    ModeCounts by_sign_at_peak;  ///< by the event of the run and the sign of the opening then
    FailureBranches branches;
    ModeCounts broken;                        ///< by the end, by the sign of the opening then
    std::vector<SensitivityRow> sensitivity;  ///< empty unless the run was made with --sensitivity
    double contact_zone_length = 0;           ///< m
    ProvenanceEntries provenance;
    std::vector<std::string> command_line;  ///< words

    /// \param stress what gives a stress of `AllThresholds` \return empty of a test without them
    template <class Stress>
    [[nodiscard]] std::optional<double> threshold(const Stress& stress) const {
        return thresholds ? std::invoke(stress, *thresholds) : std::nullopt;
    }
};

/// Evaluates a run for the report. \throws InputError if it cannot be read or evaluated
TestReport read_test_report(const RunReader& run);

}  // namespace graincrack
