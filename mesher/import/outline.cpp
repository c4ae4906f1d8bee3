#include "mesher/import/outline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "mesher/import/clean_mesh.hpp"
#include "share/base/error.hpp"
#include "share/file/specimen.hpp"

namespace graincrack::mesher {

namespace {

constexpr double off_straight = 1e-6;       ///< distance of points from the sides of a rectangle, over its size
constexpr double off_round = 0.01;          ///< distance of points from a circle over its radius, as of equal-area polygons
constexpr std::size_t fewest_of_round = 8;  ///< sides of a circle

constexpr std::uint8_t bottom = 0;
constexpr std::uint8_t right = 1;
constexpr std::uint8_t top = 2;
constexpr std::uint8_t left = 3;
constexpr std::uint8_t rim = 4;

/// Consecutive sides, closed.
using Chain = std::vector<OpenSide>;

std::vector<Chain> chains_of(const std::vector<OpenSide>& sides) {
    std::multimap<int, std::size_t> from;
    for (std::size_t i = 0; i < sides.size(); ++i) from.emplace(sides[i].from, i);
    std::vector<bool> is_taken(sides.size(), false);
    std::vector<Chain> chains;
    for (std::size_t first = 0; first < sides.size(); ++first) {
        if (is_taken[first]) continue;
        Chain chain;
        for (std::size_t i = first; !is_taken[i];) {
            is_taken[i] = true;
            chain.push_back(sides[i]);
            const auto [begin, end] = from.equal_range(sides[i].to);
            const auto next = std::find_if(begin, end, [&](const auto& each) { return !is_taken[each.second]; });
            if (next == end) break;
            i = next->second;
        }
        chains.push_back(std::move(chain));
    }
    return chains;
}

class OutlineFinder {
public:
    OutlineFinder(const ImportedMesh& mesh, const std::string& name, std::vector<Remark>& notes)
        : mesh_(mesh), name_(name), notes_(notes) {}

    Outline find(const std::string& shape) {
        chains_ = chains_of(open_sides(mesh_.triangles));
        const auto outer =
            std::max_element(chains_.begin(), chains_.end(), [&](const Chain& l, const Chain& r) { return area(l) < area(r); });
        std::swap(*outer, chains_.front());
        measure();
        outline_.shape = shape_by_outline();
        if (!shape.empty()) outline_.shape = shape;
        outline_.part_names = Specimen{}.part_names;
        name_sides();
        return std::move(outline_);
    }

private:
    [[nodiscard]] Point at(int p) const { return mesh_.points[index(p)]; }

    [[nodiscard]] double area(const Chain& chain) const {
        const Point origin = at(chain.front().from);
        return std::accumulate(chain.begin(), chain.end(), 0.0, [&](double sum, const OpenSide& side) {
            return sum + signed_area(origin, at(side.from), at(side.to));
        });
    }

    void measure() {
        for (const OpenSide& side : open_sides(mesh_.triangles)) box_.add(at(side.from));
        outline_.middle = midpoint(box_.low, box_.high);
        outline_.width = box_.width();
        outline_.height = box_.height();
    }

    [[nodiscard]] double size() const { return std::max(outline_.width, outline_.height); }

    /// The side of the extent on which a side lies; empty if there is none.
    [[nodiscard]] std::optional<std::uint8_t> straight_part(const OpenSide& side) const {
        const auto are = [&](auto distance) {
            return std::abs(distance(at(side.from))) <= off_straight * size() &&
                   std::abs(distance(at(side.to))) <= off_straight * size();
        };
        if (are([&](Point p) { return p.y - box_.low.y; })) return bottom;
        if (are([&](Point p) { return p.x - box_.high.x; })) return right;
        if (are([&](Point p) { return p.y - box_.high.y; })) return top;
        if (are([&](Point p) { return p.x - box_.low.x; })) return left;
        return std::nullopt;
    }

    /// True if the corners of a chain lie on a circle.
    [[nodiscard]] bool is_round(const Chain& chain, Point centre) const {
        double sum = 0;
        for (const OpenSide& side : chain) sum += length(at(side.from) - centre);
        const double radius = sum / static_cast<double>(chain.size());
        return chain.size() >= fewest_of_round && std::all_of(chain.begin(), chain.end(), [&](const OpenSide& side) {
                   return std::abs(length(at(side.from) - centre) - radius) <= off_round * radius;
               });
    }

    [[nodiscard]] std::string shape_by_outline() {
        const Chain& outer = chains_.front();
        if (std::count_if(chains_.begin(), chains_.end(), [&](const Chain& chain) { return area(chain) > 0; }) > 1) {
            return "polygon";  // several bodies
        }
        if (std::all_of(outer.begin(), outer.end(), [&](const OpenSide& side) { return straight_part(side).has_value(); })) {
            return "rectangle";
        }
        if (is_round(outer, outline_.middle)) {
            outline_.width = outline_.height;
            outline_.loading_arc = pole_arc(outline_.height / 2);
            return chains_.size() == 2 && is_round(chains_.back(), outline_.middle) ? "ring" : "disc";
        }
        const Point foot{outline_.middle.x, box_.low.y};
        Chain arc;
        std::copy_if(outer.begin(), outer.end(), std::back_inserter(arc),
                     [&](const OpenSide& side) { return straight_part(side) != bottom; });
        if (arc.size() < outer.size() && is_round(arc, foot) &&
            std::abs(outline_.height - outline_.width / 2) <= off_round * outline_.width) {
            return "half-disc";
        }
        return "polygon";
    }

    /// The angle under which a facet of one or more sides across the top is seen from the middle, rad; 0 without one.
    [[nodiscard]] double pole_arc(double radius) const {
        double facet = 0;
        for (const OpenSide& side : chains_.front()) {
            if (straight_part(side) == top) facet += length(at(side.to) - at(side.from));
        }
        return 2 * std::atan2(facet / 2, radius);
    }

