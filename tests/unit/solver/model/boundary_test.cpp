// Platens point by point, and who belongs to the boundary.
#include "solver/model/boundary.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/support/augig_granite.hpp"
#include "tests/support/check.hpp"
#include "tests/support/specimens.hpp"

namespace graincrack::test {
namespace {

Platen top() { return {.position = 0.05, .normal_stiffness = 1e12, .shear_stiffness = 1e11, .tan_friction = 0.1}; }
PlatenPoint point() { return {0, 1, 0.004, 0, 0, 0, true}; }

TEST(PlatenPoint, PushesButDoesNotPull) {
    const PlatenResponse apart = platen_response(top(), point(), {0, -1e-6}, 0);
    EXPECT_EQ(apart.force.y, 0);
    EXPECT_EQ(apart.stored, 0);
    const PlatenResponse pressed = platen_response(top(), point(), {0, 0}, -1e-6);
    expect_close(pressed.force.y, -1e12 * 0.004 * 1e-6, 1e-12, 4000);
    expect_close(pressed.stored, 0.5 * 4000 * 1e-6, 1e-12, 2e-3);
    Platen bottom = top();
    bottom.side = -1;
    EXPECT_GT(platen_response(bottom, point(), {0, -1e-6}, 0).force.y, 0);
    Platen cap = top();
    cap.bonded = true;
    cap.shear_stiffness = 0;
    expect_close(platen_response(cap, point(), {0, 0}, 1e-6).force.y, 4000, 1e-12, 4000);
}

TEST(PlatenPoint, PushesOnceItsGapIsClosed) {
    PlatenPoint p = point();
    p.gap = -2e-6;
    EXPECT_EQ(platen_response(top(), p, {0, 0}, -1e-6).force.y, 0);
    expect_close(platen_response(top(), p, {0, 0}, -3e-6).force.y, -4000, 1e-9, 4000);
}

// Penetration 1 µm: 4000 N, friction up to 400 N, reached after 1 µm of sliding (400 N/µm).
TEST(PlatenPoint, SticksThenSlidesAndBooksItsFriction) {
    PlatenPoint p = point();
    double booked = 0, work = 0, largest = 0;
    const auto slide_to = [&](double x) {
        const int n = 1000;
        const double from = p.anchor + p.shear / 4e8;
        double before = p.shear;
        for (int i = 1; i <= n; ++i) {
            const double at = from + (x - from) * i / n;
            const PlatenResponse r = platen_response(top(), p, {at, 0}, -1e-6);
            EXPECT_LE(std::abs(r.force.x), 400 * (1 + 1e-12));
            work += 0.5 * (before + r.shear) * (x - from) / n;
            before = r.shear;
            booked += r.friction;
            p.anchor = r.anchor;
            p.shear = r.shear;
            largest = std::max(largest, std::abs(r.force.x));
        }
        return platen_response(top(), p, {x, 0}, -1e-6);
    };
    const PlatenResponse stuck = slide_to(0.5e-6);
    expect_close(stuck.force.x, -200, 1e-9, 400);
    EXPECT_EQ(booked, 0);
    const PlatenResponse slipped = slide_to(5e-6);
    expect_close(slipped.force.x, -400, 1e-9, 400);
    expect_close(booked, 400 * 4e-6, 1e-6, 400 * 4e-6);  // 4 µm of slip, a corner of one step in it
    const PlatenResponse back = slide_to(-5e-6);
    expect_close(back.force.x, 400, 1e-9, 400);  // against the slip
    const double stored = 0.5 * 400 * 400 / 4e8;
    expect_close(work, booked + stored, 1e-9, work);
    EXPECT_GT(largest, 399);
}

TEST(PlatenPoint, LosesItsHoldWhenItLifts) {
    PlatenPoint p = point();
    p.anchor = 1e-6;
    p.shear = 100;
    const PlatenResponse r = platen_response(top(), p, {3e-6, -1e-6}, 0);
    EXPECT_EQ(r.anchor, 3e-6);
    EXPECT_EQ(r.shear, 0);
    EXPECT_EQ(r.force.x, 0);
}

std::vector<Platen> platens_of(const Specimen& s) {
    std::vector<Platen> p{top(), top()};
    p[bottom_platen].motion = bottom_platen;
    p[bottom_platen].side = -1;
    p[bottom_platen].position = -s.height / 2;
    p[top_platen].position = s.height / 2;
    return p;
}

TEST(Boundary, HasThePointsWithinReachAndOfBondedPlatensTheirFaces) {
    const Specimen s = one_diagonal_grid(4, 6, 0.04, 0.06);
    const Assemblage a = make_assemblage(s, augig_granite().rock, PlaneCondition::strain);
    const Boundary near = make_boundary(a, s, platens_of(s), 1e-6);
    const Boundary far = make_boundary(a, s, platens_of(s), 0.0101);
    std::size_t on_faces = 0;
    for (const Vector2& p : a.position) on_faces += std::abs(p.y) > 0.03 - 1e-9 ? 1 : 0;
    EXPECT_EQ(near.platen_points.size(), on_faces);
    EXPECT_GT(far.platen_points.size(), near.platen_points.size());
    for (const PlatenPoint& p : near.platen_points) {
        EXPECT_TRUE(p.on_boundary || p.tributary > 0);
        EXPECT_EQ(static_cast<std::size_t>(p.platen), a.position[p.node].y > 0 ? top_platen : bottom_platen);
        EXPECT_EQ(p.gap, 0);
    }
    for (const PlatenPoint& p : far.platen_points) {
        EXPECT_LE(p.gap, 0);
        EXPECT_GE(p.gap, -0.0101);
        EXPECT_GT(p.tributary, 0);
    }
    EXPECT_TRUE(std::is_sorted(far.platen_points.begin(), far.platen_points.end(),
                               [](const PlatenPoint& l, const PlatenPoint& r) { return l.node < r.node; }));
    std::vector<Platen> bonded = platens_of(s);
    bonded[0].bonded = bonded[1].bonded = true;
    for (const PlatenPoint& p : make_boundary(a, s, bonded, 0.02).platen_points) {
        expect_close(std::abs(a.position[p.node].y), 0.03, 1e-9, 0.03);
    }
}

}  // namespace
}  // namespace graincrack::test
