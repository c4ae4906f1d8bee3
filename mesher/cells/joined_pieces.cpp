#include "mesher/cells/joined_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "mesher/cells/convex_outline.hpp"
#include "mesher/cells/polygon.hpp"

namespace graincrack::mesher {

namespace {

constexpr double credit_of_seed = 0.3;  ///< added to the share of a piece with the seed of its cell

class PieceJoiner {
public:
    PieceJoiner(CellPieces& pieces, std::span<const Point> seeds, const std::vector<double>& wanted)
        : pieces_(pieces), seeds_(seeds), wanted_(wanted) {}

    /// The pieces in which seeds lie, most of them pieces of their own cells.
    void find_seeds() {
        std::vector<std::vector<std::size_t>> pieces_of_cell(seeds_.size());
        for (std::size_t cell = 0; cell < pieces_.size(); ++cell) pieces_of_cell[pieces_.origin(cell)].push_back(cell);
        for (std::size_t seed = 0; seed < seeds_.size(); ++seed) {
            const auto holds = [&](std::size_t cell) { return pieces_.is_inside(pieces_.loop(cell), seeds_[seed]); };
            const auto own = std::find_if(pieces_of_cell[seed].begin(), pieces_of_cell[seed].end(), holds);
            std::size_t cell = own == pieces_of_cell[seed].end() ? 0 : *own;
            if (own == pieces_of_cell[seed].end()) {
                while (cell + 1 < pieces_.size() && !holds(cell)) ++cell;
            }
            piece_of_seed_.push_back(cell);
        }
    }

    /// Drops pieces outside of loops, which have the region on their left.
    void drop_outside() {
        const auto is_of_loop = [&](int side) { return side >= 0 && pieces_.side(side).part >= 0; };
        const auto sets = pieces_.sets(is_of_loop);
        std::vector<char> is_outside(pieces_.size(), 0);
        for (std::size_t cell = 0; cell < pieces_.size(); ++cell) {
            const PieceLoop& loop = pieces_.loop(cell);
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const int side = pieces_.mark_of(loop[i], loop[(i + 1) % loop.size()]);
                if (!is_of_loop(side) || !pieces_.is_of_walls(side)) continue;
                const Point along = pieces_.direction(side);
                if (dot(along, pieces_.at(loop[(i + 1) % loop.size()]) - pieces_.at(loop[i])) < 0) is_outside[sets[cell]] = 1;
            }
        }
        for (std::size_t cell = 0; cell < pieces_.size(); ++cell) {
            if (is_outside[sets[cell]] != 0) pieces_.set_loop(cell, {});
        }
    }

