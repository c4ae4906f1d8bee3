#include "mesher/import/label_boundaries.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

namespace graincrack::mesher {

namespace {

/// Offset of the nodes of an opened corner along x and y, pixels.
constexpr double opening = 0.25;

/// Directions from a corner of pixels, counter-clockwise: right, up, left, down.
constexpr std::array<std::array<int, 2>, 4> step{{{1, 0}, {0, -1}, {-1, 0}, {0, 1}}};  // columns, rows

/// A corner of pixels, in lines between columns and rows counted from the left and the top.
struct Corner {
    int column = 0, row = 0;
};

class Tracing {
public:
    explicit Tracing(const LabelPieces& pieces)
        : pieces_(pieces),
          columns_(static_cast<std::size_t>(pieces.width) + 1),
          horizontal_(columns_ * (static_cast<std::size_t>(pieces.height) + 1)),
          vertical_(horizontal_.size()) {}

    LabelBoundaries run() && {
        for (int row = 0; row <= pieces_.height; ++row) {
            for (int column = 0; column <= pieces_.width; ++column) add_nodes({column, row});
        }
        for (const auto& [corner, direction] : starts_) {
            if (!is_done(corner, direction)) trace(corner, direction);
        }
        for (int row = 0; row <= pieces_.height; ++row) {
            for (int column = 0; column < pieces_.width; ++column) {
                if (separates({column, row}, 0) && !is_done({column, row}, 0)) trace_closed({column, row});
            }
        }
        return std::move(boundaries_);
    }

private:
    /// The piece between direction k and the next, counter-clockwise.
    [[nodiscard]] int piece_after(Corner c, int k) const {
        constexpr std::array<std::array<int, 2>, 4> offset{{{0, -1}, {-1, -1}, {-1, 0}, {0, 0}}};
        const auto& o = offset[static_cast<std::size_t>(k)];
        return pieces_.at(c.column + o[0], c.row + o[1]);
    }
    [[nodiscard]] int left_of_step(Corner c, int k) const { return piece_after(c, k); }
    [[nodiscard]] int right_of_step(Corner c, int k) const { return piece_after(c, (k + 3) % 4); }
    [[nodiscard]] bool separates(Corner c, int k) const { return left_of_step(c, k) != right_of_step(c, k); }

    [[nodiscard]] std::size_t index(Corner c) const {
        return static_cast<std::size_t>(c.row) * columns_ + static_cast<std::size_t>(c.column);
    }
    [[nodiscard]] Point point(Corner c) const {
        return {static_cast<double>(c.column), static_cast<double>(pieces_.height - c.row)};
    }
    static Corner next(Corner c, int k) {
        const auto& s = step[static_cast<std::size_t>(k)];
        return {c.column + s[0], c.row + s[1]};
    }

    /// True if a pixel side already belongs to a chain.
    std::vector<bool>::reference mark(Corner c, int k) {
        if (k == 1 || k == 2) c = next(c, k);
        return k % 2 == 0 ? horizontal_[index(c)] : vertical_[index(c)];
    }
    bool is_done(Corner c, int k) { return mark(c, k); }

    int add_node(Point p) {
        boundaries_.nodes.push_back(p);
        return static_cast<int>(boundaries_.nodes.size()) - 1;
    }

    void add_nodes(Corner c) {
        std::array<int, 4> pieces{};
        for (int k = 0; k < 4; ++k) pieces[static_cast<std::size_t>(k)] = piece_after(c, k);
        int n = 0;
        for (std::size_t k = 0; k < 4; ++k) n += pieces[k] != pieces[(k + 1) % 4] ? 1 : 0;
        const bool is_corner_of_picture = (c.column == 0 || c.column == pieces_.width) && (c.row == 0 || c.row == pieces_.height);
        if (n < 3 && !is_corner_of_picture) return;
        auto& nodes = nodes_at_[index(c)];
        nodes.fill(-1);
        if (n == 4 && (pieces[0] == pieces[2] || pieces[1] == pieces[3])) {
            open(c, pieces[0] == pieces[2] ? 0 : 1, pieces, nodes);
        } else {
            nodes.fill(add_node(point(c)));
        }
        for (int k = 0; k < 4; ++k) {
            if (separates(c, k)) starts_.emplace_back(c, k);
        }
    }

    /// Replaces a corner by two nodes if the pieces after the directions k and k + 2 are one.
    void open(Corner c, int k, const std::array<int, 4>& pieces, std::array<int, 4>& nodes) {
        const Point p = point(c);
        const Point into{k == 0 ? opening : -opening, opening};
        const int one = add_node(p + into);
        const int other = add_node(p - into);
        const auto at = [](int i) { return static_cast<std::size_t>(i % 4); };
        nodes[at(k)] = nodes[at(k + 1)] = one;
        nodes[at(k + 2)] = nodes[at(k + 3)] = other;
        // From `other` to `one`, the piece after k + 1 is on the left.
        boundaries_.chains.push_back({other, one, pieces[at(k + 1)], pieces[at(k + 3)], {p - into, p + into}});
        ++boundaries_.opened_corners;
    }

    [[nodiscard]] int node_at(Corner c, int k) const {
        const auto found = nodes_at_.find(index(c));
        return found == nodes_at_.end() ? -1 : found->second[static_cast<std::size_t>(k)];
    }

    /// The direction in which a boundary continues at a corner without a node, after arriving by direction k.
    [[nodiscard]] int onward(Corner c, int k) const {
        for (const int turn : {0, 1, 3}) {
            if (separates(c, (k + turn) % 4)) return (k + turn) % 4;
        }
        return -1;  // boundaries have no ends
    }

