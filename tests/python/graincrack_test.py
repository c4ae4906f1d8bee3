"""Reads what the tools write and compares it with what graincrack-post prints. Usage: graincrack_test.py BIN PYTHON"""

import math
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

BIN, PYTHON = (Path(argument).resolve() for argument in sys.argv[1:3])
sys.path.insert(0, str(PYTHON))

import h5py  # noqa: E402
import numpy as np  # noqa: E402

from graincrack import SCHEMA_VERSION, FormatError, GraincrackError, MissingError, Run, Specimen, Table  # noqa: E402


def tool(line: str) -> str:
    """The output of a command of the tools."""
    return subprocess.run(f"{BIN}/graincrack-{line}", shell=True, check=True, capture_output=True, text=True).stdout


class ReadsWhatTheToolsWrite(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        os.chdir(cls.folder.name)
        tool("mesh rectangle --width 20mm --height 40mm --edge 4mm --seed 10 --quiet -o specimen.h5")
        test = "solve uniaxial specimen.h5 --material augig-granite --rate 200mm/s --max-strain 0.012 --quiet "
        tool(test + "--frames 8 -o run.h5")
        tool(test + "--frames 0 -o end.h5")
        Path("strength.tsv").write_text(tool("post strength run.h5 --all-columns --quiet"))
        Path("history.tsv").write_text(tool("post history run.h5"))

    @classmethod
    def tearDownClass(cls):
        os.chdir("/")
        cls.folder.cleanup()

    def test_a_history_is_what_the_postprocessor_prints(self):
        run, printed = Run("run.h5"), Table("history.tsv")
        self.assertEqual(run.history.unit("axial_stress"), "Pa")
        self.assertEqual(printed.unit("axial_stress"), "Pa")
        self.assertIn("energy_balance_error", run.history)
        for name in run.history:
            np.testing.assert_allclose(printed[name], run.history[name], rtol=1e-6, atol=1e-300, err_msg=name)

    def test_the_peak_is_that_of_the_table(self):
        run, strength = Run("run.h5"), Table("strength.tsv")
        self.assertAlmostEqual(-run.history["axial_stress"].min() / 1e6, strength["peak_compressive_stress"][0], places=3)
        self.assertEqual(strength["test"][0], run.test)
        peak = run.frame("peak")
        at_peak = run.history["time"][run.history["axial_stress"].argmin()]
        self.assertAlmostEqual(peak.time, at_peak, delta=2 * np.diff(run.history["time"]).max())
        self.assertEqual(peak["displacement"].shape, run.specimen.nodes.shape)
        self.assertEqual(run["peak_time"], at_peak)
        self.assertEqual(run.frame("last").step, run.history["step"][-1])
        self.assertEqual(run.frame(0).time, run.frame_times[0])

    def test_the_peak_is_the_strength_where_the_stress_exceeds_it_later(self):
        shutil.copy("run.h5", "later.h5")
        with h5py.File("later.h5", "r+") as file:
            file["run"].attrs["peak_time"] = Run("run.h5").frame(3).time
        self.assertNotEqual(Run("run.h5").frame("peak").time, Run("run.h5").frame(3).time)
        self.assertEqual(Run("later.h5").frame("peak").time, Run("run.h5").frame(3).time)

    def test_cracks_are_those_that_are_counted(self):
        run, strength = Run("run.h5"), Table("strength.tsv")
        self.assertGreater(len(run.cracks["mode"]), 10)
        self.assertEqual(run.cracks.names("mode"), ["tensile", "shear"])
        self.assertEqual(run.history["tensile_cracks"][-1], (run.cracks["mode"] == 0).sum() / 2)
        peak_time = run.history["time"][run.history["axial_stress"].argmin()]
        before = run.cracks["time"] <= peak_time
        self.assertEqual(strength["shear_cracks_by_sign"][0], (run.cracks["mode"][before] == 1).sum() / 2)
        self.assertEqual(run["crack_event"], "failed")
        tensile = (run.cracks["opening"] >= 0) & (run.cracks["mode_angle"] < np.pi / 4)
        self.assertEqual(strength["tensile_cracks"][0], tensile[before].sum() / 2)

    def test_attributes_and_specimen(self):
        run, specimen = Run("run.h5"), Specimen("specimen.h5")
        self.assertEqual(run["material"], "Augig granite")
        self.assertEqual(run.attributes["mass_scaling"], "selective")
        self.assertEqual(run.provenance["tool"], "graincrack-solve")
        self.assertEqual(specimen["width"], 0.02)
        self.assertEqual([specimen.request[name] for name in ("width", "tessellation", "slit")], [0.02, specimen["tessellation"], None])
        self.assertEqual([run.request[name] for name in ("peak_drop", "heat", "cool")], [0.3, None, False])
        self.assertEqual(run.specimen.request, specimen.request)
        np.testing.assert_array_equal(specimen.nodes, run.specimen.nodes)
        corners = specimen.nodes[specimen.elements]
        edges = corners[:, 1:] - corners[:, :1]
        area = 0.5 * (edges[:, 0, 0] * edges[:, 1, 1] - edges[:, 0, 1] * edges[:, 1, 0])
        self.assertAlmostEqual(area.sum(), 0.02 * 0.04, places=12)
        np.testing.assert_allclose(area, specimen.grains["area"], rtol=1e-9)

    def test_what_is_too_long_for_an_attribute_is_a_dataset(self):
        shutil.copy("run.h5", "long.h5")
        with h5py.File("long.h5", "r+") as file:
            file["provenance/configuration"] = np.frombuffer(b"a" * 70000, np.uint8)
            file["provenance/command_line"] = np.frombuffer(b"ab\0cde", np.uint8).reshape(2, 3)
            del file["provenance"].attrs["configuration"], file["provenance"].attrs["command_line"]
        self.assertEqual(Run("long.h5").provenance["configuration"], "a" * 70000)
        self.assertEqual(Run("long.h5").provenance["command_line"], ["ab", "cde"])

    def test_a_file_of_another_schema_is_refused(self):
        for change in (-1, 1):
            shutil.copy("end.h5", "other.h5")
            with h5py.File("other.h5", "r+") as file:
                file.attrs["schema_version"] = SCHEMA_VERSION + change
            said = f"other.h5: has schema version {SCHEMA_VERSION + change}, but this module reads {SCHEMA_VERSION}; use"
            with self.assertRaisesRegex(FormatError, said):
                Run("other.h5")

    def test_what_does_not_fit_is_said(self):
        Path("text.h5").write_text("no HDF5")
        Path("ragged.tsv").write_text("a\tb\n1\n")
        for path, kind, message in (
            ("text.h5", Run, "text.h5: no HDF5 file"),
            ("specimen.h5", Run, "specimen.h5: a specimen, no run"),
            ("ragged.tsv", Table, "ragged.tsv: no table"),
            ("end.h5", Table, "end.h5: no table"),
        ):
            with self.assertRaisesRegex(FormatError, message):
                kind(path)
        run = Run("run.h5")
        for read, message in (
            (lambda: run.history["stress"], "no /history/stress; there are .*axial_stress"),
            (lambda: run["colour"], "/run has no 'colour'"),
            (lambda: run.frame(99), "no frame 99"),
            (lambda: Run("end.h5").frame("peak"), "end.h5: no frame of the peak"),
            (lambda: run.probe("end"), "no probe 'end'"),
            (lambda: Table("strength.tsv")["stress"], "no column 'stress'"),
        ):
            with self.assertRaisesRegex(MissingError, message) as caught:
                read()
            self.assertIsInstance(caught.exception, GraincrackError)
            self.assertNotIn('"', str(caught.exception)[:1])  # the line itself, where a KeyError would quote it

    def test_a_column_of_a_table_is_of_numbers_if_all_its_cells_are(self):
        table = Table("t", "name\tword\tvalue\n1_2\tnan\t3.5\n2\t\t-4e-3\n3\tinf\t\n")
        self.assertEqual(list(table["name"]), ["1_2", "2", "3"])
        self.assertEqual(list(table["word"]), ["nan", "", "inf"])
        self.assertEqual(list(table["value"])[:2], [3.5, -0.004])
        self.assertTrue(math.isnan(table["value"][2]))

    def test_examples_draw(self):
        environment = {**os.environ, "PYTHONPATH": str(PYTHON)}
        for script, source in (("curve_and_cracks", "run.h5"), ("crack_map", "run.h5"), ("strengths", "strength.tsv")):
            subprocess.run([sys.executable, PYTHON / "examples" / f"{script}.py", source, f"{script}.png"], check=True, env=environment)
            self.assertGreater(Path(f"{script}.png").stat().st_size, 10000, script)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
