#include "mesher/seeds/fixed_seeds.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "share/base/error.hpp"

namespace graincrack::mesher {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double same_place = 1e-9;  ///< over the extent of a region: meeting distance of prescribed edges
constexpr int min_circle_edges = 4;

/// Fractions 0 = s₀ < s₁ < … < s_n = 1 of a line cut into n pieces of random length.
std::vector<double> cut_line(int n, double spread, RandomNumbers& random) {
    // Lengths are uniform within ±√3 spread, which has the requested standard deviation and no outliers.
    const double half_range = std::min(std::numbers::sqrt3 * spread, 0.6);
    std::vector<double> shares(static_cast<std::size_t>(n) + 1, 0.0);
    for (std::size_t i = 1; i < shares.size(); ++i) shares[i] = shares[i - 1] + 1 + half_range * random.symmetric();
    for (double& s : shares) s /= shares.back();
    return shares;
}

/// A line to be divided into edges in proportion to the local size: its length over that size, and the places of fractions of
/// this relative length. Without a size field these are the length and the fractions themselves.
class RelativeLine {
public:
    /// \param at returns the point at a fraction of the line
    template <class At>
    RelativeLine(const SizeField& size, double length, const At& at) : length_(length) {
        if (size.is_uniform()) return;
        constexpr double steps = 4;  // steps within the distance over which sizes change
        const int n = static_cast<int>(std::clamp(steps * length / size.resolution(), 64.0, 1e6));
        sums_ = {0};
        for (int i = 0; i < n; ++i) {
            sums_.push_back(sums_.back() + size.relative_length(at(static_cast<double>(i) / n), at((i + 1.0) / n)));
        }
        length_ = sums_.back();
    }

