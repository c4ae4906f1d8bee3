#include "mesher/point_relaxation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mesher/point_sampling.hpp"
#include "share/error.hpp"

namespace graincrack::mesher {
namespace {

const Shape rectangle{ShapeKind::rectangle, 0.08, 0.16, Pole::facet};

/// A relaxed rectangle of edge 8 mm; the sample has more or fewer points than wanted if its distance is not 0.77 edges.
PlaneMesh relaxed(std::uint64_t seed, std::size_t n_inner, double sampling_distance, Outline& outline) {
    constexpr double edge = 8e-3;
    RandomNumbers random(seed);
    outline = make_outline(rectangle, 60, 0.07, random);
    const auto inner = sample_points(rectangle, sampling_distance * edge, 0.7 * edge, random);
    return relax_points(rectangle, outline, inner, {edge, 0.1, n_inner}, random);
}

double variation(const PlaneMesh& mesh) {
    std::vector<double> lengths;
    for (const Edge& e : mesh.edges) {
        lengths.push_back(length(mesh.points[static_cast<std::size_t>(e[1])] - mesh.points[static_cast<std::size_t>(e[0])]));
    }
    const double n = static_cast<double>(lengths.size());
    const double mean = std::accumulate(lengths.begin(), lengths.end(), 0.0) / n;
    double squares = 0;
    for (const double l : lengths) squares += (l - mean) * (l - mean);
    return std::sqrt(squares / n) / mean;
}

TEST(PointRelaxation, MeetsTheNumberOfPointsFromAnySample) {
    for (const double distance : {0.65, 0.77, 0.9, 1.3}) {
        Outline outline;
        const PlaneMesh mesh = relaxed(1, 200, distance, outline);
        EXPECT_EQ(mesh.points.size(), 260U) << distance;
        EXPECT_EQ(mesh.triangles.size(), 2 * 200 + 60 - 2U) << distance;
        EXPECT_LT(variation(mesh), 0.13) << distance;
    }
}

TEST(PointRelaxation, LeavesTheOutlineAlone) {
    Outline outline;
    const PlaneMesh mesh = relaxed(2, 200, 0.77, outline);
    EXPECT_TRUE(std::equal(outline.points.begin(), outline.points.end(), mesh.points.begin()));
    for (std::size_t i = outline.points.size(); i < mesh.points.size(); ++i) {
        EXPECT_GT(depth_inside(rectangle, mesh.points[i]), 2e-3);
    }
}

TEST(PointRelaxation, CornersBelongToTwoGrains) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Outline outline;
        const PlaneMesh mesh = relaxed(seed, 200, 0.77, outline);
        for (const int corner : outline.corners) {
            const auto n = std::count_if(mesh.triangles.begin(), mesh.triangles.end(),
                                         [&](const Triangle& t) { return std::find(t.begin(), t.end(), corner) != t.end(); });
            EXPECT_GE(n, 2) << "an ear, seed " << seed;
        }
        for (const Edge& e : mesh.edges) {
            EXPECT_LT(length(mesh.points[static_cast<std::size_t>(e[1])] - mesh.points[static_cast<std::size_t>(e[0])]),
                      1.6 * 8e-3)
                << seed;
        }
    }
}

TEST(PointRelaxation, WiderSpreadIsMadeOnRequest) {
    RandomNumbers random(3);
    const Outline outline = make_outline(rectangle, 120, 0.1, random);
    const auto inner = sample_points(rectangle, 0.77 * 4e-3, 0.7 * 4e-3, random);
    const auto of_spread = [&](double spread) {
        RandomNumbers same(4);
        return variation(relax_points(rectangle, outline, inner, {4e-3, spread, 870}, same));
    };
    EXPECT_NEAR(of_spread(0.15), 0.15, 0.02);
    EXPECT_NEAR(of_spread(0.25), 0.25, 0.03);
}

}  // namespace
}  // namespace graincrack::mesher
