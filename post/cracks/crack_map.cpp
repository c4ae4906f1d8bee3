#include "post/cracks/crack_map.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkInformation.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkVersion.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "post/run/crystals.hpp"
#include "post/run/run_state.hpp"
#include "share/base/error.hpp"
#include "share/file/output_file.hpp"

namespace graincrack {

namespace {

/// A named array of n tuples, filled tuple by tuple through `fill(i, values)`.
template <class Array, class Fill>
vtkSmartPointer<Array> make_array(const char* name, int components, std::size_t n, const Fill& fill) {
    auto array = vtkSmartPointer<Array>::New();
    array->SetName(name);
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(static_cast<vtkIdType>(n));
    for (std::size_t i = 0; i < n; ++i) fill(i, array->GetPointer(static_cast<vtkIdType>(i) * components));
    return array;
}

/// The array with its unit, as ParaView shows it.
template <class Array>
vtkSmartPointer<Array> with_unit(vtkSmartPointer<Array> array, const char* unit) {
    array->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), unit);
    return array;
}

/// A 3-vector for every node from a plane one.
template <class Array = vtkDoubleArray>
vtkSmartPointer<Array> vectors(const char* name, const std::vector<std::array<double, 2>>& plane) {
    return make_array<Array>(name, 3, plane.size(), [&](std::size_t i, auto* v) {
        using Value = std::remove_pointer_t<decltype(v)>;
        v[0] = static_cast<Value>(plane[i][0]);
        v[1] = static_cast<Value>(plane[i][1]);
        v[2] = 0;
    });
}

/// A named array of n numbers. \param value of each
template <class Array, class Value>
vtkSmartPointer<Array> scalars(const char* name, std::size_t n, const Value& value) {
    return make_array<Array>(name, 1, n, [&](std::size_t i, auto* v) { *v = static_cast<typename Array::ValueType>(value(i)); });
}

/// Texts as field data.
void add_texts(vtkDataObject* data, const char* name, const std::vector<std::string>& texts) {
    vtkNew<vtkStringArray> array;
    array->SetName(name);
    for (const std::string& text : texts) array->InsertNextValue(text);
    data->GetFieldData()->AddArray(array);
}

/// A number with its unit as field data.
void add_field(vtkDataObject* data, const char* name, double value, const char* unit) {
    data->GetFieldData()->AddArray(with_unit(scalars<vtkDoubleArray>(name, 1, [&](std::size_t) { return value; }), unit));
}

void add_moment(vtkDataObject* data, const FrameMoment& moment) {
    add_field(data, "time", moment.time, "s");
    add_field(data, "axial_strain", moment.axial_strain, "1");
    add_field(data, "axial_stress", moment.axial_stress, "Pa");
}

template <class Writer, class Data>
void write_xml(const std::string& path, Data* data) {
    vtkObject::GlobalWarningDisplayOff();
    OutputFile file(path);
    vtkNew<Writer> writer;
    writer->SetInputData(data);
    writer->SetFileName(file.begin().c_str());
    writer->SetCompressorTypeToLZ4();
    writer->SetDataModeToAppended();
    writer->EncodeAppendedDataOff();
    if (writer->Write() != 1 || writer->GetErrorCode() != 0) throw OutputError(path + ": could not be written whole");
    file.commit();
}

void add_stress(vtkCellData* cells, const std::vector<std::array<double, 4>>& stress) {
    const std::size_t n = stress.size();
    const auto tensor = make_array<vtkFloatArray>("stress", 6, n, [&](std::size_t i, float* v) {
        const auto& [xx, yy, xy, zz] = stress[i];
        const std::array<double, 6> all{xx, yy, zz, xy, 0, 0};
        std::transform(all.begin(), all.end(), v, [](double value) { return static_cast<float>(value); });
    });
    constexpr std::array<const char*, 6> names{"XX", "YY", "ZZ", "XY", "YZ", "XZ"};
    for (std::size_t k = 0; k < names.size(); ++k) tensor->SetComponentName(static_cast<vtkIdType>(k), names[k]);
    cells->AddArray(with_unit(tensor, "Pa"));
    const auto principal = [&](const char* name, double sign) {
        const auto value = [&](std::size_t i) {
            const auto& [xx, yy, xy, zz] = stress[i];
            return (xx + yy) / 2 + sign * std::hypot((xx - yy) / 2, xy);
        };
        cells->AddArray(with_unit(scalars<vtkFloatArray>(name, n, value), "Pa"));
    };
    principal("principal_stress_1", 1);
    principal("principal_stress_2", -1);
}

