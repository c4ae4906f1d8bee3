// The files of a calibration in one folder: what `decide` is given, and what it leaves.
//
//     material.toml    the rock with its targets; may be elsewhere                      given
//     strength.tsv     `strength` of the finished runs; absent: none are finished       given
//     moduli.tsv       `moduli` of those of rectangles under compression                given
//     toughness.tsv    `toughness` of those of half-discs                               given
//     wanted.tsv       the next runs with their reasons                                 written while runs are missing
//     calibrated.toml  the material with the values found, and [fitted]                 written if calibrated
//     nearest.toml     the same for the nearest point                                   written if it ends otherwise
//     report.md        targets, results, values with intervals, every step              written in the end
//     outcome.json     state, values, predictions, caveats and files, for programs          written last at every call
//     identify.tsv     d ln response / d ln parameter                                   written in the end
//     draws.tsv        values and properties drawn from what the data leave open        written in the end, of a known kind
#pragma once

#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "post/calibrate/decide.hpp"
#include "post/calibrate/report.hpp"
#include "post/calibrate/study.hpp"

namespace graincrack::calibrate {

/// Numbers of finished runs, by the name of their file without its folder.
using FinishedRuns = std::map<std::string, Measures>;

/// From the tables `strength` and, if they are there, `moduli` and `toughness` of a folder. \throws InputError for a table
/// without files
FinishedRuns read_finished(const std::string& folder);

/// The input that a material gives: [targets], [parameters], [study] and [laboratory]. \param settings as of `read_study`
/// \throws InputError, UsageError
Problem read_problem(const Material& rock, const std::vector<std::string>& settings = {});

struct FolderDecision {
    Decision decision;
    /// s of what is requested, run after run, by the clock of finished runs of the same tests; 0 if one has none.
    double requested_time = 0;
};

/// Decides, and writes what follows to the folder; removes what was written before and holds no longer.
/// \param material file; empty: material.toml of the folder \param settings as of `read_study`
/// \param diagnostics for notes on the values of the material
/// \throws InputError, OutputError, UsageError
FolderDecision calibrate_folder(const std::string& folder, const std::string& material = "",
                                const std::vector<std::string>& settings = {}, std::ostream& diagnostics = std::cerr);

}  // namespace graincrack::calibrate
