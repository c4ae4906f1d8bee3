"""Runs the state that `graincrack-post cracks --paraview` writes, on a stand-in for ParaView that knows what its files hold.

Usage: paraview_state_test.py BIN. Where pvbatch is installed, it makes a picture by the same state too. The stand-in has the functions and
properties of paraview.simple that the state may use, reads names of blocks, times and arrays from the .pvd, .vtu and .vtp files, and refuses
whatever they do not hold.
"""

import re
import runpy
import shutil
import subprocess
import sys
import tempfile
import types
import unittest
import xml.etree.ElementTree as xml
from pathlib import Path

BIN = Path(sys.argv[1]).resolve()
STATE = "open_in_paraview.py"


def tool(line, folder):
    subprocess.run(f"{BIN}/graincrack-{line} --quiet", shell=True, check=True, cwd=folder, capture_output=True)


def arrays(path):
    """Names of the arrays of a VTK file, as ("CELLS", "mode"); its head is XML, its data follow."""
    head = path.read_bytes().partition(b"<AppendedData")[0].decode()
    found = set()
    for kind, name in (("POINTS", "PointData"), ("CELLS", "CellData")):
        for part in re.findall(rf"<{name}\b.*?</{name}>", head, re.S):
            found |= {(kind, array) for array in re.findall(r'<DataArray [^>]*Name="([^"]+)"', part)}
    return found


class Series:
    """What a .pvd file names: arrays by block and time."""

    def __init__(self, path):
        path = Path(path)
        sets = xml.parse(path).getroot().iter("DataSet")
        self.blocks = {}
        for each in sets:
            file = path.parent / each.get("file")
            self.blocks.setdefault(each.get("name"), {})[float(each.get("timestep"))] = arrays(file)

    def times(self):
        return sorted({time for files in self.blocks.values() for time in files})


class Properties:
    """An object of ParaView: refuses properties that it would not have."""

    allowed = ()

    def __setattr__(self, name, value):
        if name not in self.allowed and not name.startswith("_"):
            raise AttributeError(f"{type(self).__name__} has no property {name}")
        object.__setattr__(self, name, value)


class View(Properties):
    allowed = ("InteractionMode", "ViewSize")


class Display(Properties):
    allowed = ("Representation", "LineWidth")

    def __init__(self, source):
        self._source, self._bar = source, False

    def SetScalarBarVisibility(self, view, visible):
        self._bar = visible


class Colours(Properties):
    allowed = ("NanColor", "InterpretValuesAsCategories", "Annotations", "IndexedColors", "AutomaticRescaleRangeMode")

    def ApplyPreset(self, name, rescale):
        assert name == "Cool to Warm"

    def RescaleTransferFunction(self, low, high):
        self._range = (low, high)


class StandIn(types.ModuleType):
    """paraview.simple, as far as the state may use it."""

    def __init__(self):
        super().__init__("simple")
        self.shown, self.coloured, self.colours, self.opened, self.pictures = [], {}, {}, {}, []
        self.time, self.view = None, View()

    def PVDReader(self, registrationName, FileName):
        self.opened[Path(FileName).name] = Series(FileName)
        return self.opened[Path(FileName).name]

    def WarpByVector(self, registrationName, Input, Vectors, ScaleFactor):
        for block, files in Input.blocks.items():
            for time, held in files.items():
                assert tuple(Vectors) in held, f"{block} at {time}: no {Vectors}"
        return Input

    def AnnotateTime(self, registrationName):
        return "time"

    def GetActiveViewOrCreate(self, kind):
        assert kind == "RenderView"
        return self.view

    def Show(self, source, view):
        self.shown.append(Display(source))
        return self.shown[-1]

    def ColorBy(self, display, array):
        main = next(iter(display._source.blocks.values()))
        for time, held in main.items():
            assert array in held, f"no {array} at {time}; there are {sorted(held)}"
        self.coloured[array[1]] = display

    def GetColorTransferFunction(self, array):
        assert array in self.coloured, f"{array} colours nothing"
        return self.colours.setdefault(array, Colours())

    def GetAnimationScene(self):
        return self

    def UpdateAnimationUsingDataTimeSteps(self):
        self.times = self.opened["grains.pvd"].times()
        assert self.times == self.opened["cracks.pvd"].times()

    def GoToLast(self):
        self.time = self.times[-1]

    def ResetCamera(self, view):
        assert view is self.view

    Render = ResetCamera

    def SaveScreenshot(self, path, view, ImageResolution):
        self.pictures.append(path)


