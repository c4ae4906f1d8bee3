#include "mesher/cells/cut_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "mesher/cells/polygon.hpp"

namespace graincrack::mesher {

namespace {

// Distances over the root of the mean area, within which a point of cells is moved:
constexpr double reach_of_lines = 0.2;    ///< onto a wall
constexpr double reach_of_corners = 0.3;  ///< to a corner of a wall
constexpr double reach_of_ends = 0.6;     ///< to the end of a wall
constexpr double same_point = 1e-9;       ///< over the extent

constexpr double credit_of_seed = 0.3;  ///< added to the share of a piece with the seed of its cell
constexpr int no_wall = -1;
constexpr int extension = -2;  ///< of a wall to the side of the cell in which it ends

/// A line of walls without branches: points, and the side of the walls from each to the next.
struct Chain {
    std::vector<Point> points;
    std::vector<int> sides;
    bool is_closed = false;
};

class CellCutter {
public:
    CellCutter(const PlaneCells& cells, std::span<const Point> seeds, const std::vector<double>& areas, const Walls& walls,
               const SizeField& size)
        : walls_(walls), graded_(size), seeds_(seeds), wanted_(areas), points_(cells.points), sides_(walls.sides) {
        for (std::size_t cell = 0; cell < cells.size(); ++cell) {
            const auto loop = cells.loop(cell);
            add_cell({loop.begin(), loop.end()}, cell);
        }
        is_fixed_.assign(points_.size(), 0);
        is_on_wall_.assign(points_.size(), 0);
        Box box{points_.front(), points_.front()};
        for (std::size_t p = 0; p < walls.hull.size(); ++p) {
            is_fixed_[p] = 1;
            box.high = {std::max(box.high.x, points_[p].x), std::max(box.high.y, points_[p].y)};
            box.low = {std::min(box.low.x, points_[p].x), std::min(box.low.y, points_[p].y)};
        }
        tolerance_ = same_point * (box.width() + box.height());
        for (Side side : cells.sides) {
            if (!walls.is_convex) side.part = no_wall;
            mark(side.from, side.to, static_cast<int>(sides_.size()));
            sides_.push_back(side);
        }
        mean_size_ = std::sqrt(std::accumulate(areas.begin(), areas.end(), 0.0) / static_cast<double>(areas.size()));
    }

    bool cut() {
        const std::vector<Chain> chains = chains_of_walls();
        return std::all_of(chains.begin(), chains.end(), [&](const Chain& chain) { return insert(chain); });
    }

    std::optional<CutCells> joined() {
        find_seeds();
        drop_outside();
        if (!join_pieces()) return std::nullopt;
        drop_kinks();
        return result();
    }

private:
    using Loop = std::vector<int>;
    static std::size_t index(int i) { return static_cast<std::size_t>(i); }
    [[nodiscard]] Point at(int p) const { return points_[index(p)]; }

    void add_cell(Loop loop, std::size_t origin) {
        const int cell = static_cast<int>(loops_.size());
        cells_of_point_.resize(points_.size());
        for (const int p : loop) cells_of_point_[index(p)].push_back(cell);
        loops_.push_back(std::move(loop));
        origin_.push_back(origin);
    }
    void set_loop(std::size_t cell, Loop loop) {
        for (const int p : loops_[cell]) std::erase(cells_of_point_[index(p)], static_cast<int>(cell));
        for (const int p : loop) cells_of_point_[index(p)].push_back(static_cast<int>(cell));
        loops_[cell] = std::move(loop);
    }
    int add_point(Point p) {
        points_.push_back(p);
        is_fixed_.push_back(0);
        is_on_wall_.push_back(0);
        cells_of_point_.emplace_back();
        return static_cast<int>(points_.size()) - 1;
    }
    void mark(int p, int q, int side) {
        marks_[edge_between(p, q)] = side;
        if (side >= 0) is_on_wall_[index(p)] = is_on_wall_[index(q)] = 1;
    }
    [[nodiscard]] int mark_of(int p, int q) const {
        const auto found = marks_.find(edge_between(p, q));
        return found == marks_.end() ? no_wall : found->second;
    }
    [[nodiscard]] std::vector<Point> corners(const Loop& loop) const {
        std::vector<Point> result;
        for (const int p : loop) result.push_back(at(p));
        return result;
    }
    [[nodiscard]] double area(std::size_t cell) const { return area_of(corners(loops_[cell])); }
    /// The root of the mean area of cells at a place.
    [[nodiscard]] double size_at(Point p) const { return mean_size_ * graded_.graded(p); }
    [[nodiscard]] double square_of_size(Point p) const { return graded_.graded(p) * graded_.graded(p); }

