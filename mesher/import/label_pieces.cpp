#include "mesher/import/label_pieces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <queue>
#include <tuple>
#include <utility>

#include "share/base/error.hpp"

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

/// Joins small pieces; a set of joined pieces is known by one of them.
class PieceJoining {
public:
    PieceJoining(const LabelPieces& pieces, int smallest)
        : set_of_(pieces.size()), labels_(pieces.label_of_piece), pixels_(pieces.pixels_of_piece), smallest_(smallest) {
        for (std::size_t i = 0; i < set_of_.size(); ++i) set_of_[i] = static_cast<int>(i);
        add_borders(pieces);
    }

    /// \return how many pieces joined another
    int run() {
        int joined = 0;
        for (std::size_t i = 0; i < set_of_.size(); ++i) queue(static_cast<int>(i));
        while (!waiting_.empty()) {
            const auto [pixels, piece] = waiting_.top();
            waiting_.pop();
            if (find(piece) != piece || pixels_[place(piece)] != pixels) continue;
            const std::vector<Border> around = borders_of(piece);
            if (around.empty()) continue;
            const int target = std::max_element(around.begin(), around.end(), [&](const Border& a, const Border& b) {
                                   return std::tuple(a.length, pixels_[place(a.piece)], -a.piece) <
                                          std::tuple(b.length, pixels_[place(b.piece)], -b.piece);
                               })->piece;
            ++joined;
            join(piece, target);
            // Pieces of one label that were apart are one now.
            for (const Border& b : around) {
                if (b.piece != target && labels_[place(b.piece)] == labels_[place(target)]) join(b.piece, target);
            }
            queue(target);
        }
        return joined;
    }

    int find(int piece) {
        while (set_of_[place(piece)] != piece) {
            set_of_[place(piece)] = set_of_[place(set_of_[place(piece)])];
            piece = set_of_[place(piece)];
        }
        return piece;
    }
    [[nodiscard]] int label(int set) const { return labels_[place(set)]; }

private:
    struct Border {
        int piece = 0;
        int length = 0;
    };

    static std::size_t place(int piece) { return static_cast<std::size_t>(piece); }

    void add_borders(const LabelPieces& pieces) {
        borders_.resize(pieces.size());
        const auto add = [&](int a, int b) {
            if (a == b || b < 0) return;
            for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, a}}) {
                auto& list = borders_[place(from)];
                if (!list.empty() && list.back().piece == to) {
                    ++list.back().length;
                } else {
                    list.push_back({to, 1});
                }
            }
        };
        for (int row = 0; row < pieces.height; ++row) {
            for (int column = 0; column < pieces.width; ++column) {
                const int piece = pieces.at(column, row);
                add(piece, pieces.at(column + 1, row));
                add(piece, pieces.at(column, row + 1));
            }
        }
    }

    void queue(int piece) {
        if (pixels_[place(piece)] < smallest_) waiting_.emplace(pixels_[place(piece)], piece);
    }

    /// The neighbours of a piece, each once, ascending.
    std::vector<Border> borders_of(int piece) {
        auto& list = borders_[place(piece)];
        for (Border& b : list) b.piece = find(b.piece);
        std::sort(list.begin(), list.end(), [](const Border& a, const Border& b) { return a.piece < b.piece; });
        std::vector<Border> sums;
        for (const Border& b : list) {
            if (b.piece == piece) continue;
            if (!sums.empty() && sums.back().piece == b.piece) {
                sums.back().length += b.length;
            } else {
                sums.push_back(b);
            }
        }
        list = sums;
        return sums;
    }

    void join(int piece, int target) {
        set_of_[place(piece)] = target;
        pixels_[place(target)] += pixels_[place(piece)];
        auto& from = borders_[place(piece)];
        auto& to = borders_[place(target)];
        if (from.size() > to.size()) std::swap(from, to);
        to.insert(to.end(), from.begin(), from.end());
        from = {};
    }

    std::vector<int> set_of_;
    std::vector<int> labels_;
    std::vector<int> pixels_;
    std::vector<std::vector<Border>> borders_;
    int smallest_;
    /// Pixels and number of a piece, the smallest on top; entries are out of date where the pixels have changed.
    std::priority_queue<std::pair<int, int>, std::vector<std::pair<int, int>>, std::greater<>> waiting_;
};

void join_small_pieces(LabelPieces& pieces, int smallest) {
    PieceJoining joining(pieces, smallest);
    pieces.joined = joining.run();
    std::vector<int> number(pieces.size(), -1);
    std::vector<int> labels;
    std::vector<int> pixels;
    for (int& piece : pieces.piece_of_pixel) {
        const int set = joining.find(piece);
        int& own = number[static_cast<std::size_t>(set)];
        if (own < 0) {
            own = static_cast<int>(labels.size());
            labels.push_back(joining.label(set));
            pixels.push_back(0);
        }
        piece = own;
        ++pixels[static_cast<std::size_t>(own)];
    }
    pieces.label_of_piece = std::move(labels);
    pieces.pixels_of_piece = std::move(pixels);
}

}  // namespace

LabelPieces label_pieces(const LabelImage& image, int smallest_piece, const std::string& name) {
    LabelPieces pieces;
    pieces.width = image.width;
    pieces.height = image.height;
    number_pieces(image, pieces, name);
    const auto is_small = [&](int pixels) { return pixels < smallest_piece; };
    const std::vector<int>& pixels = pieces.pixels_of_piece;
    if (std::any_of(pixels.begin(), pixels.end(), is_small)) join_small_pieces(pieces, smallest_piece);
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
