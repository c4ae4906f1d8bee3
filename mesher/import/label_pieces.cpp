#include "mesher/import/label_pieces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

#include "mesher/plane/geometry.hpp"
#include "share/base/error.hpp"
#include "share/base/union_find.hpp"

namespace graincrack::mesher {

namespace {

/// Numbers the connected pieces in the order of their first pixels.
void number_pieces(const LabelImage& image, LabelPieces& pieces, const std::string& name) {
    const auto width = static_cast<std::size_t>(image.width);
    const std::size_t n = image.labels.size();
    pieces.piece_of_pixel.assign(n, -1);
    std::vector<std::size_t> reached;
    for (std::size_t first = 0; first < n; ++first) {
        if (pieces.piece_of_pixel[first] >= 0) continue;
        if (pieces.size() == 10 * most_grains) {
            throw InputError(
                fmt::format("{}: more than {} pieces of one label; a picture of grains is needed", name, 10 * most_grains));
        }
        const int piece = static_cast<int>(pieces.size());
        pieces.label_of_piece.push_back(image.labels[first]);
        int count = 0;
        pieces.piece_of_pixel[first] = piece;
        reached.assign(1, first);
        while (!reached.empty()) {
            const std::size_t p = reached.back();
            reached.pop_back();
            ++count;
            const auto reach = [&](bool is_there, std::size_t q) {
                if (!is_there || pieces.piece_of_pixel[q] >= 0 || image.labels[q] != image.labels[first]) return;
                pieces.piece_of_pixel[q] = piece;
                reached.push_back(q);
            };
            reach(p % width > 0, p - 1);
            reach(p % width + 1 < width, p + 1);
            reach(p >= width, p - width);
            reach(p + width < n, p + width);
        }
        pieces.pixels_of_piece.push_back(count);
    }
}

/// Joins small pieces; one of the joined pieces represents them.
class PieceJoining {
public:
    PieceJoining(LabelPieces& pieces, int smallest)
        : pieces_(pieces), smallest_(smallest), sets_(pieces.size()), borders_(pieces.size()) {
        const auto add = [&](int a, int b) {
            if (a == b || b < 0) return;
            ++borders_[index(a)][b];
            ++borders_[index(b)][a];
        };
        for (int row = 0; row < pieces.height; ++row) {
            for (int column = 0; column < pieces.width; ++column) {
                add(pieces.at(column, row), pieces.at(column + 1, row));
                add(pieces.at(column, row), pieces.at(column, row + 1));
            }
        }
        for (std::size_t i = 0; i < pieces.size(); ++i) wait(static_cast<int>(i));
    }

    void run() {
        while (!waiting_.empty()) {
            const int piece = waiting_.begin()->second;
            waiting_.erase(waiting_.begin());
            const std::map<int, int> around = borders_[index(piece)];
            if (around.empty()) continue;
            const int target =
                std::max_element(around.begin(), around.end(), [&](const auto& a, const auto& b) {
                    return std::tuple(a.second, pixels(a.first), -a.first) < std::tuple(b.second, pixels(b.first), -b.first);
                })->first;
            ++pieces_.joined;
            waiting_.erase({pixels(target), target});
            join(piece, target);
            // Separate pieces of one label become one.
            for (const auto& [other, length] : around) {
                if (other != target && label(other) == label(target)) join(other, target);
            }
            wait(target);
        }
        renumber();
    }

private:
    int& pixels(int piece) { return pieces_.pixels_of_piece[index(piece)]; }
    int& label(int piece) { return pieces_.label_of_piece[index(piece)]; }
    void wait(int piece) {
        if (pixels(piece) < smallest_) waiting_.emplace(pixels(piece), piece);
    }

    void join(int piece, int target) {
        waiting_.erase({pixels(piece), piece});
        sets_.join(index(piece), index(target));
        pixels(target) += pixels(piece);
        for (const auto& [other, length] : borders_[index(piece)]) {
            borders_[index(other)].erase(piece);
            if (other == target) continue;
            borders_[index(target)][other] += length;
            borders_[index(other)][target] += length;
        }
        borders_[index(piece)].clear();
        label(static_cast<int>(sets_.find(index(piece)))) = label(target);
    }

    /// Numbers the sets in the order of their first pixels.
    void renumber() {
        std::vector<int> number(pieces_.size(), -1);
        std::vector<int> labels;
        std::vector<int> counts;
        for (int& piece : pieces_.piece_of_pixel) {
            const std::size_t set = sets_.find(index(piece));
            int& own = number[set];
            if (own < 0) {
                own = static_cast<int>(labels.size());
                labels.push_back(pieces_.label_of_piece[set]);
                counts.push_back(0);
            }
            piece = own;
            ++counts[index(own)];
        }
        pieces_.label_of_piece = std::move(labels);
        pieces_.pixels_of_piece = std::move(counts);
    }

    LabelPieces& pieces_;
    int smallest_;
    UnionFind sets_;
    std::vector<std::map<int, int>> borders_;  ///< sides of pixels of each piece with its neighbours
    std::set<std::pair<int, int>> waiting_;    ///< pixels and numbers of pieces below the smallest size
};

}  // namespace

LabelPieces label_pieces(const LabelImage& image, int smallest_piece, const std::string& name) {
    LabelPieces pieces;
    pieces.width = image.width;
    pieces.height = image.height;
    number_pieces(image, pieces, name);
    const std::vector<int>& pixels = pieces.pixels_of_piece;
    const auto in_small = [&](std::size_t sum, int own) {
        return sum + static_cast<std::size_t>(own < smallest_piece ? own : 0);
    };
    const std::size_t small = std::accumulate(pixels.begin(), pixels.end(), std::size_t{0}, in_small);
    if (image.are_colours && 2 * small > image.labels.size()) {
        throw InputError(name +
                         ": is a photo: most of its pixels are in pieces too small for grains; a PNG of labels is needed, " +
                         "one colour for each grain or mineral");
    }
    if (small > 0) PieceJoining(pieces, smallest_piece).run();
    if (pieces.size() > most_grains) {
        throw InputError(fmt::format("{}: {} grains; at most {} are made, so a larger smallest piece is needed", name,
                                     pieces.size(), most_grains));
    }
    std::vector<int> labels = pieces.label_of_piece;
    std::sort(labels.begin(), labels.end());
    for (std::size_t i = 1; i < labels.size(); ++i) {
        if (labels[i] != labels[i - 1]) continue;
        ++pieces.added_by_pieces;
        if (i == 1 || labels[i - 2] != labels[i]) ++pieces.labels_in_pieces;
    }
    return pieces;
}

}  // namespace graincrack::mesher
