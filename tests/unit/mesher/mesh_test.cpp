#include "mesher/mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "mesher/cells/triangles.hpp"
#include "mesher/mesh_report.hpp"
#include "mesher/seeds/orientation.hpp"
#include "share/base/error.hpp"
#include "share/file/h5_file.hpp"
#include "share/file/specimen.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/mesher/test_requests.hpp"

namespace graincrack::mesher {
namespace {

Request disc_of(std::int64_t grains, std::uint64_t seed = 1, Pole pole = Pole::facet) {
    Request request;
    request.region = disc(0.08, pole);
    request.fabric.grains = grains;
    request.seed = seed;
    return request;
}

/// psi6 from the specimen's own arrays, each grain boundary counted once: independent of the mesher's statistics.
struct Order {
    double whole = 0;
    double parts = 0;
};
Order order_of(const Specimen& s, const Region& region) {
    std::vector<Point> points;
    std::vector<Edge> edges;
    const auto add = [&](std::int32_t from, std::int32_t to) {
        points.insert(points.end(), {place_of(s, from), place_of(s, to)});
        edges.push_back({static_cast<int>(points.size()) - 2, static_cast<int>(points.size()) - 1});
    };
    for (const auto& contact : s.contact_nodes) add(contact[0], contact[1]);
    for (const auto& edge : s.boundary_edges) add(edge[0], edge[1]);
    Order order{psi6(points, edges), 0};
    for (const Partition partition : {Partition::blocks, Partition::turned, Partition::bands}) {
        order.parts = std::max(order.parts, largest_psi6_of_parts(region, partition, points, edges));
    }
    return order;
}

TEST(Mesh, HasNoPreferredDirection) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        for (const Request& request : {rectangle_of(1122, seed), disc_of(452, seed)}) {
            const Specimen s = mesh(request);
            const Order order = order_of(s, request.region);
            EXPECT_LE(order.whole, 0.15) << "seed " << seed;
            EXPECT_LE(order.parts, 0.30) << "seed " << seed;
            EXPECT_NEAR(order.whole, s.statistics.psi6, 1e-9);
            EXPECT_EQ(static_cast<std::int64_t>(s.n_grains()), *request.fabric.grains);
            EXPECT_LE(s.statistics.edge_variation, 0.11);
            EXPECT_GE(s.statistics.min_angle, 26 * std::numbers::pi / 180);
            EXPECT_NEAR(s.statistics.area_error, 0, 1e-12);
        }
    }
}

TEST(Mesh, NumbersOfGrainsAreExact) {
    for (const std::int64_t grains : {120, 121, 451, 452, 453, 1121}) {
        EXPECT_EQ(mesh(disc_of(grains)).n_grains(), static_cast<std::size_t>(grains));
        EXPECT_EQ(mesh(rectangle_of(grains)).n_grains(), static_cast<std::size_t>(grains));
    }
}

TEST(Mesh, WantedEdgeIsTheMean) {
    for (const double edge : {2e-3, 4e-3, 5.13e-3, 9e-3}) {
        for (const Region& region : {rectangle(0.08, 0.16), disc(0.08)}) {
            Request request;
            request.region = region;
            request.fabric.edge = edge;
            // whole grains allow no better than their own number
            const double tolerance = std::max(0.005, 1.5 * edge * edge / area(region));
            EXPECT_NEAR(mesh(request).statistics.mean_edge / edge, 1, tolerance) << edge;
        }
    }
}

TEST(Mesh, SpreadIsReachedWhereTheMethodCan) {
    for (const double spread : {0.1, 0.12, 0.15, 0.18, 0.2, 0.25, 0.3, 0.35}) {
        for (const std::uint64_t seed : {1U, 2U, 3U}) {
            Request request = rectangle_of(1122, seed);
            request.fabric.spread = spread;
            MeshReport report;
            const Specimen s = mesh(request, {}, &report);
            EXPECT_NEAR(s.statistics.edge_variation, spread, 0.02) << spread;
            EXPECT_NEAR(report.spread, s.statistics.edge_variation, 1e-9);
            EXPECT_GT(s.statistics.min_angle, 8 * std::numbers::pi / 180) << spread;
            EXPECT_EQ(s.n_grains(), 1122U);
            const Order order = order_of(s, request.region);
            EXPECT_LE(order.whole, 0.15);
            EXPECT_LE(order.parts, 0.30);
            EXPECT_EQ(s.statistics.elongation, 0) << "not measured";
        }
    }
    Request request = rectangle_of(1122);
    request.fabric.spread = 0.02;  // only a lattice has so small a spread; the mesher comes as near as it can
    EXPECT_LT(mesh(request).statistics.edge_variation, 0.105);
}

