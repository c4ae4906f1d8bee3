#include "solver/step/element_forces.hpp"

#include <array>
#include <cmath>

#include "solver/arithmetic/simd.hpp"

namespace graincrack {
namespace {

/// Edge displacements of the elements of a chunk, side by side, m.
struct ElementLanes {
    static constexpr std::int32_t n = elements_per_chunk;
    alignas(64) double a_x[n], a_y[n], b_x[n], b_y[n];
};

/// Geometry and elasticity of elements side by side.
struct Triangles {
    const double *gradient1_x, *gradient1_y, *gradient2_x, *gradient2_y, *area;
    const double *c11, *c12, *mu;
};
Triangles triangles_from(const Assemblage& a, std::int32_t e) {
    const TriangleTable& t = a.element_geometry;
    const ElasticityTable& c = a.elasticity;
    return {&t.gradient1_x[e], &t.gradient1_y[e], &t.gradient2_x[e], &t.gradient2_y[e],
            &t.area[e],        &c.c11[e],         &c.c12[e],         &c.mu[e]};
}

void gather_elements(const Assemblage& a, Range elements, const State& s, ElementLanes& b) {
    const std::array<std::int32_t, 3>* const nodes = &a.element_nodes[elements.begin];
    const Vector2* const displacement = s.displacement.data();
    for (std::int32_t i = 0; i < elements.size(); ++i) {
        const auto [n0, n1, n2] = nodes[i];
        const Vector2 u0 = displacement[n0];
        const Vector2 to1 = displacement[n1] - u0;
        const Vector2 to2 = displacement[n2] - u0;
        b.a_x[i] = to1.x;
        b.a_y[i] = to1.y;
        b.b_x[i] = to2.x;
        b.b_y[i] = to2.y;
    }
}

/// Heated elements of a chunk, side by side: free strain and modulus_factor, and the resulting stress and stored energy.
struct WarmLanes {
    static constexpr std::int32_t n = elements_per_chunk;
    alignas(64) double free_xx[n], free_yy[n], free_xy[n], softening[n], txx[n], tyy[n], txy[n], energy[n];
};
void gather_warmth(const Expansion& expansion, Range elements, const Warmth& warmth, WarmLanes& w) {
    for (std::int32_t i = 0; i < elements.size(); ++i) {
        const std::int32_t e = elements.begin + i;
        const PlaneWarmth& phase = warmth.of_phase[expansion.phase[e]];
        const FreeStrain free = free_strain(phase.across, phase.more_along, expansion.axis[e]);
        w.free_xx[i] = free.xx;
        w.free_yy[i] = free.yy;
        w.free_xy[i] = free.xy;
        w.softening[i] = phase.softening;
    }
}

/// Computes the forces of triangles. \param force [6][n] x and y on the three nodes, N
template <bool has_temperature>
GRAINCRACK_INLINE void find_forces_of_triangles(const Triangles& triangles, std::int32_t count, const ElementLanes& b,
                                                double* __restrict force, WarmLanes* __restrict w = nullptr) {
    constexpr std::int32_t n = ElementLanes::n;
    const Triangles t = triangles;
    for (std::int32_t i = 0; i < count; ++i) {
        const TriangleGeometry g{{t.gradient1_x[i], t.gradient1_y[i]}, {t.gradient2_x[i], t.gradient2_y[i]}, t.area[i]};
        PlaneElasticity c{t.c11[i], t.c12[i], t.mu[i], 0};
        FreeStrain free;
        if constexpr (has_temperature) {
            c = softened(c, w->softening[i]);
            free = {w->free_xx[i], w->free_yy[i], w->free_xy[i]};
        }
        const TriangleState state = triangle_state(g, c, {b.a_x[i], b.a_y[i]}, {b.b_x[i], b.b_y[i]}, free);
        const TriangleForces f = triangle_forces(g, state);
        if constexpr (has_temperature) {
            w->txx[i] = state.txx;
            w->tyy[i] = state.tyy;
            w->txy[i] = state.txy;
            w->energy[i] = triangle_energy(g, state);
        }
        force[i] = -(f.on_node1.x + f.on_node2.x);
        force[n + i] = -(f.on_node1.y + f.on_node2.y);
        force[2 * n + i] = f.on_node1.x;
        force[3 * n + i] = f.on_node1.y;
        force[4 * n + i] = f.on_node2.x;
        force[5 * n + i] = f.on_node2.y;
    }
}

/// Energy stored in the heated elements of a chunk, J, and its derivative by temperature at fixed displacements, J/K.
struct WarmEnergy {
    double stored = 0, rate = 0;
    using IsSum = void;
};
WarmEnergy energy_of(const Assemblage& a, Range elements, const Warmth& warmth, const WarmLanes& w) {
    return sum_over(elements, [&](std::int32_t e) {
        const std::int32_t i = e - elements.begin;
        const PlaneWarmth& phase = warmth.of_phase[a.expansion.phase[e]];
        const double area = a.element_geometry.area[e];
        const FreeStrain rate = free_strain(phase.across_rate, phase.more_along_rate, a.expansion.axis[e]);
        return WarmEnergy{w.energy[i] + area * phase.energy_zz,
                          phase.softening_rate * w.energy[i] +
                              area * (phase.energy_zz_rate - rate.xx * w.txx[i] - rate.yy * w.tyy[i] - 2 * rate.xy * w.txy[i])};
    });
}

/// Computes the forces of elements with a temperature, and the work of its changes.
void find_forces_of_warm_elements(const Assemblage& a, const Warmth& warmth, std::int32_t chunk, State& s) {
    constexpr double largest_step = 1;  // K; a larger step does not count as straight
    const Range elements = a.element_chunks[chunk];
    const Triangles triangles = triangles_from(a, elements.begin);
    double* const force = &s.element_force[element_slot_stride * static_cast<std::size_t>(chunk)];
    ElementLanes b;
    gather_elements(a, elements, s, b);
    const auto find_forces = [&](const Warmth& at) {
        WarmLanes w;
        gather_warmth(a.expansion, elements, at, w);
        run_on(a.vector_target,
               [&]() GRAINCRACK_KERNEL { find_forces_of_triangles<true>(triangles, elements.size(), b, force, &w); });
        return energy_of(a, elements, at, w);
    };
    ThermalState& thermal = s.thermal[chunk];
    const double change = warmth.temperature - thermal.temperature;
    const bool jumps = std::abs(change) > largest_step;
    Warmth before;
    if (jumps) before.go_to(thermal.temperature, a.expansion);
    const WarmEnergy from = jumps ? find_forces(before) : WarmEnergy{};
    const WarmEnergy to = find_forces(warmth);
    // This is the part of the change of stored energy at fixed displacements that the mean of the two rates misses.
    if (jumps) thermal.work += to.stored - from.stored - 0.5 * (from.rate + to.rate) * change;
    thermal.go_to(warmth.temperature, to.rate);
}

}  // namespace

void find_element_forces(const Assemblage& a, const Warmth& warmth, std::int32_t chunk, State& s) {
    if (!s.thermal.empty()) return find_forces_of_warm_elements(a, warmth, chunk, s);
    const Range elements = a.element_chunks[chunk];
    const Triangles triangles = triangles_from(a, elements.begin);
    ElementLanes b;
    gather_elements(a, elements, s, b);
    run_on(a.vector_target, [&]() GRAINCRACK_KERNEL {
        find_forces_of_triangles<false>(triangles, elements.size(), b,
                                        &s.element_force[element_slot_stride * static_cast<std::size_t>(chunk)]);
    });
}

}  // namespace graincrack
