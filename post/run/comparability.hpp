// Comparability of runs: their mean, fit or common row of a table has a meaning only if all settings that determine results
// agree. Seeds, frames, threads, ranks and machines do not count.
#pragma once

#include <cstddef>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include "post/run/load_curve.hpp"
#include "share/file/settings.hpp"

namespace graincrack {

using SettingGroups = std::set<SettingGroup>;

/// The settings in which different tests of one rock, or tests at different pressures, may differ.
inline const SettingGroups of_the_test{SettingGroup::test,    SettingGroup::pressure, SettingGroup::plane,
                                       SettingGroup::shape,   SettingGroup::size,     SettingGroup::cuts,
                                       SettingGroup::loading, SettingGroup::rate,     SettingGroup::end};

/// A setting, or a measure of a specimen, that influences the result of a run.
struct ComparedSetting {
    Setting setting;             ///< with its name in reports, "grain diameter"
    double tolerance = 1e-9;     ///< largest relative difference of equal numbers; random measures differ from seed to seed
    double slack = 0;            ///< largest absolute difference in SI; the larger of both counts
    bool follows_plane = false;  ///< true if only runs of one plane condition compare it
    std::string follows = {};    ///< name of another setting; this one is reported only where that one agrees
};
using ComparedSettings = std::vector<ComparedSetting>;

/// Law, rock, contacts and phases, in the order of reports.
ComparedSettings compared_material(const MaterialSettings& material);
/// All compared settings of a run and its specimen that the file of the run has.
ComparedSettings compared_settings(const RunData& run);

/// The settings in which two runs differ, with both values: "material (Granite, Gabbro), diameter (30 mm, 60 mm)"; "" if they
/// agree. Of materials with different names only the names are given. \param except groups that may differ
std::string differences(const ComparedSettings& a, const ComparedSettings& b, const SettingGroups& except = {});
std::string differences(const RunData& a, const RunData& b, const SettingGroups& except = {});

/// Pointers to runs, which must not move meanwhile.
using RunList = std::vector<const RunData*>;
RunList list_of(const std::vector<RunData>& runs);

/// Runs of which any two are comparable.
struct ComparableGroup {
    std::vector<std::size_t> runs;  ///< ascending indices
    std::string distinction;        ///< of its first run from those of other groups, as `distinctions` gives it
};
/// Divides runs into groups in the order of tables: Brazilian, tension, compression by rising pressure; within a test by rising
/// size of the grains. Runs join groups by rising size of grains and of specimen, so that the groups do not depend on the order
/// of the runs. The cost grows with the square of their number. \param except groups that may differ \param untold groups that
/// distinctions leave out
std::vector<ComparableGroup> comparable_groups(const RunList& runs, const SettingGroups& except = {},
                                               const SettingGroups& untold = {});

/// For each run the settings that distinguish it from those of the same `series_label`, or from all runs if tests may differ:
/// "Gabbro, diameter 60 mm"; "" if there are none. \param except groups that are left out
std::vector<std::string> distinctions(const RunList& runs, const SettingGroups& except = {});

/// The name of the material of all runs, or `otherwise` if they have several or none.
std::string common_material(const std::vector<RunData>& runs, const std::string& otherwise);
/// A short name for each run of a set: its test and its distinction from others, then its seed and then the name of its file as
/// far as these are needed to tell runs apart.
std::vector<std::string> names_apart(const std::vector<RunData>& runs);

/// \param what the result that needs comparable runs, with an article: "an envelope" \param except groups that may differ
/// \throws InputError if runs of one test, pressure and `distinct_shape` differ, or if others are not of one material and fabric
void require_comparable(const std::vector<RunData>& runs, const std::string& what, const SettingGroups& except = {});

/// True if two files are of one test of one specimen: all settings that determine results agree, with seeds and ends.
bool is_same_run(const RunData& a, const RunData& b);
/// The indices of the runs with each test of a specimen once, from the file that followed it furthest. \param diagnostics gets a
/// line per file left out
std::vector<std::size_t> once_each(const RunList& runs, const std::string& command, std::ostream& diagnostics);
/// Reads runs, each test of a specimen once. \throws InputError if a file cannot be read
std::vector<RunData> read_once_each(const std::vector<std::string>& paths, const std::string& command, std::ostream& diagnostics);

}  // namespace graincrack
