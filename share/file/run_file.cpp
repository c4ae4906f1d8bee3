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

// clang-format off
const std::array<HistoryDataset, static_cast<std::size_t>(HistoryColumn::count)> history_datasets{{
    {"time", Dimension::time, "time"},
    {"step", Dimension::one, "step"},
    {"axial_strain", Dimension::one, "platen approach over specimen height, elongation positive"},
    {"lateral_strain", Dimension::one, "mean widening of the lateral boundary over its width, elongation positive"},
    {"gauge_axial_strain", Dimension::one, "axial strain of the central half, elongation positive"},
    {"gauge_lateral_strain", Dimension::one, "lateral strain of the central half, elongation positive"},
    {"axial_stress", Dimension::stress, "mean platen force over the specimen's width, tension positive"},
    {"force_top", Dimension::force, "axial force of the top platen on the specimen per metre of thickness, tension positive"},
    {"force_bottom", Dimension::force, "axial force of the bottom platen on the specimen per metre of thickness, tension positive"},
    {"confining_pressure", Dimension::stress, "achieved pressure: lateral membrane force over the distance of the platens"},
    {"energy_external", Dimension::energy, "work of platens and membrane on the specimen"},
    {"energy_kinetic", Dimension::energy, "kinetic energy"},
    {"energy_strain", Dimension::energy, "strain energy of the elements"},
    {"energy_contact", Dimension::energy, "energy stored in the contacts"},
    {"energy_fracture_tension", Dimension::energy, "energy dissipated by contacts that failed in tension"},
    {"energy_fracture_shear", Dimension::energy, "energy dissipated by contacts that failed in shear, without friction"},
    {"energy_friction", Dimension::energy, "energy dissipated by friction in failed contacts"},
    {"energy_damping", Dimension::energy, "energy absorbed by damping"},
    {"energy_platen", Dimension::energy, "energy stored in platen springs and dissipated by platen friction"},
    {"non_conservative_work", Dimension::energy, "energy lost (positive) or made (negative) where the law has no potential"},
    {"energy_balance_error", Dimension::one, "(external - sum of the others) / largest stored energy so far"},
    {"unbalanced_ratio", Dimension::one, "mean unbalanced nodal force over mean magnitude of the forces at a node"},
    {"tensile_cracks", Dimension::one, "contacts that failed while open (points / 2)"},
    {"shear_cracks", Dimension::one, "contacts that failed while closed (points / 2)"},
    {"platen_speed", Dimension::speed, "speed of each platen, approach positive"},
    {"damping_load", Dimension::one, "load that damping carries by holding the mean motion back, over that of the platens"},
    {"energy_numerical", Dimension::energy, "lost by mass scaling where clusters of nodes meet or leave platens"},
}};
// clang-format on

