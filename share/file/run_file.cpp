#include "share/file/run_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <span>
#include <string_view>
#include <utility>

#include "share/base/error.hpp"
#include "share/file/file_checks.hpp"
#include "share/file/h5_file.hpp"
#include "share/file/provenance.hpp"
#include "share/file/schema.hpp"

namespace graincrack {

namespace {

template <class T, std::size_t n>
void unflatten(const std::vector<T>& values, std::vector<std::array<T, n>>& rows) {
    rows.resize(values.size() / n);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(i * n), n, rows[i].begin());
    }
}

/// Visits every array of a frame once.
template <class FrameType, class Visit>
void visit_frame(FrameType& frame, Visit&& visit) {
    visit(schema::frame_displacement, frame.displacement, 0);
    visit(schema::frame_velocity, frame.velocity, 0);
    visit(schema::frame_element_stress, frame.element_stress, 0);
    visit(schema::frame_opening, frame.opening, 0);
    visit(schema::frame_sliding, frame.sliding, 0);
    visit(schema::frame_traction, frame.traction, 2);  // [c, 2 points, 2 components]
    visit(schema::frame_damage, frame.damage, 0);
    visit(schema::frame_state, frame.state, 0);
}

/// Links the last frame as fields of the static VTKHDF view.
void link_last_frame(H5Output& file, const std::string& frame) {
    const std::string vtk = schema::vtk_group;
    const auto link = [&](const schema::Dataset& dataset, const char* where) {
        file.hard_link(frame + "/" + dataset.path, vtk + "/" + where + "/" + dataset.path);
    };
    link(schema::frame_displacement, "PointData");
    link(schema::frame_velocity, "PointData");
    link(schema::frame_element_stress, "CellData");
}

}  // namespace

// --- writing ---------------------------------------------------------------------------------------------------------

struct RunWriter::State {
    struct Slot {
        std::string group;
        double time;
        FrameRole role;
    };
    H5Output file;
    std::size_t rows = 0;        // rows of the history already written
    std::size_t next_frame = 0;  // running number, until the frames are numbered in time order at the end
    std::vector<Slot> frames;    // in time order; the frame of a peak may be added after later ones
};

RunWriter::RunWriter(H5Output file, const Specimen& specimen, const RunHeader& header)
    : state_(std::make_unique<State>(State{std::move(file), 0, 0, {}})) {
    write_specimen(state_->file, specimen);
    write_header(state_->file, header);
    write_fabric(state_->file, header, specimen);
    state_->file.create_group(schema::history_group);
    state_->file.create_group(schema::frames_group);
    state_->file.flush();
}
RunWriter::~RunWriter() = default;

void RunWriter::append_history(const History& history) {
    const std::size_t n = history.size() - state_->rows;
    if (n == 0 && state_->rows > 0) return;
    append_rows(state_->file, history, state_->rows);
    state_->rows = history.size();
    state_->file.flush();
}

void RunWriter::add_frame(const Frame& frame, FrameRole role) {
    const std::string group = fmt::format("{}/part{:06}", schema::frames_group, state_->next_frame++);
    H5Output& file = state_->file;
    file.create_group(group);
    file.quantity(group, "time", frame.time, "s");
    file.attribute(group, "step", frame.step);
    visit_frame(frame, [&](const schema::Dataset& dataset, const auto& rows, std::size_t split) {
        using T = typename std::decay_t<decltype(rows)>::value_type::value_type;
        const std::size_t width = std::tuple_size_v<typename std::decay_t<decltype(rows)>::value_type>;
        const Extents extents = split == 0 ? Extents{rows.size(), width} : Extents{rows.size(), split, width / split};
        file.write<T>(group + "/" + dataset.path, flat(rows), extents, dataset.unit, dataset.description);
    });
    file.attribute(group + "/" + schema::frame_state.path, "names",
                   std::vector<std::string>{"intact", "failed in tension", "failed in shear", "separated"});
    std::vector<State::Slot>& frames = state_->frames;
    const auto after =
        std::find_if(frames.begin(), frames.end(), [&](const State::Slot& slot) { return slot.time > frame.time; });
    frames.insert(after, {group, frame.time, role});
    file.flush();
}

void RunWriter::add_frames(const RunWriter& other) {
    for (const State::Slot& slot : other.state_->frames) {
        const std::string group = fmt::format("{}/part{:06}", schema::frames_group, state_->next_frame++);
        state_->file.copy(other.state_->file, slot.group, group);
        state_->frames.push_back({group, slot.time, slot.role});
    }
}

void RunWriter::thin_frames() {
    std::vector<State::Slot> left;
    bool drop = false;
    for (const State::Slot& slot : state_->frames) {
        const bool is_regular = slot.role == FrameRole::regular;
        if (is_regular && drop) {
            state_->file.remove(slot.group);
        } else {
            left.push_back(slot);
        }
        drop = is_regular ? !drop : drop;
    }
    state_->frames = std::move(left);
}

std::vector<FrameRole> RunWriter::frame_roles() const {
    std::vector<FrameRole> roles;
    for (const State::Slot& slot : state_->frames) roles.push_back(slot.role);
    return roles;
}

