// The rule by which runs are comparable: their mean, their fit or their common row has a meaning if all settings that decide
// results agree. Seeds, frames, threads, ranks and machines are no part of it.
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

/// What tests of one rock may differ in if they are of different kinds or at different pressures.
inline const SettingGroups of_the_test{SettingGroup::test,    SettingGroup::pressure, SettingGroup::plane,
                                       SettingGroup::shape,   SettingGroup::size,     SettingGroup::cuts,
                                       SettingGroup::loading, SettingGroup::rate,     SettingGroup::end};

/// A setting, or a measure of a specimen, by which the result of a run is what it is.
struct ComparedSetting {
    Setting setting;             ///< its name as people read it, "grain diameter"
    double tolerance = 1e-9;     ///< relative difference of equal numbers; what is drawn differs from seed to seed
    double slack = 0;            ///< the same in SI, where it is more
    bool follows_plane = false;  ///< compared in one plane condition only
    std::string follows = {};    ///< told only where the setting of this name is the same
};
using ComparedSettings = std::vector<ComparedSetting>;

/// Law, rock, contacts and phases, in the order of reports.
ComparedSettings compared_material(const MaterialSettings& material);
/// All settings of a run and its specimen by which it is compared. What its file does not hold is no part of them.
ComparedSettings compared_settings(const RunData& run);

/// In what two runs differ, with both values: "material (Granite, Gabbro), diameter (30 mm, 60 mm)"; "" if in nothing. Of
/// materials with different names only these are told. \param except may differ
std::string differences(const ComparedSettings& a, const ComparedSettings& b, const SettingGroups& except = {});
std::string differences(const RunData& a, const RunData& b, const SettingGroups& except = {});

/// Runs by pointers, which must stay where they are.
using RunList = std::vector<const RunData*>;
RunList list_of(const std::vector<RunData>& runs);

/// Comparable runs: each agrees with all others of them.
struct ComparableGroup {
    std::vector<std::size_t> runs;  ///< indices in their order
    std::string distinction;        ///< of the first from those of other groups, as of `distinctions`
};
/// In the order of tables: Brazilian, tension, compression by rising pressure; within a test by rising size of the grains. Runs
/// join groups by rising size of grains and of specimen, so that the groups do not depend on the order of the runs.
/// \param except may differ \param untold is left out of distinctions
std::vector<ComparableGroup> comparable_groups(const RunList& runs, const SettingGroups& except = {},
                                               const SettingGroups& untold = {});

/// For each run what tells it from those of its `series_label`, or from all if tests may differ: "Gabbro, diameter 60 mm"; ""
/// if nothing does. \param except is not told
std::vector<std::string> distinctions(const RunList& runs, const SettingGroups& except = {});

/// The name of the material of all runs, another text if they have several or none.
std::string common_material(const std::vector<RunData>& runs, const std::string& otherwise);
/// A short name for each run of a set: its test, what tells it from others of that, then its seed; the name of its file where
/// nothing does.
std::vector<std::string> names_apart(const std::vector<RunData>& runs);

/// \param what needs equal tests, with an article: "an envelope" \param except may differ
/// \throws InputError if runs of one test, pressure and `distinct_shape` differ, or if others are not of one material and fabric
void require_comparable(const std::vector<RunData>& runs, const std::string& what, const SettingGroups& except = {});

/// Whether two files are of one test of one specimen: all settings that decide results are equal, seeds and ends included.
bool is_same_run(const RunData& a, const RunData& b);
/// The indices of the runs, each test of a specimen once, with the file that followed it furthest. \param diagnostics gets a line
/// for each file that is left out
std::vector<std::size_t> once_each(const RunList& runs, const std::string& command, std::ostream& diagnostics);
/// Reads runs, each test of a specimen once. \throws InputError
std::vector<RunData> read_once_each(const std::vector<std::string>& paths, const std::string& command, std::ostream& diagnostics);

}  // namespace graincrack
