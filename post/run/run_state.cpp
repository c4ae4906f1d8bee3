#include "post/run/run_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "post/run/load_curve.hpp"
#include "share/base/error.hpp"
#include "share/base/text.hpp"

namespace graincrack {

namespace {

/// Time of the peak, or of 80 % of it before or after.
double time_about_peak(const RunData& data, const LoadCurve& curve, const std::string& word) {
    constexpr double share = 0.8;
    const auto& times = data.history[HistoryColumn::time];
    if (word == "peak") return times[curve.peak];
    if (word == "before") return share_of_peak(curve, share).of(times);
    for (std::size_t row = curve.peak; row < times.size(); ++row) {
        if (curve.stress[row] <= share * curve.peak_stress()) return times[row];
    }
    return times.back();
}

}  // namespace

std::vector<Crack> read_cracks(const RunReader& run, const Specimen& specimen) {
    std::vector<Crack> cracks = run.cracks();
    for (std::size_t i = 0; i < cracks.size(); ++i) {
        const auto contact = static_cast<std::int64_t>(cracks[i].contact);
        if (contact < 0 || contact >= static_cast<std::int64_t>(specimen.n_contacts()) || cracks[i].point > 1) {
            throw InputError(
                fmt::format("{}: row {} of /cracks is point {} of contact {}; the specimen has contacts 0 to {} of 2 points",
                            run.name(), i, cracks[i].point, contact, specimen.n_contacts() - 1));
        }
    }
    return cracks;
}

std::vector<Crack> read_labelled_cracks(const RunReader& run, const Specimen& specimen, const CrackLabelChoice& label) {
    return labelled(read_cracks(run, specimen), label.of(run.header()));
}

Frame read_whole_frame(const RunReader& run, const Specimen& specimen, std::size_t index) {
    Frame frame = run.frame(index);
    const std::size_t contacts = specimen.n_contacts();
    if (frame.displacement.size() != specimen.n_nodes() || frame.velocity.size() != specimen.n_nodes() ||
        frame.element_stress.size() != specimen.n_elements() || frame.state.size() != contacts ||
        frame.opening.size() != contacts || frame.sliding.size() != contacts) {
        throw InputError(fmt::format("{}: frame {} does not fit the specimen of {} nodes, {} elements and {} contacts",
                                     run.name(), index, specimen.n_nodes(), specimen.n_elements(), contacts));
    }
    return frame;
}

Frame read_frame(const RunReader& run, const Specimen& specimen, std::size_t index) {
    Frame frame = read_whole_frame(run, specimen, index);
    for (auto* values : {&frame.opening, &frame.sliding}) *values = {};
    frame.traction = {};
    return frame;
}

std::vector<Crack> cracks_until(const std::vector<Crack>& cracks, double time) {
    std::vector<Crack> present;
    std::ranges::copy_if(cracks, std::back_inserter(present), [time](const Crack& c) { return c.time <= time; });
    return present;
}

std::size_t choose_frame(const RunReader& run, const std::string& word, const std::optional<double>& time) {
    const std::vector<double> times = run.frame_times();
    if (times.empty()) throw InputError(run.name() + ": has no frames; run the solver with --frames 1 or more");
    const auto nearest = [&](double wanted) {
        const auto off = [wanted](double each) { return std::abs(each - wanted); };
        return static_cast<std::size_t>(std::ranges::min_element(times, {}, off) - times.begin());
    };
    if (time) return nearest(*time);
    if (word == "last") return times.size() - 1;
    if (word == "first") return 0;
    if (word == "before" || word == "peak" || word == "after") {
        const RunData data = run_data(run);
        return nearest(time_about_peak(data, load_curve(data), word));
    }
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), index);
    if (error != std::errc() || end != word.data() + word.size()) {
        throw UsageError("--frame " + word + ": unknown; first, before, peak, after, last or a number from 0");
    }
    if (index >= times.size()) {
        throw UsageError(fmt::format("--frame {}: {} has frames 0 to {}", word, run.name(), times.size() - 1));
    }
    return index;
}

std::vector<std::size_t> choose_frames(const RunReader& run, const std::string& names, const std::optional<double>& time) {
    std::vector<std::size_t> frames;
    for (const std::string_view word : split(names, ',')) {
        const std::size_t frame = choose_frame(run, std::string(word), time);
        if (std::ranges::find(frames, frame) == frames.end()) frames.push_back(frame);
    }
    return frames;
}

}  // namespace graincrack
