#include "solver/step/contact_forces.hpp"

#include <algorithm>
#include <cmath>

#include "solver/arithmetic/simd.hpp"

namespace graincrack {
namespace {

static_assert(contacts_per_chunk % sum_lanes == 0);

/// The contacts of a chunk side by side, and their points in order 2 i + p. Motions and tractions of points are divided by the
/// strength factor s of the contact, energies by s² (see `ContactGeometry::strength`), so that the law of the class applies.
struct ContactLanes {
    static constexpr std::int32_t n = contacts_per_chunk;
    alignas(64) double edge_x[n], edge_y[n], area[n];
    alignas(64) double strength[n];                    ///< s
    alignas(64) double force_area[n], energy_area[n];  ///< area times s, and times s²
    alignas(64) double tangent_x[n], tangent_y[n], inv_length[n];
    alignas(64) double jump_x[2 * n], jump_y[2 * n];
    alignas(64) double opening[2 * n], sliding[2 * n];
    alignas(64) double normal_traction[2 * n], shear_traction[2 * n];
    alignas(64) double intact[2 * n];    ///< 1 if the point has not failed, else 0
    alignas(64) double residual[2 * n];  ///< 1 if the point carries friction only, else 0
    alignas(64) double released[2 * n];  ///< 1 if the contact has been released to node–edge contacts, else 0
    alignas(64) double done[2 * n];      ///< 1 if one of these responses holds or it is released; 0: the full law
    alignas(64) double fracture[2 * n], shear_fracture[2 * n];  ///< dissipated energy, J
    alignas(64) double friction[2 * n];                         ///< dissipated energy, J
    bool any_failed;                                            ///< true if a point has failed
    bool any_residual;  ///< true if a point is residual or released; else `residual` and `released` are not set
};

/// The few softening points of a chunk side by side: those that have failed and still have cohesion. It holds their motions and
/// what changes with them.
struct SofteningLanes {
    static constexpr std::int32_t n = 2 * contacts_per_chunk;
    ContactHistory* histories;  ///< of all points of the chunk
    bool has_memory;            ///< true if more of a history changes than integrity and slip
    std::int32_t count;
    std::size_t place[n];  ///< place in the chunk, 2 i + p; the last lanes repeat the last point
    alignas(64) double old_opening[n], old_sliding[n], opening[n], sliding[n];
    alignas(64) double integrity[n], slip[n], largest_open[n], largest_slid[n], bridge[n];
    alignas(64) double normal[n], shear[n], fracture[n], friction[n], holds[n], remaining[n];  ///< as in `SofteningResponse`
};

void gather_contacts(const Assemblage& a, const State& s, Range range, ContactLanes& b) {
    const ContactGeometry* contacts = &a.contacts[range.begin];
    const Vector2* displacement = s.displacement.data();
    for (std::int32_t i = 0; i < range.size(); ++i) {
        const ContactGeometry& g = contacts[i];
        const Vector2 ua1 = displacement[g.nodes[0]];
        const Vector2 ua2 = displacement[g.nodes[1]];
        const Vector2 ub1 = displacement[g.nodes[2]];
        const Vector2 ub2 = displacement[g.nodes[3]];
        const Vector2 turn = 0.5 * ((ua2 - ua1) + (ub2 - ub1));
        b.edge_x[i] = g.edge.x + turn.x;
        b.edge_y[i] = g.edge.y + turn.y;
        b.area[i] = g.point_area;
        b.strength[i] = g.strength;
        b.jump_x[2 * i] = ub1.x - ua1.x;
        b.jump_x[2 * i + 1] = ub2.x - ua2.x;
        b.jump_y[2 * i] = ub1.y - ua1.y;
        b.jump_y[2 * i + 1] = ub2.y - ua2.y;
    }
}

bool any(const std::uint8_t* flags, std::int32_t count) {
    std::uint8_t found = 0;
    for (std::int32_t k = 0; k < count; ++k) found = static_cast<std::uint8_t>(found | flags[k]);
    return found != 0;
}

/// Marks the points of a chunk that are intact, residual or released before they move.
void sort_points(const Assemblage& a, const State& s, Range range, ContactLanes& b) {
    const std::int32_t count = 2 * range.size();
    const std::uint8_t* const failed = &s.failed[2 * static_cast<std::size_t>(range.begin)];
    const std::uint8_t* const residual = &s.residual[2 * static_cast<std::size_t>(range.begin)];
    const std::uint8_t* const released = &s.contact_pairs.released[range.begin];
    b.any_failed = any(failed, count);
    b.any_residual = any(residual, count) || any(released, range.size());
    if (!b.any_failed) std::fill_n(b.intact, count, 1.0);
    run_on(a.vector_target, [&]() GRAINCRACK_KERNEL {
        for (std::int32_t k = 0; b.any_failed && k < count; ++k) b.intact[k] = 1.0 - static_cast<double>(failed[k]);
        for (std::int32_t i = 0; b.any_residual && 2 * i < count; ++i) {
            const auto is_released = static_cast<double>(released[i]);
            b.released[2 * i] = is_released;
            b.released[2 * i + 1] = is_released;
            b.residual[2 * i] = (1.0 - is_released) * static_cast<double>(residual[2 * i]);
            b.residual[2 * i + 1] = (1.0 - is_released) * static_cast<double>(residual[2 * i + 1]);
        }
    });
}

GRAINCRACK_INLINE void find_motions(std::int32_t count, ContactLanes& b) {
    for (std::int32_t i = 0; i < count; ++i) {
        const double squared = b.edge_x[i] * b.edge_x[i] + b.edge_y[i] * b.edge_y[i];
        const double inv = squared < 4 * lost_frame * b.area[i] * b.area[i] ? 0.0 : 1 / std::sqrt(squared);
        b.inv_length[i] = inv;
        b.tangent_x[i] = inv * b.edge_x[i];
        b.tangent_y[i] = inv * b.edge_y[i];
    }
    for (std::int32_t i = 0; i < count; ++i) {
        // n = t turned by −90° = (ty, −tx)
        const double per_strength = 1 / b.strength[i];
        const double tx = b.tangent_x[i] * per_strength;
        const double ty = b.tangent_y[i] * per_strength;
        b.force_area[i] = b.area[i] * b.strength[i];
        b.energy_area[i] = b.force_area[i] * b.strength[i];
        // A contact whose frame has zero length counts as open by its own length, which breaks it. Otherwise it would return
        // reversed when its grains rotate further, and its jump would count as an overlap.
        const bool is_lost = b.inv_length[i] == 0;
        const double far = 2 * b.area[i] * per_strength;
        const double opening0 = b.jump_x[2 * i] * ty - b.jump_y[2 * i] * tx;
        const double opening1 = b.jump_x[2 * i + 1] * ty - b.jump_y[2 * i + 1] * tx;
        b.opening[2 * i] = is_lost ? far : opening0;
        b.opening[2 * i + 1] = is_lost ? far : opening1;
        b.sliding[2 * i] = b.jump_x[2 * i] * tx + b.jump_y[2 * i] * ty;
        b.sliding[2 * i + 1] = b.jump_x[2 * i + 1] * tx + b.jump_y[2 * i + 1] * ty;
    }
}

/// The arrays of the state at the points of a chunk.
struct Points {
    const double* old_opening;
    const double* old_sliding;
    double* integrity;
    double* slip;
    double* fracture_energy;
};
Points points_from(Range range, State& s) {
    const auto first = 2 * static_cast<std::size_t>(range.begin);
    return {&s.opening[first], &s.sliding[first], &s.integrity[first], &s.slip[first], &s.fracture_energy[first]};
}

/// Computes the intact response of all points, which is correct where it holds.
template <class Law>
GRAINCRACK_INLINE void apply_intact_response(const ContactLaw& constants, const Points& points, std::int32_t count,
                                             ContactLanes& b) {
    const ContactLaw law = constants;  // a copy that no store can change
    const double* const old_opening = points.old_opening;
    const double* const old_sliding = points.old_sliding;
    double* __restrict const integrity = points.integrity;
    for (std::int32_t k = 0; k < 2 * count; ++k) {
        const IntactResponse r = Law::intact(law, {old_opening[k], old_sliding[k], b.opening[k], b.sliding[k], integrity[k]});
        const double done = r.holds * b.intact[k];
        b.normal_traction[k] = r.normal;
        b.shear_traction[k] = r.shear;
        b.done[k] = done;
        if constexpr (Law::damages_intact) {
            integrity[k] = done == 0 ? integrity[k] : r.integrity;
            b.fracture[k] = done == 0 ? 0.0 : r.fracture;
        }
    }
}

/// True if a law has a softening response.
template <class Law>
constexpr bool has_softening = requires(const ContactLaw& law, const MovedPoint& p) {
    Law::softening(law, p);
};

/// True if a law has a softening response with a bridge.
template <class Law>
constexpr bool may_be_bridged = requires(const ContactLaw& law, const MovedPoint& p) {
    Law::bridged_softening(law, p);
};

void find_softening(const State& s, Range range, SofteningLanes& p) {
    const std::uint8_t* const failed = &s.failed[2 * static_cast<std::size_t>(range.begin)];
    const std::uint8_t* const residual = &s.residual[2 * static_cast<std::size_t>(range.begin)];
    std::int32_t n = 0;
    for (std::int32_t k = 0; k < 2 * range.size(); ++k) {
        if (failed[k] > residual[k]) p.place[n++] = static_cast<std::size_t>(k);
    }
    for (std::int32_t j = n; n > 0 && j < in_whole_lanes(n); ++j) p.place[j] = p.place[n - 1];
    p.count = n;
}

void gather_softening(const Points& points, const ContactLanes& b, SofteningLanes& p) {
    for (std::int32_t j = 0; j < in_whole_lanes(p.count); ++j) {
        const std::size_t k = p.place[j];
        const ContactHistory& history = p.histories[k];
        p.old_opening[j] = points.old_opening[k];
        p.old_sliding[j] = points.old_sliding[k];
        p.opening[j] = b.opening[k];
        p.sliding[j] = b.sliding[k];
        p.integrity[j] = points.integrity[k];
        p.slip[j] = points.slip[k];
        if (!p.has_memory) continue;
        p.largest_open[j] = history.largest_open;
        p.largest_slid[j] = history.largest_slid;
        p.bridge[j] = history.bridge;
    }
}

/// Computes the softening response, which is correct where it holds.
template <class Law, bool bridged>
GRAINCRACK_INLINE void apply_softening_response(const ContactLaw& constants, std::int32_t count, SofteningLanes& p) {
    const ContactLaw law = constants;
    for (std::int32_t j = 0; j < count; ++j) {
        const MovedPoint point{p.old_opening[j], p.old_sliding[j],  p.opening[j],      p.sliding[j], p.integrity[j],
                               p.slip[j],        p.largest_open[j], p.largest_slid[j], p.bridge[j]};
        SofteningResponse r;
        if constexpr (bridged) {
            r = Law::bridged_softening(law, point);
        } else {
            r = Law::softening(law, point);
        }
        p.normal[j] = r.normal;
        p.shear[j] = r.shear;
        p.integrity[j] = r.integrity;
        p.slip[j] = r.slip;
        p.fracture[j] = r.fracture;
        p.friction[j] = r.friction;
        p.holds[j] = r.holds;
        p.remaining[j] = r.remaining_cohesion;
        p.largest_open[j] = r.largest_open;
        p.largest_slid[j] = r.largest_slid;
        p.bridge[j] = r.bridge;
    }
}

/// Computes the residual response of residual points; released contacts carry nothing here.
GRAINCRACK_INLINE void apply_residual_response(const ContactLaw& constants, const Points& points, std::int32_t count,
                                               ContactLanes& b) {
    const ContactLaw law = constants;
    const double* const old_opening = points.old_opening;
    const double* const old_sliding = points.old_sliding;
    double* __restrict const slip = points.slip;
    for (std::int32_t k = 0; k < 2 * count; ++k) {
        const ResidualResponse r =
            residual_response(law, {old_opening[k], old_sliding[k], b.opening[k], b.sliding[k], 1, slip[k]});
        const double residual = r.holds * b.residual[k];
        const double normal = b.released[k] != 0 ? 0.0 : b.normal_traction[k];
        const double shear = b.released[k] != 0 ? 0.0 : b.shear_traction[k];
        b.normal_traction[k] = residual != 0 ? r.normal : normal;
        b.shear_traction[k] = residual != 0 ? r.shear : shear;
        slip[k] = residual != 0 ? r.slip : slip[k];
        b.friction[k] = residual != 0 ? r.friction : 0.0;
        b.done[k] = b.done[k] + residual + b.released[k];
    }
}

/// Sums the energy that friction dissipates at the points of a chunk, J.
GRAINCRACK_INLINE double sum_friction(std::int32_t count, ContactLanes& b) {
    for (std::int32_t i = 0; i < count; ++i) {
        b.friction[2 * i] = b.energy_area[i] * b.friction[2 * i];
        b.friction[2 * i + 1] = b.energy_area[i] * b.friction[2 * i + 1];
    }
    return sum_values_by_lanes(2 * count, b.friction);
}

/// \return number of points that need the full law
GRAINCRACK_INLINE std::int32_t count_undone(std::int32_t count, const ContactLanes& b) {
    std::int32_t undone = 0;
    for (std::int32_t k = 0; k < 2 * count; ++k) undone += b.done[k] == 0 ? 1 : 0;
    return undone;
}

/// Adds the fracture energies of intact points to their own and to the sums by mode. Damage before the peak belongs to the mode
/// of the branch on which it occurs.
GRAINCRACK_INLINE void book_fracture(const Points& points, std::int32_t count, ContactLanes& b, ContactSums& sums) {
    double* __restrict const fracture_energy = points.fracture_energy;
    for (std::int32_t i = 0; i < count; ++i) {
        b.fracture[2 * i] = b.energy_area[i] * b.fracture[2 * i];
        b.fracture[2 * i + 1] = b.energy_area[i] * b.fracture[2 * i + 1];
    }
    for (std::int32_t k = 0; k < 2 * count; ++k) {
        const bool tensile = b.opening[k] >= 0;
        fracture_energy[k] += b.fracture[k];
        b.shear_fracture[k] = tensile ? 0.0 : b.fracture[k];
        b.fracture[k] = tensile ? b.fracture[k] : 0.0;
    }
    sums.fracture_tension += sum_values_by_lanes(2 * count, b.fracture);
    sums.fracture_shear += sum_values_by_lanes(2 * count, b.shear_fracture);
}

/// A contact point in its chunk.
struct PointIndex {
    std::int32_t chunk, contact, end;  ///< end: 0 at the first end of the contact, 1 at the second
    [[nodiscard]] std::size_t point() const { return 2 * static_cast<std::size_t>(contact) + static_cast<std::size_t>(end); }
};

/// Middle of the half-edge of a point, half-way between the two grains, m.
Vector2 middle_of_point(const Assemblage& a, const PointIndex& at, const State& s) {
    const auto& nodes = a.contacts[at.contact].nodes;
    const double along = at.end == 0 ? 0.25 : 0.75;
    const Vector2 first = a.position[nodes[0]] + 0.5 * (s.displacement[nodes[0]] + s.displacement[nodes[2]]);
    const Vector2 second = a.position[nodes[1]] + 0.5 * (s.displacement[nodes[1]] + s.displacement[nodes[3]]);
    return first + along * (second - first);
}

/// Adds the dissipation of a point to the point's energies and to the sums of its chunk.
void book_dissipation(const PointIndex& at, double area, const ContactResponse& r, State& s) {
    ContactSums& sums = s.contact_sums[at.chunk];
    const double fracture = area * r.dissipation.fracture;
    // Damage before the peak (law `consistent`) belongs to the branch on which it occurs.
    const bool tensile = r.history.failed() ? r.history.first_mode == CrackMode::tensile : r.history.motion.opening >= 0;
    (tensile ? sums.fracture_tension : sums.fracture_shear) += fracture;
    s.fracture_energy[at.point()] += fracture;
    sums.friction += area * r.dissipation.friction;
    sums.non_conservative_work += area * r.dissipation.non_conservative_work;
}

/// Makes an event of a point. Its motion (over the strength factor), tangent and position are those of the step of the event.
ContactEvent make_event(const Assemblage& a, const PointIndex& at, ContactEventKind kind, const ContactMotion& motion,
                        const Vector2& tangent, std::int64_t step, const State& s) {
    ContactEvent event;
    event.step = step;
    event.contact = at.contact;
    event.point = static_cast<std::uint8_t>(at.end);
    event.kind = kind;
    const double strength = a.contacts[at.contact].strength;
    event.motion = {strength * motion.opening, strength * motion.sliding};
    event.tangent = tangent;
    event.position = middle_of_point(a, at, s);
    return event;
}

/// Records the `damage_levels` that a failed point falls below.
void record_levels(const Assemblage& a, const PointIndex& at, double remaining, const ContactMotion& motion,
                   const Vector2& tangent, std::int64_t step, State& s) {
    double& next = s.next_level[at.point()];
    for (std::size_t passed = count_levels_above(next); remaining < next; next = damage_level(++passed)) {
        const auto kind = static_cast<ContactEventKind>(static_cast<std::size_t>(ContactEventKind::damaged_10) + passed);
        s.events[at.chunk].push_back(make_event(a, at, kind, motion, tangent, step, s));
    }
}

/// Records the events of a point before its new history is stored: failure, loss of cohesion, separation. The traction of a
/// failure is that of the step before, the last one before the peak.
template <class Law>
void record_events(const Assemblage& a, const ContactLaw& law, const PointIndex& at, const ContactResponse& r,
                   const Vector2& tangent, std::int64_t step, State& s) {
    const ContactHistory& now = r.history;
    const ContactHistory& old = s.points[at.point()];
    if (now.failed() && s.failed[at.point()] == 0) {
        const ContactHistory before = point_history(s, at.point());
        ContactEvent event = make_event(a, at, ContactEventKind::failure, now.motion, tangent, step, s);
        event.mode = now.first_mode;
        const ContactTraction traction = contact_law::update<Law>(law, before.motion, before).traction;
        const double strength = a.contacts[at.contact].strength;
        event.peak_traction = {strength * traction.normal, strength * traction.shear};
        s.events[at.chunk].push_back(event);
    }
    const bool loses_cohesion =
        r.dissipation.fracture > 0 || now.failed_open != old.failed_open || now.failed_closed != old.failed_closed;
    if (loses_cohesion && s.next_level[at.point()] > 0) {
        record_levels(a, at, contact_law::remaining_cohesion<Law>(law, now), now.motion, tangent, step, s);
    }
    if (now.separated && !old.separated) {
        s.events[at.chunk].push_back(make_event(a, at, ContactEventKind::separation, now.motion, tangent, step, s));
    }
}

/// Stores the responses that hold, adds their dissipation to the sums, and records their events.
void store_softening(const Assemblage& a, std::int32_t chunk, std::int64_t step, const SofteningLanes& p, State& s,
                     ContactLanes& b) {
    const Range range = a.contact_chunks[chunk].contacts;
    const Points points = points_from(range, s);
    const double* const next_level = &s.next_level[2 * static_cast<std::size_t>(range.begin)];
    double sums[3][sum_lanes] = {};  // [tension, shear, friction][lane], summed as over all points of the chunk
    for (std::int32_t j = 0; j < p.count; ++j) {
        if (p.holds[j] == 0) continue;
        const std::size_t k = p.place[j];
        ContactHistory& history = p.histories[k];
        if (p.has_memory) {
            history.largest_open = p.largest_open[j];
            history.largest_slid = p.largest_slid[j];
            history.bridge = p.bridge[j];
        }
        b.normal_traction[k] = p.normal[j];
        b.shear_traction[k] = p.shear[j];
        b.done[k] = 1;
        points.integrity[k] = p.integrity[j];
        points.slip[k] = p.slip[j];
        const double fracture = b.energy_area[k / 2] * p.fracture[j];
        points.fracture_energy[k] += fracture;
        sums[history.first_mode == CrackMode::tensile ? 0 : 1][k % sum_lanes] += fracture;
        sums[2][k % sum_lanes] += b.energy_area[k / 2] * p.friction[j];
        if (p.fracture[j] > 0 && p.remaining[j] < next_level[k]) {
            const auto i = static_cast<std::int32_t>(k / 2);
            record_levels(a, {chunk, range.begin + i, static_cast<std::int32_t>(k % 2)}, p.remaining[j],
                          {p.opening[j], p.sliding[j]}, {b.tangent_x[i], b.tangent_y[i]}, step, s);
        }
    }
    ContactSums& totals = s.contact_sums[chunk];
    totals.fracture_tension += sum_values_by_lanes(sum_lanes, sums[0]);
    totals.fracture_shear += sum_values_by_lanes(sum_lanes, sums[1]);
    totals.friction += sum_values_by_lanes(sum_lanes, sums[2]);
}

/// Computes the softening response of the softening points of a chunk alone.
template <class Law>
void soften_points(const Assemblage& a, const ContactLaw& law, std::int32_t chunk, std::int64_t step, State& s, ContactLanes& b) {
    const Range range = a.contact_chunks[chunk].contacts;
    SofteningLanes p;
    find_softening(s, range, p);
    if (p.count == 0) return;
    p.histories = &s.points.of(2 * static_cast<std::size_t>(range.begin));
    p.has_memory = Law::remembers_largest || law.bridge > 0;
    gather_softening(points_from(range, s), b, p);
    run_on(a.vector_target, [&]() GRAINCRACK_KERNEL {
        if (may_be_bridged<Law> && law.bridge > 0) {
            apply_softening_response<Law, may_be_bridged<Law>>(law, in_whole_lanes(p.count), p);
        } else {
            apply_softening_response<Law, false>(law, in_whole_lanes(p.count), p);
        }
    });
    store_softening(a, chunk, step, p, s, b);
}

/// Opens a point whose contact has lost its frame, in small increments, so that it dissipates the rest of its fracture energy.
template <class Law>
void pull_apart(const ContactLaw& law, double far, ContactResponse& r) {
    constexpr double first = 1e-9;   // first increment, over `far`
    constexpr double growth = 1.02;  // of the opening in an increment; chosen, not fitted
    for (double opening = first * far; opening < far; opening *= growth) contact_law::move_point<Law>(law, {opening, 0}, r);
    contact_law::move_point<Law>(law, {far, 0}, r);
}

/// Applies the full law to the points of a chunk that need it.
template <class Law>
void apply_full_law(const Assemblage& a, const ContactLaw& law, std::int32_t chunk, std::int64_t step, State& s,
                    ContactLanes& b) {
    const Range range = a.contact_chunks[chunk].contacts;
    for (std::int32_t k = 0; k < 2 * range.size(); ++k) {
        if (b.done[k] != 0) continue;
        const PointIndex at{chunk, range.begin + k / 2, k % 2};
        ContactResponse r{{}, point_history(s, at.point()), {}};
        if (b.inv_length[k / 2] == 0) {
            pull_apart<Law>(law, b.opening[k], r);
        } else {
            contact_law::move_point<Law>(law, {b.opening[k], b.sliding[k]}, r);
        }
        book_dissipation(at, b.energy_area[k / 2], r, s);
        record_events<Law>(a, law, at, r, {b.tangent_x[k / 2], b.tangent_y[k / 2]}, step, s);
        store_point(r.history, Law::is_residual(law, r.history), at.point(), s);
        b.normal_traction[k] = r.traction.normal;
        b.shear_traction[k] = r.traction.shear;
    }
}

/// Computes the branch-free responses at all points of a chunk. \return number of points that need the full law
template <class Law>
std::int32_t apply_vector_path(const Assemblage& a, const ContactLaw& law, std::int32_t chunk, std::int64_t step, State& s,
                               ContactLanes& b) {
    const Range range = a.contact_chunks[chunk].contacts;
    const std::int32_t count = range.size();
    const Points points = points_from(range, s);
    ContactSums& sums = s.contact_sums[chunk];
    run_on(a.vector_target, [&]() GRAINCRACK_KERNEL {
        find_motions(count, b);
        apply_intact_response<Law>(law, points, count, b);
        if constexpr (Law::damages_intact) book_fracture(points, count, b, sums);
    });
    if constexpr (has_softening<Law>) {
        if (b.any_failed) soften_points<Law>(a, law, chunk, step, s, b);
    }
    std::int32_t undone = 0;
    run_on(a.vector_target, [&]() GRAINCRACK_KERNEL {
        if (b.any_residual) {
            apply_residual_response(law, points, count, b);
            sums.friction += sum_friction(count, b);
        }
        undone = count_undone(count, b);
    });
    return undone;
}

/// Computes the forces on the nodes and the couple that balances their moment: they act at a distance of the jump from each
/// other. The frame turns with the mid-edge; its share of the forces keeps angular momentum and energy exact. \param force [8][n]
/// x and y on a1, a2, b1, b2, N
GRAINCRACK_INLINE void find_contact_forces(std::int32_t count, const ContactLanes& b, double* __restrict force) {
    constexpr std::int32_t n = ContactLanes::n;
    for (std::int32_t i = 0; i < count; ++i) {
        const double tx = b.tangent_x[i];
        const double ty = b.tangent_y[i];
        const double n0 = b.force_area[i] * b.normal_traction[2 * i];
        const double n1 = b.force_area[i] * b.normal_traction[2 * i + 1];
        const double s0 = b.force_area[i] * b.shear_traction[2 * i];
        const double s1 = b.force_area[i] * b.shear_traction[2 * i + 1];
        const double moment = b.strength[i] * ((n0 * b.sliding[2 * i] - s0 * b.opening[2 * i]) +
                                               (n1 * b.sliding[2 * i + 1] - s1 * b.opening[2 * i + 1]));
        const double couple = 0.5 * moment * b.inv_length[i];
        const double couple_x = couple * ty;
        const double couple_y = -couple * tx;
        const double f0x = n0 * ty + s0 * tx;
        const double f0y = -n0 * tx + s0 * ty;
        const double f1x = n1 * ty + s1 * tx;
        const double f1y = -n1 * tx + s1 * ty;
        force[i] = f0x - couple_x;
        force[n + i] = f0y - couple_y;
        force[2 * n + i] = f1x + couple_x;
        force[3 * n + i] = f1y + couple_y;
        force[4 * n + i] = -f0x - couple_x;
        force[5 * n + i] = -f0y - couple_y;
        force[6 * n + i] = -f1x + couple_x;
        force[7 * n + i] = -f1y + couple_y;
    }
}

GRAINCRACK_INLINE void store_motions(std::int32_t count, const ContactLanes& b, double* __restrict opening,
                                     double* __restrict sliding) {
    for (std::int32_t k = 0; k < 2 * count; ++k) {
        opening[k] = b.opening[k];
        sliding[k] = b.sliding[k];
    }
}

}  // namespace

void advance_contacts(const Assemblage& a, const ContactLaws& laws, std::int32_t chunk, std::int64_t step, State& s) {
    const Range range = a.contact_chunks[chunk].contacts;
    const ContactLaw& law = laws[a.contact_chunks[chunk].contact_class];
    const std::size_t first = 2 * static_cast<std::size_t>(range.begin);
    ContactLanes b;
    gather_contacts(a, s, range, b);
    sort_points(a, s, range, b);
    contact_law::with_law(law.variant, [&](auto kind) {
        if (apply_vector_path<decltype(kind)>(a, law, chunk, step, s, b) > 0) {
            apply_full_law<decltype(kind)>(a, law, chunk, step, s, b);
        }
    });
    run_on(a.vector_target, [&]() GRAINCRACK_KERNEL {
        find_contact_forces(range.size(), b, &s.contact_force[slot_stride * static_cast<std::size_t>(chunk)]);
        store_motions(range.size(), b, &s.opening[first], &s.sliding[first]);
    });
}

}  // namespace graincrack