/// Length of the contacts of a kind whose ends lie on a segment to 1e-9 of its length.
double covered(const Specimen& s, const PrescribedEdge& edge) {
    const Curve line{Curve::Kind::prescribed, edge.from, edge.to, unit(edge.to - edge.from), {}};
    double sum = 0;
    for (std::size_t c = 0; c < s.n_contacts(); ++c) {
        const auto at = [&](std::size_t k) { return place_of(s, s.contact_nodes[c][k]); };
        const double slack = 1e-9 * length(edge.to - edge.from);
        if (line.distance(at(0)) > slack || line.distance(at(1)) > slack) continue;
        EXPECT_EQ(s.contact_kind[c], static_cast<std::uint8_t>(edge.kind.start));
        sum += length(at(1) - at(0));
    }
    return sum;
}

/// Mean length of contacts and boundary edges whose middles a test selects.
template <class Select>
double mean_edge_where(const Specimen& s, const Select& select) {
    double n = 0;
    double sum = 0;
    const auto add = [&](std::int32_t from, std::int32_t to) {
        if (!select(midpoint(place_of(s, from), place_of(s, to)))) return;
        n += 1;
        sum += length(place_of(s, to) - place_of(s, from));
    };
    for (const auto& contact : s.contact_nodes) add(contact[0], contact[1]);
    for (const auto& edge : s.boundary_edges) add(edge[0], edge[1]);
    return sum / n;
}

// Mean edges over a strip where sizes are linear: the mean of 1/h over that of 1/h², in closed form √(h₀ h₁) to the second order
// of the strip's width. Some 500 edges of spread 0.1 a strip: 1 %; the rest of the tolerance is for the springs.
TEST(Mesh, SizesAreGradedAlongAnAxis) {
    for (const bool upright : {true, false}) {
        Request request;
        request.region = upright ? rectangle(0.08, 0.16) : rectangle(0.16, 0.08);
        request.fabric.grains = 8000;
        request.fabric.grading = parse_grading(upright ? "along=y,from=0.5,to=2" : "along=x,from=0.5,to=2", "--grade");
        MeshReport report;
        const Specimen s = mesh(request, {}, &report);
        validate(s, "rectangle");
        EXPECT_EQ(s.n_grains(), 8000U);
        const auto along = [&](Point p) { return upright ? p.y : p.x; };
        const double low = mean_edge_where(s, [&](Point p) { return along(p) < -0.07; });  // relative edges 0.5 to 0.594
        const double high = mean_edge_where(s, [&](Point p) { return along(p) > 0.07; });  // 1.906 to 2
        EXPECT_NEAR(high / low, std::sqrt(1.90625 * 2) / std::sqrt(0.5 * 0.59375), 0.04 * 3.58);
        EXPECT_NEAR(report.spread, 0.1, 0.01);
        EXPECT_GT(s.statistics.min_angle, 20 * std::numbers::pi / 180);
        EXPECT_NEAR(s.statistics.area_error, 0, 1e-12);
        request.fabric.grains.reset();
        request.fabric.edge = 2e-3;
        EXPECT_NEAR(mesh(request).statistics.mean_edge / 2e-3, 1, 0.006) << "the mean edge is that asked for";
    }
}

