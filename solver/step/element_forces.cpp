#include "solver/step/element_forces.hpp"

#include <array>

#include "solver/arithmetic/simd.hpp"

namespace graincrack {
namespace {

/// Edge displacements of the elements of a chunk, side by side.
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

/// The temperature of elements side by side.
struct Warmth {
    double temperature;      ///< K
    const double* in_plane;  ///< expansion, 1/K
    double* trace;           ///< σxx + σyy that comes out, Pa
};

/// \param force [6][n] x, y on the three nodes
template <bool has_temperature>
GRAINCRACK_INLINE void find_forces_of_triangles(const Triangles& triangles, std::int32_t count, const ElementLanes& b,
                                                double* __restrict force, const Warmth& warmth = {}) {
    constexpr std::int32_t n = ElementLanes::n;
    const Triangles t = triangles;
    for (std::int32_t i = 0; i < count; ++i) {
        const TriangleGeometry g{{t.gradient1_x[i], t.gradient1_y[i]}, {t.gradient2_x[i], t.gradient2_y[i]}, t.area[i]};
        const PlaneElasticity c{t.c11[i], t.c12[i], t.mu[i], 0};
        const double free_strain = has_temperature ? warmth.in_plane[i] * warmth.temperature : 0;
        const TriangleState state = triangle_state(g, c, {b.a_x[i], b.a_y[i]}, {b.b_x[i], b.b_y[i]}, free_strain);
        const TriangleForces f = triangle_forces(g, state);
        if constexpr (has_temperature) warmth.trace[i] = state.txx + state.tyy;
        force[i] = -(f.on_node1.x + f.on_node2.x);
        force[n + i] = -(f.on_node1.y + f.on_node2.y);
        force[2 * n + i] = f.on_node1.x;
        force[3 * n + i] = f.on_node1.y;
        force[4 * n + i] = f.on_node2.x;
        force[5 * n + i] = f.on_node2.y;
    }
}

/// Where elements have a temperature: also the work that it does.
void find_forces_of_warm_elements(const Assemblage& a, double temperature, std::int32_t chunk, State& s) {
    const Range elements = a.element_chunks[chunk];
    const Triangles triangles = triangles_from(a, elements.begin);
    const ExpansionTable& x = a.expansion;
    double* const force = &s.element_force[element_slot_stride * static_cast<std::size_t>(chunk)];
    alignas(64) double trace[elements_per_chunk];
    const Warmth warmth{temperature, &x.in_plane[elements.begin], trace};
    ElementLanes b;
    gather_elements(a, elements, s, b);
    run_on(a.vector_target,
           [&]() GRAINCRACK_KERNEL { find_forces_of_triangles<true>(triangles, elements.size(), b, force, warmth); });
    s.thermal[chunk].go_to(temperature, sum_over(elements, [&](std::int32_t e) {
                               return a.element_geometry.area[e] *
                                      (x.stiffness_zz[e] * temperature - x.in_plane[e] * trace[e - elements.begin]);
                           }));
}

}  // namespace

void find_element_forces(const Assemblage& a, double temperature, std::int32_t chunk, State& s) {
    if (!s.thermal.empty()) return find_forces_of_warm_elements(a, temperature, chunk, s);
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
