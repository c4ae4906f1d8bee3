// The rule by which runs are comparable: their mean, their fit or their common row has a meaning if they are alike in all that
// makes a result what it is. Seeds, frames, threads, ranks and machines are no part of it.
#pragma once

#include <cstddef>
#include <optional>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include "post/run/load_curve.hpp"
#include "share/base/quantities.hpp"

namespace graincrack {

/// What a trait belongs to. Cuts are holes, slits, flaws and joints; the fabric is the tessellation, its distributions and the
/// scatter of strengths; loading is friction, damping, masses and program; the end is the fall behind the peak that ends a test.
enum class Aspect { test, pressure, heat, plane, material, shape, size, cuts, grain_size, fabric, loading, rate, end };
using Aspects = std::set<Aspect>;

/// What tests of one rock may differ in if they are of different kinds or at different pressures.
inline const Aspects of_the_test{Aspect::test, Aspect::pressure, Aspect::plane, Aspect::shape, Aspect::size,
                                 Aspect::cuts, Aspect::loading,  Aspect::rate,  Aspect::end};

/// A property by which the result of a run is what it is: a number, else a text, which is empty for what the run does not have.
struct Trait {
    Aspect aspect{};
    std::string name;  ///< "diameter"
    std::string text = {};
    std::optional<double> number = std::nullopt;  ///< SI
    Dimension dimension = Dimension::one;
    double tolerance = 1e-9;     ///< relative difference of equal numbers; what is drawn differs from seed to seed
    double slack = 0;            ///< the same in SI, where it is more
    bool follows_plane = false;  ///< compared in one plane condition only
    std::string follows = {};    ///< told only where the trait of this name is the same
};

/// Law, rock, contacts and phases, in the order of reports.
std::vector<Trait> material_traits(const RunSettings& header);
/// All traits of a run. What its file does not hold is empty.
std::vector<Trait> traits_of(const RunData& run);

/// In what two runs differ, with both values: "material (Granite, Gabbro), diameter (30 mm, 60 mm)"; "" if in nothing. Of
/// materials with different names only these are told. \param except may differ
std::string differences(const std::vector<Trait>& a, const std::vector<Trait>& b, const Aspects& except = {});
std::string differences(const RunData& a, const RunData& b, const Aspects& except = {});

/// Runs by pointers, which must stay where they are.
using RunList = std::vector<const RunData*>;
RunList list_of(const std::vector<RunData>& runs);

/// Comparable runs: each has no differences from another of them.
struct LikeGroup {
    std::vector<std::size_t> runs;  ///< indices in their order
    std::string distinction;        ///< of the first from those of other groups, as of `distinctions`
};
/// In the order of tables: Brazilian, tension, compression by rising pressure; within a test by rising size of the grains.
/// \param except may differ \param untold is left out of distinctions
std::vector<LikeGroup> groups_of_like(const RunList& runs, const Aspects& except = {}, const Aspects& untold = {});

/// For each run what tells it from those of its `series_label`, or from all if tests may differ: "Gabbro, diameter 60 mm"; ""
/// if nothing does. \param except is not told
std::vector<std::string> distinctions(const RunList& runs, const Aspects& except = {});

/// The name of the material of all runs, another text if they have several or none.
std::string common_material(const std::vector<RunData>& runs, const std::string& otherwise);
/// A short name for each run of a set: its test, what tells it from others of that, then its seed; the name of its file where
/// nothing does.
std::vector<std::string> names_apart(const std::vector<RunData>& runs);

/// \param what needs equal tests, with an article: "an envelope" \param except may differ
/// \throws InputError if runs of one test, pressure and `distinct_shape` differ, or if others are not of one material and fabric
void require_alike(const std::vector<RunData>& runs, const std::string& what, const Aspects& except = {});

/// Whether two files are of one test of one specimen, which one of them may have followed further.
bool is_same_run(const RunData& a, const RunData& b);
/// The indices of the runs, each test of a specimen once, with the file that followed it furthest. \param diagnostics gets a line
/// for each file that is left out
std::vector<std::size_t> once_each(const RunList& runs, const std::string& command, std::ostream& diagnostics);
/// Reads runs, each test of a specimen once. \throws InputError
std::vector<RunData> read_once_each(const std::vector<std::string>& paths, const std::string& command, std::ostream& diagnostics);

}  // namespace graincrack
