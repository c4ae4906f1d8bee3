// The runs of a calibration: their tests and numbers by the table [study] of a material, and their names and options.
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

/// A test at one confining pressure, with the options that all of its runs have.
struct Test {
    std::string name;               ///< name in `all_tests`
    double confining_pressure = 0;  ///< Pa
    double peak_drop = 1;           ///< relative fall below the peak that ends it; at 1 it continues to the strain limit
    [[nodiscard]] std::string label() const { return name + pressure_text(confining_pressure); }
    [[nodiscard]] Loading loading() const { return test_named(name).loading; }
    [[nodiscard]] bool has(const Target& target) const {
        return target.test() == name && target.confining_pressure == confining_pressure;
    }
};

/// The tests of targets, the longest first. Bending comes last, so that it does not change the specimens of the others. Each test
/// continues as far as any of its targets needs.
std::vector<Test> tests_of(const std::vector<Target>& targets);

/// A run that a decision needs.
struct RequestedRun {
    Test test;
    std::int64_t seed = 0;  ///< of the specimen
    Point point;
    std::optional<double> max_strain;  ///< strain limit; empty for that of the study
    std::string label;                 ///< short label for the name of its file: "d1p07"
    std::string reason;
};

/// Returns the measures of a run; null if it is not finished.
using FindRun = std::function<const Measures*(const RequestedRun&)>;

/// The specimens of a calibration. Unless they are set, or [fabric] of the material has a grain size, they are those of Kazerani
/// & Zhao 2014: rectangles of 80 mm × 160 mm with 1,122 grains, discs of 80 mm with 452, and half-discs of this diameter with
/// half as many or the laboratory's specimen for K_IC. Specimens of breakable crystals scale with the size in [fabric].
struct Specimens {
    double width = 0.08;                         ///< m
    double height = 0.16;                        ///< m
    double diameter = 0.08;                      ///< m
    std::optional<ToughnessTest> of_laboratory;  ///< the laboratory's test for K_IC, if it is known
    std::optional<double> bend_size;             ///< its diameter or height instead, m: `half_disc_diameter` of [study]
    double grains = 1122;
    double disc_grains = 452;
    std::optional<double> edge;        ///< mean edge of the grains instead of their numbers, m
    std::optional<double> grain_size;  ///< mean equal-area diameter of the grains instead of both, m
    /// Mean edge, m: the one set, or that of equilateral grains of this diameter, or of grains that fill a rectangle.
    [[nodiscard]] double mean_edge() const;
    [[nodiscard]] ToughnessTest bend() const;  ///< test for K_IC; if unknown, a half-disc of the diameter of the discs
    [[nodiscard]] double bend_grains() const;  ///< number of grains of the size in the discs
};

/// The settings of a calibration. All numbers are set before it begins.
struct Study {
    Specimens specimens;
    double max_strain = 0.015;                           ///< strain limit of compression tests
    double rate_tolerance = 0.006;                       ///< rate tolerance of compression tests
    double confining_pressure = 8e6;                     ///< Pa, of the fitted first peak, without [targets]
    std::vector<double> predicted_pressures{4e6, 20e6};  ///< Pa, without [targets]
    std::size_t elastic = 2;                             ///< specimens for E and ν of the grains
    std::size_t points = 0;                              ///< points of a design; 0 for 4 (p + 2) with p parameters
    std::size_t discs = 3;                               ///< discs at a point; other tests have one specimen
    std::size_t moves = 2;                               ///< most moves of a box whose optimum lies at an edge
    std::size_t corrections = 3;                         ///< most corrections of a rock type's surfaces; of a design one
    std::size_t zooms = 1;                               ///< further designs, each half as wide as the one before
    std::size_t confirmation_discs = 20;                 ///< most discs of a confirmation
    std::size_t confirmation_rectangles = 20;            ///< most specimens of every other test
    std::size_t predicted = 3;                           ///< specimens of a test that only predictions need
    double first_peak_fraction = 0.5;                    ///< least fraction of tests with a first peak that a target requires
    /// Specimens of a test at each point of a design, and most specimens of a confirmation.
    [[nodiscard]] std::size_t specimens_at_point(const Test& test) const {
        return test.loading() == Loading::splitting ? discs : 1;
    }
    [[nodiscard]] std::size_t most_specimens(const Test& test) const {
        return test.loading() == Loading::splitting ? confirmation_discs : confirmation_rectangles;
    }
};

/// Reads [study]; without this table, returns the defaults. \param settings values of keys that replace those of the file
/// \throws InputError that names file, line and key of an unknown key or a value out of bounds; UsageError for a wrong setting
Study read_study(const Material& rock, const TomlFile& file, const std::vector<std::string>& settings = {});

/// A run as a row of wanted.tsv, with options of graincrack-mesh, `graincrack-post material with` and graincrack-solve as typed.
struct RunRow {
    std::string file;
    std::string specimen;
    std::string mesh;
    std::string material;
    std::string solve;
};
/// Returns the row of a run. The name of the file has test, specimen and label, and eight digits that change with the options and
/// the material, so that the name identifies the run.
RunRow row_of(const Material& rock, const Study& study, const RequestedRun& run);

}  // namespace graincrack::calibrate
