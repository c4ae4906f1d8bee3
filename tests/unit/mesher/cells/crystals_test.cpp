#include "mesher/cells/crystals.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "mesher/fabric/crystals.hpp"
#include "share/file/specimen.hpp"
#include "share/file/specimen_measures.hpp"
#include "tests/unit/mesher/test_requests.hpp"

namespace graincrack::mesher {
namespace {

Request crystals_of(const Region& region, std::int64_t n, Tessellation tessellation = Tessellation::voronoi) {
    return {.region = region, .fabric = {.tessellation = tessellation, .grains = n, .spread = 0.3}};
}

TEST(Crystals, BecomeValidSpecimens) {
    const std::vector<Region> regions{rectangle(0.08, 0.16), disc(0.08), disc(0.08, Pole::vertex, 6, 2), half_disc(0.1),
                                      disc_with_flats(0.05, 0.3)};
    for (const Region& region : regions) {
        for (const Tessellation tessellation : {Tessellation::voronoi, Tessellation::trigon}) {
            for (const std::int64_t n : {2, 15, 300}) {
                for (const double spread : {0.0, 0.6}) {
                    Request request = crystals_of(region, n, tessellation);
                    request.fabric.spread = spread;
                    const Specimen s = valid_mesh(request);
                    EXPECT_EQ(number_of_crystals(s), static_cast<std::size_t>(n));
                    const bool is_trigon = tessellation == Tessellation::trigon;
                    EXPECT_EQ(s.tessellation, is_trigon ? "trigon" : "voronoi");
                    EXPECT_EQ(s.n_grains(), is_trigon ? s.n_elements() : static_cast<std::size_t>(n));
                    EXPECT_NEAR(s.statistics.area_error, 0, 1e-5);
                }
            }
        }
    }
}

TEST(Crystals, HaveTheirSizes) {
    for (const double spread : {0.1, 0.3, 0.6}) {
        for (const SizeDistribution distribution : {SizeDistribution::normal, SizeDistribution::lognormal}) {
            for (const std::int64_t n : {100, 1000}) {
                Request request = crystals_of(rectangle(0.08, 0.16), n);
                request.fabric.spread = spread;
                request.fabric.size_distribution = distribution;
                MeshReport report;
                const Specimen s = mesh(request, {}, &report);
                EXPECT_NEAR(s.statistics.diameter_variation / spread, 1, 1e-6);
                EXPECT_NEAR(report.spread, s.statistics.diameter_variation, 1e-9);
                EXPECT_LE(report.largest_area_error, 1e-6);
                EXPECT_EQ(report.n_edges_left, 0U);
            }
        }
    }
    Request request = request_of_edge(rectangle(0.08, 0.16), 0.004);
    request.fabric.tessellation = Tessellation::voronoi;
    EXPECT_EQ(mesh(request).n_grains(), 1848U) << "√3/4 · 4² mm² each";
}

TEST(Crystals, HaveTheirSizesWhereTheyAreFew) {
    for (const double spread : {0.0, 0.1, 0.6}) {
        for (std::uint64_t seed = 1; seed <= 50; ++seed) {
            Request request = crystals_of(seed % 2 == 0 ? disc(0.08) : rectangle(0.04, 0.08), seed % 4 < 2 ? 20 : 30);
            request.fabric.spread = spread;
            request.seed = seed;
            const MeshReport report = tessellate(request, plan_mesh(request)).report;
            EXPECT_LE(report.largest_area_error, 1e-6) << spread << " " << seed;
            EXPECT_NEAR(report.spread, spread, 1e-6) << seed;
        }
    }
}

TEST(Crystals, FollowFlawsHolesAndOutlinesWithTheirSizes) {
    Region slit = half_disc(0.08);
    slit.edges = {slit_from_below(slit, 0.02, "slit")};
    Region hole = rectangle(0.06, 0.08);
    add_hole(hole, {0.004, 0.002}, 0.008, "--hole");
    Region crossed = disc(0.08);
    crossed.edges = {central_slit(crossed, 0.03, 0.3, "one"), central_slit(crossed, 0.04, 1.4, "another")};
    Region joint = rectangle(0.04, 0.08);
    joint.edges = {{{-0.05, -0.03}, {0.05, 0.03}, {ContactKind::pre_existing_crack, "joint"}, "joint"}};
    const Region notched = polygon({{0, 0}, {0.08, 0}, {0.08, 0.06}, {0.045, 0.06}, {0.04, 0.03}, {0.035, 0.06}, {0, 0.06}}, {});
    const std::vector<std::pair<Region, double>> cases{
        {slit, 0.02}, {hole, 0}, {crossed, 0.07}, {joint, 0.04 * std::hypot(1, 0.6)}, {ring(0.08, 0.03), 0}, {notched, 0}};
    for (auto [region, length] : cases) {
        centre_region(region);
        for (const Tessellation tessellation : {Tessellation::voronoi, Tessellation::trigon}) {
            for (const double ratio : {1.0, 2.0}) {
                Request request = crystals_of(region, 250, tessellation);
                request.fabric.elongation = {ratio, 0.5};
                MeshReport report;
                const Specimen s = valid_mesh(request, &report);
                EXPECT_EQ(number_of_crystals(s), 250U);
                EXPECT_NEAR(broken_length(s), length, 1e-9) << region.name;
                EXPECT_LE(report.largest_area_error, 0.03) << region.name;
                EXPECT_NEAR(report.spread, 0.3, 0.003);
                EXPECT_NEAR(s.statistics.area_error, 0, 1e-3);
                EXPECT_GT(s.statistics.min_angle, ratio > 1 ? 0.1 : 0.2);
            }
        }
    }
}

/// Crystals of a specimen of polygons that do not break, and those of one end of it.
struct AtEnd {
    double n = 0;
    double diameter = 0;  ///< mean
    double elements = 0;  ///< mean number of a crystal
    double element_area = 0;
};
AtEnd crystals_where(const Specimen& s, const std::function<bool(Point)>& is_there) {
    std::vector<Point> moment(s.n_grains());
    std::vector<double> n_elements(s.n_grains(), 0);
    for (std::size_t e = 0; e < s.n_elements(); ++e) {
        std::array<Point, 3> at;
        for (std::size_t k = 0; k < 3; ++k) at[k] = place_of(s, s.element_nodes[e][k]);
        const std::size_t grain = index(s.element_grain[e]);
        moment[grain] = moment[grain] + (signed_area(at[0], at[1], at[2]) / 3) * (at[0] + at[1] + at[2]);
        n_elements[grain] += 1;
    }
    AtEnd end;
    for (std::size_t grain = 0; grain < s.n_grains(); ++grain) {
        if (!is_there((1 / s.grain_area[grain]) * moment[grain])) continue;
        end.n += 1;
        end.diameter += std::sqrt(4 * s.grain_area[grain] / std::numbers::pi);
        end.elements += n_elements[grain];
        end.element_area += s.grain_area[grain];
    }
    end.element_area /= end.elements;
    end.diameter /= end.n;
    end.elements /= end.n;
    return end;
}

// Mean diameters over a strip in which sizes grow linearly from g₀ to g₁ are to the second order √(g₀ g₁). The tolerance of 6 %
// is three standard errors of the fewest crystals at an end (130, whose diameters vary by .1: 2.6 %) and as much for the rows of
// crystals that the end of the strip cuts.
TEST(Crystals, AreGradedAlongAnAxis) {
    for (const bool has_element_size : {false, true}) {
        Request request = crystals_of(rectangle(0.08, 0.16), 4000);
        request.fabric.spread = 0.1;
        request.fabric.grading = parse_grading("along=y,from=0.5,to=2", "--grade");
        if (has_element_size) request.fabric.element_size = 0.4e-3;
        MeshReport report;
        const Specimen s = valid_mesh(request, &report);
        EXPECT_EQ(s.n_grains(), 4000U);
        const AtEnd low = crystals_where(s, [](Point p) { return p.y < -0.06; });  // .5 to .6875
        const AtEnd high = crystals_where(s, [](Point p) { return p.y > 0.06; });  // 1.8125 to 2
        EXPECT_GT(std::min(low.n, high.n), 130);
        EXPECT_NEAR(high.diameter / low.diameter / (std::sqrt(1.8125 * 2) / std::sqrt(0.5 * 0.6875)), 1, 0.06);
        EXPECT_LE(report.largest_area_error, 1e-6);
        EXPECT_NEAR(report.spread, 0.1, 0.002);
        // Elements are as many in each crystal (in areas their ratio would be ten), or of one size but for the corners of
        // crystals.
        EXPECT_NEAR(has_element_size ? high.element_area / low.element_area : high.elements / low.elements, 1, 0.25);
    }
}

TEST(Crystals, AreGradedAroundAHole) {
    Request request = crystals_of(rectangle(0.08, 0.08), 2000);
    add_hole(request.region, {0.005, 0}, 0.01, "--hole");
    request.fabric.spread = 0.1;
    request.fabric.grading = parse_grading("towards=holes,from=0.4,distance=24mm", "--grade");
    MeshReport report;
    const Specimen s = valid_mesh(request, &report);
    EXPECT_EQ(s.n_grains(), 2000U);
    const auto distance = [](Point p) { return length(p - Point{0.005, 0}) - 0.01; };
    const AtEnd near = crystals_where(s, [&](Point p) { return distance(p) < 3e-3; });  // .4 to .475
    const AtEnd far = crystals_where(s, [&](Point p) { return distance(p) > 24e-3; });
    EXPECT_GT(std::min(near.n, far.n), 130);
    EXPECT_NEAR(far.diameter / near.diameter * std::sqrt(0.4 * 0.475), 1, 0.06);
    EXPECT_LE(report.largest_area_error, 1e-6);
    EXPECT_NEAR(report.spread, 0.1, 0.002);
}

// A specimen's middle must be the origin to 0.1 % of its width, also where chords of the rim differ.
TEST(Crystals, KeepTheMiddleOfGradedDiscs) {
    Region slit = disc(0.028);
    slit.edges = {central_slit(slit, 0.014, -0.7, "slit")};
    for (const Region& region : {disc(0.028), slit, disc_with_flats(0.028, 0.5)}) {
        for (const char* grading : {"along=x,from=0.5,to=1.6", "along=y,from=1.6,to=0.5"}) {
            Request request = crystals_of(region, 250);
            request.fabric.grading = parse_grading(grading, "--grade");
            valid_mesh(request);
            request.fabric.elongation = {3, -1.6};
            valid_mesh(request);
        }
    }
}

// A joint at half the height divides the integral of 1/g², g from .5 to 2, by .8 to .2.
TEST(Crystals, AreSharedBySizeBetweenTheSidesOfAJoint) {
    Request request = crystals_of(rectangle(0.08, 0.16), 500);
    request.fabric.spread = 0;
    request.region.edges = {{{-0.05, 0}, {0.05, 0}, {ContactKind::pre_existing_crack, "joint"}, "joint"}};
    request.fabric.grading = parse_grading("along=y,from=0.5,to=2", "--grade");
    const Specimen s = valid_mesh(request);
    EXPECT_NEAR(crystals_where(s, [](Point p) { return p.y < 0; }).n, 400, 2);
    EXPECT_NEAR(crystals_where(s, [](Point p) { return p.y > 0; }).n, 100, 2);
}

// A joint cuts off a tenth. The tolerance is three standard errors of its 50 diameters, which vary by .4.
TEST(Crystals, AreLargeAndSmallInEachPart) {
    Request request = crystals_of(rectangle(0.08, 0.16), 500);
    request.fabric.spread = 0.4;
    request.region.edges = {{{-0.05, 0.064}, {0.05, 0.064}, {ContactKind::pre_existing_crack, "joint"}, "joint"}};
    const Specimen s = mesh(request);
    const AtEnd small = crystals_where(s, [](Point p) { return p.y > 0.064; });
    const AtEnd large = crystals_where(s, [](Point p) { return p.y < 0.064; });
    EXPECT_EQ(small.n + large.n, 500);
    EXPECT_NEAR(small.diameter / large.diameter, 1, 3 * 0.4 / std::sqrt(50.0));
}

TEST(Crystals, NameTheFlawsThatLeaveNoRoom) {
    Region region = rectangle(0.08, 0.16);
    for (const double y : {-0.04, 0.0, 0.04}) {
        const std::string name = "flaws.tsv: line " + std::to_string(3 + std::lround(y / 0.04));
        region.edges.push_back({{-0.1, y}, {0.1, y}, {ContactKind::pre_existing_crack, "joint"}, name});
    }
    test::Refusals refused;
    refused.add<UsageError>("four parts for three crystals", [&] { (void)mesh(crystals_of(region, 3)); });
    test::expect_golden(refused.text());
}

TEST(Crystals, RefuseWhatTheyDoNotHave) {
    const PrescribedEdge beside_the_boundary{{0, -0.0795}, {0.02, -0.0795}, {}, "slit"};
    Request pair = crystals_of(rectangle(0.08, 0.16), 2);
    pair.fabric.phases.fractions = {{"a", 0.2}, {"b", 0.3}, {"c", 0.5}};
    Request triangles_of_elements = rectangle_of(100);
    triangles_of_elements.fabric.element_size = 0.001;
    Request normal_triangles = rectangle_of(100);
    normal_triangles.fabric.size_distribution = SizeDistribution::normal;
    compare_refusals(crystals_of(rectangle(0.08, 0.16), 100),
                     {{"a notch", [](Request& r) { r.notch = 0.001; }},
                      {"a flaw beside the boundary", [&](Request& r) { r.region.edges = {beside_the_boundary}; }},
                      {"a hole of 3 mm", [](Request& r) { add_hole(r.region, Point(), 0.003, "--hole"); }},
                      {"2 elements an edge", [](Request& r) { r.fabric.elements_per_edge = 2; }},
                      {"graded towards no hole", graded("towards=holes,from=0.5,distance=20mm")},
                      {"graded in steps", graded("towards=boundary,from=0.5,distance=5mm")},
                      {"a spread of 0.61", [](Request& r) { r.fabric.spread = 0.61; }},
                      {"1 crystal", [](Request& r) { r.fabric.grains = 1; }},
                      {"2,000,000 crystals", [](Request& r) { r.fabric.grains = 2'000'000; }},
                      {"elements of 1 um", [](Request& r) { r.fabric.element_size = 1e-6; }},
                      {"3 phases of 2 crystals", [&](Request& r) { r = pair; }},
                      {"a size of elements of triangles", [&](Request& r) { r = triangles_of_elements; }},
                      {"a distribution of triangles", [&](Request& r) { r = normal_triangles; }}});
}

}  // namespace
}  // namespace graincrack::mesher