    /// Joins pieces, and shares the areas wanted between those that are left. \return whether they have room
    bool join_pieces() {
        const auto sets = pieces_.sets([](int side) { return side >= 0; });
        share_.assign(pieces_.size(), 0);
        std::map<std::size_t, std::vector<std::size_t>> seeds_of;  // of each set
        std::map<std::size_t, std::vector<std::size_t>> pieces_of;
        for (std::size_t cell = 0; cell < pieces_.size(); ++cell) {
            if (pieces_.loop(cell).empty()) continue;
            share_[cell] = pieces_.area(cell) / wanted_[pieces_.origin(cell)];
            pieces_of[sets[cell]].push_back(cell);
        }
        for (std::size_t seed = 0; seed < seeds_.size(); ++seed) {
            const std::size_t piece = piece_of_seed_[seed];
            if (pieces_.loop(piece).empty()) continue;
            seeds_of[sets[piece]].push_back(seed);
            if (pieces_.origin(piece) == seed) share_[piece] += credit_of_seed;
        }
        areas_.assign(pieces_.size(), 0);
        for (auto& [set, pieces] : pieces_of) {
            const std::vector<std::size_t>& seeds = seeds_of[set];
            if (seeds.empty()) return has_no_room(pieces.front());
            while (pieces.size() < seeds.size()) {
                const std::size_t largest = *std::max_element(
                    pieces.begin(), pieces.end(), [&](std::size_t a, std::size_t b) { return share_[a] < share_[b]; });
                if (!halve(largest)) return has_no_room(largest);
                pieces.push_back(pieces_.size() - 1);
            }
            while (pieces.size() > seeds.size()) {
                std::sort(pieces.begin(), pieces.end(), [&](std::size_t a, std::size_t b) { return share_[a] < share_[b]; });
                const auto joined = std::find_if(pieces.begin(), pieces.end(), [&](std::size_t piece) { return join(piece); });
                if (joined == pieces.end()) return has_no_room(pieces.front());
                pieces.erase(joined);
            }
            // The largest area goes to the largest cell, over the squares of their graded sizes.
            std::vector<double> wanted;
            for (const std::size_t seed : seeds) wanted.push_back(wanted_[seed] / pieces_.square_of_size(seeds_[seed]));
            std::sort(wanted.begin(), wanted.end());
            const auto square_at = [&](std::size_t piece) {
                return pieces_.square_of_size(moments(pieces_.corners(piece)).centroid);
            };
            std::sort(pieces.begin(), pieces.end(), [&](std::size_t a, std::size_t b) {
                return pieces_.area(a) / square_at(a) < pieces_.area(b) / square_at(b);
            });
            double present = 0;
            for (std::size_t i = 0; i < pieces.size(); ++i) {
                present += pieces_.area(pieces[i]);
                wanted[i] *= square_at(pieces[i]);
            }
            const double scale = present / std::accumulate(wanted.begin(), wanted.end(), 0.0);
            for (std::size_t i = 0; i < pieces.size(); ++i) areas_[pieces[i]] = scale * wanted[i];
        }
        return true;
    }

    /// Leaves out points at which no more than two cells, or one and the outside, meet on a straight wall or within none.
    void drop_kinks() {
        for (int p = 0; p < static_cast<int>(pieces_.n_points()); ++p) {
            const std::vector<int> around = pieces_.pieces_at(p);
            if (pieces_.is_fixed(p) || around.empty() || around.size() > 2) continue;
            const auto beside = [&](int cell) {
                const PieceLoop& loop = pieces_.loop(index(cell));
                const auto i = static_cast<std::size_t>(std::find(loop.begin(), loop.end(), p) - loop.begin());
                return edge_between(loop[(i + loop.size() - 1) % loop.size()], loop[(i + 1) % loop.size()]);
            };
            const Edge edge = beside(around.front());
            const int side = pieces_.mark_of(edge[0], p);
            if (side != pieces_.mark_of(edge[1], p) || (around.size() == 2 && beside(around.back()) != edge)) continue;
            if (around.size() == 1 && side < 0) continue;
            bool fits = true;
            std::vector<PieceLoop> loops;
            for (const int cell : around) {
                PieceLoop loop = pieces_.loop(index(cell));
                std::erase(loop, p);
                fits = fits && loop.size() > 2 && (is_sound(pieces_.corners(loop)) || !is_sound(pieces_.corners(index(cell))));
                loops.push_back(std::move(loop));
            }
            if (!fits || pieces_.mark_of(edge[0], edge[1]) != CellPieces::no_wall) continue;
            for (std::size_t i = 0; i < around.size(); ++i) pieces_.set_loop(index(around[i]), loops[i]);
            if (side != CellPieces::no_wall) pieces_.mark(edge[0], edge[1], side);
        }
    }

    [[nodiscard]] const std::vector<double>& areas() const { return areas_; }
    [[nodiscard]] Point no_room() const { return no_room_; }

private:
    static std::size_t index(int i) { return static_cast<std::size_t>(i); }

    bool has_no_room(std::size_t piece) {
        no_room_ = moments(pieces_.corners(piece)).centroid;
        return false;
    }

