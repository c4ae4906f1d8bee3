#include "mesher/cells/snapped_corners.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace graincrack::mesher {

namespace {

// Distances over the root of the mean area, within which a point of cells is moved:
constexpr double reach_of_lines = 0.2;    ///< onto a wall
constexpr double reach_of_corners = 0.3;  ///< to a corner of a wall
constexpr double reach_of_ends = 0.6;     ///< to the end of a wall

class CornerSnapper {
public:
    CornerSnapper(CellPieces& pieces, WallChain& chain) : pieces_(pieces), chain_(chain) {}

    void extend() {
        if (chain_.is_closed) return;
        if (const auto beyond = make_end(chain_.points.back(), chain_.points[chain_.points.size() - 2])) {
            chain_.points.push_back(*beyond);
            chain_.sides.push_back(CellPieces::extension);
        }
        if (const auto beyond = make_end(chain_.points.front(), chain_.points[1])) {
            chain_.points.insert(chain_.points.begin(), *beyond);
            chain_.sides.insert(chain_.sides.begin(), CellPieces::extension);
        }
    }

    /// Moves the nearest free point to each corner of the chain.
    void snap_to_corners() {
        const std::size_t n = chain_.sides.size();
        for (std::size_t k = 0; k < chain_.points.size() - (chain_.is_closed ? 1 : 0); ++k) {
            const Point corner = chain_.points[k];
            int chosen = pieces_.point_at(corner);
            if (chosen < 0) {
                std::vector<std::pair<double, int>> near;
                for (int p = 0; p < static_cast<int>(pieces_.n_points()); ++p) {
                    const double distance = length(pieces_.at(p) - corner);
                    if (distance < reach_of_corners * pieces_.size_at(corner) && pieces_.is_free(p) &&
                        !pieces_.pieces_at(p).empty() && place_.count(p) == 0) {
                        near.emplace_back(distance, p);
                    }
                }
                std::sort(near.begin(), near.end());
                for (const auto& [distance, p] : near) {
                    if (!pieces_.try_move(p, corner)) continue;
                    chosen = p;
                    break;
                }
            }
            if (chosen < 0) continue;
            place_[chosen] = static_cast<double>(k);
            const bool is_end_of_extension = (k == 0 && chain_.sides.front() == CellPieces::extension) ||
                                             (k == n && chain_.sides.back() == CellPieces::extension);
            if (!is_end_of_extension) pieces_.fix(chosen);
        }
    }

    /// Moves free points that lie near the chain straight onto it.
    void snap_to_lines() {
        const std::size_t n = chain_.sides.size();
        for (int p = 0; p < static_cast<int>(pieces_.n_points()); ++p) {
            if (pieces_.pieces_at(p).empty() || place_.count(p) > 0) continue;
            double least = std::numeric_limits<double>::infinity();
            double where = 0;
            for (std::size_t k = 0; k < n; ++k) {
                const double share = nearest_share(pieces_.at(p), chain_.points[k], chain_.points[k + 1]);
                const double distance =
                    length(pieces_.at(p) - (chain_.points[k] + share * (chain_.points[k + 1] - chain_.points[k])));
                if (distance >= least) continue;
                least = distance;
                where = static_cast<double>(k) + share;
            }
            const auto k = std::min(static_cast<std::size_t>(where), n - 1);
            const double share = where - static_cast<double>(k);
            if (least > pieces_.tolerance()) {
                // Beside an end or a corner it is left where it is.
                if (least > reach_of_lines * pieces_.size_at(pieces_.at(p)) || !pieces_.is_free(p) || share <= 0.01 ||
                    share >= 0.99 || !pieces_.try_move(p, chain_.points[k] + share * (chain_.points[k + 1] - chain_.points[k]))) {
                    continue;
                }
            }
            place_[p] = where;
        }
    }

