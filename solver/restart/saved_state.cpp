#include "solver/restart/saved_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <map>
#include <span>
#include <utility>

#include "share/base/error.hpp"
#include "share/base/sha256.hpp"
#include "share/file/h5_file.hpp"
#include "share/file/schema.hpp"
#include "solver/detection/active_contacts.hpp"
#include "solver/detection/pair_exchange.hpp"
#include "solver/restart/checkpoint.hpp"
#include "solver/restart/whole_state.hpp"
#include "solver/step/mass_scaling.hpp"

namespace graincrack {
namespace {

// The content of what a state holds, each as numbers in a fixed order; every one of them is exact as float64.
template <class Value, class Act>
requires std::is_arithmetic_v<std::remove_const_t<Value>>
void visit_members(Value& value, Act&& act) { act(value); }
template <class Act, class... Members>
void visit_all(Act&& act, Members&... content) {
    (visit_members(content, act), ...);
}
/// True if a type is `Of`, constant or not.
template <class Type, class Of>
concept Is = std::is_same_v<std::remove_const_t<Type>, Of>;

template <Is<Vector2> T, class Act>
void visit_members(T& v, Act&& act) {
    visit_all(act, v.x, v.y);
}
template <Is<ContactHistory> T, class Act>
void visit_members(T& h, Act&& act) {
    visit_all(act, h.motion.opening, h.motion.sliding, h.max_displacement, h.largest_open, h.largest_slid, h.slip, h.integrity,
              h.friction_fraction, h.bridge, h.failed_open, h.failed_closed, h.separated);
    act(h.first_mode);
}
template <Is<NodeEdgeContact> T, class Act>
void visit_members(T& t, Act&& act) {
    visit_all(act, t.active, t.near_first, t.area, t.initial_overlap, t.overlap, t.elastic_slip, t.release_correction);
}
template <Is<CandidatePair> T, class Act>
void visit_members(T& p, Act&& act) {
    visit_all(act, p.node, p.edge);
}
template <Is<ThermalState> T, class Act>
void visit_members(T& t, Act&& act) {
    visit_all(act, t.temperature, t.force, t.work);
}
template <Is<PlatenPoint> T, class Act>
void visit_members(T& p, Act&& act) {
    visit_all(act, p.node, p.platen, p.tributary, p.gap, p.anchor, p.shear, p.on_boundary);
}
/// Sums: doubles alone.
template <class T, class Act>
requires SumOfMembers<std::remove_const_t<T>>
void visit_members(T& sums, Act&& act) {
    auto values = std::bit_cast<std::array<double, sizeof(T) / sizeof(double)>>(sums);
    for (double& value : values) act(value);
    if constexpr (!std::is_const_v<T>) sums = std::bit_cast<T>(values);
}

/// Continues the temperature that a state has.
void resume_temperature(State& s, NamedNumbers& amplitudes) {
    if (s.thermal.empty()) return;
    s.loading.temperature = s.thermal.front().temperature;
    if (std::find(amplitudes.names.begin(), amplitudes.names.end(), "temperature") != amplitudes.names.end()) return;
    amplitudes.names.emplace_back("temperature");
    amplitudes.values.push_back(s.loading.temperature);
}

/// Every single number of a state.
template <class AnyState, class Visit>
void visit_numbers(AnyState& s, Visit&& visit) {
    visit("step", s.step);
    visit("time", s.time);
    visit("origin_step", s.origin_step);
    visit("origin_time", s.origin_time);
    visit("next_list_update", s.contact_pairs.next_update);
    visit("wants_rebuild", s.contact_pairs.wants_rebuild);
    visit("travel_since_rebuild", s.contact_pairs.travel_since_rebuild);
    visit("detection_interval", s.contact_pairs.detection_interval);
    visit("platen_displacement_bottom", s.loading.platen_displacement[bottom_platen]);
    visit("platen_displacement_top", s.loading.platen_displacement[top_platen]);
    visit("platen_increment_bottom", s.loading.increment_before[bottom_platen]);
    visit("platen_increment_top", s.loading.increment_before[top_platen]);
    visit("mean_damping_power", s.damping_load.damping_power);
    visit("mean_platen_power", s.damping_load.platen_power);
    visit("mean_time", s.damping_load.time);
}

template <class Item>
std::size_t width_of() {
    std::size_t width = 0;
    Item item{};
    visit_members(item, [&](auto& /*member*/) { ++width; });
    return width;
}

/// SHA-256 of the content of a state, in the order in which it is written and read.
class ContentHash {
public:
    template <class Value>
    void add(const std::string& name, const Value& value) {
        hash_.add(name);
        add_value(value);
    }
    std::string hex() { return hash_.hex(); }

private:
    void add_value(const std::string& text) { hash_.add(text); }
    template <class Value>
    requires std::is_arithmetic_v<Value>
    void add_value(Value value) { hash_.add(&value, sizeof value); }
    void add_value(const std::vector<double>& values) { hash_.add(values.data(), values.size() * sizeof(double)); }
    template <class Value>
    void add_value(const std::vector<Value>& values) {
        for (const Value& value : values) add_value(value);
    }

