#include "solver/step/contact_forces.hpp"

#include <algorithm>
#include <cmath>

#include "solver/simd.hpp"

namespace graincrack {
namespace {

constexpr std::int32_t n = contacts_per_chunk;
constexpr std::int32_t lanes = 8;  // of the widest vector unit; any fixed number gives the same bytes everywhere
static_assert(n % lanes == 0);

/// A chunk's contacts side by side, and their points: 2 i + p.
struct Lanes {
    alignas(64) double edge_x[n], edge_y[n], area[n];
    alignas(64) double tangent_x[n], tangent_y[n], inv_length[n];
    alignas(64) double jump_x[2 * n], jump_y[2 * n];
    alignas(64) double opening[2 * n], sliding[2 * n];
    alignas(64) double normal_traction[2 * n], shear_traction[2 * n];
    alignas(64) double intact[2 * n];    ///< 1 while the point has not failed, else 0
    alignas(64) double residual[2 * n];  ///< 1 if it carries nothing but friction, else 0
    alignas(64) double gone[2 * n];      ///< 1 if the contact has been released to touches, else 0
    alignas(64) double ordinary[2 * n];  ///< 1 where one of these is all there is to know, else 0: the point needs the full law
    alignas(64) double fracture[2 * n], closed_fracture[2 * n];  ///< booked by the intact law, J
    alignas(64) double friction[2 * n];                          ///< of spent points, J
    bool any_spent;                                              ///< or gone; else those two are not set
};

void gather(const Assemblage& a, const State& s, Range range, Lanes& b) {
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
        b.jump_x[2 * i] = ub1.x - ua1.x;
        b.jump_x[2 * i + 1] = ub2.x - ua2.x;
        b.jump_y[2 * i] = ub1.y - ua1.y;
        b.jump_y[2 * i + 1] = ub2.y - ua2.y;
    }
}

template <class T>
void prefetch(const T* data, std::size_t count) {
    constexpr std::size_t line = 64;  // bytes
    const auto* const bytes = reinterpret_cast<const char*>(data);
    for (std::size_t i = 0; i < count * sizeof(T); i += line) {
        __builtin_prefetch(bytes + i);
    }
}

/// Asks for what the next chunk will read, so that it comes while this one is worked on; for its nodes the contacts must be here,
/// so they are asked for a chunk earlier.
void prefetch_ahead(const Assemblage& a, const State& s, std::int32_t chunk) {
    const auto n_chunks = static_cast<std::int32_t>(a.contact_chunks.size());
    if (chunk + 2 < n_chunks) {
        const Range later = a.contact_chunks[chunk + 2];
        prefetch(&a.contacts[later.begin], static_cast<std::size_t>(later.size()));
    }
    if (chunk + 1 < n_chunks) {
        const Range next = a.contact_chunks[chunk + 1];
        const auto first = 2 * static_cast<std::size_t>(next.begin);
        for (const auto* values : {&s.opening, &s.sliding, &s.integrity, &s.fracture_energy}) {
            prefetch(&(*values)[first], 2 * static_cast<std::size_t>(next.size()));
        }
        for (std::int32_t c = next.begin; c < next.end; ++c) {
            for (const std::int32_t node : a.contacts[c].nodes) {
                __builtin_prefetch(&s.displacement[node]);
            }
        }
    }
}

bool any(const std::uint8_t* flags, std::int32_t count) {
    std::uint8_t found = 0;
    for (std::int32_t k = 0; k < count; ++k) {
        found = static_cast<std::uint8_t>(found | flags[k]);
    }
    return found != 0;
}

/// What is known of the points of a chunk before they move.
void sort_points(const Assemblage& a, const State& s, Range range, Lanes& b) {
    const std::int32_t count = 2 * range.size();
    const std::uint8_t* const failed = &s.failed[2 * static_cast<std::size_t>(range.begin)];
    const std::uint8_t* const residual = &s.residual[2 * static_cast<std::size_t>(range.begin)];
    const std::uint8_t* const released = &s.contact_pairs.released[range.begin];
    const bool any_failed = any(failed, count);
    b.any_spent = any(residual, count) || any(released, range.size());
    if (!any_failed) {
        std::fill_n(b.intact, count, 1.0);
    }
    run_on(a.vector_target, [&]() GRAINCRACK_KERNEL {
        for (std::int32_t k = 0; any_failed && k < count; ++k) {
            b.intact[k] = 1.0 - static_cast<double>(failed[k]);
        }
        for (std::int32_t i = 0; b.any_spent && 2 * i < count; ++i) {
            const auto gone = static_cast<double>(released[i]);
            b.gone[2 * i] = gone;
            b.gone[2 * i + 1] = gone;
            b.residual[2 * i] = (1.0 - gone) * static_cast<double>(residual[2 * i]);
            b.residual[2 * i + 1] = (1.0 - gone) * static_cast<double>(residual[2 * i + 1]);
        }
    });
}

GRAINCRACK_INLINE void find_motions(std::int32_t count, Lanes& b) {
    for (std::int32_t i = 0; i < count; ++i) {
        const double squared = b.edge_x[i] * b.edge_x[i] + b.edge_y[i] * b.edge_y[i];
        const double inv = squared < 4 * lost_frame * b.area[i] * b.area[i] ? 0.0 : 1 / std::sqrt(squared);
        b.inv_length[i] = inv;
        b.tangent_x[i] = inv * b.edge_x[i];
        b.tangent_y[i] = inv * b.edge_y[i];
    }
    for (std::int32_t i = 0; i < count; ++i) {
        // n = t turned by −90° = (ty, −tx)
        const double tx = b.tangent_x[i];
        const double ty = b.tangent_y[i];
        b.opening[2 * i] = b.jump_x[2 * i] * ty - b.jump_y[2 * i] * tx;
        b.opening[2 * i + 1] = b.jump_x[2 * i + 1] * ty - b.jump_y[2 * i + 1] * tx;
        b.sliding[2 * i] = b.jump_x[2 * i] * tx + b.jump_y[2 * i] * ty;
        b.sliding[2 * i + 1] = b.jump_x[2 * i + 1] * tx + b.jump_y[2 * i + 1] * ty;
    }
}

/// What the intact law changes of the points of a chunk, and what it finds.
struct Points {
    const double* old_opening;
    const double* old_sliding;
    double* integrity;
    double* slip;
    double* fracture_energy;
};

/// The law of intact points.
template <class Law>
GRAINCRACK_INLINE void apply_intact_law(const ContactLaw& constants, const Points& points, std::int32_t count, Lanes& b) {
    const ContactLaw law = constants;  // a copy that no store can change
    const double* const old_opening = points.old_opening;
    const double* const old_sliding = points.old_sliding;
    double* __restrict const integrity = points.integrity;
    for (std::int32_t k = 0; k < 2 * count; ++k) {
        const IntactResponse r = Law::intact(law, {old_opening[k], old_sliding[k], b.opening[k], b.sliding[k], integrity[k]});
        const double ordinary = r.holds * b.intact[k];
        b.normal_traction[k] = r.normal;
        b.shear_traction[k] = r.shear;
        b.ordinary[k] = ordinary;
        if constexpr (Law::damages_intact) {
            integrity[k] = ordinary == 0 ? integrity[k] : r.integrity;
            b.fracture[k] = ordinary == 0 ? 0.0 : r.fracture;
        }
    }
}

/// Points of which friction is left, and those that are no contacts any more.
GRAINCRACK_INLINE void apply_spent_law(const ContactLaw& constants, const Points& points, std::int32_t count, Lanes& b) {
    const ContactLaw law = constants;
    const double* const old_opening = points.old_opening;
    const double* const old_sliding = points.old_sliding;
    double* __restrict const slip = points.slip;
    for (std::int32_t k = 0; k < 2 * count; ++k) {
        const ResidualResponse r = residual_response(law, {old_opening[k], old_sliding[k], b.opening[k], b.sliding[k], slip[k]});
        const double residual = r.holds * b.residual[k];
        const double normal = b.gone[k] != 0 ? 0.0 : b.normal_traction[k];
        const double shear = b.gone[k] != 0 ? 0.0 : b.shear_traction[k];
        b.normal_traction[k] = residual != 0 ? r.normal : normal;
        b.shear_traction[k] = residual != 0 ? r.shear : shear;
        slip[k] = residual != 0 ? r.slip : slip[k];
        b.friction[k] = residual != 0 ? r.friction : 0.0;
        b.ordinary[k] = b.ordinary[k] + residual + b.gone[k];
    }
}

/// Sum of values of the points of a chunk, by lanes.
GRAINCRACK_INLINE double sum_of_points(std::int32_t count, double* values) {
    double sum[lanes] = {};
    for (std::int32_t k = 2 * count; k % lanes != 0; ++k) {
        values[k] = 0;
    }
    for (std::int32_t k = 0; k < 2 * count; k += lanes) {
        for (std::int32_t l = 0; l < lanes; ++l) {
            sum[l] += values[k + l];
        }
    }
    return ((sum[0] + sum[1]) + (sum[2] + sum[3])) + ((sum[4] + sum[5]) + (sum[6] + sum[7]));
}

/// Friction of spent points.
GRAINCRACK_INLINE double sum_friction(std::int32_t count, Lanes& b) {
    for (std::int32_t i = 0; i < count; ++i) {
        b.friction[2 * i] = b.area[i] * b.friction[2 * i];
        b.friction[2 * i + 1] = b.area[i] * b.friction[2 * i + 1];
    }
    return sum_of_points(count, b.friction);
}

/// \return number of points that need the full law
GRAINCRACK_INLINE std::int32_t count_left_over(std::int32_t count, const Lanes& b) {
    std::int32_t left_over = 0;
    for (std::int32_t k = 0; k < 2 * count; ++k) {
        left_over += b.ordinary[k] == 0 ? 1 : 0;
    }
    return left_over;
}

/// Damage before the peak: the energy it takes, of each point and on the branch it happens on.
GRAINCRACK_INLINE void book_intact_damage(const Points& points, std::int32_t count, Lanes& b, ContactSums& sums) {
    double* __restrict const fracture_energy = points.fracture_energy;
    for (std::int32_t i = 0; i < count; ++i) {
        b.fracture[2 * i] = b.area[i] * b.fracture[2 * i];
        b.fracture[2 * i + 1] = b.area[i] * b.fracture[2 * i + 1];
    }
    for (std::int32_t k = 0; k < 2 * count; ++k) {
        fracture_energy[k] += b.fracture[k];
    }
    for (std::int32_t k = 0; k < 2 * count; ++k) {
        b.closed_fracture[k] = b.opening[k] >= 0 ? 0.0 : b.fracture[k];
        b.fracture[k] = b.opening[k] >= 0 ? b.fracture[k] : 0.0;
    }
    sums.fracture_tension += sum_of_points(count, b.fracture);
    sums.fracture_shear += sum_of_points(count, b.closed_fracture);
}

/// The full law at one point: energies and events on top of the traction.
ContactTraction advance_point(const Assemblage& a, const ContactLaw& law, std::int32_t chunk, std::int32_t c, std::int32_t p,
                              const ContactMotion& to, const Vector2& tangent, std::int64_t step, State& s) {
    const std::size_t point = 2 * static_cast<std::size_t>(c) + static_cast<std::size_t>(p);
    const ContactGeometry& g = a.contacts[c];
    ContactHistory& history = s.points.of(point);
    history.motion = {s.opening[point], s.sliding[point]};
    history.integrity = s.integrity[point];
    history.slip = s.slip[point];
    const ContactResponse r = update_contact(law, to, history);
    ContactSums& sums = s.contact_sums[chunk];
    const double fracture = g.point_area * r.dissipation.fracture;
    // Damage before the peak (consistent) counts to the branch it happens on.
    const bool tensile = r.history.failed() ? r.history.first_mode == CrackMode::tensile : to.opening >= 0;
    (tensile ? sums.fracture_tension : sums.fracture_shear) += fracture;
    s.fracture_energy[point] += fracture;
    sums.friction += g.point_area * r.dissipation.friction;
    sums.non_conservative_work += g.point_area * r.dissipation.non_conservative_work;
    const bool fails = r.history.failed() && !history.failed();
    const bool separates = r.history.separated && !history.separated;
    if (fails || separates) {
        const double along = p == 0 ? 0.25 : 0.75;
        const Vector2 first = a.position[g.nodes[0]] + 0.5 * (s.displacement[g.nodes[0]] + s.displacement[g.nodes[2]]);
        const Vector2 second = a.position[g.nodes[1]] + 0.5 * (s.displacement[g.nodes[1]] + s.displacement[g.nodes[3]]);
        ContactEvent event{step, c,       static_cast<std::uint8_t>(p),    false, r.history.first_mode, to,
                           {},   tangent, first + along * (second - first)};
        event.peak_traction = update_contact(law, history.motion, history).traction;
        if (fails) {
            s.events[chunk].push_back(event);
            s.clusters.note_failure(point);
        }
        if (separates) {
            event.is_separation = true;
            s.events[chunk].push_back(event);
        }
    }
    history = r.history;
    s.failed[point] = history.failed() ? 1 : 0;
    s.residual[point] = is_residual(law, history) ? 1 : 0;
    s.integrity[point] = history.integrity;
    s.slip[point] = history.slip;
    return r.traction;
}

void apply_full_law(const Assemblage& a, const ContactLaw& law, std::int32_t chunk, std::int64_t step, State& s, Lanes& b) {
    const Range range = a.contact_chunks[chunk];
    for (std::int32_t k = 0; k < 2 * range.size(); ++k) {
        if (b.ordinary[k] == 0) {
            const std::int32_t i = k / 2;
            const ContactTraction t = advance_point(a, law, chunk, range.begin + i, k % 2, {b.opening[k], b.sliding[k]},
                                                    {b.tangent_x[i], b.tangent_y[i]}, step, s);
            b.normal_traction[k] = t.normal;
            b.shear_traction[k] = t.shear;
        }
    }
}

/// Forces on the nodes, slot by slot, and the couple that balances the moment they would exert because they act at a jump's
/// length from each other: the frame turns with the mid-edge, and its share of the forces keeps angular momentum and energy
/// exact. \param force [8][n] x, y on a1, a2, b1, b2
GRAINCRACK_INLINE void find_forces(std::int32_t count, const Lanes& b, double* __restrict force) {
    for (std::int32_t i = 0; i < count; ++i) {
        const double tx = b.tangent_x[i];
        const double ty = b.tangent_y[i];
        const double n0 = b.area[i] * b.normal_traction[2 * i];
        const double n1 = b.area[i] * b.normal_traction[2 * i + 1];
        const double s0 = b.area[i] * b.shear_traction[2 * i];
        const double s1 = b.area[i] * b.shear_traction[2 * i + 1];
        const double moment =
            (n0 * b.sliding[2 * i] - s0 * b.opening[2 * i]) + (n1 * b.sliding[2 * i + 1] - s1 * b.opening[2 * i + 1]);
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

GRAINCRACK_INLINE void keep_motions(std::int32_t count, const Lanes& b, double* __restrict opening, double* __restrict sliding) {
    for (std::int32_t k = 0; k < 2 * count; ++k) {
        opening[k] = b.opening[k];
        sliding[k] = b.sliding[k];
    }
}

}  // namespace

void advance_contacts(const Assemblage& a, const ContactLaw& law, std::int32_t chunk, std::int64_t step, State& s) {
    const Range range = a.contact_chunks[chunk];
    const std::int32_t count = range.size();
    const std::size_t first = 2 * static_cast<std::size_t>(range.begin);
    const Points points{&s.opening[first], &s.sliding[first], &s.integrity[first], &s.slip[first], &s.fracture_energy[first]};
    ContactSums& sums = s.contact_sums[chunk];
    Lanes batch;
    gather(a, s, range, batch);
    prefetch_ahead(a, s, chunk);
    sort_points(a, s, range, batch);
    std::int32_t left_over = 0;
    contact_law::with_law(law.variant, [&](auto kind) {
        using Law = decltype(kind);
        run_on(a.vector_target, [&]() GRAINCRACK_KERNEL {
            find_motions(count, batch);
            apply_intact_law<Law>(law, points, count, batch);
            if constexpr (Law::damages_intact) {
                book_intact_damage(points, count, batch, sums);
            }
        });
    });
    run_on(a.vector_target, [&]() GRAINCRACK_KERNEL {
        if (batch.any_spent) {
            apply_spent_law(law, points, count, batch);
            sums.friction += sum_friction(count, batch);
        }
        left_over = count_left_over(count, batch);
    });
    if (left_over > 0) {
        apply_full_law(a, law, chunk, step, s, batch);
    }
    run_on(a.vector_target, [&]() GRAINCRACK_KERNEL {
        find_forces(count, batch, &s.contact_force[slot_stride * static_cast<std::size_t>(chunk)]);
        keep_motions(count, batch, &s.opening[first], &s.sliding[first]);
    });
}

}  // namespace graincrack
