#include "post/export/mesh_vtk.hpp"

#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include "tests/support/specimens.hpp"

namespace graincrack {
namespace {

TEST(MeshVtk, TrianglesReadBackWithGrainsAndPhases) {
    Specimen s = test::crossed_blocks(4, 4, 0.1, 0.1, [](int i, int j) { return j / 2 * 2 + i / 2; });
    s.phase_names = {"quartz", "mica"};
    s.grain_phase = {0, 1, 1, 0};
    const SharedMesh mesh = share_nodes(s);
    const std::string text = vtu_text(mesh);
    EXPECT_EQ(text, vtu_text(mesh));
    vtkNew<vtkXMLUnstructuredGridReader> reader;
    reader->ReadFromInputStringOn();
    reader->SetInputString(text);
    reader->Update();
    vtkUnstructuredGrid* grid = reader->GetOutput();
    ASSERT_EQ(grid->GetNumberOfPoints(), static_cast<vtkIdType>(mesh.points.size()));
    ASSERT_EQ(grid->GetNumberOfCells(), static_cast<vtkIdType>(mesh.triangles.size()));
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        const double* point = grid->GetPoint(static_cast<vtkIdType>(i));
        EXPECT_EQ(point[0], mesh.points[i][0]);
        EXPECT_EQ(point[1], mesh.points[i][1]);
        EXPECT_EQ(point[2], 0);
    }
    const auto data = [&](const char* name, vtkIdType cell) {
        return grid->GetCellData()->GetArray(name)->GetComponent(cell, 0);
    };
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto cell = static_cast<vtkIdType>(t);
        vtkNew<vtkIdList> corners;
        grid->GetCellPoints(cell, corners);
        ASSERT_EQ(corners->GetNumberOfIds(), 3);
        for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(corners->GetId(static_cast<vtkIdType>(k)), mesh.triangles[t][k]);
        const auto grain = static_cast<std::size_t>(s.element_grain[t]);
        EXPECT_EQ(data("grain", cell), s.element_grain[t]);
        EXPECT_EQ(data("phase", cell), s.grain_phase[grain]);
        EXPECT_EQ(data("grain_area", cell), s.grain_area[grain]);
    }
    auto* names = vtkStringArray::SafeDownCast(grid->GetFieldData()->GetAbstractArray("phase_names"));
    ASSERT_NE(names, nullptr);
    ASSERT_EQ(names->GetNumberOfValues(), 2);
    EXPECT_EQ(names->GetValue(1), "mica");
}

}  // namespace
}  // namespace graincrack
