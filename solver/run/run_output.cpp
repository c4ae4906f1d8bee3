#include "solver/run/run_output.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "share/file/h5_file.hpp"
#include "share/file/output_file.hpp"
#include "share/file/platen_faces.hpp"
#include "share/file/specimen_measures.hpp"
#include "solver/model/gather.hpp"
#include "solver/restart/whole_state.hpp"
#include "solver/run/outcome.hpp"

namespace graincrack {
namespace {

constexpr double first_frame_interval = 1.0 / 64;  // of the strain or time that the run may reach
constexpr double peak_frame_drop = 0.02;           // fall below the peak at which the frame of the peak is final
// Wall time from one writing of rows to the next, s, the second one while a frame is being written. It takes some milliseconds,
// in which a kill would damage the unfinished file.
constexpr double flush_interval = 2, longest_flush_interval = 10;

/// Rollers and punches; platens that are infinitely wide need not be told.
void write_faces(H5Output& file, const Boundary& boundary, const Specimen& specimen) {
    const double half = loaded_width(specimen) / 2;
    PlatenFaceSet set;
    bool any = false;
    for (const Platen& platen : boundary.platens) {
        const bool is_finite = std::isfinite(platen.left);
        any = any || is_finite;
        set.direction = std::atan2(platen.axis.y, platen.axis.x);
        set.faces.push_back({platen.side, is_finite ? platen.left : -half, is_finite ? platen.right : half, platen.position});
    }
    if (any) write_platen_faces(file, set);
}

/// The file of a run on the first rank.
std::unique_ptr<WritingThread> open_file(const Run& run, const std::string& output) {
    std::unique_ptr<WritingThread> file;
    run.request.ranks->on_first([&] {
        auto place = std::make_unique<OutputFile>(output, ".checkpoint.part");
        const bool is_file = !place->is_stream();
        if (is_file) clear_checkpoint_name(checkpoint_of(output), run.request.restart, run.request.discard_checkpoint);
        auto writer = std::make_unique<RunWriter>(H5Output(std::move(place), "run"), run.specimen, run.header);
        file = std::make_unique<WritingThread>(std::move(writer), is_file && run.request.frames > 0);
    });
    return file;
}

}  // namespace

RunOutput::RunOutput(Run run, const std::string& output, const std::optional<FrameProgress>& frames)
    : run_(std::move(run)),
      ranks_(*run_.request.ranks),
      file_(open_file(run_, output)),
      frames_(run_.request.frames, first_frame_interval, run_.setup, run_.state, run_.team, file_.get()),
      since_checkpoint_(run_.request.wall_clock),
      since_flush_(run_.request.wall_clock) {
    if (!ranks_.of_first(file_ && file_->when_done().file().is_stream())) checkpoint_ = checkpoint_of(output);
    if (frames) frames_.resume(*frames, RunReader(run_.request.restart));
}

void RunOutput::record() {
    const Recorder& r = run_.recorder;
    const double interval = file_ && file_->is_done() ? flush_interval : longest_flush_interval;
    if (file_ && (rows_written_ == 0 || since_flush_.elapsed() >= interval)) append_rows();
    frames_.peak(r.is_at_peak(), r.axial_stress() < (1 - peak_frame_drop) * r.peak());
    frames_.regular(run_.program.stages().progress());
}

void RunOutput::append_rows() {
    RunWriter& file = file_->when_done();
    run_.program.append(file.file(), rows_written_);
    file.append_history(run_.recorder.history());
    rows_written_ = run_.recorder.history().size();
    since_flush_.restart();
}

bool RunOutput::wants_checkpoint() {
    if (checkpoint_.empty()) return false;
    const bool is_asked = take_checkpoint_request();
    const double elapsed = since_checkpoint_.elapsed();
    if (writes_checkpoint_ && (!file_ || file_->is_done())) {
        checkpoint_time_ = elapsed;
        writes_checkpoint_ = false;
    }
    const double interval = std::max(run_.request.checkpoint_interval.value_or(0), least_checkpoint_interval());
    return ranks_.of_first(is_asked || (run_.request.checkpoint_interval && !writes_checkpoint_ && elapsed >= interval));
}

const std::string& RunOutput::write_checkpoint() {
    if (checkpoint_.empty()) return checkpoint_;
    since_checkpoint_.restart();
    writes_checkpoint_ = true;
    auto write_frames = frames_.save();
    const WholeState whole(run_.setup.assemblage, run_.state);
    ranks_.on_first([&] {
        RunHeader header = run_.header;
        header.stop_reason = "checkpoint";
        header.peak_axial_stress = run_.recorder.peak();
        header.peak_time = peak_time(header, run_.recorder.history());
        file_->later(
            [=, this, write_frames = std::move(write_frames), state = whole.state(), program = run_.program,
             history = run_.recorder.history(), error = run_.recorder.energy().largest_error(),
             cracks = run_.recorder.crack_log().rows(run_.setup.assemblage, whole.state().fracture_energy)](RunWriter& run) {
                checkpoint_problem_.clear();
                try {
                    RunWriter checkpoint(H5Output(OutputFile::covered(checkpoint_), "run"), run_.specimen, header);
                    const FrameProgress frames = write_frames(run, checkpoint);
                    checkpoint.append_history(history);
                    program.append(checkpoint.file(), 0);
                    program.write(checkpoint.file());
                    write_faces(checkpoint.file(), run_.setup.boundary, run_.specimen);
                    write_saved_state(checkpoint.file(), state, program.stages().state(), error, frames);
                    checkpoint.finish(header, cracks, run_.provenance);
                } catch (const OutputError& cause) {
                    checkpoint_problem_ = cause.what();
                }
            });
    });
    return checkpoint_;
}

void RunOutput::finish(const std::vector<SensitivityRow>& sensitivity, double wall_time) {
    run_.provenance.wall_time = wall_time;
    frames_.last();
    const Assemblage& a = run_.setup.assemblage;
    const std::optional<WholeState> whole =
        run_.request.save_state ? std::optional<WholeState>(std::in_place, a, run_.state) : std::nullopt;
    std::vector<double> fracture_energy = run_.state.fracture_energy;
    gather_chunks(a.part, a.part.contacts, 2UL * contacts_per_chunk, fracture_energy);
    ranks_.on_first([&] {
        append_rows();
        RunWriter& file = file_->when_done();
        run_.program.write(file.file());
        write_faces(file.file(), run_.setup.boundary, run_.specimen);
        const double error = run_.recorder.energy().largest_error();
        if (whole) write_saved_state(file.file(), whole->state(), run_.program.stages().state(), error);
        file.finish(run_.header, run_.recorder.crack_log().rows(a, fracture_energy), run_.provenance, sensitivity);
        if (!checkpoint_.empty()) remove_checkpoint(checkpoint_);
    });
}

}  // namespace graincrack
