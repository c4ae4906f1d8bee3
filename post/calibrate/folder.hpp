// Reads and writes the files of a calibration in one folder:
//
//     material.toml    the rock with its targets; may be elsewhere                      input
//     strength.tsv     table `strength` of the finished runs; absent if there are none  input
//     moduli.tsv       table `moduli` of compressed rectangles                          input
//     toughness.tsv    table `toughness` of half-discs                                  input
//     wanted.tsv       the next runs with their reasons                                 written while runs are missing
//     calibrated.toml  the material with the calibrated values, and [fitted]            written if calibrated
//     nearest.toml     the same for the nearest point                                   written if it ends otherwise
//     report.md        targets, results, values with intervals, all steps               written at the end
//     outcome.json     state, values, predictions, caveats and files, for programs      written last at every call
//     identify.tsv     d ln response / d ln parameter                                   written at the end
//     draws.tsv        posterior samples of values and properties                       written at the end, for a known rock type
#pragma once

#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "post/calibrate/decide.hpp"
#include "post/calibrate/report.hpp"
#include "post/calibrate/study.hpp"

namespace graincrack::calibrate {

/// Measures of finished runs by the names of their files without folders.
using FinishedRuns = std::map<std::string, Measures>;

/// Reads the tables `strength`, `moduli` and `toughness` that a folder has. \throws InputError for a table without files
FinishedRuns read_finished(const std::string& folder);

/// Reads [targets], [parameters], [study] and [laboratory] of a material. \param settings as for `read_study`
/// \throws InputError for a wrong file, UsageError for a wrong setting
Problem read_problem(const Material& rock, const std::vector<std::string>& settings = {});

struct FolderDecision {
    Decision decision;
    /// Estimated time of the requested runs one after another, s, by finished runs of the same tests; 0 if a test has none.
    double requested_time = 0;
};

/// Takes the decisions and writes their files to the folder; removes earlier files that are no longer valid.
/// \param material file; material.toml of the folder if empty \param settings as for `read_study`
/// \param diagnostics for notes on the values of the material
/// \throws InputError for a wrong file, OutputError for one that cannot be written, UsageError for a wrong setting
FolderDecision calibrate_folder(const std::string& folder, const std::string& material = "",
                                const std::vector<std::string>& settings = {}, std::ostream& diagnostics = std::cerr);

}  // namespace graincrack::calibrate
