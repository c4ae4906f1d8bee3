#include "post/cracks/paraview_state.hpp"

#include <fmt/format.h>

namespace graincrack {

namespace {

constexpr const char* head = R"py("""Opens the grains and cracks of this folder, coloured and in time.

paraview --script=open_in_paraview.py           in ParaView
pvbatch open_in_paraview.py PICTURE.png         a picture of the last frame, without a display
"""
import os
import sys

from paraview import simple

FOLDER = os.path.dirname(os.path.abspath(__file__))
# Displacements are drawn this many times as large.
MAGNIFY = 1
# Ends of the colours of stress, Pa: the tensile strength of the contacts.
)py";

constexpr const char* scene = R"py(
GRAIN_ARRAY = "principal_stress_1"  # the largest in the plane, tension positive; or principal_stress_2, fragment, grain, phase
CRACK_ARRAY = "mode"  # or broken, separated, time_of_failure, opening, sliding, damage, class, strength_factor


def series(name):
    """A series of this folder, displaced."""
    reader = simple.PVDReader(registrationName=name, FileName=os.path.join(FOLDER, name + ".pvd"))
    return simple.WarpByVector(registrationName=name + " displaced", Input=reader, Vectors=["POINTS", "displacement"],
                               ScaleFactor=MAGNIFY)


def show_grains(grains, view):
    display = simple.Show(grains, view)
    display.Representation = "Surface"
    simple.ColorBy(display, ("CELLS", GRAIN_ARRAY))
    colours = simple.GetColorTransferFunction(GRAIN_ARRAY)
    if "stress" in GRAIN_ARRAY:
        colours.ApplyPreset("Cool to Warm", True)
        colours.AutomaticRescaleRangeMode = "Never"
        colours.RescaleTransferFunction(-STRESS, STRESS)
        # Platens have no stress.
        colours.NanColor = [0.75, 0.75, 0.75]
    display.SetScalarBarVisibility(view, True)


def show_cracks(cracks, view):
    display = simple.Show(cracks, view)
    display.Representation = "Surface"
    display.LineWidth = 2.5
    simple.ColorBy(display, ("CELLS", CRACK_ARRAY))
    if CRACK_ARRAY == "mode":
        colours = simple.GetColorTransferFunction(CRACK_ARRAY)
        colours.InterpretValuesAsCategories = 1
        colours.Annotations = ["0", "tensile", "1", "shear"]
        colours.IndexedColors = [0.84, 0.10, 0.11, 0.0, 0.0, 0.0]
    display.SetScalarBarVisibility(view, True)


view = simple.GetActiveViewOrCreate("RenderView")
view.InteractionMode = "2D"
grains, cracks = series("grains"), series("cracks")
# Colours are chosen at the last frame: the first has no cracks.
animation = simple.GetAnimationScene()
animation.UpdateAnimationUsingDataTimeSteps()
animation.GoToLast()
show_grains(grains, view)
show_cracks(cracks, view)
simple.Show(simple.AnnotateTime(registrationName="time"), view)
simple.ResetCamera(view)
simple.Render(view)
if sys.argv[-1].endswith(".png"):
    simple.SaveScreenshot(sys.argv[-1], view, ImageResolution=[1200, 1600])
)py";

}  // namespace

std::string paraview_state(double stress) { return fmt::format("{}STRESS = {:g}{}", head, stress, scene); }

}  // namespace graincrack
