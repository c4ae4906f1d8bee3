#include "mesher/fabric/open_boundaries.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "mesher/fabric/crystals.hpp"
#include "share/file/specimen_measures.hpp"
#include "tests/unit/mesher/test_requests.hpp"

namespace graincrack::mesher {
namespace {

bool is_open(const Specimen& s, std::size_t c) {
    return s.contact_kind[c] == static_cast<std::uint8_t>(ContactKind::open_boundary);
}

/// The contacts of each whole boundary between two crystals that is no flaw.
using Boundaries = std::map<std::pair<int, int>, std::vector<std::size_t>>;
Boundaries boundaries_of(const Specimen& s) {
    Boundaries boundaries;
    const auto crystals = crystals_of_contacts(s, s.grain_crystal.empty() ? own_crystals(s) : s.grain_crystal);
    for (std::size_t c = 0; c < s.n_contacts(); ++c) {
        const bool has_class = !s.contact_flaw.empty() && s.contact_flaw[c] > 0;
        if (has_class || (s.contact_kind[c] != 0 && !is_open(s, c))) continue;
        boundaries[crystals[c]].push_back(c);
    }
    return boundaries;
}

/// Whole boundaries are open, to half of one of the share of their length.
void expect_share(const Specimen& s, double share) {
    double all = 0, open = 0, longest = 0;
    for (const auto& [crystals, contacts] : boundaries_of(s)) {
        EXPECT_NE(crystals.first, crystals.second);
        double length = 0;
        for (const std::size_t c : contacts) {
            length += contact_length(s, c);
            EXPECT_EQ(is_open(s, c), is_open(s, contacts.front())) << "a boundary is open as a whole";
        }
        all += length;
        if (is_open(s, contacts.front())) open += length;
        longest = std::max(longest, length);
    }
    EXPECT_NEAR(open, share * all, 0.5 * longest * (1 + 1e-9)) << share;
}

TEST(OpenBoundaries, HaveTheShareOfTrianglesAndMoreWithALargerShare) {
    const Specimen plain = mesh(rectangle_of(1122));
    for (const double row : {1.0, 3.0}) {
        std::vector<std::uint8_t> before = plain.contact_kind;
        for (const double share : {0.0, 0.001, 0.1, 0.3, 0.6, 0.95}) {
            Specimen s = plain;
            open_boundaries(s, own_crystals(s), {share, {}, row});
            expect_share(s, share);
            for (std::size_t c = 0; c < s.n_contacts(); ++c) EXPECT_TRUE(before[c] == 0 || is_open(s, c)) << "opened by less";
            before = s.contact_kind;
        }
        EXPECT_GT(std::count(before.begin(), before.end(), 0), 0);
    }
    // They are drawn anew by another seed alone.
    const auto kinds = [&](const OpenBoundaryRequest& request) {
        Specimen s = plain;
        open_boundaries(s, own_crystals(s), request);
        return s.contact_kind;
    };
    EXPECT_EQ(kinds({0.3, plain.seed}), kinds({0.3, {}}));
    EXPECT_NE(kinds({0.3, plain.seed + 1}), kinds({0.3, {}}));
    EXPECT_EQ(kinds({}), plain.contact_kind);
}

TEST(OpenBoundaries, AreWholeBetweenPolygonsAndNeitherFlawsNorWithinCrystals) {
    for (const Tessellation tessellation : {Tessellation::voronoi, Tessellation::trigon}) {
        Request request = rectangle_of(120);
        request.fabric.tessellation = tessellation;
        request.region.edges = {{{-0.03, -0.03}, {0.03, -0.02}, {ContactKind::grain_boundary, "joint"}},
                                {{-0.02, 0.02}, {0.02, 0.03}, ContactKind::pre_existing_crack}};
        const Specimen closed = mesh(request);
        request.fabric.open.fraction = 0.4;
        const Specimen s = mesh(request);
        expect_share(s, 0.4);
        EXPECT_EQ(s.contact_flaw, closed.contact_flaw);
        for (std::size_t c = 0; c < s.n_contacts(); ++c) {
            const bool could_open = closed.contact_kind[c] == 0 && s.contact_flaw[c] == 0;
            EXPECT_TRUE(is_open(s, c) ? could_open : s.contact_kind[c] == closed.contact_kind[c]) << c;
        }
    }
}

/// Open boundaries that are connected.
struct Row {
    std::map<std::pair<double, double>, int> contacts_at;
    double boundaries = 0, length = 0;
    double extent = 0;  ///< largest distance of two of its places
};
std::vector<Row> rows_of(const Specimen& s) {
    std::vector<Row> rows;
    for (const auto& [crystals, contacts] : boundaries_of(s)) {
        if (!is_open(s, contacts.front())) continue;
        Row row{{}, 1};
        for (const std::size_t c : contacts) {
            row.length += contact_length(s, c);
            for (const std::size_t end : {0U, 1U}) {
                const Point p = place_of(s, s.contact_nodes[c][end]);
                ++row.contacts_at[{p.x, p.y}];
            }
        }
        std::erase_if(rows, [&](const Row& other) {
            if (std::ranges::none_of(other.contacts_at, [&](const auto& at) { return row.contacts_at.contains(at.first); })) {
                return false;
            }
            for (const auto& [place, n] : other.contacts_at) row.contacts_at[place] += n;
            row.boundaries += other.boundaries;
            row.length += other.length;
            return true;
        });
        for (const auto& [p, n] : row.contacts_at) {
            for (const auto& [q, m] : row.contacts_at) {
                row.extent = std::max(row.extent, std::hypot(p.first - q.first, p.second - q.second));
            }
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

TEST(OpenBoundaries, LieInChainsApartOfTheMeanNumberOfBoundaries) {
    Request of_crystals = rectangle_of(1200);
    of_crystals.fabric.tessellation = Tessellation::voronoi;
    for (const Request& request : {rectangle_of(2000), of_crystals}) {
        const Specimen closed = mesh(request);
        for (const double mean : {1.5, 3.0}) {
            double boundaries = 0, rows = 0, single = 0, length = 0, extent = 0;
            for (std::uint64_t seed = 0; seed < 20; ++seed) {
                Specimen s = closed;
                open_boundaries(s, own_crystals(s), {0.05, seed, mean});
                for (const Row& row : rows_of(s)) {
                    int ends = 0;
                    for (const auto& [place, n] : row.contacts_at) {
                        EXPECT_LE(n, 2) << "a branch";
                        ends += n == 1 ? 1 : 0;
                    }
                    EXPECT_EQ(ends, 2);
                    rows += 1;
                    boundaries += row.boundaries;
                    single += row.boundaries == 1 ? 1 : 0;
                    length += row.length;
                    extent += row.extent;
                }
            }
            EXPECT_GT(rows, 900);
            // Numbers of mean L with probabilities (1 − q) qⁿ⁻¹ have the variance L (L − 1), and 1/L of them are 1.
            EXPECT_NEAR(boundaries / rows, mean, 3 * std::sqrt(mean * (mean - 1) / rows));
            EXPECT_NEAR(single / rows, 1 / mean, 3 * std::sqrt((mean - 1) / rows) / mean);
            EXPECT_GT(extent, std::sqrt(0.75) * length) << "no straighter than the zigzag of a honeycomb";
        }
    }
}

TEST(OpenBoundaries, AreNoPartOfANotch) {
    Request bent = request_of(half_disc(0.08), 400);
    bent.region.edges = {slit_from_below(bent.region, 0.02, "--slit")};
    bent.fabric.open.fraction = 0.6;
    const auto notch = edge_notch(mesh(bent));
    ASSERT_TRUE(notch);
    EXPECT_NEAR(notch->length(), 0.02, 1e-9);
    bent.region.edges.clear();
    EXPECT_FALSE(edge_notch(mesh(bent)));
    Request plate = rectangle_of(1122);
    plate.notch = 0.03;
    const auto without = notch_ends(mesh(plate));
    plate.fabric.open.fraction = 0.5;
    EXPECT_EQ(notch_ends(mesh(plate)), without);
}

TEST(OpenBoundaries, RefuseBadRequests) {
    const auto open = [](const OpenBoundaryRequest& request) { return [request](Request& r) { r.fabric.open = request; }; };
    compare_refusals(rectangle_of(1122), {{"a share of 1", open({1.0, {}})},
                                          {"a share of -0.1", open({-0.1, {}})},
                                          {"a share that is no number", open({std::nan(""), {}})},
                                          {"a seed without a share", open({{}, 3})},
                                          {"a length without a share", open({{}, {}, 2})}});
    for (const OpenBoundaryRequest& good : {OpenBoundaryRequest{0, 3}, OpenBoundaryRequest{0.999, {}}}) {
        Request request = rectangle_of(1122);
        request.fabric.open = good;
        EXPECT_NO_THROW((void)plan_mesh(request));
    }
}

}  // namespace
}  // namespace graincrack::mesher
