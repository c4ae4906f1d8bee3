#include "solver/run/run_output.hpp"

#include <cmath>
#include <memory>
#include <utility>

#include "share/file/h5_file.hpp"
#include "share/file/output_file.hpp"
#include "share/file/platen_faces.hpp"
#include "share/file/specimen_measures.hpp"
#include "solver/model/gather.hpp"
#include "solver/restart/whole_state.hpp"

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

/// The file of a run on the first rank, and on all the name of its checkpoints unless it is a stream.
std::unique_ptr<RunWriter> open_writer(const Run& run, const std::string& output, std::string& checkpoint) {
    std::unique_ptr<RunWriter> writer;
    bool is_stream = false;
    run.request.ranks->on_first([&] {
        auto place = std::make_unique<OutputFile>(output, ".checkpoint.part");
        is_stream = place->is_stream();
        if (!is_stream) clear_checkpoint_name(checkpoint_of(output), run.request.restart, run.request.discard_checkpoint);
        writer = std::make_unique<RunWriter>(H5Output(std::move(place), "run"), run.specimen, run.header);
    });
    if (!run.request.ranks->of_first(is_stream)) checkpoint = checkpoint_of(output);
    return writer;
}

}  // namespace

RunOutput::RunOutput(const Run& run, const std::string& output, const std::optional<FrameProgress>& frames)
    : run_(run),
      ranks_(*run.request.ranks),
      writer_(open_writer(run, output, checkpoint_)),
      frames_(run.request.frames, first_frame_interval, writer_.get()),
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
    if (!writer_) return;
    run_.program.append(writer_->file(), rows_written_);
    rows_written_ = run_.recorder.history().size();
    writer_->append_history(run_.recorder.history());
    since_flush_.restart();
}

void RunOutput::write_end(H5Output& file, const State* state, const std::optional<FrameProgress>& frames) const {
    run_.program.write(file);
    write_faces(file, run_.setup.boundary, run_.specimen);
    if (state == nullptr) return;
    write_saved_state(file, *state, run_.program.stages().state(), run_.recorder.energy().largest_error(), frames);
}

bool RunOutput::wants_checkpoint() const {
    if (checkpoint_.empty()) return false;
    const bool is_asked = take_checkpoint_request();
    return ranks_.of_first(
        is_asked || (run_.request.checkpoint_interval && since_checkpoint_.elapsed() >= *run_.request.checkpoint_interval));
}

const std::string& RunOutput::write_checkpoint() {
    if (checkpoint_.empty()) return checkpoint_;
    std::optional<RunWriter> writer;
    ranks_.on_first([&] { writer.emplace(H5Output(OutputFile::covered(checkpoint_), "run"), run_.specimen, run_.header); });
    const FrameProgress frames =
        frames_.save(run_.setup.assemblage, run_.setup.parameters.laws, run_.state, writer ? &*writer : nullptr);
    const WholeState whole(run_.setup.assemblage, run_.state);
    ranks_.on_first([&] {
        const State& state = whole.state();
        writer->append_history(run_.recorder.history());
        run_.program.append(writer->file(), 0);
        write_end(writer->file(), &state, frames);
        RunHeader header = run_.header;
        header.stop_reason = "checkpoint";
        header.steps = state.step;
        header.integrations = state.step;
        header.peak_axial_stress = run_.recorder.peak();
        Provenance provenance;
        provenance.tool = "graincrack-solve";
        provenance.threads = run_.threads;
        provenance.ranks = ranks_.size();
        provenance.vector_target = name_of(run_.setup.assemblage.vector_target);
        writer->finish(header, run_.recorder.crack_log().rows(run_.setup.assemblage, state.fracture_energy), provenance);
    });
    since_checkpoint_.restart();
    return checkpoint_;
}

void RunOutput::finish(const std::vector<SensitivityRow>& sensitivity, const Provenance& provenance) {
    frames_.last(run_.setup.assemblage, run_.setup.parameters.laws, run_.state);
    const Assemblage& a = run_.setup.assemblage;
    const std::optional<WholeState> whole =
        run_.request.save_state ? std::optional<WholeState>(std::in_place, a, run_.state) : std::nullopt;
    std::vector<double> fracture_energy = run_.state.fracture_energy;
    gather_chunks(a.part, a.part.contacts, 2UL * contacts_per_chunk, fracture_energy);
    ranks_.on_first([&] {
        append_rows();
        write_end(writer_->file(), whole ? &whole->state() : nullptr);
        writer_->finish(run_.header, run_.recorder.crack_log().rows(a, fracture_energy), provenance, sensitivity);
        if (!checkpoint_.empty()) remove_checkpoint(checkpoint_);
    });
}

}  // namespace graincrack