    [[nodiscard]] double length() const { return length_; }
    /// The fraction of the line at a fraction of its relative length.
    [[nodiscard]] double place(double share) const {
        if (sums_.empty() || share <= 0 || share >= 1) return share;
        const double aim = share * length_;
        const auto next = std::clamp(std::upper_bound(sums_.begin(), sums_.end(), aim), sums_.begin() + 1, sums_.end() - 1);
        const double part = (aim - *(next - 1)) / (*next - *(next - 1));
        return (static_cast<double>(next - sums_.begin()) - 1 + part) / static_cast<double>(sums_.size() - 1);
    }
    /// The fraction of its relative length at a fraction of the line.
    [[nodiscard]] double relative_share(double share) const {
        if (sums_.empty()) return share;
        const double at = std::clamp(share, 0.0, 1.0) * static_cast<double>(sums_.size() - 1);
        const auto i = std::min(static_cast<std::size_t>(at), sums_.size() - 2);
        return (sums_[i] + (at - static_cast<double>(i)) * (sums_[i + 1] - sums_[i])) / length_;
    }
    [[nodiscard]] bool is_uniform() const { return sums_.empty(); }

private:
    double length_;
    std::vector<double> sums_;  ///< relative lengths up to equally spaced places
};

/// Point of a curve at a fraction of its length; on a circle from the upper pole, counter-clockwise.
Point point_of(const Curve& curve, double share) {
    if (curve.kind != Curve::Kind::arc && !curve.is_circle()) return curve.from + share * (curve.to - curve.from);
    const Point start = curve.is_circle() ? Point{0, curve.circle.radius} : curve.from - curve.circle.centre;
    const double turn = share * (curve.is_circle() ? 2 * pi : curve.arc_angle());
    return curve.circle.centre + std::cos(turn) * start + std::sin(turn) * left_of(start);
}

/// A straight side, an arc or a circle, to be divided into edges.
struct Divided {
    RelativeLine line;
    double rise;  ///< rise along y, m
    int n;        ///< number of edges
    [[nodiscard]] double length() const { return line.length(); }
};

/// The sides and circles of all loops, with the fewest edges that they need.
std::vector<Divided> undivided(const Region& region, const SizeField& size) {
    std::vector<Divided> sides;
    for (const Curve& curve : curves_of({region.name, region.loops, {}})) {
        const bool is_arc = curve.kind == Curve::Kind::arc;
        const double rise = curve.is_circle() ? 0 : std::abs(curve.to.y - curve.from.y);
        const int fewest = curve.is_circle() ? min_circle_edges : 1;
        const RelativeLine line(size, curve.length(), [&](double share) { return point_of(curve, share); });
        sides.push_back({line, rise, is_arc ? 1 + static_cast<int>(curve.arc_angle() / (pi / 4)) : fewest});
    }
    return sides;
}

int number_of_edges(const std::vector<Divided>& sides) {
    int sum = 0;
    for (const Divided& side : sides) sum += side.n;
    return sum;
}

/// Divides the sides into n edges in proportion to length: the side with the longest edges gets one more until all are used;
/// among equals the longer, then the steeper side. If n is odd, the last goes to the longest side, so that opposite sides of a
/// rectangle have equal numbers or differ by one.
std::vector<Divided> edges_per_side(const Region& region, int n, const SizeField& size) {
    std::vector<Divided> sides = undivided(region, size);
    const auto add_to_best = [&](const auto& measure) {
        constexpr double round_off = 1e-12;
        auto best = sides.begin();
        for (auto it = sides.begin() + 1; it != sides.end(); ++it) {
            const double difference = measure(*it) - measure(*best);
            const bool equal = std::abs(difference) <= round_off * measure(*best);
            const bool better = equal && it->length() == best->length() ? it->rise > best->rise : it->length() > best->length();
            if (equal ? better : difference > 0) best = it;
        }
        ++best->n;
    };
    int missing = n - number_of_edges(sides);
    for (; missing > n % 2; --missing) add_to_best([](const Divided& side) { return side.length() / side.n; });
    if (missing > 0) add_to_best([](const Divided& side) { return side.length(); });
    return sides;
}

/// Polar angles of the points of a circle, counter-clockwise from just left of the upper pole's facet (or from the pole).
/// \param line the circle from the upper pole
std::vector<double> rim_angles(const Circle& circle, int n, double spread, RandomNumbers& random, const RelativeLine& line) {
    const bool facets = circle.pole == Pole::facet;
    const int arcs = 2 * circle.diameters;  // from pole to pole
    const double half_facet = facets ? pi / n : 0.0;
    const double span = pi / circle.diameters - 2 * half_facet;
    const int between = facets ? n - arcs : n;  // number of edges other than the pole facets
    const auto edges_before = [&](int arc) {
        if (line.is_uniform()) return (arc * between + arcs - 1) / arcs;
        const int share = static_cast<int>(std::lround(line.relative_share(static_cast<double>(arc) / arcs) * between));
        return std::clamp(share, arc, between - arcs + arc);  // each arc has an edge
    };
    const auto place = [&](double start, double share) {  // place of a fraction of the relative length of an arc without facets
        if (line.is_uniform()) return start + share * span;
        const auto relative = [&](double angle) { return line.relative_share((angle - pi / 2) / (2 * pi)); };
        const double from = relative(start);
        return pi / 2 + 2 * pi * line.place(from + share * (relative(start + span) - from));
    };
    std::vector<double> angles;
    for (int arc = 0; arc < arcs; ++arc) {
        const double start = (0.5 + static_cast<double>(arc) / circle.diameters) * pi + half_facet;
        const auto shares = cut_line(edges_before(arc + 1) - edges_before(arc), spread, random);
        const std::size_t n_points = shares.size() - (facets ? 0 : 1);  // the next pole vertex opens the next arc
        for (std::size_t i = 0; i < n_points; ++i) angles.push_back(place(start, shares[i]));
    }
    return angles;
}

double polygon_area(const std::vector<Point>& points) {
    double doubled = 0;
    for (std::size_t i = 0; i < points.size(); ++i) doubled += cross(points[i], points[(i + 1) % points.size()]);
    return doubled / 2;
}

/// Points about the origin at a radius. Points at a pole move along its diameter until the diameter has its length. `pole_of`:
/// number of the pole, counter-clockwise from the upper one, or −1.
std::vector<Point> rim_points(const Circle& circle, const std::vector<double>& angles, const std::vector<int>& pole_of,
                              double radius) {
    std::vector<Point> points(angles.size());
    for (std::size_t i = 0; i < angles.size(); ++i) {
        points[i] = {radius * std::cos(angles[i]), radius * std::sin(angles[i])};
        if (pole_of[i] < 0) continue;
        if (pole_of[i] % circle.diameters == 0) {
            points[i].y = std::copysign(circle.radius, points[i].y);
        } else {
            const double angle = (0.5 + static_cast<double>(pole_of[i]) / circle.diameters) * pi;
            const Point along{std::cos(angle), std::sin(angle)};
            points[i] = points[i] + (circle.radius - dot(points[i], along)) * along;
        }
    }
    return points;
}

/// Points of a circle about the origin, counter-clockwise.
std::vector<Point> circle_points(const Circle& circle, int n, double spread, RandomNumbers& random, const RelativeLine& line) {
    const auto angles = rim_angles(circle, n, spread, random, line);
    const double reach = circle.pole == Pole::facet ? pi / n : 0.0;
    std::vector<int> pole_of(angles.size(), -1);
    for (std::size_t i = 0; i < angles.size(); ++i) {
        const double from_upper = (angles[i] - pi / 2) / (pi / circle.diameters);  // in units of the angle between poles
        const double pole = std::round(from_upper);
        if (std::abs(from_upper - pole) * (pi / circle.diameters) < reach + 1e-9) {
            pole_of[i] = static_cast<int>(pole) % (2 * circle.diameters);
        }
    }
    std::vector<Point> points;
    double rim_radius = circle.radius;
    // The area grows almost as the square of the rim radius, except for the moved nodes at the poles, so a few corrections
    // suffice.
    for (int i = 0; i < 100; ++i) {
        points = rim_points(circle, angles, pole_of, rim_radius);
        const double ratio = pi * circle.radius * circle.radius / polygon_area(points);
        if (std::abs(ratio - 1) < 4e-16) break;
        rim_radius *= std::sqrt(ratio);
    }
    if (circle.pole == Pole::vertex) {
        for (std::size_t i = 0; i < angles.size(); ++i) {
            if (pole_of[i] >= 0 && pole_of[i] % circle.diameters == 0) points[i].x = 0;
        }
    }
    return points;
}

/// Points of an arc between its ends, at the radius at which their polygon has the area of the sector.
std::vector<Point> arc_points(const Curve& arc, const std::vector<double>& shares) {
    const double radius = arc.circle.radius;
    const double angle = arc.arc_angle();
    const std::size_t n = shares.size() - 1;
    double inner_radius = radius;
    for (int i = 0; i < 100; ++i) {
        const auto radius_of = [&](std::size_t k) { return k == 0 || k == n ? radius : inner_radius; };
        double sector = 0;
        for (std::size_t k = 0; k < n; ++k) {
            sector += 0.5 * radius_of(k) * radius_of(k + 1) * std::sin(angle * (shares[k + 1] - shares[k]));
        }
        const double ratio = 0.5 * radius * radius * angle / sector;
        if (n == 1 || std::abs(ratio - 1) < 4e-16) break;
        inner_radius *= n == 2 ? ratio : std::sqrt(ratio);
    }
    const Point from = unit(arc.from - arc.circle.centre);
    std::vector<Point> points;
    for (std::size_t k = 1; k < n; ++k) {
        const double turn = angle * shares[k];
        points.push_back(arc.circle.centre + inner_radius * (std::cos(turn) * from + std::sin(turn) * left_of(from)));
    }
    return points;
}

/// Builds fixed seeds.
class Builder {
public:
    Builder(const Region& region, double spread, RandomNumbers& random, const SizeField& size)
        : region_(region), spread_(spread), random_(random), size_(size) {
        const Box box = bounds(region);
        tolerance_ = same_place * (box.width() + box.height());
    }

