// The files of a calibration in one folder: what `decide` is given, and what it leaves.
//
//     material.toml    the rock with [laboratory] targets and [study]; may be elsewhere given
//     strength.tsv     `strength` of the finished runs; absent: none are finished      given
//     moduli.tsv       `moduli` of the uniaxial ones                                    given
//     toughness.tsv    `toughness` of those with a notch                                given
//     wanted.tsv       the next runs with their reasons                                 written while runs are missing
//     calibrated.toml  the material with the values found, and [fitted]                 written if calibrated
//     nearest.toml     the same for the nearest point                                 written if it ends otherwise
//     report.md        targets, results, values with intervals, every step              written in the end
#pragma once

#include <iostream>
#include <string>
#include <vector>

#include "post/calibrate/decide.hpp"

namespace graincrack::calibrate {

/// Reads [study] of a material file; without one, the defaults. \param settings values of keys instead of those of the file
/// \throws InputError naming file, line and key for one that is unknown or out of bounds, UsageError for a setting
Study read_study(const Material& rock, const std::vector<std::string>& settings = {});

/// Finished runs from the table `strength` and, joined by the column `file`, those of `moduli` and `toughness` in the same
/// folder. Tests of other kinds than those of a calibration are passed over. \throws InputError for a missing column or table
std::vector<FinishedRun> read_finished(const std::string& folder);

/// wanted.tsv, a row a run: its file, its specimen, the options of graincrack-mesh, of `graincrack-post material with` and of
/// graincrack-solve as they would be typed, and the reason.
std::string wanted_table(const Study& study, const std::vector<WantedRun>& wanted);

/// A material file with the values of a point. \param what what it is, behind the name of the rock \param fitted for [fitted]
std::string material_text(const Material& rock, const Point& point, const char* what, const Decision& fitted);

/// The report, in Markdown.
std::string report_text(const Material& rock, const Study& study, const Decision& decision, std::size_t n_runs);

/// Decides, and writes what follows to the folder; removes what was written before and holds no longer.
/// \param material file; empty: material.toml of the folder \param settings as of `read_study`
/// \param diagnostics for notes on the values of the material
/// \throws InputError, OutputError, UsageError
Decision calibrate_folder(const std::string& folder, const std::string& material = "",
                          const std::vector<std::string>& settings = {}, std::ostream& diagnostics = std::cerr);

}  // namespace graincrack::calibrate