    /// Adds points where the chain crosses edges.
    void add_crossings() {
        const std::size_t n = chain_.sides.size();
        struct Crossed {
            Edge edge;
            double share;
            double place;
            Point at;
        };
        std::vector<Crossed> crossed;
        std::vector<Edge> edges;
        pieces_.for_each_edge([&](int p, int q) { edges.push_back(edge_between(p, q)); });
        std::sort(edges.begin(), edges.end());
        edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
        for (const Edge& e : edges) {
            for (std::size_t k = 0; k < n; ++k) {
                const auto meets_there = [&](int p) {
                    const auto found = place_.find(p);
                    if (found == place_.end()) return false;
                    const double t = found->second;
                    return (t >= static_cast<double>(k) && t <= static_cast<double>(k + 1)) ||
                           (chain_.is_closed && k + 1 == n && t == 0);
                };
                const Point a = chain_.points[k];
                const Point along = chain_.points[k + 1] - a;
                const double sp = cross(along, pieces_.at(e[0]) - a);
                const double sq = cross(along, pieces_.at(e[1]) - a);
                if ((sp > 0) == (sq > 0) || meets_there(e[0]) || meets_there(e[1])) continue;
                const double on_edge = sp / (sp - sq);
                const Point foot = pieces_.at(e[0]) + on_edge * (pieces_.at(e[1]) - pieces_.at(e[0]));
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
            const int added = pieces_.add_point(c.at);
            pieces_.split_edge(c.edge[0], is_same ? last : c.edge[1], added);
            last = added;
            place_[added] = c.place;
        }
    }

    [[nodiscard]] ChainNodes nodes() const {
        ChainNodes nodes;
        for (const auto& [point, where] : place_) nodes.emplace_back(where, point);
        std::sort(nodes.begin(), nodes.end());
        return nodes;
    }

private:
    /// Makes a point of cells at the end of a chain, or adds a point behind it on the side of the cell in which it ends.
    /// \return that further point, if there is one
    std::optional<Point> make_end(Point end, Point before) {
        if (const int known = pieces_.point_at(end); known >= 0) {
            pieces_.fix(known);
            return std::nullopt;
        }
        Edge nearest{-1, -1};
        pieces_.for_each_edge([&](int p, int q) {
            const Point foot = pieces_.at(p) + nearest_share(end, pieces_.at(p), pieces_.at(q)) * (pieces_.at(q) - pieces_.at(p));
            if (squared_length(end - foot) < pieces_.tolerance() * pieces_.tolerance()) nearest = edge_between(p, q);
        });
        if (nearest[0] >= 0) {
            // A point that can slide along a wall is taken there.
            for (const int p : nearest) {
                const bool slides = !pieces_.is_fixed(p) && pieces_.mark_of(nearest[0], nearest[1]) >= 0;
                if (!slides || length(pieces_.at(p) - end) > reach_of_corners * pieces_.size_at(end)) continue;
                if (!pieces_.try_move(p, end)) continue;
                pieces_.fix(p);
                return std::nullopt;
            }
            const int added = pieces_.add_point(end);
            pieces_.fix(added);
            pieces_.split_edge(nearest[0], nearest[1], added);
            return std::nullopt;
        }
        std::size_t around = 0;
        while (around < pieces_.size() && !pieces_.is_inside(pieces_.loop(around), end)) ++around;
        if (around == pieces_.size()) return std::nullopt;
        const PieceLoop loop = pieces_.loop(around);
        PieceLoop by_distance = loop;
        std::sort(by_distance.begin(), by_distance.end(),
                  [&](int p, int q) { return squared_length(pieces_.at(p) - end) < squared_length(pieces_.at(q) - end); });
        for (const int p : by_distance) {
            if (!pieces_.is_free(p) || length(pieces_.at(p) - end) > reach_of_ends * pieces_.size_at(end)) continue;
            if (!pieces_.try_move(p, end)) continue;
            pieces_.fix(p);
            return std::nullopt;
        }
        // Where the line leaves the cell.
        const Point along = end - before;
        double least = std::numeric_limits<double>::infinity();
        Edge crossed{-1, -1};
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const int p = loop[i];
            const int q = loop[(i + 1) % loop.size()];
            const double sp = cross(along, pieces_.at(p) - end);
            const double sq = cross(along, pieces_.at(q) - end);
            if ((sp > 0) == (sq > 0)) continue;
            const Point foot = pieces_.at(p) + (sp / (sp - sq)) * (pieces_.at(q) - pieces_.at(p));
            const double way = dot(foot - end, along);
            if (way <= 0 || way >= least) continue;
            least = way;
            crossed = {p, q};
        }
        if (crossed[0] < 0) return std::nullopt;
        const Point beyond = end + (least / squared_length(along)) * along;
        for (const int p : crossed) {
            if (length(pieces_.at(p) - beyond) < reach_of_corners * pieces_.size_at(beyond)) return pieces_.at(p);
        }
        const int added = pieces_.add_point(beyond);
        pieces_.split_edge(crossed[0], crossed[1], added);
        return beyond;
    }

    CellPieces& pieces_;
    WallChain& chain_;
    std::map<int, double> place_;  ///< of points on the chain
};

}  // namespace

ChainNodes snapped_corners(CellPieces& pieces, WallChain& chain) {
    CornerSnapper snapper(pieces, chain);
    snapper.extend();
    snapper.snap_to_corners();
    snapper.snap_to_lines();
    snapper.add_crossings();
    return snapper.nodes();
}

}  // namespace graincrack::mesher