TEST(Mesh, SizesAreGradedTowardsAFlaw) {
    Request request;
    request.region = disc(0.08);
    request.region.edges = {central_slit(request.region, 0.024, 0.8, "--slit")};
    request.fabric.edge = 1.5e-3;
    request.fabric.grading = parse_grading("towards=flaws,from=0.4,distance=15mm", "--grade");
    const Specimen s = mesh(request);
    validate(s, "disc");
    EXPECT_NEAR(s.statistics.mean_edge / 1.5e-3, 1, 0.006);
    const PrescribedEdge& slit = request.region.edges.front();
    const Curve line = curves_of({"", {}, {slit}}).front();
    const double near = mean_edge_where(s, [&](Point p) { return line.distance(p) < 1.5e-3; });  // 0.4 to 0.46
    const double far = mean_edge_where(s, [&](Point p) { return line.distance(p) > 16e-3; });
    EXPECT_NEAR(far / near, 1 / std::sqrt(0.4 * 0.46), 0.05 * 2.33);
    EXPECT_NEAR(covered(s, slit) / 0.024, 1, 1e-9);
    EXPECT_GT(s.statistics.min_angle, 15 * std::numbers::pi / 180);
    EXPECT_NEAR(s.statistics.area_error, 0, 1e-12);
}

TEST(Mesh, GrainsAreElongated) {
    const double turned = std::numbers::pi / 6;
    const auto slit = [](Region region) {
        region.edges = {{{-0.012, -0.004}, {0.012, 0.006}, ContactKind::pre_existing_crack}};
        return region;
    };
    for (const Region& region : {rectangle(0.08, 0.16), disc(0.08, Pole::facet, 6, 1), half_disc(0.1), ring(0.08, 0.03),
                                 slit(rectangle(0.08, 0.16)), slit(disc_with_flats(0.08, 0.3))}) {
        Request request;
        request.region = region;
        request.fabric.edge = 2e-3;
        request.fabric.elongation = {2, turned};
        MeshReport report;
        const Specimen s = mesh(request, {}, &report);
        validate(s, region.name);
        // The boundary has its own directions, and some 5 % of the edges.
        EXPECT_NEAR(s.statistics.elongation, 2, 0.06) << region.name;
        EXPECT_NEAR(s.statistics.elongation_angle, turned + turn_to_load(region), 0.02) << region.name;
        EXPECT_NEAR(s.statistics.mean_edge / 2e-3, 1, 0.006) << region.name;
        EXPECT_NEAR(s.statistics.area_error, 0, 1e-12) << region.name;
        EXPECT_NEAR(report.spread, 0.1, 0.012) << region.name;
        EXPECT_LE(s.statistics.psi6, max_psi6);
        EXPECT_LE(report.psi6_of_parts, max_psi6_of_parts);
        // An angle of 8° becomes 4° at worst where a map elongates by 2.
        EXPECT_GT(report.min_angle, 20 * std::numbers::pi / 180) << region.name;
        EXPECT_GT(s.statistics.min_angle, 10 * std::numbers::pi / 180) << region.name;
        for (const PrescribedEdge& e : region.edges) EXPECT_NEAR(covered(s, e) / length(e.to - e.from), 1, 1e-9) << region.name;
    }
}

TEST(Mesh, AllSizesAtOnceGiveTheSameSpecimenAgain) {
    Request request;
    request.region = rectangle(0.08, 0.12);
    add_hole(request.region, {0.01, 0.02}, 0.008, "--hole");
    request.region.edges = {{{-0.03, -0.03}, {0.02, -0.01}, ContactKind::pre_existing_crack}};
    request.fabric.grains = 2501;
    request.fabric.spread = 0.3;
    request.fabric.grading = parse_grading("towards=flaws,from=0.5,distance=20mm", "--grade");
    request.fabric.elongation = {1.7, -0.5};
    request.fabric.elements_per_edge = 2;
    const Specimen first = mesh(request);
    validate(first, "rectangle");
    EXPECT_EQ(first.n_grains(), 2501U);
    EXPECT_NEAR(covered(first, request.region.edges.front()) / length(Point{0.05, 0.02}), 1, 1e-9);
    const Specimen second = mesh(request);
    EXPECT_EQ(first.node_position, second.node_position);
    EXPECT_EQ(first.contact_nodes, second.contact_nodes);
}

