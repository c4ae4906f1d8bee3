#include "post/chart/picture.hpp"

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkImageData.h>
#include <vtkImageShrink3D.h>
#include <vtkNew.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVersion.h>
#include <vtkWindowToImageFilter.h>
#include <vtk_glew.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <span>

#include "post/chart/offscreen_window.hpp"
#include "post/table/output_file.hpp"
#include "share/error.hpp"

namespace graincrack {

namespace {

/// Pixels rendered for each pixel of the picture, along each side: edges are smooth whether or not the driver multisamples.
constexpr int oversampling = 3;

std::string ending(const std::string& path) { return std::filesystem::path(path).extension().string(); }

/// A sans-serif font with Greek letters where one is installed; VTK's own otherwise.
void set_font(vtkTextProperty* style, bool bold) {
    static const std::array<std::filesystem::path, 2> folders{"/usr/share/fonts/truetype/liberation",
                                                              "/usr/share/fonts/truetype/dejavu"};
    static const std::array<std::array<const char*, 2>, 2> names{
        {{"LiberationSans-Regular.ttf", "LiberationSans-Bold.ttf"}, {"DejaVuSans.ttf", "DejaVuSans-Bold.ttf"}}};
    for (std::size_t i = 0; i < folders.size(); ++i) {
        const std::filesystem::path file = folders[i] / names[i][bold ? 1 : 0];
        std::error_code ignored;
        if (std::filesystem::exists(file, ignored)) {
            style->SetFontFamily(VTK_FONT_FILE);
            style->SetFontFile(file.c_str());
            return;
        }
    }
    style->SetFontFamilyToArial();
    style->SetBold(bold ? 1 : 0);
}

/// Turns shapes into coloured triangles of a 2D overlay, in order, and text into actors above them.
class OverlayBuilder {
public:
    OverlayBuilder(vtkRenderer* renderer, int height) : renderer_(renderer), height_(height) {
        colours_->SetNumberOfComponents(3);
    }

    void operator()(const Polygons& polygons) {
        for (std::size_t i = 0; i < polygons.size(); ++i) add_polygon(polygons[i], polygons.fill);
    }
    void operator()(const Strokes& strokes) {
        for (std::size_t i = 0; i < strokes.ends.size(); i += 2) {
            add_line(std::span(strokes.ends).subspan(i, 2), strokes.width, strokes.colour);
        }
    }
    void operator()(const Polyline& line) { add_line(line.points, line.width, line.colour); }
    void operator()(const Text& text) {
        vtkNew<vtkTextActor> actor;
        actor->SetInput(text.label.c_str());
        vtkTextProperty* style = actor->GetTextProperty();
        set_font(style, text.bold);
        // VTK measures fonts in points of 1/72 inch at the window's dots per inch, which is set to 72.
        style->SetFontSize(static_cast<int>(std::lround(text.size * oversampling)));
        style->SetColor(text.colour.red / 255.0, text.colour.green / 255.0, text.colour.blue / 255.0);
        style->SetJustification(text.anchor == Anchor::start ? VTK_TEXT_LEFT
                                : text.anchor == Anchor::end ? VTK_TEXT_RIGHT
                                                             : VTK_TEXT_CENTERED);
        style->SetVerticalJustificationToBottom();
        style->UseTightBoundingBoxOff();
        if (text.upwards) style->SetOrientation(90);
        // VTK's bottom is that of the descenders, not the baseline.
        const double descent = 0.22 * text.size;
        const Pixel at = text.upwards ? Pixel{text.at.x + descent, text.at.y} : Pixel{text.at.x, text.at.y + descent};
        actor->SetPosition(at.x * oversampling, (height_ - at.y) * oversampling);
        texts_.push_back(actor.Get());
    }
    /// Hands the collected triangles to the renderer, and above them the text.
    void finish() {
        vtkNew<vtkPolyData> mesh;
        mesh->SetPoints(points_);
        mesh->SetPolys(triangles_);
        mesh->GetCellData()->SetScalars(colours_);
        vtkNew<vtkPolyDataMapper2D> mapper;
        mapper->SetInputData(mesh);
        mapper->SetScalarModeToUseCellData();
        mapper->ScalarVisibilityOn();
        vtkNew<vtkActor2D> actor;
        actor->SetMapper(mapper);
        renderer_->AddActor2D(actor);
        for (const auto& text : texts_) renderer_->AddActor2D(text);
    }

private:
    void add_polygon(std::span<const Pixel> corners, Colour fill) {
        const vtkIdType first = points_->GetNumberOfPoints();
        for (const Pixel& p : corners) add_point(p);
        for (vtkIdType i = 2; i < static_cast<vtkIdType>(corners.size()); ++i)
            add_triangle(first, first + i - 1, first + i, fill);
    }
    /// Bars with discs at ends and corners where these are wide enough to be seen.
    void add_line(std::span<const Pixel> points, double width, Colour colour) {
        for (std::size_t i = 1; i < points.size(); ++i) add_bar(points[i - 1], points[i], width, colour);
        if (width < 1.5) return;
        for (const Pixel& p : points) add_disc(p, width / 2, colour);
    }
    void add_point(Pixel p) { points_->InsertNextPoint(p.x * oversampling, (height_ - p.y) * oversampling, 0); }
    void add_triangle(vtkIdType a, vtkIdType b, vtkIdType c, Colour colour) {
        triangles_->InsertNextCell({a, b, c});
        colours_->InsertNextTuple3(colour.red, colour.green, colour.blue);
    }
    void add_bar(Pixel a, Pixel b, double width, Colour colour) {
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        if (length == 0) return;
        const double dx = -(b.y - a.y) / length * width / 2;
        const double dy = (b.x - a.x) / length * width / 2;
        const std::array<Pixel, 4> bar{{{a.x + dx, a.y + dy}, {b.x + dx, b.y + dy}, {b.x - dx, b.y - dy}, {a.x - dx, a.y - dy}}};
        add_polygon(bar, colour);
    }
    void add_disc(Pixel centre, double radius, Colour colour) {
        constexpr std::size_t corners = 12;
        std::array<Pixel, corners> rim;
        for (std::size_t i = 0; i < corners; ++i) {
            const double angle = 2 * std::numbers::pi * static_cast<double>(i) / corners;
            rim[i] = {centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)};
        }
        add_polygon(rim, colour);
    }