/// Middle of the half facet of a crack's contact point, mean of both sides, in reference position and displaced.
std::array<double, 2> current_middle(const Specimen& specimen, const Frame& frame, const Crack& crack) {
    const auto& nodes = specimen.contact_nodes[static_cast<std::size_t>(crack.contact)];
    std::array<double, 2> middle{};
    for (std::size_t k = 0; k < 4; ++k) {
        const bool near = (k % 2) == crack.point;  // a1, b1 belong to point 0; a2, b2 to point 1
        const auto node = static_cast<std::size_t>(nodes[k]);
        for (std::size_t axis = 0; axis < 2; ++axis) {
            middle[axis] += (near ? 0.375 : 0.125) * (specimen.node_position[node][axis] + frame.displacement[node][axis]);
        }
    }
    return middle;
}

/// Adds arrays with an entry for each of some cracks.
class CrackArrays {
public:
    CrackArrays(vtkCellData* cells, const std::vector<Crack>& cracks) : cells_(cells), cracks_(cracks) {}
    template <class Value>
    void real(const char* name, const char* unit, const Value& value) {
        cells_->AddArray(with_unit(array<vtkDoubleArray>(name, value), unit));
    }
    template <class Value>
    void byte(const char* name, const Value& value) {
        cells_->AddArray(array<vtkUnsignedCharArray>(name, value));
    }
    template <class Value>
    void whole(const char* name, const Value& value) {
        cells_->AddArray(array<vtkIntArray>(name, value));
    }

private:
    template <class Array, class Value>
    [[nodiscard]] vtkSmartPointer<Array> array(const char* name, const Value& value) const {
        return scalars<Array>(name, cracks_.size(), [&](std::size_t i) { return value(cracks_[i]); });
    }
    vtkCellData* cells_;
    const std::vector<Crack>& cracks_;
};

/// The energy that a point that has failed would give back, J: open ½ σ·δ, since it unloads towards the origin; closed the
/// compression of its normal spring and the elastic part of its sliding.
double stored_energy(const Frame& frame, const Crack& crack, const ContactParameters& contact) {
    const auto c = static_cast<std::size_t>(crack.contact);
    const double opening = frame.opening[c][crack.point];
    const double sliding = frame.sliding[c][crack.point];
    const double normal = frame.traction[c][2 * crack.point];
    const double shear = frame.traction[c][2 * crack.point + 1];
    const double per_area = opening >= 0
                                ? 0.5 * (normal * opening + shear * sliding)
                                : 0.5 * (normal * normal / contact.normal_stiffness + shear * shear / contact.shear_stiffness);
    return per_area * crack.length;
}

std::size_t index(const Crack& crack) { return static_cast<std::size_t>(crack.contact); }

/// Adds the data that change from frame to frame. \param classes of all contacts \param contacts their parameters by class
void add_present_data(CrackArrays& arrays, const Frame& frame, const std::vector<std::uint8_t>& classes,
                      const std::vector<ContactParameters>& contacts) {
    arrays.real("opening", "m", [&](const Crack& c) { return frame.opening[index(c)][c.point]; });
    arrays.real("sliding", "m", [&](const Crack& c) { return frame.sliding[index(c)][c.point]; });
    arrays.real("normal_traction", "Pa", [&](const Crack& c) { return frame.traction[index(c)][2 * c.point]; });
    arrays.real("shear_traction", "Pa", [&](const Crack& c) { return frame.traction[index(c)][2 * c.point + 1]; });
    arrays.real("stored_energy", "J", [&](const Crack& c) { return stored_energy(frame, c, contacts.at(classes[index(c)])); });
    arrays.real("damage", "1", [&](const Crack& c) { return frame.damage[index(c)][c.point]; });
    arrays.byte("separated", [&](const Crack& c) { return c.separated.time <= frame.time; });  // false for NaN
    arrays.byte("broken", [&](const Crack& c) { return c.broken.time <= frame.time; });
}