TEST(Mesh, PolesMeetThePlatens) {
    for (const Pole pole : {Pole::facet, Pole::vertex}) {
        const Specimen s = mesh(disc_of(452, 1, pole));
        int facets = 0;
        double highest = 0;
        for (const auto& edge : s.boundary_edges) {
            const double y0 = place_of(s, edge[0]).y;
            const double y1 = place_of(s, edge[1]).y;
            highest = std::max({highest, std::abs(y0), std::abs(y1)});
            if (std::abs(y0) == 0.04 && y0 == y1) ++facets;
        }
        EXPECT_EQ(highest, 0.04);
        EXPECT_EQ(facets, pole == Pole::facet ? 2 : 0);
        EXPECT_EQ(s.loading_arc > 0, pole == Pole::facet);
    }
}

TEST(Mesh, SpecimensAreValidInManyProportionsAndSizes) {
    for (const auto& [width, height, edge] :
         {std::tuple{0.01, 0.2, 5e-3}, std::tuple{0.2, 0.01, 5e-3}, std::tuple{0.05, 0.05, 5e-3}, std::tuple{80e3, 160e3, 5e3},
          std::tuple{80e-6, 160e-6, 5e-6}}) {
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            Request request;
            request.region = rectangle(width, height);
            request.fabric.edge = edge;
            request.seed = seed;
            const Specimen s = mesh(request);
            validate(s, "rectangle");
            EXPECT_NEAR(s.statistics.area_error, 0, 1e-12);
            if (width * height > 100 * edge * edge) {
                EXPECT_NEAR(s.statistics.mean_edge / edge, 1, 0.01);
            }
        }
    }
}

TEST(Mesh, BadRequestsNameTheirOption) {
    const auto changed = [](const auto& change) { return refusal(rectangle_of(1122), change); };
    EXPECT_EQ(refusal(rectangle_of(1122)), "");
    EXPECT_NE(changed([](auto& r) { r.fabric.grains = 0; }).find("--grains"), std::string::npos);
    EXPECT_NE(changed([](auto& r) { r.fabric.grains = -5; }).find("--grains"), std::string::npos);
    EXPECT_NE(changed([](auto& r) { r.fabric.grains.reset(); }).find("--edge"), std::string::npos);
    EXPECT_NE(changed([](auto& r) { r.fabric.edge = 0.005; }).find("--grains"), std::string::npos) << "both";
    EXPECT_NE(changed([](auto& r) { r.fabric.spread = 0.5; }).find("--spread"), std::string::npos);
    EXPECT_NE(changed([](auto& r) { r.fabric.spread = std::nan(""); }).find("--spread"), std::string::npos);
    EXPECT_NE(changed([](auto& r) {
                  r.fabric.grading = Grading{Grading::Kind::towards_flaws, 0.5, 1, 0.02};
              }).find("--grade"),
              std::string::npos);
    EXPECT_NE(changed([](auto& r) {
                  r.fabric.grading = Grading{Grading::Kind::towards_boundary, 0.5, 1, 0.002};
              }).find("--grade"),
              std::string::npos);
    const auto with_edge = [&](double edge) {
        return changed([edge](auto& r) {
            r.fabric.grains.reset();
            r.fabric.edge = edge;
        });
    };
    EXPECT_EQ(with_edge(0.04), "");
    EXPECT_NE(with_edge(0.09).find("--edge"), std::string::npos);
    EXPECT_NE(with_edge(1e-9).find("--edge"), std::string::npos);
}

/// Distances of the nodes from the centre and areas of the grains, each sorted: invariant under rotation and renumbering.
std::vector<double> turned_invariants(const Specimen& s) {
    std::vector<double> radii;
    for (const auto& [x, y] : s.node_position) radii.push_back(std::hypot(x, y));
    std::sort(radii.begin(), radii.end());
    std::vector<double> areas = s.grain_area;
    std::sort(areas.begin(), areas.end());
    radii.insert(radii.end(), areas.begin(), areas.end());
    return radii;
}

