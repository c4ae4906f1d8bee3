#include "mesher/import/labels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "mesher/import/label_boundaries.hpp"
#include "mesher/import/label_junctions.hpp"
#include "mesher/import/label_network.hpp"
#include "mesher/import/label_pieces.hpp"
#include "mesher/plane/refined_triangulation.hpp"
#include "share/base/error.hpp"
#include "share/base/units.hpp"

namespace graincrack::mesher {

namespace {

constexpr double element_of_side = 3;  ///< for each side of pixels of boundaries that are too short for elements
constexpr double least_element = 2;    ///< by default, pixels
constexpr double most_triangles = 20'000'000;

void check_options(const LabelOptions& options) {
    const auto is_length = [](double x) { return std::isfinite(x) && x > 0; };
    if (!is_length(options.pixel_size)) throw UsageError("size of a pixel: a length above 0 m is needed");
    if (options.element_size && !is_length(*options.element_size)) {
        throw UsageError("size of elements: a length above 0 m is needed");
    }
}

/// The wanted side of triangles, pixels.
double element_in_pixels(const LabelPieces& pieces, const LabelOptions& options, const std::string& name) {
    const double area = static_cast<double>(pieces.width) * pieces.height;
    if (!options.element_size) return std::max(side_for_area(area / static_cast<double>(pieces.size())), least_element);
    const double element = *options.element_size / options.pixel_size;
    if (triangles_of_square * area > most_triangles * element * element) {
        const double least = std::sqrt(triangles_of_square * area / most_triangles) * options.pixel_size;
        throw InputError(fmt::format("{}: elements of {} are too many for {} × {} pixels; at least {} are needed", name,
                                     format_length(*options.element_size), pieces.width, pieces.height, format_length(least)));
    }
    return element;
}

/// The smallest angle of triangles, degrees.
double smallest_angle(const RefinedMesh& mesh) {
    double smallest = 180;
    for (const Triangle& t : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Point p = mesh.points[static_cast<std::size_t>(t[k])];
            const Point a = mesh.points[static_cast<std::size_t>(t[(k + 1) % 3])] - p;
            const Point b = mesh.points[static_cast<std::size_t>(t[(k + 2) % 3])] - p;
            smallest = std::min(smallest, std::atan2(cross(a, b), dot(a, b)) * 180 / std::numbers::pi);
        }
    }
    return smallest;
}

double shortest_side(const RefinedMesh& mesh) {
    double shortest = INFINITY;
    for (const Triangle& t : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Point p = mesh.points[static_cast<std::size_t>(t[k])];
            shortest = std::min(shortest, length(mesh.points[static_cast<std::size_t>(t[(k + 1) % 3])] - p));
        }
    }
    return shortest;
}

/// The sides of triangles along the outline of the picture, with the names of its sides.
std::vector<NamedLine> outline(const RefinedMesh& mesh, double width, double height) {
    std::vector<NamedLine> lines;
    for (const Triangle& t : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const int from = t[k];
            const int to = t[(k + 1) % 3];
            const Point p = mesh.points[static_cast<std::size_t>(from)];
            const Point q = mesh.points[static_cast<std::size_t>(to)];
            if (p.y == 0 && q.y == 0) lines.push_back({from, to, "bottom"});
            if (p.x == width && q.x == width) lines.push_back({from, to, "right"});
            if (p.y == height && q.y == height) lines.push_back({from, to, "top"});
            if (p.x == 0 && q.x == 0) lines.push_back({from, to, "left"});
        }
    }
    return lines;
}

RefinedMesh triangles_of(const LabelNetwork& network, double element, const std::string& name) {
    Refinement refinement;
    refinement.side = element;
    try {
        return refined_triangles(network.points, network.segments, refinement);
    } catch (const UsageError& error) {
        throw InputError(fmt::format("{}: {}; a picture of fewer pixels or larger grains is needed", name, error.what()));
    }
}