    /// The chains of walls: loops first, then prescribed edges, each continued by the straightest.
    [[nodiscard]] std::vector<Chain> chains_of_walls() const {
        std::vector<Chain> chains;
        const auto n = walls_.sides.size();
        std::vector<char> is_used(n, 0);
        std::size_t i = 0;
        while (i < n && walls_.sides[i].part >= 0) {
            const bool is_hull = walls_.is_convex && i == 0;
            Chain chain;
            chain.is_closed = true;
            const int first = walls_.sides[i].from;
            do {
                chain.points.push_back(walls_.at(walls_.sides[i].from));
                chain.sides.push_back(static_cast<int>(i));
            } while (walls_.sides[i++].to != first);
            chain.points.push_back(chain.points.front());
            if (!is_hull) chains.push_back(std::move(chain));
        }
        for (; i < n; ++i) {
            if (is_used[i] != 0) continue;
            is_used[i] = 1;
            std::vector<int> numbers{walls_.sides[i].from, walls_.sides[i].to};
            std::vector<int> sides{static_cast<int>(i)};
            for (const bool forwards : {true, false}) {
                while (true) {
                    const int end = forwards ? numbers.back() : numbers.front();
                    const Point before = walls_.at(forwards ? numbers[numbers.size() - 2] : numbers[1]);
                    const Point along = unit(walls_.at(end) - before);
                    double straightest = 0.5;
                    std::size_t next = n;
                    for (std::size_t k = 0; k < n; ++k) {
                        const Side& side = walls_.sides[k];
                        if (is_used[k] != 0 || side.part >= 0 || (side.from != end && side.to != end)) continue;
                        const int far = side.from == end ? side.to : side.from;
                        if (std::find(numbers.begin(), numbers.end(), far) != numbers.end()) continue;
                        const double cosine = dot(along, unit(walls_.at(far) - walls_.at(end)));
                        if (cosine <= straightest) continue;
                        straightest = cosine;
                        next = k;
                    }
                    if (next == n) break;
                    is_used[next] = 1;
                    const int far = walls_.sides[next].from == end ? walls_.sides[next].to : walls_.sides[next].from;
                    numbers.insert(forwards ? numbers.end() : numbers.begin(), far);
                    sides.insert(forwards ? sides.end() : sides.begin(), static_cast<int>(next));
                }
            }
            Chain chain;
            for (const int p : numbers) chain.points.push_back(walls_.at(p));
            chain.sides = std::move(sides);
            chains.push_back(std::move(chain));
        }
        return chains;
    }

    [[nodiscard]] bool are_sound_around(int p) const {
        return std::all_of(cells_of_point_[index(p)].begin(), cells_of_point_[index(p)].end(),
                           [&](int cell) { return is_sound(corners(loops_[index(cell)])); });
    }

    /// Moves a point if the cells around it allow that.
    bool try_move(int p, Point goal) {
        const Point before = at(p);
        points_[index(p)] = goal;
        if (are_sound_around(p)) return true;
        points_[index(p)] = before;
        return false;
    }

    [[nodiscard]] bool is_free(int p) const { return is_fixed_[index(p)] == 0 && is_on_wall_[index(p)] == 0; }

    /// The point of cells at a place, or none.
    [[nodiscard]] int point_at(Point place) const {
        for (std::size_t p = 0; p < points_.size(); ++p) {
            if (!cells_of_point_[p].empty() && squared_length(points_[p] - place) < tolerance_ * tolerance_) {
                return static_cast<int>(p);
            }
        }
        return -1;
    }

    void split_edge(int p, int q, int middle) {
        const std::vector<int> around = cells_of_point_[index(p)];
        for (const int cell : around) {
            Loop& loop = loops_[index(cell)];
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const int a = loop[i];
                const int b = loop[(i + 1) % loop.size()];
                if (edge_between(a, b) != edge_between(p, q)) continue;
                loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(i) + 1, middle);
                cells_of_point_[index(middle)].push_back(cell);
                break;
            }
        }
        const int side = mark_of(p, q);
        if (side == no_wall) return;
        marks_.erase(edge_between(p, q));
        mark(p, middle, side);
        mark(middle, q, side);
    }

