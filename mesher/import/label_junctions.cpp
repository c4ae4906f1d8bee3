#include "mesher/import/label_junctions.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace graincrack::mesher {

namespace {

/// What meets in a node.
struct Junction {
    std::vector<std::size_t> chains;
    bool on_outline = false;
    bool joined = false;
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

    /// The piece at one end of a chain that is on neither side of it.
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

    /// Removes chains, and nodes that no chain has any more.
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

int join_near_junctions(LabelBoundaries& boundaries, int most_sides) {
    return most_sides > 0 ? JunctionJoining(boundaries).run(static_cast<std::size_t>(std::min(most_sides, 2))) : 0;
}

}  // namespace graincrack::mesher
