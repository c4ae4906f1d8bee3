#include "share/file/run_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "share/base/error.hpp"
#include "share/file/datasets.hpp"
#include "share/file/file_checks.hpp"
#include "share/file/h5_file.hpp"
#include "share/file/provenance.hpp"
#include "share/file/schema.hpp"

namespace graincrack {

namespace {

/// Visits every array of a frame once.
template <class FrameType, class Visit>
void visit_frame(FrameType&& frame, Visit&& visit) {
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

void visit_frame_datasets(const VisitDataset& visit) {
    visit_frame(Frame(), [&](const schema::Dataset& dataset, const auto&... /*rows*/) { visit(dataset); });
}

// --- writing ---------------------------------------------------------------------------------------------------------

RunWriter::RunWriter(H5Output file, const Specimen& specimen, const RunHeader& header) : file_(std::move(file)) {
    write_specimen(file_, specimen);
    write_header(file_, header);
    write_fabric(file_, header, specimen);
    file_.create_group(schema::history_group);
    file_.create_group(schema::frames_group);
    file_.flush();
}

void RunWriter::append_history(const History& history) {
    const std::size_t n = history.size() - rows_;
    if (n == 0 && rows_ > 0) return;
    append_rows(file_, history, rows_);
    rows_ = history.size();
    file_.flush();
}

std::string RunWriter::next_group() { return fmt::format("{}/part{:06}", schema::frames_group, n_groups_++); }

void RunWriter::add_frame(const Frame& frame, FrameRole role) {
    const std::string group = next_group();
    file_.create_group(group);
    file_.quantity(group, "time", frame.time, "s");
    file_.attribute(group, "step", frame.step);
    visit_frame(frame, [&](const schema::Dataset& dataset, const auto& rows, std::size_t split) {
        using Row = typename std::decay_t<decltype(rows)>::value_type;
        const std::size_t width = Stored<Row>::width;
        const Extents extents = split == 0 ? Extents{rows.size(), width} : Extents{rows.size(), split, width / split};
        file_.write<typename Row::value_type>(group + "/" + dataset.path, flat(rows), extents, dataset.unit, dataset.description);
    });
    file_.attribute(group + "/" + schema::frame_state.path, "names",
                    std::vector<std::string>{"intact", "failed in tension", "failed in shear", "separated"});
    const auto after = std::find_if(frames_.begin(), frames_.end(), [&](const Slot& slot) { return slot.time > frame.time; });
    frames_.insert(after, {group, frame.time, role});
    file_.flush();
}

void RunWriter::add_frames(const RunWriter& other) {
    for (const Slot& slot : other.frames_) {
        const std::string group = next_group();
        file_.copy(other.file_, slot.group, group);
        frames_.push_back({group, slot.time, slot.role});
    }
}

void RunWriter::thin_frames() {
    std::vector<Slot> left;
    bool drop = false;
    for (const Slot& slot : frames_) {
        const bool is_regular = slot.role == FrameRole::regular;
        if (is_regular && drop) {
            file_.remove(slot.group);
        } else {
            left.push_back(slot);
        }
        drop = is_regular ? !drop : drop;
    }
    frames_ = std::move(left);
}

std::vector<FrameRole> RunWriter::frame_roles() const {
    std::vector<FrameRole> roles;
    for (const Slot& slot : frames_) roles.push_back(slot.role);
    return roles;
}

void RunWriter::finish(const RunHeader& header, const std::vector<Crack>& cracks, const Provenance& provenance,
                       const std::vector<SensitivityRow>& sensitivity) {
    write_header(file_, header);
    write_cracks(file_, cracks);
    if (!sensitivity.empty()) write_sensitivity(file_, sensitivity);
    for (std::size_t i = 0; i < frames_.size(); ++i) {
        std::string& group = frames_[i].group;
        const std::string numbered = fmt::format("{}/{:04}", schema::frames_group, i);
        file_.move(group, numbered);
        group = numbered;
    }
    if (!frames_.empty()) link_last_frame(file_, frames_.back().group);
    write_provenance(file_, provenance);
    file_.commit();
}

// --- reading ---------------------------------------------------------------------------------------------------------

RunReader::RunReader(const std::string& path) : file_(path, "run"), header_(read_header(file_)) {
    for (const std::string& name : file_.children(schema::frames_group)) {
        frames_.push_back(std::string(schema::frames_group) + "/" + name);
    }
}

Specimen RunReader::specimen() const {
    Specimen specimen = read_specimen(file_);
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

History RunReader::history() const {
    History history = read_history(file_);
    if (history.size() == 0) throw InputError(fmt::format("{}: {} has no rows", name(), schema::history_group));
    return history;
}

std::vector<double> RunReader::frame_times() const {
    std::vector<double> times;
    for (const std::string& group : frames_) {
        times.push_back(file_.attribute<double>(group, "time"));
        if (!std::isfinite(times.back()) || (times.size() > 1 && times.back() < times[times.size() - 2])) {
            throw InputError(
                fmt::format("{}: time {} of {} does not follow that of the frame before", name(), times.back(), group));
        }
    }
    return times;
}

Frame RunReader::frame(std::size_t index) const {
    if (index >= frames_.size()) {
        throw InputError(fmt::format("{}: there is no frame {}; the run has {}", name(), index, frames_.size()));
    }
    const H5Input& file = file_;
    const std::string& group = frames_[index];
    Frame frame;
    frame.time = file.attribute<double>(group, "time");
    frame.step = file.attribute<std::int64_t>(group, "step");
    const std::size_t nodes = rows_of(file, schema::node_position.path);
    const std::size_t elements = rows_of(file, schema::element_nodes.path);
    const std::size_t contacts = rows_of(file, schema::contact_nodes.path);
    visit_frame(frame, [&](const schema::Dataset& dataset, auto& rows, std::size_t split) {
        using Row = typename std::decay_t<decltype(rows)>::value_type;
        using T = typename Row::value_type;
        const std::size_t width = Stored<Row>::width;
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
        rows = rows_from<Row>(values);
    });
    return frame;
}

double RunReader::wall_time() const { return file_.attribute_or<double>(schema::provenance_group, "wall_time", 0); }
int RunReader::threads() const {
    return static_cast<int>(file_.attribute_or<std::int64_t>(schema::provenance_group, "threads", 1));
}

}  // namespace graincrack