    Sha256 hash_;
};

constexpr const char* group = schema::state_group;
constexpr const char* digest_name = "digest";

class StateWriter {
public:
    explicit StateWriter(H5Output& file) : file_(file) { file.create_group(group); }
    template <class Value>
    void attribute(const std::string& name, const Value& value) {
        file_.attribute(group, name, value);
        hash_.add(name, value);
    }
    template <class Value>
    void number(const std::string& name, Value value) {
        attribute(name, static_cast<double>(value));
    }
    template <class Item>
    void array(const std::string& name, const std::vector<Item>& items) {
        std::vector<double> numbers;
        for (const Item& item : items) {
            visit_members(item, [&](const auto& member) { numbers.push_back(static_cast<double>(member)); });
        }
        file_.write<double>(std::string(group) + "/" + name, std::span<const double>(numbers), {items.size(), width_of<Item>()},
                            "1", "of the solver's state, in its own order, SI");
        hash_.add(name, numbers);
    }
    void array(const std::string& name, const PointHistories& points) {
        std::vector<ContactHistory> histories;
        for (std::size_t point = 0; point < points.size(); ++point) histories.push_back(points[point]);
        array(name, histories);
    }
    void finish() { file_.attribute(group, digest_name, hash_.hex()); }

private:
    H5Output& file_;
    ContentHash hash_;
};

class StateReader {
public:
    explicit StateReader(const H5Input& file) : file_(file) {}
    template <class Value>
    void attribute(const std::string& name, Value& value) {
        value = file_.attribute<Value>(group, name);
        hash_.add(name, value);
    }
    template <class Value>
    void number(const std::string& name, Value& value) {
        double number = 0;
        attribute(name, number);
        value = static_cast<Value>(number);
    }
    /// An array that a new state has keeps its number of items.
    template <class Item>
    void array(const std::string& name, std::vector<Item>& items) {
        const std::size_t width = width_of<Item>();
        const std::vector<double> numbers = file_.read<double>(std::string(group) + "/" + name);
        const std::size_t n = numbers.size() / width;
        if (numbers.size() != n * width || (!items.empty() && items.size() != n)) {
            throw InputError(
                fmt::format("{}: {}/{} has not the size of this version of graincrack-solve: the state is of another "
                            "version, or damaged",
                            file_.name(), group, name));
        }
        hash_.add(name, numbers);
        items.resize(n);
        std::size_t at = 0;
        for (Item& item : items) {
            visit_members(item, [&](auto& member) { member = static_cast<std::decay_t<decltype(member)>>(numbers[at++]); });
        }
    }
    void array(const std::string& name, PointHistories& points) {
        std::vector<ContactHistory> histories(points.size());
        array(name, histories);
        for (std::size_t point = 0; point < histories.size(); ++point) {
            if (histories[point] != ContactHistory{}) points.of(point) = histories[point];
        }
    }
    /// \throws InputError if the content is not that which was written
    void finish() {
        if (file_.attribute<std::string>(group, digest_name) != hash_.hex()) {
            throw InputError(
                fmt::format("{}: {} has not the content of which it has the digest: the file is damaged", file_.name(), group));
        }
    }

private:
    const H5Input& file_;
    ContentHash hash_;
};

/// The content of /state, in its order.
template <class Io, class AnyState, class Loading, class Error>
void visit_content(Io& io, AnyState& state, Loading& loading, Error& energy_balance_error) {
    visit_numbers(state, [&](const char* name, auto& value) { io.number(name, value); });
    visit_arrays(state, [&](const char* name, ArrayOf /*of*/, auto& items) {
        if (name != not_saved) io.array(name, items);
    });
    io.attribute("amplitudes", loading.boundary_conditions.names);
    io.attribute("amplitude_values", loading.boundary_conditions.values);
    io.attribute("platen_speed", loading.platen_speed);
    io.attribute("mean_compression", loading.mean_compression);
    io.attribute("stages", loading.progress.names);
    io.attribute("stage_values", loading.progress.values);
    io.attribute("stages_ended_by", loading.stages_end_by);
    io.attribute("energy_balance_error", energy_balance_error);
}

/// The position of the frames of a checkpoint.
template <class Io, class Frames>
void visit_frames(Io& io, Frames& frames) {
    io.attribute("next_frame", frames.next);
    io.attribute("frame_interval", frames.interval);
    io.attribute("regular_frames", frames.regular);
    std::vector<std::int64_t> roles;
    for (const FrameRole role : frames.roles) roles.push_back(static_cast<std::int64_t>(role));
    io.attribute("frame_roles", roles);
    frames.roles.clear();
    for (const std::int64_t role : roles) frames.roles.push_back(static_cast<FrameRole>(role));
}

bool same_mesh(const Specimen& a, const Specimen& b) {
    return a.node_position == b.node_position && a.element_nodes == b.element_nodes && a.contact_nodes == b.contact_nodes &&
           a.element_grain == b.element_grain && a.grain_phase == b.grain_phase;
}

/// \throws InputError where a run cannot start from a state as asked
void require_same(const RunReader& run, const Specimen& specimen, const SimulationRequest& request, const Setup& setup) {
    const RunHeader& old = run.header();
    const auto refuse = [&](const std::string& what) { throw InputError(run.name() + ": " + what); };
    if (!run.file().has(group)) refuse("has no saved state to start from; make it with --save-state or --checkpoint-every");
    if (!run.file().has_attribute(group, digest_name)) {
        refuse("has a saved state of another version of graincrack-solve; make it again with this one");
    }
    if (!same_mesh(run.specimen(), specimen)) refuse("is a run of another specimen; give the one it was made from, or itself");
    const std::vector<Phase>& phases = setup.material.fabric.phases;
    if (old.plane != request.plane ||
        old.fabric.phases != (old.fabric.feels_temperature() ? phases : without_expansion(phases))) {
        refuse("has other phases, another rock or another plane condition; they must be the same");
    }
    if (old.contact_law != name_of(request.law)) {
        refuse(fmt::format("has the contact law {}, not {}, whose history variables differ; give --contact-law {}",
                           old.contact_law, name_of(request.law), old.contact_law));
    }
    if (old.mass_scaling_factor != setup.mass_scaling_factor) {
        refuse(fmt::format("has the mass-scaling factor {0}, not {1}; give {2}", old.mass_scaling_factor,
                           setup.mass_scaling_factor,
                           old.mass_scaling_factor > 0
                               ? fmt::format("--mass-scaling selective --mass-scaling-factor {}", old.mass_scaling_factor)
                               : "--mass-scaling none"));
    }
}

/// Points of the new platens take over what old ones remember.
void take_over_platens(const std::string& name, const std::vector<PlatenPoint>& old, std::vector<PlatenPoint>& points) {
    std::map<std::pair<std::int32_t, std::int32_t>, const PlatenPoint*> found;
    std::map<std::int32_t, double> moved;  // platens that were placed elsewhere: what their gaps are wider by
    for (const PlatenPoint& point : old) found[{point.node, point.platen}] = &point;
    std::size_t taken = 0;
    for (PlatenPoint& point : points) {
        if (const auto at = found.find({point.node, point.platen}); at != found.end()) {
            moved[point.platen] = at->second->gap - point.gap;
            point.gap = at->second->gap;
            point.anchor = at->second->anchor;
            point.shear = at->second->shear;
            ++taken;
        }
    }
    for (PlatenPoint& point : points) {
        if (found.count({point.node, point.platen}) == 0) point.gap += moved[point.platen];
    }
    if (taken < old.size()) {
        throw InputError(name +
                         ": has platens that this program lacks; give it the same [platens], with a max_strain no smaller");
    }
}

/// Other contact values change what is stored: that is work from outside.
void book_change(const RunHeader& old, const Setup& setup, State& s) {
    const auto& laws = all_contact_laws();
    const auto law = std::find_if(laws.begin(), laws.end(), [&](const LawDescription& l) { return l.name == old.contact_law; });
    const ContactLaws before = make_contact_laws(old.fabric.contacts, law->variant);
    const double change =
        stored_in_contacts(setup.assemblage, setup.parameters.laws, s) - stored_in_contacts(setup.assemblage, before, s);
    s.node_sums.front().load_work += change;
}

}  // namespace

void write_saved_state(H5Output& file, const State& state, const StageControllerState& loading, double energy_balance_error,
                       std::optional<FrameProgress> frames) {
    StateWriter writer(file);
    visit_content(writer, state, loading, energy_balance_error);
    if (frames) visit_frames(writer, *frames);
    writer.finish();
}

SavedState read_saved_state(const std::string& path, const Specimen& specimen, const SimulationRequest& request,
                            const Setup& setup) {
    const RunReader run(path);
    require_same(run, specimen, request, setup);
    SavedState saved;
    State& s = saved.state;
    s = make_state(setup.assemblage, setup.boundary, specimen);
    std::vector<PlatenPoint> platen_points = std::move(s.platen_points);
    s.platen_points.clear();
    if (run.file().has(std::string(group) + "/thermal")) take_temperature(setup.assemblage, s);
    if (run.file().has(std::string(group) + "/worn")) s.worn.resize(setup.assemblage.n_nodes());
    StateReader reader(run.file());
    visit_content(reader, s, saved.loading, saved.energy_balance_error);
    if (is_checkpoint(run)) visit_frames(reader, saved.frames);
    reader.finish();
    resume_temperature(s, saved.loading.boundary_conditions);
    group_pairs(s.contact_pairs);
    group_watched(setup.assemblage, s.contact_pairs);
    take_over_platens(run.name(), s.platen_points, platen_points);
    s.platen_points = platen_points;
    complete_cluster_state(setup.assemblage, setup.parameters.mass_scaling, s);
    keep_own_pairs(setup.assemblage, s.contact_pairs);
    find_ghosts(setup.assemblage, s);
    resume_active(setup.assemblage, setup.parameters.laws, s.contact_pairs);
    const RunHeader& old = run.header();
    if (old.time_step != setup.parameters.time_step) {
        s.origin_step = s.step;
        s.origin_time = s.time;
    }
    book_change(old, setup, s);
    saved.cracks = run.cracks();
    saved.energy_scale = old.energy_scale;
    return saved;
}

}  // namespace graincrack
