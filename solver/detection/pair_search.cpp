// The search: cells over exposed edges, and the pairs near each other.
#include "solver/detection/pair_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "share/base/union_find.hpp"
#include "solver/detection/pair_exchange.hpp"
#include "solver/detection/pair_geometry.hpp"

namespace graincrack {
namespace {

/// The vertices of the specimen: nodes that contact points which have not debonded link.
UnionFind linked_nodes(const Assemblage& a, const ContactPairList& list) {
    UnionFind linked(a.position.size());
    for_each_contact(a, [&](std::int32_t c, std::int32_t /*contact_class*/) {
        for (std::size_t p = 0; p < 2; ++p) {
            if (list.debonded[2 * static_cast<std::size_t>(c) + p] != 0) continue;
            linked.join(static_cast<std::size_t>(a.contacts[c].nodes[p]), static_cast<std::size_t>(a.contacts[c].nodes[2 + p]));
        }
    });
    return linked;
}

Rectangle around(const Vector2& p, const Vector2& q, double margin) {
    return {{std::min(p.x, q.x) - margin, std::min(p.y, q.y) - margin},
            {std::max(p.x, q.x) + margin, std::max(p.y, q.y) + margin}};
}

/// Square cells with the exposed edges near them. The origin is the lower left corner of all edges.
class Cells {
public:
    Cells(const std::vector<Rectangle>& boxes, double size) : size_(size) {
        if (boxes.empty()) {
            begin_.assign(2, 0);
            return;
        }
        Rectangle all;
        for (const Rectangle& box : boxes) {
            all.include(box.low);
            all.include(box.high);
        }
        // Fragments may fly far: cells then grow, so that there are not many more cells than edges.
        const double area = (all.high.x - all.low.x) * (all.high.y - all.low.y);
        size_ = std::max(size_, std::sqrt(area / (4 * static_cast<double>(boxes.size()) + 64)));
        origin_ = all.low;
        columns_ = column(all.high.x) + 1;
        rows_ = row(all.high.y) + 1;
        begin_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
        for_cells_of(boxes, [this](std::size_t cell, std::int32_t) { ++begin_[cell + 1]; });
        std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
        edges_.resize(begin_.back());
        std::vector<std::int32_t> at(begin_.begin(), begin_.end() - 1);
        for_cells_of(boxes, [&](std::size_t cell, std::int32_t box) { edges_[at[cell]++] = box; });
    }
    /// Calls `visit` with the index of every box that may hold `p`.
    template <class Visit>
    void visit_near(const Vector2& p, Visit&& visit) const {
        const std::int32_t i = column(p.x);
        const std::int32_t j = row(p.y);
        if (i < 0 || j < 0 || i >= columns_ || j >= rows_) return;
        const std::size_t cell = cell_of(i, j);
        for (std::int32_t k = begin_[cell]; k < begin_[cell + 1]; ++k) visit(edges_[k]);
    }

private:
    [[nodiscard]] std::int32_t column(double x) const { return static_cast<std::int32_t>(std::floor((x - origin_.x) / size_)); }
    [[nodiscard]] std::int32_t row(double y) const { return static_cast<std::int32_t>(std::floor((y - origin_.y) / size_)); }
    [[nodiscard]] std::size_t cell_of(std::int32_t i, std::int32_t j) const {
        return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(i);
    }
    template <class Visit>
    void for_cells_of(const std::vector<Rectangle>& boxes, Visit&& visit) const {
        for (std::int32_t b = 0; b < static_cast<std::int32_t>(boxes.size()); ++b) {
            for (std::int32_t j = row(boxes[b].low.y); j <= row(boxes[b].high.y); ++j) {
                for (std::int32_t i = column(boxes[b].low.x); i <= column(boxes[b].high.x); ++i) visit(cell_of(i, j), b);
            }
        }
    }
    double size_;
    Vector2 origin_;
    std::int32_t columns_ = 0, rows_ = 0;
    std::vector<std::int32_t> begin_, edges_;
};

}  // namespace

std::vector<CandidatePair> find_pairs(const Assemblage& a, double margin, State& s) {
    const GrainSurface& surface = a.surface;
    const std::vector<std::int32_t> exposed = find_exposed_edges(a, s.contact_pairs);
    const std::vector<std::uint8_t> is_known = exchange_exposed_nodes(a, exposed, margin, s);
    std::vector<std::int32_t> edges;
    std::vector<Rectangle> boxes;
    std::vector<std::uint8_t> is_exposed_node(a.position.size(), 0);
    for (const std::int32_t e : exposed) {
        const SurfaceEdge& edge = surface.edges[e];
        if (is_known[edge.nodes[0]] != 0 && is_known[edge.nodes[1]] != 0) {
            edges.push_back(e);
            boxes.push_back(around(position_of(a, s, edge.nodes[0]), position_of(a, s, edge.nodes[1]), margin));
            is_exposed_node[edge.nodes[0]] = is_exposed_node[edge.nodes[1]] = 1;
        }
    }
    const Cells cells(boxes, surface.mean_length);
    UnionFind linked = linked_nodes(a, s.contact_pairs);
    std::vector<CandidatePair> pairs;
    for (std::int32_t node = 0; node < a.n_nodes(); ++node) {
        if (is_exposed_node[node] == 0) continue;
        const Vector2 p = position_of(a, s, node);
        cells.visit_near(p, [&](std::int32_t box) {
            const SurfaceEdge& edge = surface.edges[edges[box]];
            if (!boxes[box].contains(p) || edge.grain == surface.grain_of_node[node]) return;
            const Vector2 first = position_of(a, s, edge.nodes[0]);
            const Vector2 along = position_of(a, s, edge.nodes[1]) - first;
            const double place = std::clamp(dot(p - first, along) / dot(along, along), 0.0, 1.0);
            if (length(p - first - place * along) > margin) return;
            const std::size_t vertex = linked.find(static_cast<std::size_t>(node));
            const bool is_linked = std::any_of(edge.nodes.begin(), edge.nodes.end(), [&](std::int32_t other) {
                return linked.find(static_cast<std::size_t>(other)) == vertex;
            });
            const bool is_partner =
                edge.contact >= 0 && std::find(a.contacts[edge.contact].nodes.begin(), a.contacts[edge.contact].nodes.end(),
                                               node) != a.contacts[edge.contact].nodes.end();
            if (is_partner ? s.contact_pairs.released[edge.contact] != 0 : !is_linked) pairs.push_back({node, edges[box]});
        });
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    keep_pairs_of_own_nodes(a, pairs);
    return pairs;
}

}  // namespace graincrack