    vtkRenderer* renderer_;
    double height_;
    vtkNew<vtkPoints> points_;
    vtkNew<vtkCellArray> triangles_;
    vtkNew<vtkUnsignedCharArray> colours_;
    std::vector<vtkSmartPointer<vtkTextActor>> texts_;
};

}  // namespace

std::vector<unsigned char> png_bytes(const Drawing& drawing) {
    // GLEW complains about the missing display although the context is complete; failures are checked for here.
    vtkObject::GlobalWarningDisplayOff();
    const vtkSmartPointer<vtkRenderWindow> window =
        make_offscreen_window(drawing.width() * oversampling, drawing.height() * oversampling);
    window->SetMultiSamples(0);
    window->SetDPI(72);
    vtkNew<vtkRenderer> renderer;
    renderer->SetBackground(1, 1, 1);
    window->AddRenderer(renderer);
    OverlayBuilder overlay(renderer, drawing.height());
    for (const Drawing::Shape& shape : drawing.shapes()) std::visit(overlay, shape);
    overlay.finish();
    // All shapes have the same depth: later ones cover earlier ones.
    vtkOpenGLRenderWindow::SafeDownCast(window)->GetState()->vtkglDepthFunc(GL_ALWAYS);
    window->Render();

    vtkNew<vtkWindowToImageFilter> grabber;
    grabber->SetInput(window);
    grabber->ReadFrontBufferOff();
    grabber->ShouldRerenderOff();
    vtkNew<vtkImageShrink3D> shrink;
    shrink->SetInputConnection(grabber->GetOutputPort());
    shrink->SetShrinkFactors(oversampling, oversampling, 1);
    shrink->MeanOn();
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputConnection(shrink->GetOutputPort());
    writer->WriteToMemoryOn();
    writer->Write();
    vtkUnsignedCharArray* bytes = writer->GetResult();
    if (writer->GetErrorCode() != 0 || bytes == nullptr) throw OutputError("picture: could not be made");
    return {bytes->GetPointer(0), bytes->GetPointer(0) + bytes->GetNumberOfValues()};
}

void require_picture_name(const std::string& path) {
    const std::string kind = ending(path);
    if (kind != ".png" && kind != ".svg") throw UsageError("--output " + path + ": a picture's name must end in .png or .svg");
}

void write_picture(const Drawing& drawing, const std::string& path) {
    require_picture_name(path);
    if (ending(path) == ".svg") {
        write_whole_file(path, to_svg(drawing));
    } else {
        const std::vector<unsigned char> bytes = png_bytes(drawing);
        write_whole_file(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    }
}

std::string vtk_library_version() { return std::string("VTK ") + vtkVersion::GetVTKVersion(); }

}  // namespace graincrack
