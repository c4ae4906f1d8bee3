#include "post/cracks/crack_map.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkVersion.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <utility>

#include "post/cracks/run_state.hpp"
#include "post/table/output_file.hpp"
#include "share/error.hpp"

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

template <class Array, class T>
vtkSmartPointer<Array> scalars(const char* name, const std::vector<T>& values) {
    return make_array<Array>(name, 1, values.size(), [&](std::size_t i, auto* v) { *v = values[i]; });
}

template <class Writer, class Data>
void write_xml(const std::string& path, Data* data) {
    vtkObject::GlobalWarningDisplayOff();
    OutputFile file(path);
    vtkNew<Writer> writer;
    writer->SetInputData(data);
    writer->SetFileName(file.part().c_str());
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
    cells->AddArray(tensor);
    const auto principal = [&](const char* name, double sign) {
        cells->AddArray(make_array<vtkFloatArray>(name, 1, n, [&](std::size_t i, float* v) {
            const auto& [xx, yy, xy, zz] = stress[i];
            *v = static_cast<float>((xx + yy) / 2 + sign * std::hypot((xx - yy) / 2, xy));
        }));
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

/// Minerals on both sides and what is left of the contact at the time of the frame.
void add_contact_data(vtkCellData* cells, const std::vector<Crack>& cracks, const Specimen& specimen, const Frame& frame) {
    const std::vector<std::int32_t> grain = grain_of_nodes(specimen);
    const auto contact_of = [&](std::size_t i) { return static_cast<std::size_t>(cracks[i].contact); };
    const auto phase = [&](const char* name, std::size_t side) {
        cells->AddArray(make_array<vtkUnsignedCharArray>(name, 1, cracks.size(), [&](std::size_t i, unsigned char* v) {
            const auto node = static_cast<std::size_t>(specimen.contact_nodes[contact_of(i)][side]);
            *v = specimen.grain_phase[static_cast<std::size_t>(grain[node])];
        }));
    };
    phase("phase_a", 0);
    phase("phase_b", 2);
    cells->AddArray(make_array<vtkDoubleArray>(
        "damage", 1, cracks.size(), [&](std::size_t i, double* v) { *v = frame.damage[contact_of(i)][cracks[i].point]; }));
}

void add_crack_data(vtkCellData* cells, const std::vector<Crack>& cracks, double time) {
    const auto real = [&](const char* name, auto value) {
        cells->AddArray(
            make_array<vtkDoubleArray>(name, 1, cracks.size(), [&](std::size_t i, double* v) { *v = value(cracks[i]); }));
    };
    const auto byte = [&](const char* name, auto value) {
        cells->AddArray(make_array<vtkUnsignedCharArray>(
            name, 1, cracks.size(), [&](std::size_t i, unsigned char* v) { *v = static_cast<unsigned char>(value(cracks[i])); }));
    };
    byte("mode", [](const Crack& c) { return c.mode; });
    real("time", [](const Crack& c) { return c.time; });
    real("mode_angle", [](const Crack& c) { return c.mode_angle; });
    real("opening", [](const Crack& c) { return c.opening; });
    real("sliding", [](const Crack& c) { return c.sliding; });
    real("energy", [](const Crack& c) { return c.energy_released; });
    byte("separated", [time](const Crack& c) { return c.time_separated <= time; });  // false for NaN
    byte("point", [](const Crack& c) { return c.point; });
    byte("mode_by_displacement", [](const Crack& c) {
        return *mode_of(c, {CrackEvent::failed, CrackModeRule::displacement});
    });  // of `opening`, `sliding`
    byte("broken", [time](const Crack& c) { return c.time_broken <= time; });
    real("time_broken", [](const Crack& c) { return c.time_broken; });
    cells->AddArray(make_array<vtkIntArray>("contact", 1, cracks.size(), [&](std::size_t i, int* v) { *v = cracks[i].contact; }));
}

}  // namespace

void write_grains(const std::string& path, const Specimen& specimen, Frame frame, const Fragments& fragments) {
    vtkNew<vtkUnstructuredGrid> grid;
    grid->GetPointData()->AddArray(vectors("displacement", std::exchange(frame.displacement, {})));
    grid->GetPointData()->AddArray(vectors<vtkFloatArray>("velocity", std::exchange(frame.velocity, {})));
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
    cells->AddArray(scalars<vtkIntArray>("grain", specimen.element_grain));
    cells->AddArray(make_array<vtkUnsignedCharArray>("phase", 1, specimen.n_elements(), [&](std::size_t i, unsigned char* v) {
        *v = specimen.grain_phase[static_cast<std::size_t>(specimen.element_grain[i])];
    }));
    cells->AddArray(make_array<vtkIntArray>("fragment", 1, specimen.n_elements(), [&](std::size_t i, int* v) {
        *v = static_cast<int>(fragments.of_grain[static_cast<std::size_t>(specimen.element_grain[i])]);
    }));
    write_xml<vtkXMLUnstructuredGridWriter>(path, grid.Get());
}

void write_cracks(const std::string& path, const Specimen& specimen, const std::vector<Crack>& labelled_cracks,
                  const Frame& frame, const CrackLabel& label) {
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
    data->GetPointData()->AddArray(vectors("displacement", moves));
    add_crack_data(data->GetCellData(), present, frame.time);
    add_contact_data(data->GetCellData(), present, specimen, frame);
    vtkNew<vtkStringArray> definition;
    definition->SetName("crack_label");
    definition->InsertNextValue(definition_of(label));
    data->GetFieldData()->AddArray(definition);
    write_xml<vtkXMLPolyDataWriter>(path, data.Get());
}

std::string vtk_library_version() { return std::string("VTK ") + vtkVersion::GetVTKVersion(); }

}  // namespace graincrack