/// Adds the data that are the same in all frames.
void add_failure_data(CrackArrays& arrays) {
    arrays.real("time_of_failure", "s", [](const Crack& c) { return c.time; });
    arrays.real("opening_at_failure", "m", [](const Crack& c) { return c.opening; });
    arrays.real("sliding_at_failure", "m", [](const Crack& c) { return c.sliding; });
    arrays.byte("mode", [](const Crack& c) { return c.mode; });
    arrays.real("mode_angle", "rad", [](const Crack& c) { return c.mode_angle; });
    arrays.byte("mode_by_sign", [](const Crack& c) { return c.opening >= 0 ? CrackMode::tensile : CrackMode::shear; });
    arrays.real("fracture_energy_at_end", "J", [](const Crack& c) { return c.energy_released; });
    arrays.real("time_broken", "s", [](const Crack& c) { return c.broken.time; });
    arrays.byte("point", [](const Crack& c) { return c.point; });
}

/// Minerals on both sides, their class and, where the contacts have one, their strength factor.
void add_phases(CrackArrays& arrays, const std::vector<std::uint8_t>& classes, const Specimen& specimen) {
    const auto grains = grains_of_contacts(specimen);
    arrays.byte("phase_a", [&](const Crack& c) { return specimen.grain_phase[grains[index(c)][0]]; });
    arrays.byte("phase_b", [&](const Crack& c) { return specimen.grain_phase[grains[index(c)][1]]; });
    arrays.byte("class", [&](const Crack& c) { return classes[index(c)]; });
    if (specimen.contact_strength_factor.empty()) return;
    arrays.real("strength_factor", "1", [&](const Crack& c) { return specimen.contact_strength_factor[index(c)]; });
}

}  // namespace

void write_grains(const std::string& path, const Specimen& specimen, Frame frame, const Fragments& fragments,
                  const FrameMoment& moment) {
    vtkNew<vtkUnstructuredGrid> grid;
    add_moment(grid, moment);
    grid->GetPointData()->AddArray(with_unit(vectors("displacement", std::exchange(frame.displacement, {})), "m"));
    grid->GetPointData()->AddArray(with_unit(vectors<vtkFloatArray>("velocity", std::exchange(frame.velocity, {})), "m/s"));
    vtkCellData* cells = grid->GetCellData();
    add_stress(cells, std::exchange(frame.element_stress, {}));
    frame = {};
    vtkNew<vtkPoints> points;
    points->SetData(vectors("position", specimen.node_position));
    grid->SetPoints(points);
    vtkNew<vtkCellArray> triangles;
    triangles->AllocateExact(static_cast<vtkIdType>(specimen.n_elements()), 3 * static_cast<vtkIdType>(specimen.n_elements()));
    for (const auto& nodes : specimen.element_nodes) triangles->InsertNextCell({nodes[0], nodes[1], nodes[2]});
    grid->SetCells(VTK_TRIANGLE, triangles);
    add_texts(grid, "phase_names", specimen.phase_names);
    const std::size_t n = specimen.n_elements();
    const auto grain = [&](std::size_t i) { return static_cast<std::size_t>(specimen.element_grain[i]); };
    cells->AddArray(scalars<vtkIntArray>("grain", n, grain));
    if (!specimen.grain_crystal.empty()) {
        cells->AddArray(scalars<vtkIntArray>("crystal", n, [&](std::size_t i) { return specimen.grain_crystal[grain(i)]; }));
    }
    cells->AddArray(scalars<vtkUnsignedCharArray>("phase", n, [&](std::size_t i) { return specimen.grain_phase[grain(i)]; }));
    cells->AddArray(scalars<vtkIntArray>("fragment", n, [&](std::size_t i) { return fragments.of_grain[grain(i)]; }));
    write_xml<vtkXMLUnstructuredGridWriter>(path, grid.Get());
}

