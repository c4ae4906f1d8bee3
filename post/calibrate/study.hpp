// Runs of a calibration: how many there are of which kind, by the table [study] of a material, their names and options.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "post/calibrate/parameter.hpp"
#include "post/calibrate/target.hpp"
#include "share/base/toml_file.hpp"

namespace graincrack::calibrate {

/// A test under one confining pressure: all of its runs have these options.
struct Test {
    std::string name;  ///< of `all_tests`
    double confining_pressure = 0;
    double peak_drop = 1;  ///< fall below the peak that ends it; 1: it continues to the strain limit
    [[nodiscard]] std::string label() const { return name + pressure_text(confining_pressure); }
    [[nodiscard]] Loading loading() const { return test_named(name).loading; }
    [[nodiscard]] bool has(const Target& target) const {
        return target.test() == name && target.confining_pressure == confining_pressure;
    }
};

/// The tests of targets, the longest first but for bending, which is the last so that the others keep their specimens with it;
/// each goes on as far as the target that needs most.
std::vector<Test> tests_of(const std::vector<Target>& targets);

/// A run that a decision needs.
struct RequestedRun {
    Test test;
    std::int64_t seed = 0;  ///< of the specimen
    Point point;
    std::optional<double> max_strain;  ///< empty: that of the study
    std::string label;                 ///< short, for its name: "d1p07"
    std::string reason;
};

/// The numbers of a finished run; null if it is not finished.
using FindRun = std::function<const Measures*(const RequestedRun&)>;

/// The paper's specimens, unless set or the material's [fabric] has a grain size: rectangles of 80 mm × 160 mm with 1,122 grains,
/// discs of 80 mm with 452, half-discs of the same diameter with half of them, or the laboratory's specimen of K_IC. Crystals
/// that break, of a size that [fabric] gives, have specimens in proportion to it.
struct Specimens {
    double width = 0.08;   ///< m
    double height = 0.16;  ///< m
    double diameter = 0.08;
    std::optional<ToughnessTest> of_laboratory;  ///< on which K_IC is tested; empty if the laboratory's is not known
    std::optional<double> bend_size;             ///< m: the same at another diameter or height, `half_disc_diameter` of [study]
    double grains = 1122;
    double disc_grains = 452;
    std::optional<double> edge;        ///< m: mean edge of the grains, instead of their numbers
    std::optional<double> grain_size;  ///< m: mean equal-area diameter of the grains, instead of both
    /// Mean edge, m: as it is set, or that of equilateral grains of that diameter, or of those that fill a rectangle.
    [[nodiscard]] double mean_edge() const;
    [[nodiscard]] ToughnessTest bend() const;  ///< of K_IC; unless known, a half-disc of the diameter of the discs
    [[nodiscard]] double bend_grains() const;  ///< as large as those of the discs
};

/// How a calibration is done. All numbers are set before it begins.
struct Study {
    Specimens specimens;
    double max_strain = 0.015;                           ///< strain limit of compression tests
    double rate_tolerance = 0.006;                       ///< of compression tests
    double confining_pressure = 8e6;                     ///< Pa, without [targets]: at which friction is fitted
    std::vector<double> predicted_pressures{4e6, 20e6};  ///< Pa, without [targets]
    std::size_t elastic = 2;                             ///< specimens for E and ν of the grains
    std::size_t points = 0;                              ///< of a design; 0: 4 (p + 2) for p parameters
    std::size_t discs = 3;                               ///< at a point; one of every other test
    std::size_t moves = 2;                               ///< of a box whose optimum lies at an edge, at most
    std::size_t corrections = 3;                         ///< of the surfaces of a kind by new specimens, at most; of a design one
    std::size_t zooms = 1;                               ///< designs of half the width of the one before
    std::size_t confirmation_discs = 20;                 ///< at most
    std::size_t confirmation_rectangles = 20;            ///< of every other test, at most
    std::size_t predicted = 3;                           ///< specimens of a test that only predictions need
    double first_peak_fraction = 0.5;                    ///< of tests that shall have a first peak, at least
    /// Specimens of a test at each point of a design, and at most of a confirmation.
    [[nodiscard]] std::size_t specimens_at_point(const Test& test) const {
        return test.loading() == Loading::splitting ? discs : 1;
    }
    [[nodiscard]] std::size_t most_specimens(const Test& test) const {
        return test.loading() == Loading::splitting ? confirmation_discs : confirmation_rectangles;
    }
};

/// Reads [study]; without one, the defaults. \param settings values of keys instead of those of the file
/// \throws InputError naming file, line and key for one that is unknown or out of bounds, UsageError for a setting
Study read_study(const Material& rock, const TomlFile& file, const std::vector<std::string>& settings = {});

/// A run as a row of requested.tsv: the options of graincrack-mesh, of `graincrack-post material with` and of graincrack-solve as
/// they would be typed.
struct RunRow {
    std::string file;
    std::string specimen;
    std::string mesh;
    std::string material;
    std::string solve;
};
/// The file has test, specimen and label of the run, and eight digits that change with its options and with what the rock is made
/// of, so that a run is known by its name.
RunRow row_of(const Material& rock, const Study& study, const RequestedRun& run);

}  // namespace graincrack::calibrate