// The same grains, rotated: every diameter ends in facets that lie on the platens and are centred on the load.
TEST(Mesh, ADiscIsLoadedAlongEachOfItsDiameters) {
    Request request;
    request.region = disc(0.08);
    request.region.loops.front().circle->diameters = 6;
    request.fabric.grains = 452;
    const std::vector<double> first = turned_invariants(mesh(request));
    double moment_before = 0;
    for (int turn = 0; turn < 6; ++turn) {
        request.region.loops.front().circle->loaded_diameter = turn;
        const Specimen turned = mesh(request);
        EXPECT_EQ(turned.n_grains(), 452U);
        const std::vector<double> now = turned_invariants(turned);
        ASSERT_EQ(now.size(), first.size());
        for (std::size_t i = 0; i < first.size(); ++i) EXPECT_NEAR(now[i], first[i], 1e-16);  // round-off of 0.04 m
        for (const double platen : {0.04, -0.04}) {
            double left = 0;
            double right = 0;
            double inside = 0;
            for (const auto& [x, y] : turned.node_position) {
                if (y == platen) (x < 0 ? left : right) = x;
                if (std::abs(y) < 0.03) inside += x * y;  // differs between the rotated specimens
            }
            EXPECT_LT(left, -0.002);  // half a facet of 5 mm
            EXPECT_NEAR(left, -right, 1e-15);
            EXPECT_NE(inside, moment_before);
            if (platen < 0) moment_before = inside;
        }
    }
    request.region.loops.front().circle->loaded_diameter = 6;
    EXPECT_THROW((void)plan_mesh(request), UsageError);
    request.region = disc(0.08, Pole::facet, 36);
    EXPECT_THROW((void)plan_mesh(request), UsageError);
}

TEST(Mesh, EveryKindOfSpecimenFollowsItsFlaws) {
    const auto slit = [](Region region, double size, double angle) {
        region.edges = {central_slit(region, size, angle, "--slit")};
        return region;
    };
    std::vector<Region> regions{slit(rectangle(0.08, 0.16), 0.03, 0.9),
                                slit(disc(0.08), 0.024, 1.1),
                                slit(disc_with_flats(0.08, 0.35), 0.024, -0.3),
                                ring(0.08, 0.03),
                                half_disc(0.08),
                                rectangle(0.12, 0.04)};
    regions[3].edges = {{{0.015, 0}, {0.04, 0}, ContactKind::pre_existing_crack}};  // from the hole to the outline
    for (const std::size_t i : {4U, 5U}) regions[i].edges = {slit_from_below(regions[i], 0.018, "--slit")};
    regions[5].name = "beam";
    add_hole(regions[0], {0.02, 0.05}, 0.008, "--hole");
    regions[0].edges.push_back({{-0.1, 0.02}, {0.1, 0.07}});
    for (const Region& region : regions) {
        for (const int n : {1, 3}) {
            Request request;
            request.region = region;
            request.fabric.edge = 3e-3;
            request.fabric.elements_per_edge = n;
            const Specimen s = mesh(request);
            validate(s, region.name);
            EXPECT_EQ(s.shape, region.name);
            double all = 0;
            for (const PrescribedEdge& whole : region.edges) {
                for (const PrescribedEdge& edge : clip({region.name, region.loops, {}}, whole)) {
                    const double requested = length(edge.to - edge.from);
                    EXPECT_NEAR(covered(s, edge) / requested, 1, 1e-9) << region.name;
                    if (edge.kind == ContactKind::pre_existing_crack) all += requested;
                }
            }
            EXPECT_NEAR(broken_length(s), all, 1e-12) << "no other contact is broken";
            EXPECT_LT(s.statistics.edge_variation, 0.13) << region.name;
            EXPECT_GT(s.statistics.min_angle, 15 * std::numbers::pi / 180) << region.name;
            const bool moved = region.loops.size() > 1;  // a flaw ends on a circle, whose point it moves
            EXPECT_NEAR(s.statistics.area_error, 0, moved ? 1e-3 : 1e-12) << region.name;
        }
    }
}

TEST(Mesh, RoundSpecimensOfFewDividedGrainsAreValid) {
    for (const std::uint64_t seed : {8U, 9U, 10U}) {
        Request request;
        request.region = ring(16.366e-3, 6.9931e-3);
        request.fabric.grains = 27;
        request.fabric.spread = 0.1859;
        request.fabric.elements_per_edge = 3;
        request.seed = seed;
        EXPECT_NO_THROW(validate(mesh(request), "ring")) << seed;
    }
}