namespace {

constexpr std::size_t n_history_columns = static_cast<std::size_t>(HistoryColumn::count);

/// Visits every contact parameter once.
template <class Contact, class Visit>
void visit_contact(Contact& contact, const Visit& visit) {
    for (const ContactParameter& row : all_contact_parameters()) {
        visit(row.quantity.name.data(), contact.*row.value, row.quantity.dimension);
    }
    visit("critical_opening", contact.critical_opening, Dimension::length);
    visit("critical_sliding", contact.critical_sliding, Dimension::length);
    visit("ultimate_opening", contact.ultimate_opening, Dimension::length);
}
/// Visits every property of a phase once.
template <class AnyPhase, class Visit>
void visit_phase(AnyPhase& phase, const Visit& visit) {
    visit("young_modulus", phase.young_modulus, Dimension::stress);
    visit("poisson_ratio", phase.poisson_ratio, Dimension::one);
    visit("density", phase.density, Dimension::density);
}

/// Visits every attribute of /run once, for writing and reading alike.
template <class Header, class Visit>
void visit_header(Header& h, Visit&& visit) {
    visit("test", h.test);
    visit("material", h.material);
    visit("contact_law", h.contact_law);
    visit("coupling", h.coupling);
    visit("fracture_energy_choice", h.fracture_energy_choice);
    visit("young_modulus", h.rock.young_modulus, Dimension::stress);
    visit("poisson_ratio", h.rock.poisson_ratio, Dimension::one);
    visit("density", h.rock.density, Dimension::density);
    visit("mode_i_toughness", h.rock.mode_i_toughness, Dimension::toughness);
    visit("mode_ii_toughness", h.rock.mode_ii_toughness, Dimension::toughness);
    visit("tensile_strength", h.rock.tensile_strength, Dimension::stress);
    visit_contact(h.contact, visit);
    visit("platen_friction", h.platen_friction, Dimension::angle);
    visit("confining_pressure", h.confining_pressure, Dimension::stress);
    visit("rate", h.rate);
    visit("rate_tolerance", h.rate_tolerance, Dimension::one);
    visit("rate_share", h.rate_share, Dimension::one);
    visit("platen_speed", h.platen_speed, Dimension::speed);
    visit("damping", h.damping, Dimension::one);
    visit("damping_form", h.damping_form);
    visit("peak_drop", h.peak_drop, Dimension::one);
    visit("max_strain", h.max_strain, Dimension::one);
    visit("mass_scaling", h.mass_scaling);
    visit("mass_scaling_factor", h.mass_scaling_factor, Dimension::one);
    visit("added_mass", h.added_mass, Dimension::one);
    visit("stable_time_step", h.stable_time_step, Dimension::time);
    visit("time_step", h.time_step, Dimension::time);
    visit("stop_reason", h.stop_reason);
    visit("steps", h.steps);
    visit("integrations", h.integrations);
    visit("isotropic_end_time", h.isotropic_end_time, Dimension::time);
    visit("peak_axial_stress", h.peak_axial_stress, Dimension::stress);
    visit("energy_scale", h.energy_scale, Dimension::energy);
    visit("energy_balance_error", h.energy_balance_error, Dimension::one);
    visit("platen_force_difference", h.platen_force_difference, Dimension::one);
    visit("confinement_mean", h.confinement_mean, Dimension::stress);
    visit("confinement_deviation", h.confinement_deviation, Dimension::stress);
    visit("damping_share", h.damping_share, Dimension::one);
    visit("damping_load", h.damping_load, Dimension::one);
}

struct HeaderWriter {
    H5Output& file;
    void operator()(const char* name, const std::string& value) const { file.attribute(schema::run_group, name, value); }
    void operator()(const char* name, const std::int64_t& value) const { file.attribute(schema::run_group, name, value); }
    void operator()(const char* name, const double& value, Dimension dimension) const {
        file.quantity(schema::run_group, name, value, si_unit(dimension));
    }
};

struct HeaderReader {
    const H5Input& file;
    void operator()(const char* name, std::string& value) const { value = file.attribute<std::string>(schema::run_group, name); }
    void operator()(const char* name, std::int64_t& value) const {
        value = file.attribute<std::int64_t>(schema::run_group, name);
    }
    void operator()(const char* name, double& value, Dimension /*dimension*/) const {
        value = file.attribute<double>(schema::run_group, name);
        if (!std::isfinite(value)) {
            throw InputError(fmt::format("{}: attribute {} of {} is {}; a finite number is needed", file.name(), name,
                                         schema::run_group, value));
        }
    }
};

void write_header(H5Output& file, const RunHeader& header) {
    file.create_group(schema::run_group);
    file.attribute(schema::run_group, "plane", std::string(name_of(header.plane)));
    file.attribute(schema::run_group, "crack_event", std::string(name_of(header.crack_event)));
    visit_header(header, HeaderWriter{file});
}

/// Properties of phases or classes as datasets of a group, one a property.
class PropertyTable {
public:
    void operator()(const char* name, const double& value, Dimension dimension) const {
        if (columns_.find(name) == columns_.end()) order_.emplace_back(name, dimension);
        columns_[name].push_back(value);
    }
    void write(H5Output& file, const std::string& group, const std::vector<std::string>& names) const {
        file.create_group(group);
        file.attribute(group, "names", names);
        for (const auto& [name, dimension] : order_) {
            file.write<double>(group + "/" + name, std::span<const double>(columns_[name]), {names.size()}, si_unit(dimension),
                               "by index of the attribute names of the group");
        }
    }

private:
    mutable std::vector<std::pair<std::string, Dimension>> order_;
    mutable std::map<std::string, std::vector<double>> columns_;
};

void write_fabric(H5Output& file, const Fabric& fabric, const std::vector<std::string>& phase_names) {
    const PropertyTable phases;
    for (const Phase& phase : fabric.phases) visit_phase(phase, phases);
    phases.write(file, schema::phases_group, phase_names);
    const PropertyTable classes;
    for (const ContactParameters& contact : fabric.contacts) visit_contact(contact, classes);
    classes.write(file, schema::classes_group, contact_class_names(phase_names));
}

/// Row `row` of a group of properties.
struct PropertyReader {
    const H5Input& file;
    std::string group;
    std::size_t rows, row;
    void operator()(const char* name, double& value, Dimension /*dimension*/) const {
        value = file.read<double>(group + "/" + name, {rows})[row];
        if (!std::isfinite(value)) {
            throw InputError(
                fmt::format("{}: {}/{} has the value {}; a finite number is needed", file.name(), group, name, value));
        }
    }
};

Fabric read_fabric(const H5Input& file) {
    const std::size_t n_phases = rows_of(file, std::string(schema::phases_group) + "/young_modulus");
    if (n_phases < 1 || n_phases > max_phases) {
        throw InputError(
            fmt::format("{}: {} has {} phases; 1 to {} are needed", file.name(), schema::phases_group, n_phases, max_phases));
    }
    Fabric fabric{std::vector<Phase>(n_phases), std::vector<ContactParameters>(n_contact_classes(n_phases))};
    for (std::size_t i = 0; i < fabric.phases.size(); ++i) {
        visit_phase(fabric.phases[i], PropertyReader{file, schema::phases_group, fabric.phases.size(), i});
    }
    for (std::size_t i = 0; i < fabric.contacts.size(); ++i) {
        visit_contact(fabric.contacts[i], PropertyReader{file, schema::classes_group, fabric.contacts.size(), i});
    }
    return fabric;
}

CrackEvent read_crack_event(const H5Input& file) {
    const auto name = file.attribute<std::string>(schema::run_group, "crack_event");
    const auto* const event =
        std::find_if(all_crack_events.begin(), all_crack_events.end(), [&](CrackEvent e) { return name_of(e) == name; });
    if (event == all_crack_events.end()) {
        throw InputError(fmt::format("{}: attribute crack_event of {} is \"{}\"; failed, half-damaged or broken is needed",
                                     file.name(), schema::run_group, name));
    }
    return *event;
}

RunHeader read_header(const H5Input& file) {
    RunHeader header;
    const auto plane = file.attribute<std::string>(schema::run_group, "plane");
    header.plane = plane == "stress" ? PlaneCondition::stress : PlaneCondition::strain;
    header.crack_event = read_crack_event(file);
    visit_header(header, HeaderReader{file});
    header.fabric = read_fabric(file);
    if (header.time_step <= 0 || header.steps < 0) {
        throw InputError(
            fmt::format("{}: time_step and steps of {} are {} and {}; a positive step and no negative number are needed",
                        file.name(), schema::run_group, header.time_step, header.steps));
    }
    return header;
}

std::string history_path(std::size_t column) {
    return std::string(schema::history_group) + "/" + std::string(history_datasets[column].name);
}

template <class T, std::size_t n>
std::span<const T> flat(const std::vector<std::array<T, n>>& rows) {
    return {rows.empty() ? nullptr : rows.front().data(), rows.size() * n};
}

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

template <class T>
std::vector<T> column_of(const std::vector<Crack>& cracks, T (*get)(const Crack&)) {
    std::vector<T> column(cracks.size());
    std::transform(cracks.begin(), cracks.end(), column.begin(), get);
    return column;
}

template <class T>
void write_column(H5Output& file, const schema::Dataset& dataset, const std::vector<T>& values, std::size_t width = 1) {
    const Extents extents = width == 1 ? Extents{values.size()} : Extents{values.size() / width, width};
    file.write<T>(dataset.path, std::span<const T>(values), extents, dataset.unit, dataset.description);
}

/// Columns of /cracks that are NaN where a point has not come so far.
struct MomentColumns {
    CrackMoment Crack::*moment;
    std::array<schema::Dataset, 3> datasets;  ///< of time, opening and sliding
};
constexpr std::array moment_columns{
    MomentColumns{&Crack::damaged_10,
                  {schema::crack_time_damaged_10, schema::crack_opening_damaged_10, schema::crack_sliding_damaged_10}},
    MomentColumns{&Crack::damaged_50,
                  {schema::crack_time_damaged_50, schema::crack_opening_damaged_50, schema::crack_sliding_damaged_50}},
    MomentColumns{&Crack::broken, {schema::crack_time_broken, schema::crack_opening_broken, schema::crack_sliding_broken}},
    MomentColumns{&Crack::separated,
                  {schema::crack_time_separated, schema::crack_opening_separated, schema::crack_sliding_separated}}};

/// Visits each of these columns once: its dataset, and a function that gives its entry of a crack.
template <class Visit>
void visit_moments(const Visit& visit) {
    constexpr std::array values{&CrackMoment::time, &CrackMoment::opening, &CrackMoment::sliding};
    for (const MomentColumns& columns : moment_columns) {
        for (std::size_t i = 0; i < values.size(); ++i) {
            visit(
                columns.datasets[i],
                [ moment = columns.moment, value = values[i] ](auto& crack) -> auto& { return crack.*moment.*value; });
        }
    }
}

void write_cracks(H5Output& file, const std::vector<Crack>& cracks) {
    file.create_group(schema::cracks_group);
    write_column(file, schema::crack_time, column_of<double>(cracks, [](const Crack& c) { return c.time; }));
    write_column(file, schema::crack_step, column_of<std::int64_t>(cracks, [](const Crack& c) { return c.step; }));
    write_column(file, schema::crack_contact, column_of<std::int32_t>(cracks, [](const Crack& c) { return c.contact; }));
    write_column(file, schema::crack_point, column_of<std::uint8_t>(cracks, [](const Crack& c) { return c.point; }));
    write_column(file, schema::crack_mode,
                 column_of<std::uint8_t>(cracks, [](const Crack& c) { return static_cast<std::uint8_t>(c.mode); }));
    file.attribute(schema::crack_mode.path, "names", std::vector<std::string>{"tensile", "shear"});
    write_column(file, schema::crack_mode_angle, column_of<double>(cracks, [](const Crack& c) { return c.mode_angle; }));
    std::vector<double> position;
    for (const Crack& crack : cracks) position.insert(position.end(), crack.position.begin(), crack.position.end());
    write_column(file, schema::crack_position, position, 2);
    write_column(file, schema::crack_orientation, column_of<double>(cracks, [](const Crack& c) { return c.orientation; }));
    write_column(file, schema::crack_length, column_of<double>(cracks, [](const Crack& c) { return c.length; }));
    write_column(file, schema::crack_opening, column_of<double>(cracks, [](const Crack& c) { return c.opening; }));
    write_column(file, schema::crack_sliding, column_of<double>(cracks, [](const Crack& c) { return c.sliding; }));
    write_column(file, schema::crack_energy, column_of<double>(cracks, [](const Crack& c) { return c.energy_released; }));
    visit_moments([&](const schema::Dataset& dataset, const auto& value) {
        std::vector<double> values;
        for (const Crack& crack : cracks) values.push_back(value(crack));
        write_column(file, dataset, values);
    });
}

void read_moments(const H5Input& file, std::vector<Crack>& cracks) {
    visit_moments([&](const schema::Dataset& dataset, const auto& value) {
        const std::vector<double> values = file.read<double>(dataset.path, {cracks.size()});
        require_all(file, dataset.path, values, "a finite number or NaN", [](double v) { return !std::isinf(v); });
        for (std::size_t i = 0; i < cracks.size(); ++i) value(cracks[i]) = values[i];
    });
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
    const bool has_fabric = !header.fabric.phases.empty();
    write_fabric(state_->file,
                 has_fabric ? header.fabric : uniform_fabric(header.rock, header.contact, specimen.phase_names.size()),
                 specimen.phase_names);
    state_->file.create_group(schema::history_group);
    state_->file.create_group(schema::frames_group);
    state_->file.flush();
}
RunWriter::~RunWriter() = default;

void RunWriter::append_history(const History& history) {
    const std::size_t n = history.size() - state_->rows;
    if (n == 0 && state_->rows > 0) return;
    for (std::size_t i = 0; i < n_history_columns; ++i) {
        const std::span<const double> rows(history.columns[i].data() + state_->rows, n);
        state_->file.append<double>(history_path(i), rows, {n}, si_unit(history_datasets[i].dimension),
                                    history_datasets[i].description);
    }
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
    return specimen;
}
const H5Input& RunReader::file() const { return state_->file; }

History read_history(const H5Input& file) {
    History history;
    const std::size_t rows = rows_of(file, history_path(0));
    for (std::size_t i = 0; i < n_history_columns; ++i) history.columns[i] = read_finite(file, history_path(i), {rows});
    const std::vector<double>& time = history[HistoryColumn::time];
    if (!std::is_sorted(time.begin(), time.end())) {
        throw InputError(fmt::format("{}: the times of {} do not ascend", file.name(), history_path(0)));
    }
    return history;
}

History RunReader::history() const {
    History history = read_history(state_->file);
    if (history.size() == 0) throw InputError(fmt::format("{}: {} has no rows", name(), schema::history_group));
    return history;
}

std::vector<Crack> RunReader::cracks() const {
    const H5Input& f = state_->file;
    const std::size_t n = rows_of(f, schema::crack_time.path);
    const auto numbers = [&](const schema::Dataset& dataset) { return read_finite(f, dataset.path, {n}); };
    const auto below = [&]<class T>(const schema::Dataset& dataset, std::size_t limit, T /*type*/) {
        std::vector<T> values = f.read<T>(dataset.path, {n});
        require_all(f, dataset.path, values, fmt::format("0 to {}", static_cast<double>(limit) - 1).c_str(),
                    [limit](T value) { return value >= 0 && static_cast<std::size_t>(value) < limit; });
        return values;
    };
    const std::size_t n_contacts = rows_of(f, schema::contact_nodes.path);
    const std::vector<double> time = numbers(schema::crack_time);
    const auto step = f.read<std::int64_t>(schema::crack_step.path, {n});
    const auto contact = below(schema::crack_contact, n_contacts, std::int32_t{});
    const auto point = below(schema::crack_point, 2, std::uint8_t{});
    const auto mode = below(schema::crack_mode, 2, std::uint8_t{});
    const std::vector<double> mode_angle = numbers(schema::crack_mode_angle);
    const std::vector<double> position = read_finite(f, schema::crack_position.path, {n, 2});
    const std::vector<double> orientation = numbers(schema::crack_orientation);
    const std::vector<double> length = numbers(schema::crack_length);
    const std::vector<double> opening = numbers(schema::crack_opening);
    const std::vector<double> sliding = numbers(schema::crack_sliding);
    const std::vector<double> energy = numbers(schema::crack_energy);
    std::vector<Crack> cracks(n);
    for (std::size_t i = 0; i < n; ++i) {
        cracks[i] = {time[i],
                     step[i],
                     contact[i],
                     point[i],
                     static_cast<CrackMode>(mode[i]),
                     mode_angle[i],
                     {position[2 * i], position[2 * i + 1]},
                     orientation[i],
                     length[i],
                     opening[i],
                     sliding[i],
                     energy[i]};
    }
    read_moments(f, cracks);
    return cracks;
}

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