    void trace(Corner c, int k) {
        BoundaryChain chain{node_at(c, k), -1, left_of_step(c, k), right_of_step(c, k), {}};
        chain.path.push_back(point(c));
        while (true) {
            mark(c, k) = true;
            c = next(c, k);
            chain.path.push_back(point(c));
            chain.to = node_at(c, (k + 2) % 4);
            if (chain.to >= 0) break;
            k = onward(c, k);
        }
        boundaries_.chains.push_back(std::move(chain));
    }

    void trace_closed(Corner c) {
        int k = 0;
        BoundaryChain chain{-1, -1, left_of_step(c, k), right_of_step(c, k), {}};
        while (!is_done(c, k)) {
            mark(c, k) = true;
            chain.path.push_back(point(c));
            c = next(c, k);
            k = onward(c, k);
        }
        boundaries_.chains.push_back(std::move(chain));
    }

    const LabelPieces& pieces_;
    std::size_t columns_;
    std::vector<bool> horizontal_;  ///< for the side to the right of a corner
    std::vector<bool> vertical_;    ///< for the side below a corner
    std::unordered_map<std::size_t, std::array<int, 4>> nodes_at_;
    std::vector<std::pair<Corner, int>> starts_;
    LabelBoundaries boundaries_;
};

/// The chains that meet in a node.
struct Junction {
    std::vector<std::size_t> chains;
    bool on_outline = false, joined = false;
};

class JunctionJoining {
public:
    explicit JunctionJoining(LabelBoundaries& boundaries) : boundaries_(boundaries), junctions_(boundaries.nodes.size()) {
        for (std::size_t c = 0; c < boundaries_.chains.size(); ++c) {
            const BoundaryChain& chain = boundaries_.chains[c];
            if (chain.closed()) continue;
            for (const int node : {chain.from, chain.to}) {
                junction(node).chains.push_back(c);
                junction(node).on_outline = junction(node).on_outline || chain.on_outline();
            }
        }
    }

    int run(std::size_t most_sides) && {
        std::vector<bool> gone(boundaries_.chains.size());
        for (std::size_t sides = 1; sides <= most_sides; ++sides) {
            for (std::size_t c = 0; c < gone.size(); ++c) {
                if (gone[c] || !can_go(boundaries_.chains[c], sides)) continue;
                join(boundaries_.chains[c]);
                gone[c] = true;
            }
        }
        const auto n = static_cast<int>(std::count(gone.begin(), gone.end(), true));
        if (n > 0) remove(gone);
        return n;
    }

private:
    Junction& junction(int node) { return junctions_[static_cast<std::size_t>(node)]; }
    Point& place(int node) { return boundaries_.nodes[static_cast<std::size_t>(node)]; }

    /// The piece at one end of a chain that is not beside it.
    int piece_beyond(const BoundaryChain& chain, int node) {
        for (const std::size_t c : junction(node).chains) {
            for (const int piece : {boundaries_.chains[c].left, boundaries_.chains[c].right}) {
                if (piece != chain.left && piece != chain.right) return piece;
            }
        }
        return -1;
    }

    bool can_go(const BoundaryChain& chain, std::size_t sides) {
        if (chain.closed() || chain.from == chain.to || chain.path.size() != sides + 1) return false;
        for (const int node : {chain.from, chain.to}) {
            const Junction& j = junction(node);
            if (j.chains.size() != 3 || j.on_outline || j.joined) return false;
        }
        for (const std::size_t c : junction(chain.from).chains) {
            const BoundaryChain& other = boundaries_.chains[c];
            const bool same_ends =
                (other.from == chain.from && other.to == chain.to) || (other.from == chain.to && other.to == chain.from);
            if (same_ends && &other != &chain) return false;
        }
        return piece_beyond(chain, chain.from) != piece_beyond(chain, chain.to);
    }

    void join(const BoundaryChain& chain) {
        const int from = chain.from;
        const int to = chain.to;
        place(from) = chain.path.size() == 3 ? chain.path[1] : midpoint(chain.path.front(), chain.path.back());
        junction(from).joined = junction(to).joined = true;
        for (const std::size_t c : junction(to).chains) {
            BoundaryChain& other = boundaries_.chains[c];
            if (other.from == to) other.from = from;
            if (other.to == to) other.to = from;
        }
    }

    /// Removes chains, and nodes without chains.
    void remove(const std::vector<bool>& gone) {
        std::vector<BoundaryChain> chains;
        for (std::size_t c = 0; c < gone.size(); ++c) {
            if (!gone[c]) chains.push_back(std::move(boundaries_.chains[c]));
        }
        std::vector<int> number(boundaries_.nodes.size(), -1);
        std::vector<Point> nodes;
        for (BoundaryChain& chain : chains) {
            for (int* node : {&chain.from, &chain.to}) {
                if (*node < 0) continue;
                int& own = number[static_cast<std::size_t>(*node)];
                if (own < 0) {
                    own = static_cast<int>(nodes.size());
                    nodes.push_back(place(*node));
                }
                *node = own;
            }
        }
        boundaries_.chains = std::move(chains);
        boundaries_.nodes = std::move(nodes);
    }

    LabelBoundaries& boundaries_;
    std::vector<Junction> junctions_;
};

}  // namespace

LabelBoundaries label_boundaries(const LabelPieces& pieces) { return Tracing(pieces).run(); }

int join_near_junctions(LabelBoundaries& boundaries, int most_sides) {
    return most_sides > 0 ? JunctionJoining(boundaries).run(static_cast<std::size_t>(std::min(most_sides, 2))) : 0;
}

}  // namespace graincrack::mesher
