// States of a run in space: frames and cracks that are checked against the specimen, and the choice of a frame.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "post/run/crack_label.hpp"
#include "share/file/run_file.hpp"

namespace graincrack {

/// The crack log. \throws InputError if a row names a contact or point that the specimen does not have
std::vector<Crack> read_cracks(const RunReader& run, const Specimen& specimen);
/// The same by a label.
std::vector<Crack> read_labelled_cracks(const RunReader& run, const Specimen& specimen, const CrackLabelChoice& label = {});
/// A frame. \throws InputError if its arrays do not fit the specimen
Frame read_whole_frame(const RunReader& run, const Specimen& specimen, std::size_t index);
/// The same without opening, sliding and traction, which no map shows: a third of its size.
Frame read_frame(const RunReader& run, const Specimen& specimen, std::size_t index);
/// The cracks up to a time.
std::vector<Crack> cracks_until(const std::vector<Crack>& cracks, double time);

/// Index of the frame a user means: "first", "last", "peak" (the frame nearest in time to the peak of the curve), "before",
/// "after" (nearest to 80 % of the peak on that side; after: the last frame if the stress does not fall so far), or a number
/// from 0; a `time` in s, if given, has precedence: the frame nearest to it.
/// \throws UsageError for another name or a number out of range, InputError for a run without frames
std::size_t choose_frame(const RunReader& run, const std::string& word, const std::optional<double>& time);
/// The same for several names with commas between.
std::vector<std::size_t> choose_frames(const RunReader& run, const std::string& names, const std::optional<double>& time);

}  // namespace graincrack