    /// Adds fixed seeds on the loops.
    void add_loops(int n) {
        const auto sides = edges_per_side(region_, n, size_);
        auto side = sides.begin();
        for (const Loop& loop : region_.loops) {
            const int first = size();
            const auto add_point = [&](Point p, std::uint8_t part) {
                seeds_.sides.push_back({size(), size() + 1, part});
                seeds_.points.push_back(p);
            };
            if (loop.circle) {
                auto points = circle_points(*loop.circle, side->n, spread_, random_, side->line);
                ++side;
                if (&loop != &region_.loops.front()) std::reverse(points.begin(), points.end());
                for (const Point p : points) {
                    const bool outer = &loop == &region_.loops.front();
                    if (outer && std::abs(p.y) == loop.circle->radius) kept_.push_back(size());  // meets a platen
                    add_point(loop.circle->centre + p, loop.parts[0]);
                }
                if (&loop == &region_.loops.front() && loop.circle->pole == Pole::facet) {
                    seeds_.loading_arc = 2 * std::atan2(std::abs(points.front().x), loop.circle->radius);
                }
            }
            std::vector<int> corners;
            for (std::size_t i = 0; i < loop.corners.size(); ++i) {
                const Point from = loop.corners[i];
                const Point to = loop.corners[(i + 1) % loop.corners.size()];
                auto shares = cut_line(side->n, spread_, random_);
                for (double& share : shares) share = side->line.place(share);
                ++side;
                corners.push_back(size());
                if (const auto centre = loop.centre(i)) {
                    add_point(from, loop.parts[i]);
                    const Curve arc{Curve::Kind::arc, from, to, {}, Circle{*centre, length(from - *centre)}};
                    for (const Point p : arc_points(arc, shares)) add_point(p, loop.parts[i]);
                    continue;
                }
                for (std::size_t k = 0; k + 1 < shares.size(); ++k) {
                    // The coordinate that is constant along the side is copied, so that the side is exactly straight.
                    Point p = from;
                    if (from.x != to.x) p.x += shares[k] * (to.x - from.x);
                    if (from.y != to.y) p.y += shares[k] * (to.y - from.y);
                    add_point(p, loop.parts[i]);
                }
            }
            seeds_.sides.back().to = first;
            const int n_loop = size() - first;
            for (std::size_t i = 0; i < corners.size(); ++i) {
                const int at = corners[i];
                if (!can_be_cut_off(loop.behind((i + corners.size() - 1) % corners.size()), loop.corners[i], loop.ahead(i))) {
                    continue;
                }
                seeds_.corners.push_back({first + (at - first + n_loop - 1) % n_loop, at, first + (at - first + 1) % n_loop});
            }
            kept_.insert(kept_.end(), corners.begin(), corners.end());
        }
    }

