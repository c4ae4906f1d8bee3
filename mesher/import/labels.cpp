#include "mesher/import/labels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "mesher/import/label_boundaries.hpp"
#include "mesher/import/label_network.hpp"
#include "mesher/import/label_pieces.hpp"
#include "mesher/plane/refined_triangulation.hpp"
#include "share/base/error.hpp"
#include "share/base/units.hpp"

namespace graincrack::mesher {

namespace {

constexpr double element_of_side = 3;  ///< elements per pixel side of boundaries that are too short for elements
constexpr double least_element = 2;    ///< default, pixels
constexpr double most_triangles = 20'000'000;
constexpr int soft_edge = 2;  ///< reach to a colour of the key, pixels

/// The requested side of triangles, pixels.
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

RefinedMesh triangles_of(const LabelNetwork& network, double element, const std::string& name) {
    Refinement refinement;
    refinement.side = element;
    try {
        return refined_triangles(network.points, network.segments, refinement);
    } catch (const UsageError& error) {
        throw InputError(fmt::format("{}: {}; a picture of fewer pixels or larger grains is needed", name, error.what()));
    }
}

int distance_squared(int colour, int other) {
    int sum = 0;
    for (const int shift : {0, 8, 16}) sum += static_cast<int>(std::pow((colour >> shift & 0xff) - (other >> shift & 0xff), 2));
    return sum;
}

/// Replaces colours that the key lacks, as at soft edges, by the nearest of its colours around them. \return number of pixels
int sharpen_edges(LabelImage& image, const PhaseKey::OfLabels& phases) {
    std::map<int, int> known;  // colours of labels
    for (const int label : std::set<int>(image.labels.begin(), image.labels.end())) {
        const int colour = image.colour_of(label).value_or(-1);
        if (phases.by_colour.count(colour) + phases.by_number.count(label) > 0) known[label] = colour;
    }
    int sharpened = 0;
    for (int pass = 0; pass < soft_edge && !phases.by_colour.empty(); ++pass) {
        const LabelImage before = image;
        for (int i = 0; i < image.width * image.height; ++i) {
            int& label = image.labels[static_cast<std::size_t>(i)];
            const std::optional<int> colour = image.colour_of(label);
            if (!colour || known.count(label) > 0) continue;
            std::map<int, int> around;  // number by distance
            for (int k = 0; k < 9; ++k) {
                const int column = std::clamp(i % image.width + k % 3 - 1, 0, image.width - 1);
                const auto other = known.find(before.at(column, std::clamp(i / image.width + k / 3 - 1, 0, image.height - 1)));
                if (other != known.end()) around.emplace(distance_squared(*colour, other->second), other->first);
            }
            if (around.empty()) continue;
            label = around.begin()->second;
            ++sharpened;
        }
    }
    return sharpened;
}

std::string count(int n, const std::string& one, const std::string& many) { return fmt::format("{} {}", n, n == 1 ? one : many); }

/// Notes on keys that have phases but are not in the picture.
std::vector<Remark> notes_on_key(const std::vector<LabelRow>& rows, const PhaseKey::OfLabels& phases) {
    std::set<int> labels;
    std::set<int> colours;
    for (const LabelRow& row : rows) {
        labels.insert(row.label);
        if (row.colour) colours.insert(*row.colour);
    }
    std::vector<Remark> notes;
    for (const auto& [label, phase] : phases.by_number) {
        if (labels.count(label) > 0) continue;
        notes.emplace_back(fmt::format("no grain has the label {} of the phase {}", label, phase), "unused_label");
    }
    for (const auto& [colour, phase] : phases.by_colour) {
        if (colours.count(colour) > 0) continue;
        notes.emplace_back(fmt::format("no grain has the colour {} of the phase {}", colour_text(colour), phase), "unused_label");
    }
    return notes;
}

/// Checks that each label has a phase if any has one.
void check_phases(const std::vector<LabelRow>& rows, const PhaseKey::OfLabels& phases, const std::string& name) {
    if (phases.by_number.empty() && phases.by_colour.empty()) return;
    for (const LabelRow& row : rows) {
        if (!row.phase.empty()) continue;
        throw InputError(fmt::format("{}: the label {}{} has no phase; the key needs a row with a phase for each label", name,
                                     row.label, row.colour ? fmt::format(" ({})", colour_text(*row.colour)) : ""));
    }
}

std::vector<Remark> notes_on_pieces(const LabelPieces& pieces, const LabelOptions& options) {
    std::vector<Remark> notes;
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
    return notes;
}

}  // namespace

std::vector<LabelRow> labels_of(std::string_view bytes, const LabelOptions& options, const std::string& name) {
    const LabelImage image = read_label_image(bytes, name);
    return label_rows(image, label_pieces(image, options.smallest_piece, name), options.phases, name);
}

ImportedMesh import_labels(std::string_view bytes, const LabelOptions& options, const std::string& name) {
    ImportedMesh imported;
    LabelPieces pieces;
    int sharpened = 0;
    {
        LabelImage image = read_label_image(bytes, name);
        sharpened = sharpen_edges(image, options.phases);
        imported.format = fmt::format("labels, {}, {} × {} pixels", image.format, image.width, image.height);
        pieces = label_pieces(image, options.smallest_piece, name);
        imported.labels = label_rows(image, pieces, options.phases, name);
    }
    check_phases(imported.labels, options.phases, name);
    const double pixel = options.pixel_size;
    const double element = element_in_pixels(pieces, options, name);
    imported.notes = notes_on_pieces(pieces, options);
    if (sharpened > 0) {
        imported.notes.push_back(fmt::format("{} up to {} from a colour of the key took the nearest of its colours beside them",
                                             count(sharpened, "pixel", "pixels"), soft_edge));
    }
    for (Remark& note : notes_on_key(imported.labels, options.phases)) imported.notes.push_back(std::move(note));

    LabelBoundaries boundaries = label_boundaries(pieces);
    const int joined_junctions = join_near_junctions(boundaries, static_cast<int>(std::min(element / element_of_side, 2.0)));
    const LabelNetwork network = label_network(boundaries, element);
    RefinedMesh mesh = triangles_of(network, element, name);
    if (boundaries.opened_corners > 0) {
        imported.notes.push_back(fmt::format("where a grain met itself in a point, the other two got a boundary: {}",
                                             count(boundaries.opened_corners, "corner of pixels", "corners of pixels")));
    }
    if (joined_junctions > 0) {
        imported.notes.push_back(fmt::format("{} of one or two sides of pixels became a point where four grains meet",
                                             count(joined_junctions, "grain boundary", "grain boundaries")));
    }
    imported.notes.push_back(
        fmt::format("boundaries smoothed; sides of about {}", format_quantity(element * pixel, Dimension::length, 3)));

    std::map<int, std::string> phase_of_label;
    for (const LabelRow& row : imported.labels) phase_of_label[row.label] = row.phase;
    for (const int label : pieces.label_of_piece) imported.phase_of_grain.push_back(phase_of_label.at(label));
    imported.triangles = std::move(mesh.triangles);
    imported.grain_of_triangle = std::move(mesh.region_of_triangle);
    imported.points = std::move(mesh.points);
    for (Point& p : imported.points) p = pixel * p;
    return imported;
}

}  // namespace graincrack::mesher
