#include "solver/run/run_output.hpp"

#include <cmath>
#include <memory>
#include <utility>

#include "share/file/end_faces.hpp"
#include "share/file/h5_file.hpp"
#include "share/file/output_file.hpp"
#include "share/file/platen_faces.hpp"

namespace graincrack {
namespace {

constexpr double first_frame_interval = 1.0 / 64;  // of the strain or time that the run may reach
constexpr double peak_frame_drop = 0.02;           // fall below the peak at which the frame of the peak is final
// Wall time from one writing of rows to the next, s: it takes some milliseconds, in which a kill would damage the unfinished
// file.
constexpr double flush_interval_of_frames = 0.25;
constexpr double longest_flush_interval = 2;

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

/// The file of a run, and the name of its checkpoints unless it is a stream.
H5Output open_output(const Run& run, const std::string& output, std::string& checkpoint) {
    auto place = std::make_unique<OutputFile>(output);
    if (!place->is_stream()) {
        checkpoint = checkpoint_of(output);
        clear_checkpoint_name(checkpoint, run.request.restart, run.request.discard_checkpoint);
    }
    return H5Output(std::move(place), "run");
}

}  // namespace

RunOutput::RunOutput(const Run& run, const std::string& output, const std::optional<FrameProgress>& frames)
    : run_(run),
      writer_(open_output(run, output, checkpoint_), run.specimen, run.header),
      frames_(run.request.frames, first_frame_interval, writer_),
      since_checkpoint_(run.request.wall_clock),
      since_flush_(run.request.wall_clock) {
    if (frames) frames_.resume(*frames, RunReader(run.request.restart));
}

void RunOutput::record() {
    const Recorder& r = run_.recorder;
    const Assemblage& a = run_.setup.assemblage;
    const ContactLaws& laws = run_.setup.parameters.laws;
    const bool has_fallen = r.axial_stress() < (1 - peak_frame_drop) * r.peak();
    const bool keeps_peak = frames_.peak(r.is_at_peak(), has_fallen, a, laws, run_.state);
    const bool keeps_this = frames_.regular(run_.program.stages().progress(), a, laws, run_.state);
    if (rows_written_ == 0 ||
        since_flush_.elapsed() >= (keeps_peak || keeps_this ? flush_interval_of_frames : longest_flush_interval)) {
        append_rows();
    }
}

void RunOutput::append_rows() {
    run_.program.append(writer_.file(), rows_written_);
    rows_written_ = run_.recorder.history().size();
    writer_.append_history(run_.recorder.history());
    since_flush_.restart();
}

bool RunOutput::wants_checkpoint() const {
    if (checkpoint_.empty()) return false;
    const bool is_asked = take_checkpoint_request();
    return is_asked || (run_.request.checkpoint_interval && since_checkpoint_.elapsed() >= *run_.request.checkpoint_interval);
}

const std::string& RunOutput::write_checkpoint() {
    if (checkpoint_.empty()) return checkpoint_;
    RunWriter writer(H5Output(OutputFile::covered(checkpoint_), "run"), run_.specimen, run_.header);
    writer.append_history(run_.recorder.history());
    run_.program.append(writer.file(), 0);
    run_.program.write(writer.file());
    write_faces(writer.file(), run_.setup.boundary, run_.specimen);
    const FrameProgress frames = frames_.save(run_.setup.assemblage, run_.setup.parameters.laws, run_.state, writer);
    write_saved_state(writer.file(), run_.state, run_.program.stages().state(), run_.recorder.energy().largest_error());
    write_frame_progress(writer.file(), frames);
    RunHeader header = run_.header;
    header.stop_reason = "checkpoint";
    header.steps = run_.state.step;
    header.integrations = run_.state.step;
    header.peak_axial_stress = run_.recorder.peak();
    Provenance provenance;
    provenance.tool = "graincrack-solve";
    provenance.threads = run_.threads;
    provenance.vector_target = name_of(run_.setup.assemblage.vector_target);
    writer.finish(header, run_.recorder.crack_log().rows(run_.setup.assemblage, run_.state), provenance);
    since_checkpoint_.restart();
    return checkpoint_;
}

void RunOutput::finish(const std::vector<SensitivityRow>& sensitivity, const Provenance& provenance) {
    frames_.last(run_.setup.assemblage, run_.setup.parameters.laws, run_.state);
    append_rows();
    run_.program.write(writer_.file());
    write_faces(writer_.file(), run_.setup.boundary, run_.specimen);
    if (run_.request.save_state) {
        write_saved_state(writer_.file(), run_.state, run_.program.stages().state(), run_.recorder.energy().largest_error());
    }
    writer_.finish(run_.header, run_.recorder.crack_log().rows(run_.setup.assemblage, run_.state), provenance, sensitivity);
    if (!checkpoint_.empty()) remove_checkpoint(checkpoint_);
}

}  // namespace graincrack
