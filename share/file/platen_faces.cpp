#include "share/file/platen_faces.hpp"

#include <cmath>
#include <span>

#include "share/file/file_checks.hpp"
#include "share/file/schema.hpp"
#include "share/file/specimen_measures.hpp"

namespace graincrack {
namespace {

struct Side {
    double side;
    const schema::Dataset& dataset;
};
constexpr std::array<Side, 2> platen_sides{{{-1, schema::platens_bottom}, {1, schema::platens_top}}};

/// Unit vector of a direction; components of round-off are 0.
std::array<double, 2> axis_of(double direction) {
    const auto rounded = [](double value) { return std::abs(value) < 1e-15 ? 0 : value; };
    return {rounded(std::cos(direction)), rounded(std::sin(direction))};
}

}  // namespace

std::array<double, 2> PlatenFaceSet::displacement(const PlatenFace& face, double approach) const {
    const std::array<double, 2> axis = axis_of(direction);
    return {-face.side * approach * axis[0], -face.side * approach * axis[1]};
}

std::array<std::array<double, 2>, 4> PlatenFaceSet::bar(const PlatenFace& face, double thickness, double approach) const {
    const std::array<double, 2> axis = axis_of(direction);
    // Across points right for an axis that points upwards, and upwards for an axis along x, as in the solver.
    const double right = axis[1] > 0 ? 1 : -1;
    const double inner = face.position - face.side * approach;
    const double outer = inner + face.side * thickness;
    const auto corner = [&](double across, double along) {
        return std::array{right * across * axis[1] + along * axis[0], -right * across * axis[0] + along * axis[1]};
    };
    return {corner(face.left, inner), corner(face.right, inner), corner(face.right, outer), corner(face.left, outer)};
}

void write_platen_faces(H5Output& file, const PlatenFaceSet& set) {
    file.create_group(schema::platens_group);
    file.quantity(schema::platens_group, "direction", set.direction, "rad");
    for (const auto& [side, dataset] : platen_sides) {
        std::vector<double> rows;
        for (const PlatenFace& face : set.faces) {
            if (face.side == side) rows.insert(rows.end(), {face.left, face.right, face.position});
        }
        file.write<double>(dataset.path, std::span<const double>(rows), {rows.size() / 3, 3}, dataset.unit, dataset.description);
    }
}

PlatenFaceSet read_platen_faces(const H5Input& file, const Specimen& specimen) {
    PlatenFaceSet set;
    if (!file.has(schema::platens_group)) {
        const double half = loaded_width(specimen) / 2;
        for (const double side : {-1.0, 1.0}) set.faces.push_back({side, -half, half, side * specimen.height / 2});
        return set;
    }
    set.direction = file.attribute<double>(schema::platens_group, "direction");
    if (!std::isfinite(set.direction)) {
        throw InputError(fmt::format("{}: attribute direction of {} is {}; a finite number is needed", file.name(),
                                     schema::platens_group, set.direction));
    }
    for (const auto& [side, dataset] : platen_sides) {
        const std::vector<double> rows = read_finite(file, dataset.path, {rows_of(file, dataset.path), 3});
        for (std::size_t i = 0; i < rows.size(); i += 3) set.faces.push_back({side, rows[i], rows[i + 1], rows[i + 2]});
    }
    return set;
}

}  // namespace graincrack
