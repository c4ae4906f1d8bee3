#include "solver/restart/saved_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <span>

#include "share/base/error.hpp"
#include "share/file/h5_file.hpp"
#include "share/file/schema.hpp"
#include "solver/detection/active_contacts.hpp"
#include "solver/detection/pair_exchange.hpp"
#include "solver/restart/state_check.hpp"
#include "solver/restart/whole_state.hpp"
#include "solver/step/contact_energy.hpp"
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
/// Whether a type is `Of`, constant or not.
template <class Type, class Of>
concept Is = std::is_same_v<std::remove_const_t<Type>, Of>;

template <Is<Vector2> T, class Act>
void visit_members(T& v, Act&& act) {
    visit_all(act, v.x, v.y);
}
template <Is<ContactHistory> T, class Act>
void visit_members(T& h, Act&& act) {
    visit_all(act, h.motion.opening, h.motion.sliding, h.max_displacement, h.largest_open, h.largest_slid, h.slip, h.integrity,
              h.friction_share, h.failed_open, h.failed_closed, h.separated);
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
template <Is<PlatenPoint> T, class Act>
void visit_members(T& p, Act&& act) {
    visit_all(act, p.node, p.platen, p.tributary, p.gap, p.anchor, p.shear, p.on_boundary);
}
template <Is<NodeSums> T, class Act>
void visit_members(T& s, Act&& act) {
    visit_all(act, s.damping, s.platen_work, s.load_work, s.reaction_work, s.platen_friction);
}
template <Is<ContactSums> T, class Act>
void visit_members(T& s, Act&& act) {
    visit_all(act, s.fracture_tension, s.fracture_shear, s.friction, s.non_conservative_work);
}
template <Is<ClusterSums> T, class Act>
void visit_members(T& s, Act&& act) {
    visit_all(act, s.damping, s.platen_loss, s.platen_work);
}

/// Every array of a state that the next step needs and cannot find anew.
template <class AnyState, class Visit>
void visit_arrays(AnyState& s, Visit&& visit) {
    visit("displacement", s.displacement);
    visit("velocity", s.velocity);
    visit("last_force", s.last_force);
    visit("mean_displacement", s.damping_load.mean_displacement);
    visit("contact_slots", s.contact_force);
    visit("opening", s.opening);
    visit("sliding", s.sliding);
    visit("integrity", s.integrity);
    visit("slip", s.slip);
    visit("failed", s.failed);
    visit("residual", s.residual);
    visit("fracture_energy", s.fracture_energy);
    visit("platen_points", s.platen_points);
    visit("node_sums", s.node_sums);
    visit("contact_sums", s.contact_sums);
    visit("debonded", s.contact_pairs.debonded);
    visit("released", s.contact_pairs.released);
    visit("candidate_pairs", s.contact_pairs.pairs);
    visit("node_edge_contacts", s.contact_pairs.contacts);
    visit("pair_forces", s.contact_pairs.forces);
    visit("watched_pairs", s.contact_pairs.watched);
    visit("pair_friction", s.contact_pairs.friction);
    visit("displacement_at_search", s.contact_pairs.displacement_at_search);
    visit("cluster_load", s.contact_pairs.cluster_load);
    visit("active_pairs", s.contact_pairs.active.pair);
    visit("active_counts", s.contact_pairs.active.count);
    visit("next_mark", s.next_mark);
    visit("cluster_near_platen", s.clusters.near_platen);
    visit("cluster_energies", s.clusters.sums);
}

/// And every single number.
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

std::string path_of(const std::string& name) { return std::string(schema::state_group) + "/" + name; }

template <class Item>
std::size_t width_of() {
    std::size_t width = 0;
    Item item{};
    visit_members(item, [&](auto& /*member*/) { ++width; });
    return width;
}

template <class Item>
void write_array(H5Output& file, const std::string& name, const std::vector<Item>& items) {
    std::vector<double> numbers;
    for (const Item& item : items) {
        visit_members(item, [&](const auto& member) { numbers.push_back(static_cast<double>(member)); });
    }
    file.write<double>(path_of(name), std::span<const double>(numbers), {items.size(), width_of<Item>()}, "1",
                       "of the solver's state, in its own order, SI");
}

/// A number of a file as a member of a state. \throws InputError if it is not finite, or none that the member can have
template <class Member>
void take(double number, const std::string& where, Member& member) {
    using Value = std::decay_t<Member>;
    bool fits = std::isfinite(number);
    if constexpr (std::is_same_v<Value, bool> || std::is_enum_v<Value>) {
        fits = number == 0 || number == 1;
    } else if constexpr (std::is_integral_v<Value>) {
        constexpr double exact = 9007199254740992;  // 2^53: integers beyond it are not exact as float64
        fits = fits && number == std::floor(number) && std::abs(number) <= exact &&
               number >= static_cast<double>(std::numeric_limits<Value>::lowest()) &&
               number <= static_cast<double>(std::numeric_limits<Value>::max());
    }
    if (!fits) {
        throw InputError(fmt::format("{} has the value {}, which is outside its range: the file is damaged", where, number));
    }
    member = static_cast<Value>(number);
}

/// \param rows that the array must have, unless it is a list of any length
template <class Item>
void read_array(const H5Input& file, const std::string& name, std::optional<std::size_t> rows, std::vector<Item>& items) {
    const std::string path = path_of(name);
    const Extents extents = file.extents(path);
    const std::size_t width = width_of<Item>();
    if (extents.size() != 2 || extents[1] != width) {
        throw InputError(fmt::format("{}: {} has not {} numbers a row: it is of another version of graincrack-solve", file.name(),
                                     path, width));
    }
    if (rows && extents[0] != *rows) {
        throw InputError(fmt::format("{}: {} has {} rows, not {}: the file is damaged", file.name(), path, extents[0], *rows));
    }
    const std::vector<double> numbers = file.read<double>(path);
    const std::string where = file.name() + ": " + path;
    items.resize(extents[0]);
    std::size_t at = 0;
    for (Item& item : items) visit_members(item, [&](auto& member) { take(numbers[at++], where, member); });
}

bool same_mesh(const Specimen& a, const Specimen& b) {
    return a.node_position == b.node_position && a.element_nodes == b.element_nodes && a.contact_nodes == b.contact_nodes &&
           a.element_grain == b.element_grain && a.grain_phase == b.grain_phase;
}

/// Arrays that have as many rows as their lists are long; all others have those that they have in a new state.
bool is_list(std::string_view name) {
    constexpr std::array names{"platen_points", "candidate_pairs",  "node_edge_contacts", "pair_forces",
                               "watched_pairs", "active_pairs",     "active_counts",      "displacement_at_search",
                               "cluster_load",  "cluster_energies", "cluster_near_platen"};
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// \throws InputError where a run cannot start from a state as asked
void require_same(const RunReader& run, const Specimen& specimen, const SimulationRequest& request, const Setup& setup) {
    const RunHeader& old = run.header();
    const auto refuse = [&](const std::string& what) { throw InputError(run.name() + ": " + what); };
    if (!run.file().has(schema::state_group)) {
        refuse("has no saved state to start from; make it with --save-state or --checkpoint-every");
    }
    if (!same_mesh(run.specimen(), specimen)) refuse("is a run of another specimen; give the one it was made from, or itself");
    if (old.plane != request.plane || old.fabric.phases != setup.fabric.phases) {
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
    for (const PlatenPoint& point : old) found[{point.node, point.platen}] = &point;
    std::size_t taken = 0;
    for (PlatenPoint& point : points) {
        if (const auto at = found.find({point.node, point.platen}); at != found.end()) {
            point.anchor = at->second->anchor;
            point.shear = at->second->shear;
            ++taken;
        }
    }
    if (taken < old.size()) {
        throw InputError(name +
                         ": has platens that this program lacks; give it the same [platens], with a max_strain no smaller");
    }
}

/// Other contact values change what is stored: that is work from outside.
void book_change(const std::string& name, const RunHeader& old, const Setup& setup, State& s) {
    const auto& laws = all_contact_laws();
    const auto law = std::find_if(laws.begin(), laws.end(), [&](const LawDescription& l) { return l.name == old.contact_law; });
    const ContactLaws before = make_contact_laws(old.fabric.contacts, law->variant);
    const double change =
        stored_in_contacts(setup.assemblage, setup.parameters.laws, s) - stored_in_contacts(setup.assemblage, before, s);
    if (!std::isfinite(change)) {
        throw InputError(name + ": its contact values store no energy that is a number: the file is damaged");
    }
    s.node_sums.front().load_work += change;
}

StageControllerState read_loading(const H5Input& file) {
    const std::string group = schema::state_group;
    const auto texts = [&](const char* name) { return file.attribute<std::vector<std::string>>(group, name); };
    const auto numbers = [&](const char* name) { return file.attribute<std::vector<double>>(group, name); };
    StageControllerState loading;
    loading.boundary_conditions = {texts("amplitudes"), numbers("amplitude_values")};
    loading.platen_speed = file.attribute<double>(group, "platen_speed");
    loading.mean_compression = file.attribute<double>(group, "mean_compression");
    loading.progress = {texts("stages"), numbers("stage_values")};
    loading.stages_end_by = texts("stages_ended_by");
    const auto fit = [](const NamedNumbers& n) { return n.names.size() == n.values.size(); };
    if (!fit(loading.boundary_conditions) || !fit(loading.progress) || !std::isfinite(loading.platen_speed) ||
        !std::isfinite(loading.mean_compression)) {
        throw InputError(fmt::format("{}: names and values of the loading in {} do not fit each other: the file is damaged",
                                     file.name(), group));
    }
    return loading;
}

}  // namespace

void write_saved_state(H5Output& file, const State& state, const StageControllerState& loading, double energy_balance_error) {
    const std::string group = schema::state_group;
    file.create_group(group);
    visit_numbers(state, [&](const char* name, const auto& value) { file.attribute(group, name, static_cast<double>(value)); });
    visit_arrays(state, [&](const char* name, const auto& items) { write_array(file, name, items); });
    std::vector<ContactHistory> histories;
    for (std::size_t point = 0; point < state.failed.size(); ++point) histories.push_back(state.points[point]);
    write_array(file, "history", histories);
    file.attribute(group, "amplitudes", loading.boundary_conditions.names);
    file.attribute(group, "amplitude_values", loading.boundary_conditions.values);
    file.attribute(group, "platen_speed", loading.platen_speed);
    file.attribute(group, "mean_compression", loading.mean_compression);
    file.attribute(group, "stages", loading.progress.names);
    file.attribute(group, "stage_values", loading.progress.values);
    file.attribute(group, "stages_ended_by", loading.stages_end_by);
    file.attribute(group, "energy_balance_error", energy_balance_error);
}

void write_frame_progress(H5Output& file, const FrameProgress& progress) {
    const std::string group = schema::state_group;
    std::vector<std::int64_t> roles;
    for (const FrameRole role : progress.roles) roles.push_back(static_cast<std::int64_t>(role));
    file.attribute(group, "next_frame", progress.next);
    file.attribute(group, "frame_interval", progress.interval);
    file.attribute(group, "regular_frames", std::int64_t{progress.regular});
    file.attribute(group, "frame_roles", roles);
}

FrameProgress read_frame_progress(const RunReader& run) {
    const H5Input& file = run.file();
    const std::string group = schema::state_group;
    FrameProgress progress;
    progress.next = file.attribute<double>(group, "next_frame");
    progress.interval = file.attribute<double>(group, "frame_interval");
    const auto n_regular = file.attribute<std::int64_t>(group, "regular_frames");
    const auto roles = file.attribute<std::vector<std::int64_t>>(group, "frame_roles");
    const bool are_roles = std::all_of(roles.begin(), roles.end(), [](std::int64_t role) {
        return role >= 0 && role <= static_cast<std::int64_t>(FrameRole::present);
    });
    const auto regular = std::count(roles.begin(), roles.end(), static_cast<std::int64_t>(FrameRole::regular));
    if (!are_roles || roles.size() != run.n_frames() || n_regular != regular || !std::isfinite(progress.next) ||
        !std::isfinite(progress.interval) || progress.interval <= 0) {
        throw InputError(run.name() + ": the frames are not those that the state counts: the file is damaged");
    }
    progress.regular = static_cast<int>(n_regular);
    std::transform(roles.begin(), roles.end(), std::back_inserter(progress.roles),
                   [](std::int64_t role) { return static_cast<FrameRole>(role); });
    return progress;
}

std::size_t size_of_saved_state(const State& state) {
    std::size_t numbers = state.failed.size() * width_of<ContactHistory>();
    visit_arrays(state, [&]<class Item>(const char* /*name*/, const std::vector<Item>& items) {
        numbers += items.size() * width_of<Item>();
    });
    return numbers * sizeof(double);
}

SavedState read_saved_state(const std::string& path, const Specimen& specimen, const SimulationRequest& request,
                            const Setup& setup) {
    const RunReader run(path);
    require_same(run, specimen, request, setup);
    const H5Input& file = run.file();
    const std::string group = schema::state_group;
    SavedState saved;
    State& s = saved.state;
    s = make_state(setup.assemblage, setup.boundary, specimen);
    std::vector<PlatenPoint> platen_points = s.platen_points;
    visit_numbers(s, [&](const char* name, auto& value) {
        take(file.attribute<double>(group, name), fmt::format("{}: attribute {} of {}", run.name(), name, group), value);
    });
    visit_arrays(s, [&](const char* name, auto& items) {
        read_array(file, name, is_list(name) ? std::nullopt : std::optional(items.size()), items);
    });
    std::vector<ContactHistory> histories;
    read_array(file, "history", s.failed.size(), histories);
    require_sound_state(run.name(), setup, run.header().time_step, s);
    for (std::size_t point = 0; point < histories.size(); ++point) {
        if (histories[point] != ContactHistory{}) s.points.of(point) = histories[point];
    }
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
    book_change(run.name(), old, setup, s);
    saved.loading = read_loading(file);
    saved.cracks = run.cracks();
    saved.energy_scale = old.energy_scale;
    take(file.attribute<double>(group, "energy_balance_error"), run.name() + ": attribute energy_balance_error of " + group,
         saved.energy_balance_error);
    if (old.stop_reason == "checkpoint") saved.frames = read_frame_progress(run);
    return saved;
}

}  // namespace graincrack