class OpensInParaView(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp())
        tool("mesh rectangle --width 20mm --height 40mm --edge 4mm -o specimen.h5", cls.folder)
        solve = "specimen.h5 --material augig-granite --rate 200mm/s --frames 4"
        tool(f"solve uniaxial {solve} --max-strain 0.012 -o uniaxial.h5", cls.folder)
        tool(f"solve tension {solve} --max-strain 0.001 -o tension.h5", cls.folder)
        for test in ("uniaxial", "tension"):
            tool(f"post cracks {test}.h5 -o {test} --paraview", cls.folder)

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder)

    def run_state(self, test, arguments=()):
        simple = StandIn()
        package = types.ModuleType("paraview")
        package.simple = simple
        before = sys.argv, {name: sys.modules.get(name) for name in ("paraview", "paraview.simple")}
        sys.argv = [STATE, *arguments]
        sys.modules |= {"paraview": package, "paraview.simple": simple}
        try:
            runpy.run_path(str(self.folder / test / STATE))
        finally:
            sys.argv = before[0]
            for name, module in before[1].items():
                if module is None:
                    del sys.modules[name]
        return simple

    def test_it_asks_for_what_the_files_hold(self):
        for test, blocks in (("uniaxial", {"grains", "platens"}), ("tension", {"grains"})):
            with self.subTest(test):
                simple = self.run_state(test)
                self.assertEqual(set(simple.opened), {"grains.pvd", "cracks.pvd"})
                self.assertEqual(set(simple.opened["grains.pvd"].blocks), blocks)
                self.assertEqual(set(simple.coloured), {"principal_stress_1", "mode"})
                self.assertTrue(all(display._bar for display in simple.coloured.values()))
                self.assertEqual(len(simple.shown), 3)
                self.assertGreater(len(simple.times), 2)
                self.assertEqual(simple.time, simple.times[-1])
                self.assertEqual(simple.pictures, [])

    def test_stress_has_the_range_of_the_contacts_strength(self):
        low, high = self.run_state("uniaxial").colours["principal_stress_1"]._range
        self.assertEqual((low, high), (-24.15e6, 24.15e6))

    def test_modes_have_the_names_that_the_files_have(self):
        colours = self.run_state("uniaxial").colours["mode"]
        self.assertEqual(colours.Annotations, ["0", "tensile", "1", "shear"])
        self.assertEqual(len(colours.IndexedColors), 6)

    def test_a_picture_is_made_where_one_is_named(self):
        self.assertEqual(self.run_state("uniaxial", ["picture.png"]).pictures, ["picture.png"])

    def test_the_stand_in_refuses_what_files_do_not_hold(self):
        state = (self.folder / "uniaxial" / STATE).read_text()
        for right, wrong in (('"mode"', '"modes"'), ('"displacement"', '"motion"'), ('"cracks"', '"crack"'),
                             ("principal_stress_1", "principal_stress_3"), ("LineWidth", "Linewidth")):
            with self.subTest(wrong):
                self.assertIn(right, state)
                folder = self.folder / "wrong"
                shutil.copytree(self.folder / "uniaxial", folder)
                (folder / STATE).write_text(state.replace(right, wrong))
                with self.assertRaises((AssertionError, AttributeError, OSError)):
                    self.run_state("wrong")
                shutil.rmtree(folder)

    def test_no_state_unless_asked_for(self):
        tool("post cracks uniaxial.h5 -o plain", self.folder)
        self.assertFalse((self.folder / "plain" / STATE).exists())

    @unittest.skipUnless(shutil.which("pvbatch"), "ParaView is not installed")
    def test_paraview_makes_a_picture(self):
        subprocess.run(["pvbatch", str(self.folder / "uniaxial" / STATE), "picture.png"], check=True, cwd=self.folder, timeout=300)
        self.assertGreater((self.folder / "picture.png").stat().st_size, 5000)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
