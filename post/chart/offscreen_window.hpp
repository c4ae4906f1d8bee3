// A VTK window without a display: EGL's surfaceless platform (Mesa). Included by picture.cpp only.
#pragma once

#include <vtkSmartPointer.h>

class vtkRenderWindow;

namespace graincrack {

/// A window that renders into memory; plain VTK 9.1 aborts where there is no display.
///
/// \throws OutputError if EGL offers no surfaceless OpenGL 3.2 context
vtkSmartPointer<vtkRenderWindow> make_offscreen_window(int width, int height);

}  // namespace graincrack