void write_cracks(const std::string& path, const Specimen& specimen, const std::vector<Crack>& labelled_cracks,
                  const Frame& frame, const CrackLabel& label, const std::vector<ContactParameters>& contacts,
                  const FrameMoment& moment) {
    const std::vector<Crack> present = cracks_until(labelled_cracks, frame.time);
    std::vector<std::array<double, 2>> ends;
    std::vector<std::array<double, 2>> moves;
    vtkNew<vtkCellArray> lines;
    for (const Crack& crack : present) {
        const double dx = crack.length / 2 * std::cos(crack.orientation);
        const double dy = crack.length / 2 * std::sin(crack.orientation);
        const auto [x, y] = crack.position;
        const auto [now_x, now_y] = current_middle(specimen, frame, crack);
        const auto first = static_cast<vtkIdType>(ends.size());
        ends.push_back({x - dx, y - dy});
        ends.push_back({x + dx, y + dy});
        moves.insert(moves.end(), 2, {now_x - x, now_y - y});
        lines->InsertNextCell({first, first + 1});
    }
    vtkNew<vtkPolyData> data;
    vtkNew<vtkPoints> points;
    points->SetData(vectors("position", ends));
    data->SetPoints(points);
    data->SetLines(lines);
    data->GetPointData()->AddArray(with_unit(vectors("displacement", moves), "m"));
    CrackArrays arrays(data->GetCellData(), present);
    const std::vector<std::uint8_t> classes = contact_classes(specimen);
    add_present_data(arrays, frame, classes, contacts);
    add_failure_data(arrays);
    arrays.whole("contact", [](const Crack& c) { return c.contact; });
    add_phases(arrays, classes, specimen);
    add_texts(data, "phase_names", specimen.phase_names);
    add_texts(data, "class_names", contact_class_names(specimen));
    add_texts(data, "crack_label", {definition_of(label)});
    add_texts(data, "mode_names", {"tensile", "shear"});
    add_moment(data, moment);
    write_xml<vtkXMLPolyDataWriter>(path, data.Get());
}

void write_platens(const std::string& path, const PlatenFaceSet& platens, double height, const FrameMoment& moment) {
    constexpr double thickness = 0.05;  // of the height
    std::vector<std::array<double, 2>> corners;
    std::vector<std::array<double, 2>> moves;
    vtkNew<vtkCellArray> rectangles;
    for (const PlatenFace& face : platens.faces) {
        const auto first = static_cast<vtkIdType>(corners.size());
        const auto bar = platens.bar(face, thickness * height, 0);
        corners.insert(corners.end(), bar.begin(), bar.end());
        moves.insert(moves.end(), bar.size(), platens.displacement(face, -height / 2 * moment.axial_strain));
        rectangles->InsertNextCell({first, first + 1, first + 2, first + 3});
    }
    vtkNew<vtkPolyData> data;
    vtkNew<vtkPoints> points;
    points->SetData(vectors("position", corners));
    data->SetPoints(points);
    data->SetPolys(rectangles);
    data->GetPointData()->AddArray(with_unit(vectors("displacement", moves), "m"));
    data->GetCellData()->AddArray(scalars<vtkUnsignedCharArray>(
        "platen", platens.faces.size(), [&](std::size_t i) { return platens.faces[i].side > 0 ? 1 : 0; }));
    add_moment(data, moment);
    write_xml<vtkXMLPolyDataWriter>(path, data.Get());
}

std::string vtk_library_version() { return std::string("VTK ") + vtkVersion::GetVTKVersion(); }

}  // namespace graincrack
