#include "post/export/mesh_vtk.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include "post/cracks/vtk_arrays.hpp"
#include "share/base/error.hpp"

namespace graincrack {

std::string vtu_text(const SharedMesh& mesh) {
    vtkObject::GlobalWarningDisplayOff();
    vtkNew<vtkUnstructuredGrid> grid;
    vtkNew<vtkPoints> points;
    points->SetData(with_unit(vectors("position", mesh.points), "m"));
    grid->SetPoints(points);
    const std::size_t n = mesh.triangles.size();
    vtkNew<vtkCellArray> triangles;
    triangles->AllocateExact(static_cast<vtkIdType>(n), 3 * static_cast<vtkIdType>(n));
    for (const auto& corners : mesh.triangles) triangles->InsertNextCell({corners[0], corners[1], corners[2]});
    grid->SetCells(VTK_TRIANGLE, triangles);
    add_texts(grid, "phase_names", mesh.phase_names);
    const auto grain = [&](std::size_t triangle) { return static_cast<std::size_t>(mesh.triangle_grain[triangle]); };
    vtkCellData* cells = grid->GetCellData();
    cells->AddArray(scalars<vtkIntArray>("grain", mesh.triangle_grain));
    cells->AddArray(make_array<vtkUnsignedCharArray>("phase", 1, n,
                                                     [&](std::size_t i, unsigned char* v) { *v = mesh.grain_phase[grain(i)]; }));
    cells->AddArray(with_unit(
        make_array<vtkDoubleArray>("grain_area", 1, n, [&](std::size_t i, double* v) { *v = mesh.grain_area[grain(i)]; }), "m2"));
    vtkNew<vtkXMLUnstructuredGridWriter> writer;
    writer->SetInputData(grid);
    writer->WriteToOutputStringOn();
    writer->SetCompressorTypeToZLib();
    writer->SetDataModeToAppended();
    writer->EncodeAppendedDataOn();
    if (writer->Write() != 1 || writer->GetErrorCode() != 0) throw OutputError("the mesh could not be written as a VTK file");
    return writer->GetOutputString();
}

}  // namespace graincrack
