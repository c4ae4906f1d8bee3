// The contact stage of a step: jumps of displacement → law → nodal forces, block by block.
//
// A block is worked on in passes over arrays on the stack: gather (scalar, indexed), frame and motion (vector), the law of
// points that stay intact (vector, no branch), the full law for all others (scalar, few), nodal forces (vector), scatter to the
// slots. Sums are over fixed lanes, so that every vector unit adds in the same order.
#include <cmath>

#include "solver/step.hpp"
#include "solver/vector_targets.hpp"

namespace graincrack {
namespace {

constexpr std::int32_t n = contacts_per_block;
constexpr std::int32_t lanes = 8;  // of the widest vector unit; any fixed number gives the same bytes everywhere
static_assert(n % lanes == 0);

/// A block's contacts side by side; [p] is the contact point.
struct Batch {
    alignas(64) double edge_x[n], edge_y[n], edge_squared[n], area[n];
    alignas(64) double jump_x[2][n], jump_y[2][n];
    alignas(64) double tangent_x[n], tangent_y[n], inv_length[n];
    alignas(64) double old_opening[2][n], opening[2][n], old_sliding[2][n], sliding[2][n];
    alignas(64) double normal_traction[2][n], shear_traction[2][n];
    alignas(64) double intact[2][n];    ///< 1 while the point has not failed, else 0
    alignas(64) double ordinary[2][n];  ///< 1 where the intact law holds, else 0
    alignas(64) double cohesion_left[2][n];
    alignas(64) double fracture[2][n];  ///< booked by the intact law, J
    alignas(64) double force[8][n];     ///< x, y on a1, a2, b1, b2
};

void gather(const Assemblage& a, const State& s, Range range, Batch& b) {
    for (std::int32_t i = 0; i < range.size(); ++i) {
        const std::int32_t c = range.begin + i;
        const ContactGeometry& g = a.contacts[c];
        const Vector2 ua1 = s.displacement[g.nodes[0]];
        const Vector2 ua2 = s.displacement[g.nodes[1]];
        const Vector2 ub1 = s.displacement[g.nodes[2]];
        const Vector2 ub2 = s.displacement[g.nodes[3]];
        const Vector2 turn = 0.5 * ((ua2 - ua1) + (ub2 - ub1));
        b.edge_x[i] = g.edge.x + turn.x;
        b.edge_y[i] = g.edge.y + turn.y;
        b.edge_squared[i] = 4 * g.point_area * g.point_area;
        b.area[i] = g.point_area;
        b.jump_x[0][i] = ub1.x - ua1.x;
        b.jump_y[0][i] = ub1.y - ua1.y;
        b.jump_x[1][i] = ub2.x - ua2.x;
        b.jump_y[1][i] = ub2.y - ua2.y;
        for (std::int32_t p = 0; p < 2; ++p) {
            b.old_opening[p][i] = s.opening[2 * c + p];
            b.old_sliding[p][i] = s.sliding[2 * c + p];
            b.cohesion_left[p][i] = s.cohesion_left[2 * c + p];
            b.intact[p][i] = s.failed[2 * c + p] == 0 ? 1.0 : 0.0;
        }
    }
}

GRAINCRACK_VECTOR_TARGETS void find_motions(std::int32_t count, Batch& b) {
    for (std::int32_t i = 0; i < count; ++i) {
        const double squared = b.edge_x[i] * b.edge_x[i] + b.edge_y[i] * b.edge_y[i];
        const double inv = squared < lost_frame * b.edge_squared[i] ? 0.0 : 1 / std::sqrt(squared);
        b.inv_length[i] = inv;
        b.tangent_x[i] = inv * b.edge_x[i];
        b.tangent_y[i] = inv * b.edge_y[i];
    }
    for (std::int32_t p = 0; p < 2; ++p) {
        for (std::int32_t i = 0; i < count; ++i) {
            // n = t turned by −90° = (ty, −tx)
            b.opening[p][i] = b.jump_x[p][i] * b.tangent_y[i] - b.jump_y[p][i] * b.tangent_x[i];
            b.sliding[p][i] = b.jump_x[p][i] * b.tangent_x[i] + b.jump_y[p][i] * b.tangent_y[i];
        }
    }
}

/// \return number of points that need the full law
template <class Law>
GRAINCRACK_VECTOR_TARGETS std::int32_t apply_intact_law(const ContactLaw& constants, std::int32_t count, Batch& b) {
    const ContactLaw law = constants;  // a copy that no store can change
    std::int32_t left_over = 0;
    for (std::int32_t p = 0; p < 2; ++p) {
        for (std::int32_t i = 0; i < count; ++i) {
            const IntactResponse r = Law::intact(
                law, {b.old_opening[p][i], b.old_sliding[p][i], b.opening[p][i], b.sliding[p][i], b.cohesion_left[p][i]});
            const double ordinary = r.holds * b.intact[p][i];
            b.normal_traction[p][i] = r.normal;
            b.shear_traction[p][i] = r.shear;
            b.ordinary[p][i] = ordinary;
            if constexpr (Law::damages_intact) {
                b.cohesion_left[p][i] = ordinary == 0 ? b.cohesion_left[p][i] : r.cohesion_left;
                b.fracture[p][i] = ordinary == 0 ? 0.0 : b.area[i] * r.fracture;
            }
        }
        for (std::int32_t i = 0; i < count; ++i) {
            left_over += b.ordinary[p][i] == 0 ? 1 : 0;
        }
    }
    return left_over;
}

/// Sum over the points of a block that are open, or closed.
GRAINCRACK_VECTOR_TARGETS double fracture_sum(const Batch& b, bool open) {
    double sum[lanes] = {};
    for (std::int32_t p = 0; p < 2; ++p) {
        for (std::int32_t i = 0; i < n; i += lanes) {
            for (std::int32_t k = 0; k < lanes; ++k) {
                sum[k] += (b.opening[p][i + k] >= 0) == open ? b.fracture[p][i + k] : 0.0;
            }
        }
    }
    return ((sum[0] + sum[1]) + (sum[2] + sum[3])) + ((sum[4] + sum[5]) + (sum[6] + sum[7]));
}

/// Damage before the peak: β and the energy it takes, on the branch it happens on.
void book_intact_damage(std::int32_t block, Range range, Batch& b, State& s) {
    for (std::int32_t p = 0; p < 2; ++p) {
        for (std::int32_t i = range.size(); i < n; ++i) {
            b.fracture[p][i] = b.opening[p][i] = 0;
        }
        for (std::int32_t i = 0; i < range.size(); ++i) {
            const auto point = 2 * static_cast<std::size_t>(range.begin + i) + static_cast<std::size_t>(p);
            s.cohesion_left[point] = b.cohesion_left[p][i];
            s.fracture_energy[point] += b.fracture[p][i];
        }
    }
    s.contact_sums[block].fracture_tension += fracture_sum(b, true);
    s.contact_sums[block].fracture_shear += fracture_sum(b, false);
}

/// The full law at one point: energies and events on top of the traction.
ContactTraction advance_point(const Assemblage& a, const ContactLaw& law, std::int32_t block, std::int32_t c, std::int32_t p,
                              const ContactMotion& to, const Vector2& tangent, std::int64_t step, State& s) {
    const std::size_t point = 2 * static_cast<std::size_t>(c) + static_cast<std::size_t>(p);
    const ContactGeometry& g = a.contacts[c];
    ContactHistory& history = s.points[point];
    history.motion = {s.opening[point], s.sliding[point]};
    history.cohesion_left = s.cohesion_left[point];
    const ContactResponse r = update_contact(law, to, history);
    ContactSums& sums = s.contact_sums[block];
    const double fracture = g.point_area * r.dissipation.fracture;
    // Damage before the peak (consistent) counts to the branch it happens on.
    const bool tensile = r.history.failed() ? r.history.first_mode == CrackMode::tensile : to.opening >= 0;
    (tensile ? sums.fracture_tension : sums.fracture_shear) += fracture;
    s.fracture_energy[point] += fracture;
    sums.friction += g.point_area * r.dissipation.friction;
    sums.mismatch += g.point_area * r.dissipation.mismatch;
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
            s.events[block].push_back(event);
        }
        if (separates) {
            event.is_separation = true;
            s.events[block].push_back(event);
        }
    }
    history = r.history;
    s.failed[point] = history.failed() ? 1 : 0;
    s.cohesion_left[point] = history.cohesion_left;
    return r.traction;
}