H5Output& RunWriter::file() { return state_->file; }
std::size_t RunWriter::n_frames() const { return state_->frames.size(); }

void RunWriter::finish(const RunHeader& header, const std::vector<Crack>& cracks, const Provenance& provenance,
                       const std::vector<SensitivityRow>& sensitivity) {
    write_header(state_->file, header);
    write_cracks(state_->file, cracks);
    if (!sensitivity.empty()) write_sensitivity(state_->file, sensitivity);
    for (std::size_t i = 0; i < state_->frames.size(); ++i) {
        std::string& group = state_->frames[i].group;
        const std::string numbered = fmt::format("{}/{:04}", schema::frames_group, i);
        state_->file.move(group, numbered);
        group = numbered;
    }
    if (!state_->frames.empty()) link_last_frame(state_->file, state_->frames.back().group);
    write_provenance(state_->file, provenance);
    state_->file.commit();
}

// --- reading ---------------------------------------------------------------------------------------------------------

struct RunReader::State {
    H5Input file;
    RunHeader header;
    std::vector<std::string> frames;
};

RunReader::RunReader(const std::string& path) : state_(std::make_unique<State>(State{H5Input(path, "run"), {}, {}})) {
    state_->header = read_header(state_->file);
    for (const std::string& name : state_->file.children(schema::frames_group)) {
        state_->frames.push_back(std::string(schema::frames_group) + "/" + name);
    }
}
RunReader::~RunReader() = default;
RunReader::RunReader(RunReader&&) noexcept = default;

const std::string& RunReader::name() const { return state_->file.name(); }
const RunHeader& RunReader::header() const { return state_->header; }
Specimen RunReader::specimen() const {
    Specimen specimen = read_specimen(state_->file);
    if (specimen.phase_names.size() != header().fabric.phases.size()) {
        throw InputError(fmt::format("{}: {} has {} phases, the specimen has {}; as many are needed", name(),
                                     schema::phases_group, header().fabric.phases.size(), specimen.phase_names.size()));
    }
    if (const std::size_t n_classes = contact_class_names(specimen).size(); n_classes != header().fabric.contacts.size()) {
        throw InputError(fmt::format("{}: {} has {} classes, the specimen has {}; as many are needed", name(),
                                     schema::classes_group, header().fabric.contacts.size(), n_classes));
    }
    return specimen;
}
const H5Input& RunReader::file() const { return state_->file; }

History RunReader::history() const {
    History history = read_history(state_->file);
    if (history.size() == 0) throw InputError(fmt::format("{}: {} has no rows", name(), schema::history_group));
    return history;
}

std::vector<Crack> RunReader::cracks() const { return read_cracks(state_->file); }
std::size_t RunReader::n_frames() const { return state_->frames.size(); }

std::vector<double> RunReader::frame_times() const {
    std::vector<double> times;
    for (const std::string& group : state_->frames) {
        times.push_back(state_->file.attribute<double>(group, "time"));
        if (!std::isfinite(times.back()) || (times.size() > 1 && times.back() < times[times.size() - 2])) {
            throw InputError(
                fmt::format("{}: time {} of {} does not follow that of the frame before", name(), times.back(), group));
        }
    }
    return times;
}

Frame RunReader::frame(std::size_t index) const {
    if (index >= state_->frames.size()) {
        throw InputError(fmt::format("{}: there is no frame {}; the run has {}", name(), index, state_->frames.size()));
    }
    const H5Input& file = state_->file;
    const std::string& group = state_->frames[index];
    Frame frame;
    frame.time = file.attribute<double>(group, "time");
    frame.step = file.attribute<std::int64_t>(group, "step");
    const std::size_t nodes = rows_of(file, schema::node_position.path);
    const std::size_t elements = rows_of(file, schema::element_nodes.path);
    const std::size_t contacts = rows_of(file, schema::contact_nodes.path);
    visit_frame(frame, [&](const schema::Dataset& dataset, auto& rows, std::size_t split) {
        using Row = typename std::decay_t<decltype(rows)>::value_type;
        using T = typename Row::value_type;
        const std::size_t width = std::tuple_size_v<Row>;
        const std::string_view array = dataset.path;
        const bool is_nodal = array == schema::frame_displacement.path || array == schema::frame_velocity.path;
        const std::size_t n = is_nodal ? nodes : array == schema::frame_element_stress.path ? elements : contacts;
        const std::string path = group + "/" + dataset.path;
        const std::vector<T> values = file.read<T>(path, split == 0 ? Extents{n, width} : Extents{n, split, width / split});
        if constexpr (std::is_same_v<T, double>) {
            require_all(file, path, values, "a finite number", [](double value) { return std::isfinite(value); });
        } else {
            require_all(file, path, values, "0 to 3", [](T value) { return value <= static_cast<T>(PointState::separated); });
        }
        unflatten(values, rows);
    });
    return frame;
}

double RunReader::wall_time() const { return state_->file.attribute_or<double>(schema::provenance_group, "wall_time", 0); }
int RunReader::threads() const {
    return static_cast<int>(state_->file.attribute_or<std::int64_t>(schema::provenance_group, "threads", 1));
}

}  // namespace graincrack