    /// Divides a piece between two of its corners, as nearly in halves as these allow.
    bool halve(std::size_t piece) {
        const PieceLoop loop = pieces_.loop(piece);
        const std::size_t n = loop.size();
        double best = std::numeric_limits<double>::infinity();
        PieceLoop left;
        PieceLoop right;
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t k = i + 2; k < n && k < i + n - 1; ++k) {
                PieceLoop a(loop.begin() + static_cast<std::ptrdiff_t>(i), loop.begin() + static_cast<std::ptrdiff_t>(k) + 1);
                PieceLoop b(loop.begin() + static_cast<std::ptrdiff_t>(k), loop.end());
                b.insert(b.end(), loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(i) + 1);
                if (!is_sound(pieces_.corners(a)) || !is_sound(pieces_.corners(b))) continue;
                const double difference = std::abs(area_of(pieces_.corners(a)) - area_of(pieces_.corners(b)));
                if (difference >= best) continue;
                best = difference;
                left = std::move(a);
                right = std::move(b);
            }
        }
        if (left.empty()) return false;
        pieces_.set_loop(piece, std::move(left));
        pieces_.add_piece(std::move(right), pieces_.origin(piece));
        for (const std::size_t half : {piece, pieces_.size() - 1}) {
            share_.resize(pieces_.size(), 0);
            share_[half] = pieces_.area(half) / wanted_[pieces_.origin(half)];
        }
        areas_.resize(pieces_.size(), 0);
        return true;
    }

    /// Joins a piece to a neighbour, the one with the longest common side of those with which it makes a sound polygon.
    bool join(std::size_t piece) {
        std::map<int, double> common;
        const PieceLoop& loop = pieces_.loop(piece);
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const int p = loop[i];
            const int q = loop[(i + 1) % loop.size()];
            if (pieces_.mark_of(p, q) != CellPieces::no_wall) continue;
            for (const int cell : pieces_.pieces_at(p)) {
                const PieceLoop& other = pieces_.loop(index(cell));
                if (cell == static_cast<int>(piece) || std::find(other.begin(), other.end(), q) == other.end()) continue;
                common[cell] += length(pieces_.at(q) - pieces_.at(p));
            }
        }
        std::vector<std::pair<double, int>> order;
        for (const auto& [cell, size] : common) order.emplace_back(-size, cell);
        std::sort(order.begin(), order.end());
        for (const bool must_be_sound : {true, false}) {
            for (const auto& [size, cell] : order) {
                auto united = united_loop(piece, index(cell));
                if (!united || (must_be_sound && !is_sound(pieces_.corners(*united)))) continue;
                if (pieces_.area(piece) > pieces_.area(index(cell))) pieces_.set_origin(index(cell), pieces_.origin(piece));
                share_[index(cell)] += share_[piece];
                pieces_.set_loop(piece, {});
                pieces_.set_loop(index(cell), std::move(*united));
                return true;
            }
        }
        return false;
    }

    /// The loop around two cells that have one run of edges in common, none of which is of a wall.
    [[nodiscard]] std::optional<PieceLoop> united_loop(std::size_t a, std::size_t b) const {
        const PieceLoop& first = pieces_.loop(a);
        const PieceLoop& second = pieces_.loop(b);
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
            if (pieces_.mark_of(p, q) != CellPieces::no_wall) return std::nullopt;
            if (run > 0 && pieces_.is_fixed(p)) return std::nullopt;
        }
        PieceLoop united;
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

    CellPieces& pieces_;
    std::span<const Point> seeds_;
    const std::vector<double>& wanted_;
    std::vector<std::size_t> piece_of_seed_;
    std::vector<double> share_;  ///< of the wanted area of its cell that a piece has
    std::vector<double> areas_;  ///< wanted of pieces that are left
    Point no_room_;
};

}  // namespace

std::optional<std::vector<double>> joined_pieces(CellPieces& pieces, std::span<const Point> seeds,
                                                 const std::vector<double>& wanted, Point& no_room) {
    PieceJoiner joiner(pieces, seeds, wanted);
    joiner.find_seeds();
    joiner.drop_outside();
    if (!joiner.join_pieces()) {
        no_room = joiner.no_room();
        return std::nullopt;
    }
    joiner.drop_kinks();
    return joiner.areas();
}

}  // namespace graincrack::mesher