    template <class Visit>
    void for_each_edge(const Visit& visit) const {
        for (const Loop& loop : loops_) {
            for (std::size_t i = 0; i < loop.size(); ++i) visit(loop[i], loop[(i + 1) % loop.size()]);
        }
    }

    [[nodiscard]] bool is_inside(const Loop& loop, Point p) const {
        bool inside = false;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Point a = at(loop[i]);
            const Point b = at(loop[(i + 1) % loop.size()]);
            if ((a.y > p.y) != (b.y > p.y) && (cross(b - a, p - a) > 0) == (b.y > a.y)) inside = !inside;
        }
        return inside;
    }

    /// Makes a point of cells at the end of a chain, or adds a point behind it on the side of the cell in which it ends.
    /// \return that further point, if there is one
    std::optional<Point> make_end(Point end, Point before) {
        if (const int known = point_at(end); known >= 0) {
            is_fixed_[index(known)] = 1;
            return std::nullopt;
        }
        Edge nearest{-1, -1};
        for_each_edge([&](int p, int q) {
            const Point foot = at(p) + nearest_share(end, at(p), at(q)) * (at(q) - at(p));
            if (squared_length(end - foot) < tolerance_ * tolerance_) nearest = edge_between(p, q);
        });
        if (nearest[0] >= 0) {
            // A point that can slide along a wall is taken there.
            for (const int p : nearest) {
                const bool slides = is_fixed_[index(p)] == 0 && mark_of(nearest[0], nearest[1]) >= 0;
                if (!slides || length(at(p) - end) > reach_of_corners * size_at(end) || !try_move(p, end)) continue;
                is_fixed_[index(p)] = 1;
                return std::nullopt;
            }
            const int added = add_point(end);
            is_fixed_[index(added)] = 1;
            split_edge(nearest[0], nearest[1], added);
            return std::nullopt;
        }
        const auto found = std::find_if(loops_.begin(), loops_.end(), [&](const Loop& loop) { return is_inside(loop, end); });
        if (found == loops_.end()) return std::nullopt;
        const Loop loop = *found;
        Loop by_distance = loop;
        std::sort(by_distance.begin(), by_distance.end(),
                  [&](int p, int q) { return squared_length(at(p) - end) < squared_length(at(q) - end); });
        for (const int p : by_distance) {
            if (!is_free(p) || length(at(p) - end) > reach_of_ends * size_at(end) || !try_move(p, end)) continue;
            is_fixed_[index(p)] = 1;
            return std::nullopt;
        }
        // Where the line leaves the cell.
        const Point along = end - before;
        double least = std::numeric_limits<double>::infinity();
        Edge crossed{-1, -1};
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const int p = loop[i];
            const int q = loop[(i + 1) % loop.size()];
            const double sp = cross(along, at(p) - end);
            const double sq = cross(along, at(q) - end);
            if ((sp > 0) == (sq > 0)) continue;
            const Point foot = at(p) + (sp / (sp - sq)) * (at(q) - at(p));
            const double way = dot(foot - end, along);
            if (way <= 0 || way >= least) continue;
            least = way;
            crossed = {p, q};
        }
        if (crossed[0] < 0) return std::nullopt;
        const Point beyond = end + (least / squared_length(along)) * along;
        for (const int p : crossed) {
            if (length(at(p) - beyond) < reach_of_corners * size_at(beyond)) return at(p);
        }
        const int added = add_point(beyond);
        split_edge(crossed[0], crossed[1], added);
        return beyond;
    }

    bool insert(Chain chain) {
        if (!chain.is_closed) {
            if (const auto beyond = make_end(chain.points.back(), chain.points[chain.points.size() - 2])) {
                chain.points.push_back(*beyond);
                chain.sides.push_back(extension);
            }
            if (const auto beyond = make_end(chain.points.front(), chain.points[1])) {
                chain.points.insert(chain.points.begin(), *beyond);
                chain.sides.insert(chain.sides.begin(), extension);
            }
        }
        const std::vector<std::pair<double, int>> nodes = nodes_of(chain);
        if (nodes.size() < 2) return false;
        const auto n = static_cast<double>(chain.sides.size());
        for (std::size_t i = 0; i + (chain.is_closed ? 0 : 1) < nodes.size(); ++i) {
            const auto [from, u] = nodes[i];
            auto [to, v] = nodes[(i + 1) % nodes.size()];
            if (i + 1 == nodes.size()) to += n;
            std::vector<std::pair<int, int>> path{{u, 0}};  // points, and the sides that lead to them
            const auto side_at = [&](double t) { return chain.sides[static_cast<std::size_t>(t) % chain.sides.size()]; };
            for (double k = std::floor(from) + 1; k < to; ++k) {
                const auto corner = static_cast<std::size_t>(k) % chain.sides.size();
                const int added = add_point(chain.points[corner]);
                is_fixed_[index(added)] = 1;
                path.emplace_back(added, side_at(k - 0.5));
            }
            path.emplace_back(v, side_at(std::max(from, std::ceil(to) - 1)));
            if (!split_cell(path)) return false;
        }
        return true;
    }

    /// The points of cells on a chain, in its order, where need be new ones; each with the place: number of the side and share.
    std::vector<std::pair<double, int>> nodes_of(const Chain& chain) {
        const std::size_t n = chain.sides.size();
        std::map<int, double> place;
        // Corners first: the nearest free point is moved there.
        for (std::size_t k = 0; k < chain.points.size() - (chain.is_closed ? 1 : 0); ++k) {
            const Point corner = chain.points[k];
            int chosen = point_at(corner);
            if (chosen < 0) {
                std::vector<std::pair<double, int>> near;
                for (std::size_t p = 0; p < points_.size(); ++p) {
                    const double distance = length(points_[p] - corner);
                    if (distance < reach_of_corners * size_at(corner) && is_free(static_cast<int>(p)) &&
                        !cells_of_point_[p].empty() && place.count(static_cast<int>(p)) == 0) {
                        near.emplace_back(distance, static_cast<int>(p));
                    }
                }
                std::sort(near.begin(), near.end());
                for (const auto& [distance, p] : near) {
                    if (!try_move(p, corner)) continue;
                    chosen = p;
                    break;
                }
            }
            if (chosen < 0) continue;
            place[chosen] = static_cast<double>(k);
            const bool is_end_of_extension =
                (k == 0 && chain.sides.front() == extension) || (k == n && chain.sides.back() == extension);
            if (!is_end_of_extension) is_fixed_[index(chosen)] = 1;
        }
        for (std::size_t p = 0; p < points_.size(); ++p) {
            const int point = static_cast<int>(p);
            if (cells_of_point_[p].empty() || place.count(point) > 0) continue;
            double least = std::numeric_limits<double>::infinity();
            double where = 0;
            for (std::size_t k = 0; k < n; ++k) {
                const double share = nearest_share(points_[p], chain.points[k], chain.points[k + 1]);
                const double distance = length(points_[p] - (chain.points[k] + share * (chain.points[k + 1] - chain.points[k])));
                if (distance >= least) continue;
                least = distance;
                where = static_cast<double>(k) + share;
            }
            const auto k = std::min(static_cast<std::size_t>(where), n - 1);
            const double share = where - static_cast<double>(k);
            if (least > tolerance_) {
                // Beside an end or a corner it is left where it is.
                if (least > reach_of_lines * size_at(points_[p]) || !is_free(point) || share <= 0.01 || share >= 0.99 ||
                    !try_move(point, chain.points[k] + share * (chain.points[k + 1] - chain.points[k]))) {
                    continue;
                }
            }
            place[point] = where;
        }
        // Crossings of sides of cells.
        struct Crossed {
            Edge edge;
            double share;
            double place;
            Point at;
        };
        std::vector<Crossed> crossed;
        std::vector<Edge> edges;
        for_each_edge([&](int p, int q) { edges.push_back(edge_between(p, q)); });
        std::sort(edges.begin(), edges.end());
        edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
        for (const Edge& e : edges) {
            for (std::size_t k = 0; k < n; ++k) {
                const auto meets_there = [&](int p) {
                    const auto found = place.find(p);
                    if (found == place.end()) return false;
                    const double t = found->second;
                    return (t >= static_cast<double>(k) && t <= static_cast<double>(k + 1)) ||
                           (chain.is_closed && k + 1 == n && t == 0);
                };
                const Point a = chain.points[k];
                const Point along = chain.points[k + 1] - a;
                const double sp = cross(along, at(e[0]) - a);
                const double sq = cross(along, at(e[1]) - a);
                if ((sp > 0) == (sq > 0) || meets_there(e[0]) || meets_there(e[1])) continue;
                const double on_edge = sp / (sp - sq);
                const Point foot = at(e[0]) + on_edge * (at(e[1]) - at(e[0]));
                const double share = dot(foot - a, along) / squared_length(along);
                if (share < 0 || share > 1) continue;
                crossed.push_back({e, on_edge, static_cast<double>(k) + share, a + share * along});
            }
        }
        // From the far end of each edge, so that what is left of it keeps its first point.
        std::sort(crossed.begin(), crossed.end(),
                  [](const Crossed& a, const Crossed& b) { return a.edge != b.edge ? a.edge < b.edge : a.share > b.share; });
        int last = -1;
        for (std::size_t i = 0; i < crossed.size(); ++i) {
            const Crossed& c = crossed[i];
            const bool is_same = i > 0 && crossed[i - 1].edge == c.edge;
            const int added = add_point(c.at);
            split_edge(c.edge[0], is_same ? last : c.edge[1], added);
            last = added;
            place[added] = c.place;
        }
        std::vector<std::pair<double, int>> nodes;
        for (const auto& [point, where] : place) nodes.emplace_back(where, point);
        std::sort(nodes.begin(), nodes.end());
        return nodes;
    }

    /// Divides the cell in which a path from one of its points to another lies; a path along its side is marked only.
    bool split_cell(const std::vector<std::pair<int, int>>& path) {
        const int u = path.front().first;
        const int v = path.back().first;
        const auto mark_path = [&] {
            for (std::size_t i = 1; i < path.size(); ++i) {
                // An extension that is there gives way to a wall, and no wall to an extension.
                if (path[i].second < 0 && mark_of(path[i - 1].first, path[i].first) >= 0) continue;
                mark(path[i - 1].first, path[i].first, path[i].second);
            }
        };
        const Point middle = midpoint(at(u), at(path[1].first));
        for (const int cell : std::vector<int>(cells_of_point_[index(u)])) {
            Loop loop = loops_[index(cell)];
            const auto start = std::find(loop.begin(), loop.end(), u);
            std::rotate(loop.begin(), start, loop.end());
            const auto end = std::find(loop.begin(), loop.end(), v);
            if (end == loop.end()) continue;
            if (path.size() == 2 && (loop[1] == v || loop.back() == v)) {
                mark_path();
                return true;
            }
            if (!is_inside(loop, middle)) continue;
            Loop right(loop.begin(), end + 1);
            Loop left(end, loop.end());
            left.push_back(u);
            for (std::size_t i = path.size() - 2; i > 0; --i) right.push_back(path[i].first);
            for (std::size_t i = 1; i + 1 < path.size(); ++i) left.push_back(path[i].first);
            if (!(area_of(corners(left)) > 0) || !(area_of(corners(right)) > 0)) return false;
            set_loop(index(cell), std::move(left));
            add_cell(std::move(right), origin_[index(cell)]);
            mark_path();
            return true;
        }
        return false;
    }

    /// The number of a set of cells for each; cells beside an edge that is no border are in one set.
    template <class IsBorder>
    [[nodiscard]] std::vector<std::size_t> sets_of_cells(const IsBorder& is_border) const {
        std::map<Edge, std::size_t> other;
        std::vector<std::size_t> parent(loops_.size());
        std::iota(parent.begin(), parent.end(), std::size_t{0});
        const auto root = [&](std::size_t i) {
            while (parent[i] != i) i = parent[i] = parent[parent[i]];
            return i;
        };
        for (std::size_t cell = 0; cell < loops_.size(); ++cell) {
            const Loop& loop = loops_[cell];
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const int p = loop[i];
                const int q = loop[(i + 1) % loop.size()];
                const auto [found, is_new] = other.try_emplace(edge_between(p, q), cell);
                if (!is_new && !is_border(mark_of(p, q))) parent[root(cell)] = root(found->second);
            }
        }
        std::vector<std::size_t> sets;
        for (std::size_t cell = 0; cell < loops_.size(); ++cell) sets.push_back(root(cell));
        return sets;
    }

    /// The pieces in which seeds lie, most of them pieces of their own cells.
    void find_seeds() {
        std::vector<std::vector<std::size_t>> pieces(seeds_.size());
        for (std::size_t cell = 0; cell < loops_.size(); ++cell) pieces[origin_[cell]].push_back(cell);
        for (std::size_t seed = 0; seed < seeds_.size(); ++seed) {
            const auto holds = [&](std::size_t cell) { return is_inside(loops_[cell], seeds_[seed]); };
            const auto own = std::find_if(pieces[seed].begin(), pieces[seed].end(), holds);
            std::size_t cell = own == pieces[seed].end() ? 0 : *own;
            if (own == pieces[seed].end()) {
                while (cell + 1 < loops_.size() && !holds(cell)) ++cell;
            }
            piece_of_seed_.push_back(cell);
        }
    }

    void drop_outside() {
        const auto is_of_loop = [&](int side) { return side >= 0 && sides_[index(side)].part >= 0; };
        const auto sets = sets_of_cells(is_of_loop);
        std::vector<char> is_outside(loops_.size(), 0);
        for (std::size_t cell = 0; cell < loops_.size(); ++cell) {
            const Loop& loop = loops_[cell];
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const int side = mark_of(loop[i], loop[(i + 1) % loop.size()]);
                if (!is_of_loop(side) || index(side) >= walls_.sides.size()) continue;
                const Point along = walls_.at(sides_[index(side)].to) - walls_.at(sides_[index(side)].from);
                if (dot(along, at(loop[(i + 1) % loop.size()]) - at(loop[i])) < 0) is_outside[sets[cell]] = 1;
            }
        }
        for (std::size_t cell = 0; cell < loops_.size(); ++cell) {
            if (is_outside[sets[cell]] != 0) set_loop(cell, {});
        }
    }

    /// Divides a piece between two of its corners, as nearly in halves as these allow.
    bool halve(std::size_t piece) {
        const Loop loop = loops_[piece];
        const std::size_t n = loop.size();
        double best = std::numeric_limits<double>::infinity();
        Loop left;
        Loop right;
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t k = i + 2; k < n && k < i + n - 1; ++k) {
                Loop a(loop.begin() + static_cast<std::ptrdiff_t>(i), loop.begin() + static_cast<std::ptrdiff_t>(k) + 1);
                Loop b(loop.begin() + static_cast<std::ptrdiff_t>(k), loop.end());
                b.insert(b.end(), loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(i) + 1);
                if (!is_sound(corners(a)) || !is_sound(corners(b))) continue;
                const double difference = std::abs(area_of(corners(a)) - area_of(corners(b)));
                if (difference >= best) continue;
                best = difference;
                left = std::move(a);
                right = std::move(b);
            }
        }
        if (left.empty()) return false;
        set_loop(piece, std::move(left));
        add_cell(std::move(right), origin_[piece]);
        for (const std::size_t half : {piece, loops_.size() - 1}) {
            share_.resize(loops_.size(), 0);
            share_[half] = area(half) / wanted_[origin_[half]];
        }
        areas_.resize(loops_.size(), 0);
        return true;
    }

    /// Joins a piece to a neighbour, the one with the longest common side of those with which it makes a sound polygon.
    bool join(std::size_t piece) {
        std::map<int, double> common;
        const Loop& loop = loops_[piece];
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const int p = loop[i];
            const int q = loop[(i + 1) % loop.size()];
            if (mark_of(p, q) != no_wall) continue;
            for (const int cell : cells_of_point_[index(p)]) {
                const Loop& other = loops_[index(cell)];
                if (cell == static_cast<int>(piece) || std::find(other.begin(), other.end(), q) == other.end()) continue;
                common[cell] += length(at(q) - at(p));
            }
        }
        std::vector<std::pair<double, int>> order;
        for (const auto& [cell, size] : common) order.emplace_back(-size, cell);
        std::sort(order.begin(), order.end());
        for (const bool must_be_sound : {true, false}) {
            for (const auto& [size, cell] : order) {
                auto united = united_loop(piece, index(cell));
                if (!united || (must_be_sound && !is_sound(corners(*united)))) continue;
                if (area(piece) > area(index(cell))) origin_[index(cell)] = origin_[piece];
                share_[index(cell)] += share_[piece];
                set_loop(piece, {});
                set_loop(index(cell), std::move(*united));
                return true;
            }
        }
        return false;
    }

    /// The loop around two cells that have one run of edges in common, none of which is of a wall.
    [[nodiscard]] std::optional<Loop> united_loop(std::size_t a, std::size_t b) const {
        const Loop& first = loops_[a];
        const Loop& second = loops_[b];
        const auto is_common = [&](std::size_t i) {
            const int p = first[i % first.size()];
            const int q = first[(i + 1) % first.size()];
            const auto found = std::find(second.begin(), second.end(), q);
            if (found == second.end()) return false;
            return (found + 1 == second.end() ? second.front() : *(found + 1)) == p;
        };
        std::size_t start = 0;
        while (start < first.size() && !(is_common(start) && !is_common(start + first.size() - 1))) ++start;
        if (start == first.size()) return std::nullopt;
        std::size_t run = 0;
        for (; is_common(start + run); ++run) {
            const int p = first[(start + run) % first.size()];
            const int q = first[(start + run + 1) % first.size()];
            if (mark_of(p, q) != no_wall) return std::nullopt;
            if (run > 0 && is_fixed_[index(p)] != 0) return std::nullopt;
        }
        Loop united;
        for (std::size_t i = run; i <= first.size(); ++i) united.push_back(first[(start + i) % first.size()]);
        // From the last point of the first, which is where the run begins, along the second to where it ends.
        const auto place = std::find(second.begin(), second.end(), united.back()) - second.begin();
        for (std::size_t i = 1; i + run < second.size(); ++i) {
            const int p = second[(static_cast<std::size_t>(place) + i) % second.size()];
            if (std::find(united.begin(), united.end(), p) != united.end()) return std::nullopt;
            united.push_back(p);
        }
        return united;
    }

    bool join_pieces() {
        const auto sets = sets_of_cells([](int side) { return side >= 0; });
        share_.assign(loops_.size(), 0);
        std::map<std::size_t, std::vector<std::size_t>> seeds_of;  // of each set
        std::map<std::size_t, std::vector<std::size_t>> pieces_of;
        for (std::size_t cell = 0; cell < loops_.size(); ++cell) {
            if (loops_[cell].empty()) continue;
            share_[cell] = area(cell) / wanted_[origin_[cell]];
            pieces_of[sets[cell]].push_back(cell);
        }
        for (std::size_t seed = 0; seed < seeds_.size(); ++seed) {
            const std::size_t piece = piece_of_seed_[seed];
            if (loops_[piece].empty()) continue;
            seeds_of[sets[piece]].push_back(seed);
            if (origin_[piece] == seed) share_[piece] += credit_of_seed;
        }
        areas_.assign(loops_.size(), 0);
        for (auto& [set, pieces] : pieces_of) {
            const std::vector<std::size_t>& seeds = seeds_of[set];
            if (seeds.empty()) return false;
            while (pieces.size() < seeds.size()) {
                const std::size_t largest = *std::max_element(
                    pieces.begin(), pieces.end(), [&](std::size_t a, std::size_t b) { return share_[a] < share_[b]; });
                if (!halve(largest)) return false;
                pieces.push_back(loops_.size() - 1);
            }
            while (pieces.size() > seeds.size()) {
                std::sort(pieces.begin(), pieces.end(), [&](std::size_t a, std::size_t b) { return share_[a] < share_[b]; });
                const auto joined = std::find_if(pieces.begin(), pieces.end(), [&](std::size_t piece) { return join(piece); });
                if (joined == pieces.end()) return false;
                pieces.erase(joined);
            }
            // The largest area goes to the largest cell, over the squares of their graded sizes.
            std::vector<double> wanted;
            for (const std::size_t seed : seeds) wanted.push_back(wanted_[seed] / square_of_size(seeds_[seed]));
            std::sort(wanted.begin(), wanted.end());
            const auto square_at = [&](std::size_t piece) { return square_of_size(moments(corners(loops_[piece])).centroid); };
            std::sort(pieces.begin(), pieces.end(),
                      [&](std::size_t a, std::size_t b) { return area(a) / square_at(a) < area(b) / square_at(b); });
            double present = 0;
            for (std::size_t i = 0; i < pieces.size(); ++i) {
                present += area(pieces[i]);
                wanted[i] *= square_at(pieces[i]);
            }
            const double scale = present / std::accumulate(wanted.begin(), wanted.end(), 0.0);
            for (std::size_t i = 0; i < pieces.size(); ++i) areas_[pieces[i]] = scale * wanted[i];
        }
        return true;
    }

    /// Leaves out points at which no more than two cells, or one and the outside, meet on a straight wall or within none.
    void drop_kinks() {
        for (std::size_t p = 0; p < points_.size(); ++p) {
            const std::vector<int> around = cells_of_point_[p];
            if (is_fixed_[p] != 0 || around.empty() || around.size() > 2) continue;
            const auto beside = [&](int cell) {
                const Loop& loop = loops_[index(cell)];
                const auto i = static_cast<std::size_t>(std::find(loop.begin(), loop.end(), static_cast<int>(p)) - loop.begin());
                return edge_between(loop[(i + loop.size() - 1) % loop.size()], loop[(i + 1) % loop.size()]);
            };
            const Edge edge = beside(around.front());
            const int side = mark_of(edge[0], static_cast<int>(p));
            if (side != mark_of(edge[1], static_cast<int>(p)) || (around.size() == 2 && beside(around.back()) != edge)) continue;
            if (around.size() == 1 && side < 0) continue;
            bool fits = true;
            std::vector<Loop> loops;
            for (const int cell : around) {
                Loop loop = loops_[index(cell)];
                std::erase(loop, static_cast<int>(p));
                fits = fits && loop.size() > 2 && (is_sound(corners(loop)) || !is_sound(corners(loops_[index(cell)])));
                loops.push_back(std::move(loop));
            }
            if (!fits || marks_.count(edge) > 0) continue;
            for (std::size_t i = 0; i < around.size(); ++i) set_loop(index(around[i]), loops[i]);
            if (side != no_wall) mark(edge[0], edge[1], side);
        }
    }

    [[nodiscard]] std::optional<CutCells> result() const {
        CutCells made;
        std::vector<int> number(points_.size(), -1);
        for (const bool fixed : {true, false}) {
            for (std::size_t p = 0; p < points_.size(); ++p) {
                if (cells_of_point_[p].empty() || (is_fixed_[p] != 0) != fixed) continue;
                number[p] = static_cast<int>(made.cells.points.size());
                made.cells.points.push_back(points_[p]);
            }
            if (fixed) made.n_fixed = made.cells.points.size();
        }
        std::vector<std::pair<int, Side>> walls;
        for (std::size_t cell = 0; cell < loops_.size(); ++cell) {
            const Loop& loop = loops_[cell];
            if (loop.empty()) continue;
            made.areas.push_back(areas_[cell]);
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const int p = loop[i];
                const int q = loop[(i + 1) % loop.size()];
                const Edge edge = edge_between(number[index(p)], number[index(q)]);
                made.cells.corners.push_back(number[index(p)]);
                made.cells.edges.push_back(edge);
                const int side = mark_of(p, q);
                if (side < 0) continue;
                const Side& wall = sides_[index(side)];
                if (wall.part >= 0) {
                    walls.push_back({side, {number[index(p)], number[index(q)], wall.part, {}}});
                } else if (index(side) < walls_.sides.size() && edge[0] == number[index(p)]) {
                    walls.push_back({side, {edge[0], edge[1], -1, wall.kind}});
                }
            }
            made.cells.start.push_back(static_cast<int>(made.cells.corners.size()));
        }
        std::sort(made.cells.edges.begin(), made.cells.edges.end());
        made.cells.edges.erase(std::unique(made.cells.edges.begin(), made.cells.edges.end()), made.cells.edges.end());
        std::stable_sort(walls.begin(), walls.end(), [](const auto& a, const auto& b) {
            return std::pair(a.second.part < 0, a.first) < std::pair(b.second.part < 0, b.first);
        });
        for (const auto& [side, wall] : walls) made.cells.sides.push_back(wall);
        return made;
    }

    const Walls& walls_;
    const SizeField& graded_;
    std::span<const Point> seeds_;
    const std::vector<double>& wanted_;
    std::vector<Point> points_;
    std::vector<Side> sides_;  ///< those of the walls, then those of the hull
    std::vector<Loop> loops_;  ///< of cells and pieces; empty ones are gone
    std::vector<std::size_t> origin_;
    std::vector<std::size_t> piece_of_seed_;
    std::vector<double> share_;  ///< of the wanted area of its cell that a piece has
    std::vector<double> areas_;  ///< wanted of pieces that are left
    std::vector<std::vector<int>> cells_of_point_;
    std::vector<char> is_fixed_;
    std::vector<char> is_on_wall_;
    std::map<Edge, int> marks_;  ///< edges along walls, with the number of the side, and extensions
    double mean_size_ = 0;
    double tolerance_ = 0;
};

}  // namespace

std::optional<CutCells> cut_cells(const PlaneCells& cells, std::span<const Point> seeds, const std::vector<double>& areas,
                                  const Walls& walls, const SizeField& size) {
    CellCutter cutter(cells, seeds, areas, walls, size);
    if (!cutter.cut()) return std::nullopt;
    return cutter.joined();
}

}  // namespace graincrack::mesher
