// Measures strains on the specimen.
#pragma once

#include <cstdint>
#include <vector>

#include "share/file/specimen.hpp"
#include "solver/model/assemblage.hpp"

namespace graincrack {

/// A strain as a linear function Σ weight · component of displacements, by least squares over the nodes of a region.
struct Gauge {
    struct Term {
        std::int32_t node;
        double weight;  ///< 1/m
    };
    bool along_y = false;
    std::vector<Term> terms;      ///< ascending by node
    std::vector<Range> of_chunk;  ///< terms of each chunk of nodes
    /// The part of the strain from the nodes of a chunk.
    [[nodiscard]] double strain_of(std::int32_t chunk, const std::vector<Vector2>& displacement) const;
};

struct GaugeStrains {
    double axial = 0, lateral = 0, widening = 0;
    using IsSum = void;
};

/// The strain measures of the history apart from that of the platens.
struct Gauges {
    Gauge axial;     ///< slope of u_y over y in the central half
    Gauge lateral;   ///< slope of u_x over x in the central half
    Gauge widening;  ///< mean u_x of the right boundary less that of the left, over the width
    [[nodiscard]] GaugeStrains strains(const Assemblage& assemblage, const std::vector<Vector2>& displacement) const;
};
/// Makes the gauges. The central half is |y| ≤ height/4 and, in a specimen without end faces (a disc), |x| ≤ width/4. The
/// boundary gauge uses the left and right parts of the boundary or, in a disc, the rim within 15° of the x axis.
Gauges make_gauges(const Assemblage& assemblage, const Specimen& specimen);

}  // namespace graincrack