void apply_full_law(const Assemblage& a, const ContactLaw& law, std::int32_t block, std::int64_t step, State& s, Batch& b) {
    const Range range = a.contact_blocks[block];
    for (std::int32_t i = 0; i < range.size(); ++i) {
        for (std::int32_t p = 0; p < 2; ++p) {
            if (s.touches.released[range.begin + i] != 0) {
                b.normal_traction[p][i] = b.shear_traction[p][i] = 0;
            } else if (b.ordinary[p][i] == 0) {
                const ContactTraction t = advance_point(a, law, block, range.begin + i, p, {b.opening[p][i], b.sliding[p][i]},
                                                        {b.tangent_x[i], b.tangent_y[i]}, step, s);
                b.normal_traction[p][i] = t.normal;
                b.shear_traction[p][i] = t.shear;
            }
        }
    }
}

/// Tractions at the nodes, and the couple that balances the moment they would exert because they act at a jump's length from
/// each other: the frame turns with the mid-edge, and its share of the forces keeps angular momentum and energy exact.
GRAINCRACK_VECTOR_TARGETS void find_forces(std::int32_t count, Batch& b) {
    for (std::int32_t i = 0; i < count; ++i) {
        const double tx = b.tangent_x[i];
        const double ty = b.tangent_y[i];
        const double n0 = b.area[i] * b.normal_traction[0][i];
        const double n1 = b.area[i] * b.normal_traction[1][i];
        const double s0 = b.area[i] * b.shear_traction[0][i];
        const double s1 = b.area[i] * b.shear_traction[1][i];
        const double moment = (n0 * b.sliding[0][i] - s0 * b.opening[0][i]) + (n1 * b.sliding[1][i] - s1 * b.opening[1][i]);
        const double couple = 0.5 * moment * b.inv_length[i];
        const double couple_x = couple * ty;
        const double couple_y = -couple * tx;
        const double f0x = n0 * ty + s0 * tx;
        const double f0y = -n0 * tx + s0 * ty;
        const double f1x = n1 * ty + s1 * tx;
        const double f1y = -n1 * tx + s1 * ty;
        b.force[0][i] = f0x - couple_x;
        b.force[1][i] = f0y - couple_y;
        b.force[2][i] = f1x + couple_x;
        b.force[3][i] = f1y + couple_y;
        b.force[4][i] = -f0x - couple_x;
        b.force[5][i] = -f0y - couple_y;
        b.force[6][i] = -f1x + couple_x;
        b.force[7][i] = -f1y + couple_y;
    }
}

