// The laboratory tests, a row each: what they are called, which shapes they load, and how. The solver's options and programs, the
// validation of specimens, calibrations, tables, plots and reports take it from there.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "share/rock/fracture_process_zone.hpp"

namespace graincrack {

enum class TestKind : std::uint8_t { uniaxial, triaxial, brazilian, tension, bend, program };

/// How a test loads a specimen: its program, the sense of its stress and what that is follow from this.
enum class Loading : std::uint8_t {
    compression,  ///< axial stress between platens on the faces bottom and top
    tension,      ///< the same between bonded platens that move apart
    splitting,    ///< a diameter between platens: 2F/(π t D)
    bending,      ///< three rollers
    program       ///< as a file says
};

struct TestDescription {
    TestKind kind;
    std::string_view name;   ///< command of graincrack-solve, attribute of run files
    std::string_view help;   ///< of that command
    std::string_view title;  ///< "Uniaxial compression"
    std::string_view label;  ///< in tables: "Brazilian", "direct tension"
    Loading loading;
    std::vector<std::string_view> shapes = {};      ///< that it loads; none: any with the faces bottom and top
    PlaneCondition plane = PlaneCondition::strain;  ///< default
    bool is_confined = false;                       ///< has a confining pressure on the lateral edges
    /// Fraction of the most steps that it takes at the automatic rate, which is fast until contacts fail.
    double usual_fraction = 0;
    /// Bound of the measures of equilibrium at the automatic rate (`AutomaticRate`). What a few tensile cracks end needs slower
    /// loading than compression; most of all direct tension, where the load falls before the platens are slower.
    double rate_tolerance = 3e-3;

    [[nodiscard]] bool is_tensile() const {
        return loading == Loading::tension || loading == Loading::splitting || loading == Loading::bending;
    }
};

/// The rows, in the order of `TestKind`.
const std::vector<TestDescription>& all_tests();
const TestDescription& description_of(TestKind kind);
/// The row of a name of run files; of an unknown one that of `program`.
const TestDescription& test_named(std::string_view name);
inline std::string_view name_of(TestKind kind) { return description_of(kind).name; }

}  // namespace graincrack