std::string count(int n, const std::string& one, const std::string& many) { return fmt::format("{} {}", n, n == 1 ? one : many); }

std::vector<std::string> notes_on_pieces(const LabelPieces& pieces, const LabelOptions& options) {
    std::vector<std::string> notes;
    if (pieces.joined > 0) {
        notes.push_back(fmt::format("{} of fewer than {} pixels joined a neighbour", count(pieces.joined, "piece", "pieces"),
                                    options.smallest_piece));
    }
    if (pieces.added_by_pieces > 0) {
        notes.push_back(
            fmt::format("{} in several pieces: each is a grain, {} more than labels",
                        pieces.labels_in_pieces == 1 ? "1 label is" : fmt::format("{} labels are", pieces.labels_in_pieces),
                        pieces.added_by_pieces));
    }
    for (const auto& [label, phase] : options.phase_by_label) {
        const bool is_there =
            std::find(pieces.label_of_piece.begin(), pieces.label_of_piece.end(), label) != pieces.label_of_piece.end();
        if (!is_there) notes.push_back(fmt::format("no grain has the label {} of the phase {}", label, phase));
    }
    return notes;
}

}  // namespace

ImportedMesh import_labels(std::string_view bytes, const LabelOptions& options, const std::string& name) {
    check_options(options);
    ImportedMesh imported;
    LabelPieces pieces;
    {
        const LabelImage image = read_label_image(bytes, name);
        imported.format = fmt::format("labels, {}, {} × {} pixels", image.format, image.width, image.height);
        pieces = label_pieces(image, options.smallest_piece, name);
    }
    const double pixel = options.pixel_size;
    const double element = element_in_pixels(pieces, options, name);
    imported.notes = notes_on_pieces(pieces, options);

    LabelBoundaries boundaries = label_boundaries(pieces);
    const int joined_junctions =
        options.jagged ? 0 : join_near_junctions(boundaries, static_cast<int>(std::min(element / element_of_side, 2.0)));
    const LabelNetwork network = label_network(boundaries, pieces.pixels_of_piece, {element, options.jagged});
    RefinedMesh mesh = triangles_of(network, element, name);
    if (boundaries.opened_corners > 0) {
        imported.notes.push_back(fmt::format("where a grain met itself in a point, the other two got a boundary: {}",
                                             count(boundaries.opened_corners, "corner of pixels", "corners of pixels")));
    }
    if (joined_junctions > 0) {
        imported.notes.push_back(fmt::format("{} of one or two sides of pixels became a point where four grains meet",
                                             count(joined_junctions, "grain boundary", "grain boundaries")));
    }
    if (network.refined_chains > 0) {
        imported.notes.push_back(fmt::format("{} finer sides in places: near others, at small angles or beside short ones",
                                             count(network.refined_chains, "grain boundary has", "grain boundaries have")));
    }
    imported.notes.push_back(
        fmt::format("boundaries {}; sides of about {}, the shortest {}; the smallest angle is {:.1f}°",
                    options.jagged ? "along pixels" : "smoothed", format_quantity(element * pixel, Dimension::length, 3),
                    format_quantity(shortest_side(mesh) * pixel, Dimension::length, 3), smallest_angle(mesh)));

    for (const int label : pieces.label_of_piece) {
        const auto phase = options.phase_by_label.find(label);
        if (phase == options.phase_by_label.end() && !options.phase_by_label.empty()) {
            throw InputError(fmt::format("{}: the label {} has no phase; the key needs a row for each label", name, label));
        }
        imported.phase_of_grain.push_back(phase == options.phase_by_label.end() ? "" : phase->second);
    }
    imported.lines = outline(mesh, pieces.width, pieces.height);
    imported.triangles = std::move(mesh.triangles);
    imported.grain_of_triangle = std::move(mesh.region_of_triangle);
    imported.points = std::move(mesh.points);
    for (Point& p : imported.points) p = pixel * p;
    return imported;
}

}  // namespace graincrack::mesher