    /// Adds fixed seeds on the prescribed edges, after the loops.
    void add_prescribed(double edge) {
        std::vector<PrescribedEdge> pieces;
        for (const PrescribedEdge& e : region_.edges) {
            for (const PrescribedEdge& piece : clip(region_, e)) pieces.push_back(piece);
        }
        const std::size_t n_loop_sides = seeds_.sides.size();
        std::vector<std::vector<std::pair<double, int>>> stations(pieces.size());  // [pieces] fraction along the piece, and point
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            stations[i] = {{0, station(pieces[i].from)}, {1, station(pieces[i].to)}};
            for (std::size_t j = 0; j < i; ++j) meet(pieces, i, j, stations);
        }
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            std::sort(stations[i].begin(), stations[i].end());
            for (std::size_t k = 0; k + 1 < stations[i].size(); ++k) {
                if (stations[i][k].second != stations[i][k + 1].second) {
                    add_line(stations[i][k].second, stations[i][k + 1].second, edge, pieces[i].kind);
                }
            }
        }
        // Points are inserted into loops in pairs, so that the number of boundary points keeps its parity.
        if (n_inserted_ % 2 != 0) split_longest_side(n_loop_sides + static_cast<std::size_t>(n_inserted_));
        seeds_.n_fixed = seeds_.points.size();
    }

    Seeds seeds() && { return std::move(seeds_); }