void scatter(Range range, const Batch& b, State& s) {
    for (std::int32_t i = 0; i < range.size(); ++i) {
        const auto c = static_cast<std::size_t>(range.begin + i);
        Vector2* slots = &s.contact_force[4 * c];
        for (std::size_t k = 0; k < 4; ++k) {
            slots[k] = {b.force[2 * k][i], b.force[2 * k + 1][i]};
        }
        for (std::size_t p = 0; p < 2; ++p) {
            s.opening[2 * c + p] = b.opening[p][i];
            s.sliding[2 * c + p] = b.sliding[p][i];
        }
    }
}

}  // namespace

void advance_contacts(const Assemblage& a, const ContactLaw& law, std::int32_t block, std::int64_t step, State& s) {
    const Range range = a.contact_blocks[block];
    Batch batch;
    gather(a, s, range, batch);
    find_motions(range.size(), batch);
    const std::int32_t left_over = contact_law::with_law(law.variant, [&](auto kind) {
        using Law = decltype(kind);
        const std::int32_t n_left = apply_intact_law<Law>(law, range.size(), batch);
        if constexpr (Law::damages_intact) {
            book_intact_damage(block, range, batch, s);
        }
        return n_left;
    });
    if (left_over > 0) {
        apply_full_law(a, law, block, step, s, batch);
    }
    find_forces(range.size(), batch);
    scatter(range, batch, s);
}

}  // namespace graincrack