    std::uint8_t part_of_name(const std::string& part) {
        std::vector<std::string>& names = outline_.part_names;
        const auto found = std::find(names.begin(), names.end(), part);
        if (found != names.end()) return static_cast<std::uint8_t>(found - names.begin());
        if (names.size() > std::numeric_limits<std::uint8_t>::max()) {
            throw InputError(name_ + ": more than 251 names of parts of the boundary");
        }
        names.push_back(part);
        return static_cast<std::uint8_t>(names.size() - 1);
    }

    /// The part of a side without a name.
    std::uint8_t part_of(const OpenSide& side, std::size_t hole) {
        const std::string& shape = outline_.shape;
        if (hole > 0) return part_of_name(shape == "ring" ? "inner" : fmt::format("hole_{}", hole));
        const auto straight = straight_part(side);
        if (shape == "rectangle" || shape == "beam") return straight ? *straight : part_of_name("side");
        if (shape == "half-disc") return straight == bottom ? bottom : rim;
        return shape == "disc" || shape == "ring" ? rim : part_of_name("side");
    }

    void name_sides() {
        if (outline_.shape == "ring") outline_.part_names[rim] = "outer";
        // Names of sides by their ends, with their places in the file.
        std::map<Edge, std::pair<std::size_t, const std::string*>> named;
        for (std::size_t i = 0; i < mesh_.lines.size(); ++i) {
            const NamedLine& line = mesh_.lines[i];
            named.try_emplace(edge_between(line.from, line.to), i, &line.name);
        }
        std::vector<std::pair<std::size_t, Side>> sides;
        std::size_t n_holes = 0, place = mesh_.lines.size();
        for (const Chain& chain : chains_) {
            const bool is_hole = area(chain) < 0;
            if (is_hole) ++n_holes;
            for (const OpenSide& side : chain) {
                const auto found = named.find(edge_between(side.from, side.to));
                const bool has_name = found != named.end() && !flaw_of_line(*found->second.second);
                const std::uint8_t part = has_name ? part_of_name(*found->second.second) : part_of(side, is_hole ? n_holes : 0);
                sides.push_back({has_name ? found->second.first : place++, {side.from, side.to, part, {}}});
            }
        }
        std::sort(sides.begin(), sides.end(), [](const auto& l, const auto& r) { return l.first < r.first; });
        std::set<Edge> on_boundary;
        for (const auto& [order, side] : sides) {
            outline_.sides.push_back(side);
            on_boundary.insert(edge_between(side.from, side.to));
        }
        add_flaws(on_boundary);
    }

    /// Adds contacts of their own kind along named lines between grains.
    void add_flaws(const std::set<Edge>& on_boundary) {
        std::map<Edge, std::set<int>> grains;  // on both sides of a named line
        for (const NamedLine& line : mesh_.lines) grains[edge_between(line.from, line.to)];
        for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
            for (std::size_t k = 0; k < 3; ++k) {
                const int p = mesh_.triangles[t][k];
                const int q = mesh_.triangles[t][(k + 1) % 3];
                const auto found = grains.find(edge_between(p, q));
                if (found != grains.end()) found->second.insert(mesh_.grain_of_triangle[t]);
            }
        }
        std::set<std::string> unused;
        std::size_t n_lost = 0;
        std::set<Edge> done;
        for (const NamedLine& line : mesh_.lines) {
            const Edge edge = edge_between(line.from, line.to);
            const auto kind = flaw_of_line(line.name);
            if (on_boundary.contains(edge)) {
                if (kind) ++n_lost;
            } else if (!kind) {
                unused.insert(line.name);
            } else if (grains[edge].size() < 2) {
                ++n_lost;
            } else if (done.insert(edge).second) {
                outline_.sides.push_back({line.from, line.to, -1, *kind});
            }
        }
        if (n_lost > 0) {
            notes_.emplace_back(
                fmt::format("{} lines of cracks and flaws lie between no two grains and were passed over", n_lost), "lost_lines");
        }
        for (const std::string& each : unused) {
            notes_.emplace_back(
                fmt::format("lines \"{}\" lie inside and say nothing there; contacts along lines of the name crack, flaw-NAME or "
                            "flaw-NAME-broken are cracks or of a class of flaws",
                            each),
                "unknown_lines");
        }
    }

    const ImportedMesh& mesh_;
    const std::string& name_;
    std::vector<Remark>& notes_;
    std::vector<Chain> chains_;  ///< the outer one first
    Box box_;
    Outline outline_;
};

}  // namespace

Outline outline_of(const ImportedMesh& mesh, const std::string& shape, const std::string& name, std::vector<Remark>& notes) {
    return OutlineFinder(mesh, name, notes).find(shape);
}

std::optional<FlawKind> flaw_of_line(const std::string& name) {
    constexpr std::string_view prefix = "flaw-";
    constexpr std::string_view suffix = "-broken";
    if (name == "crack") return FlawKind{ContactKind::pre_existing_crack};
    if (name == "open-boundary") return FlawKind{ContactKind::open_boundary};
    if (name.substr(0, prefix.size()) != prefix) return std::nullopt;
    std::string flaw = name.substr(prefix.size());
    const bool is_broken = flaw.size() > suffix.size() && flaw.substr(flaw.size() - suffix.size()) == suffix;
    if (is_broken) flaw.resize(flaw.size() - suffix.size());
    if (!is_flaw_name(flaw)) return std::nullopt;
    return FlawKind{is_broken ? ContactKind::pre_existing_crack : ContactKind::grain_boundary, flaw};
}

}  // namespace graincrack::mesher