private:
    [[nodiscard]] int size() const { return static_cast<int>(seeds_.points.size()); }
    [[nodiscard]] Point& at(int p) { return seeds_.points[index(p)]; }
    [[nodiscard]] bool is_kept(int p) const { return std::find(kept_.begin(), kept_.end(), p) != kept_.end(); }

    /// The point at an end or crossing of prescribed edges: an existing one, a point of a loop moved there, or a new one.
    int station(Point p) {
        for (const int q : kept_) {
            if (length(at(q) - p) < tolerance_) return q;
        }
        const int index = std::abs(depth_inside(region_, p)) < tolerance_ ? point_of_loop(p) : size();
        if (index == size()) seeds_.points.push_back(p);
        at(index) = p;
        kept_.push_back(index);
        return index;
    }

    /// The nearest point of a loop if it may move along its side; otherwise a new, inserted one.
    int point_of_loop(Point p) {
        const auto distance = [&](const Side& side) {
            return Curve{Curve::Kind::side, at(side.from), at(side.to), unit(at(side.to) - at(side.from)), {}}.distance(p);
        };
        auto nearest = seeds_.sides.begin();
        for (auto it = nearest; it != seeds_.sides.end(); ++it) {
            if (it->part >= 0 && distance(*it) < distance(*nearest)) nearest = it;
        }
        const int end = length(at(nearest->from) - p) < length(at(nearest->to) - p) ? nearest->from : nearest->to;
        if (!is_kept(end)) return end;
        insert(nearest, size());
        return size();
    }

    void insert(std::vector<Side>::iterator side, int point) {
        for (Corner& c : seeds_.corners) {
            if (c.at == side->to) c.before = point;
            if (c.at == side->from) c.after = point;
        }
        Side second = *side;
        side->to = second.from = point;
        seeds_.sides.insert(side + 1, second);
        ++n_inserted_;
    }

    void split_longest_side(std::size_t n_loop_sides) {
        const auto size_of = [&](const Side& s) { return size_.relative_length(at(s.from), at(s.to)); };
        const auto end = seeds_.sides.begin() + static_cast<std::ptrdiff_t>(n_loop_sides);
        const auto longest =
            std::max_element(seeds_.sides.begin(), end, [&](const Side& a, const Side& b) { return size_of(a) < size_of(b); });
        const Point middle = midpoint(at(longest->from), at(longest->to));
        insert(longest, size());
        seeds_.points.push_back(middle);
    }

    /// Divides two pieces where they meet.
    void meet(const std::vector<PrescribedEdge>& pieces, std::size_t i, std::size_t j,
              std::vector<std::vector<std::pair<double, int>>>& stations) {
        const PrescribedEdge& a = pieces[i];
        const PrescribedEdge& b = pieces[j];
        const Point u = a.to - a.from;
        const Point v = b.to - b.from;
        const double sine = cross(u, v);
        const double slack_a = tolerance_ / length(u);
        const double slack_b = tolerance_ / length(v);
        if (std::abs(sine) <= same_place * length(u) * length(v)) {
            const double from = dot(b.from - a.from, u) / squared_length(u);
            const double to = dot(b.to - a.from, u) / squared_length(u);
            const bool on_one_line = std::abs(cross(b.from - a.from, u)) < tolerance_ * length(u);
            if (on_one_line && std::max(from, to) > slack_a && std::min(from, to) < 1 - slack_a) {
                throw UsageError("region " + region_.name + ": two prescribed edges lie upon each other");
            }
            return;
        }
        const double on_a = cross(b.from - a.from, v) / sine;
        const double on_b = cross(b.from - a.from, u) / sine;
        if (on_a < -slack_a || on_a > 1 + slack_a || on_b < -slack_b || on_b > 1 + slack_b) return;
        // An end on the other edge is the meeting point.
        const Point p = on_b < slack_b       ? b.from
                        : on_b > 1 - slack_b ? b.to
                        : on_a < slack_a     ? a.from
                        : on_a > 1 - slack_a ? a.to
                                             : a.from + on_a * u;
        const int point = station(p);
        stations[i].emplace_back(std::clamp(on_a, 0.0, 1.0), point);
        stations[j].emplace_back(std::clamp(on_b, 0.0, 1.0), point);
    }

    void add_line(int from, int to, double edge, const FlawKind& kind) {
        const Point start = at(from);
        const Point way = at(to) - start;
        const RelativeLine line(size_, length(way), [&](double share) { return start + share * way; });
        const auto shares = cut_line(std::max(1, static_cast<int>(std::lround(line.length() / edge))), spread_, random_);
        int last = from;
        for (std::size_t k = 1; k < shares.size(); ++k) {
            const int next = k + 1 == shares.size() ? to : size();
            if (next != to) seeds_.points.push_back(start + line.place(shares[k]) * way);
            seeds_.sides.push_back({last, next, -1, kind});
            last = next;
        }
    }

    const Region& region_;
    double spread_;
    RandomNumbers& random_;
    const SizeField& size_;
    double tolerance_ = 0;
    int n_inserted_ = 0;
    std::vector<int> kept_;  ///< immovable points: corners, ends and crossings
    Seeds seeds_;
};

}  // namespace

int admissible_boundary_count(const Region& region, double requested, bool odd) {
    const int parity = odd ? 1 : 0;
    const int fewest = number_of_edges(undivided(region, {}));
    const int n = 2 * static_cast<int>(std::lround((requested - parity) / 2)) + parity;
    return std::max(n, fewest + (fewest + parity) % 2);
}

double relative_perimeter(const Region& region, const SizeField& size) {
    double sum = 0;
    for (const Divided& side : undivided(region, size)) sum += side.length();
    return sum;
}

Seeds fixed_seeds(const Region& region, int n, double edge, double spread, RandomNumbers& random, const SizeField& size) {
    Builder builder(region, spread, random, size);
    builder.add_loops(n);
    builder.add_prescribed(edge);
    return std::move(builder).seeds();
}

}  // namespace graincrack::mesher