TEST(Mesh, JointSetsAreFollowedAndCovered) {
    Request request = rectangle_of(3000);
    request.joint_sets = {parse_joint_set("spacing=20mm,dip=45deg,persistence=0.7", "--joint-set"),
                          parse_joint_set("spacing=25mm,dip=-30deg,class=intact", "--joint-set")};
    const MeshPlan plan = plan_mesh(request);
    EXPECT_GT(plan.region.edges.size(), 20U);
    const Specimen s = mesh(request);
    validate(s, "rectangle");
    EXPECT_EQ(s.n_grains(), 3000U);
    for (const PrescribedEdge& edge : plan.region.edges) EXPECT_NEAR(covered(s, edge) / length(edge.to - edge.from), 1, 1e-9);
    EXPECT_GT(s.statistics.min_angle, 10 * std::numbers::pi / 180);
}

TEST(Mesh, FlawsOfNamedClassesHaveThemInTheFile) {
    Request request = rectangle_of(600);
    request.fabric.elements_per_edge = 2;
    request.fabric.strength.modulus = 5;
    request.region.edges = {{{-0.02, 0.02}, {0.02, 0.03}, {ContactKind::grain_boundary, "vein"}},
                            {{-0.02, -0.02}, {0.02, -0.01}, {ContactKind::pre_existing_crack, "joint"}},
                            {{-0.02, 0}, {0.02, 0}, ContactKind::pre_existing_crack}};
    const test::TemporaryFolder folder;
    const std::string path = folder.file("specimen.h5");
    {
        H5Output out(path, "specimen");
        write_specimen(out, mesh(request));
        out.commit();
    }
    const Specimen s = read_specimen(H5Input(path, "specimen"));
    EXPECT_EQ(s.flaw_names, (std::vector<std::string>{"joint", "vein"}));
    EXPECT_EQ(contact_class_names(s), (std::vector<std::string>{"rock-rock", "joint", "vein"}));
    const std::vector<std::uint8_t> classes = contact_classes(s);
    std::array<double, 3> length{};
    for (std::size_t c = 0; c < s.n_contacts(); ++c) {
        if (classes[c] > 0) {
            EXPECT_EQ(s.contact_strength_factor[c], 1) << "a flaw has a strength of its own";
            EXPECT_EQ(s.contact_kind[c], classes[c] == 1 ? 1 : 0);
        }
        if (classes[c] > 0 || s.contact_kind[c] != 0) length[classes[c]] += contact_length(s, c);
    }
    EXPECT_NEAR(length[0], 0.04, 1e-12) << "the crack without a class";
    EXPECT_NEAR(length[1], std::hypot(0.04, 0.01), 1e-12);
    EXPECT_NEAR(length[2], std::hypot(0.04, 0.01), 1e-12);
}

TEST(Mesh, PlanIsWhatComesOut) {
    const Request request = rectangle_of(1122);
    const MeshPlan plan = plan_mesh(request);
    MeshReport report;
    const Specimen s = mesh(request, {}, &report);
    EXPECT_EQ(static_cast<std::size_t>(plan.n_boundary), s.n_boundary_edges());
    EXPECT_NEAR(plan.edge / s.statistics.mean_edge, 1, 0.01);
    EXPECT_GE(report.attempts, 1);
    EXPECT_NEAR(report.psi6_of_parts, order_of(s, request.region).parts, 1e-9);
}

TEST(MeshReport, NamesWhatWasNotReached) {
    Request request = rectangle_of(200);
    request.fabric.spread = 0.01;
    MeshReport report;
    const Specimen s = mesh(request, {}, &report);
    std::string text;
    for (const Remark& line : describe_mesh(s, request, report)) text += line.text + "\n";
    EXPECT_NE(summary_of(s, "s.h5")[0].find("s.h5: rectangle of 80 × 160 mm, 200 grains, mean "), std::string::npos);
    EXPECT_NE(text.find("was requested"), std::string::npos);
    EXPECT_NE(describe_plan(request)[0].find("200 grains"), std::string::npos);
}

}  // namespace
}  // namespace graincrack::mesher
