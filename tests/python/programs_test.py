"""Drives the programs from Python and compares what they make with what their command lines make. Usage: programs_test.py BIN PYTHON"""

import contextlib
import inspect
import json
import os
import runpy
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import types
import unittest
import warnings
from pathlib import Path

import numpy as np

BIN, PYTHON = (Path(argument).resolve() for argument in sys.argv[1:3])
sys.path.insert(0, str(PYTHON))
os.environ["GRAINCRACK_BIN"] = str(BIN)

import graincrack  # noqa: E402

ROCK = "augig-granite-calibrated"
QUICK = {"rate": (200, "mm/s"), "max_strain": 0.006, "frames": 2}
QUICK_LINE = f"--material {ROCK} --rate 200mm/s --max-strain 0.006 --frames 2 --quiet"


def tool(line, fails=False):
    """What a command of the tools prints; of one that fails, its error."""
    done = subprocess.run(f"{BIN}/graincrack-{line}", shell=True, capture_output=True, text=True)
    if (done.returncode != 0) != fails:
        raise AssertionError(f"{line}: exit code {done.returncode}: {done.stderr}")
    return done.stderr if fails else done.stdout


def digest(path):
    return tool(f"post info --digest {os.fspath(path)}").split()[0]


def python(program, **environment):
    """What a program of Python prints, with the error on which it ends."""
    return subprocess.run([sys.executable, "-c", program], capture_output=True, text=True,
                          env={**os.environ, "PYTHONPATH": str(PYTHON), **environment})


def appears(path):
    """Whether a file is there within a minute, and a moment later."""
    for _ in range(6000):
        if Path(path).exists():
            time.sleep(0.3)
            return True
        time.sleep(0.01)
    return False


def interrupt_when(path):
    """Presses Ctrl-C once a program has begun a file."""
    threading.Thread(target=lambda: appears(path) and os.kill(os.getpid(), signal.SIGINT), daemon=True).start()


class DrivesThePrograms(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        os.chdir(cls.folder.name)
        graincrack.quiet = True
        warnings.simplefilter("ignore", graincrack.GraincrackWarning)  # so few crystals are no rock
        cls.disc = graincrack.disc(diameter="30mm", grains=40, material=ROCK, output="disc.h5")
        cls.pillar = graincrack.rectangle(width="15mm", height="30mm", grains=40, material=ROCK, output="pillar.h5")
        cls.runs = [graincrack.brazilian(cls.disc, **QUICK, output="brazilian.h5"),
                    graincrack.uniaxial(cls.pillar, **QUICK, output="uniaxial.h5"),
                    graincrack.triaxial(cls.pillar, confining_pressure="4MPa", **QUICK, output="triaxial.h5")]

    @classmethod
    def tearDownClass(cls):
        os.chdir("/")
        cls.folder.cleanup()

    def same(self, made, line):
        """What Python made is what the command line makes."""
        Path("line.h5").unlink(missing_ok=True)
        tool(f"{line} -o line.h5")
        self.assertEqual(digest(made), digest("line.h5"))

    def test_specimens_of_each_tessellation(self):
        for tessellation in ("delaunay", "voronoi", "trigon"):
            specimen = graincrack.rectangle(width=(20, "mm"), height=0.03, edge="4mm", tessellation=tessellation, seed=3,
                                            phases={"quartz": 0.4, "mica": 0.6})
            self.same(specimen, f"mesh rectangle --width 20mm --height 30mm --edge 4mm --tessellation {tessellation} --seed 3 "
                                "--phases quartz=0.4,mica=0.6 --quiet")
            self.assertEqual(specimen["tessellation"], tessellation)

    def test_an_imported_mesh(self):
        mesh = Path(__file__).resolve().parents[1] / "data" / "meshes" / "two-parts.msh"
        specimen = graincrack.import_(mesh, scale="10mm", grain="entity", format="gmsh")
        self.same(specimen, f"mesh import {mesh} --scale 10mm --grain entity --quiet")
        self.assertEqual(specimen.nodes.max(), 0.01)

    def test_tests_with_the_material_of_their_specimen(self):
        brazilian, uniaxial, triaxial = self.runs
        self.same(brazilian, f"solve brazilian disc.h5 {QUICK_LINE}")
        self.same(uniaxial, f"solve uniaxial pillar.h5 {QUICK_LINE}")
        self.same(triaxial, f"solve triaxial pillar.h5 --confining-pressure 4MPa {QUICK_LINE}")
        self.assertEqual((brazilian.test, triaxial["confining_pressure"]), ("brazilian", 4e6))
        other = graincrack.brazilian(self.disc, material="lac-du-bonnet-granite-calibrated", **QUICK)
        self.assertEqual(other["material"], "Lac du Bonnet granite, nearest point")

    def test_a_loading_program(self):
        options = {"contact_tensile_strength": "12MPa", "frames": 1}
        program = graincrack.uniaxial(self.pillar, **QUICK, print_program=True)
        Path("program.toml").write_text(program + "\n")
        self.same(graincrack.program(self.pillar, program="program.toml", **options),
                  f"solve program pillar.h5 --program program.toml --material {ROCK} --contact-tensile-strength 12MPa --frames 1 --quiet")

    def test_samples_of_grainlearning(self):
        example, got = runpy.run_path(str(PYTHON / "examples" / "grainlearning.py")), []
        system = types.SimpleNamespace(param_data=np.array([[8e6, 40e6], [12e6, 40e6]]), ctrl_data=np.array([0, 1e-3, 3e-3]), set_sim_data=got.extend)
        example["run_samples"](system, self.pillar, rate="200mm/s")
        run = graincrack.uniaxial(self.pillar, contact_tensile_strength="12MPa", contact_cohesion="40MPa", rate="200mm/s", max_strain=3e-3, peak_drop="none")
        strain, stress = (-run.history[f"axial_{name}"] for name in ("strain", "stress"))
        self.assertEqual([curve.shape for curve in got], [(1, 3), (1, 3)])
        self.assertAlmostEqual(got[1][0, 1], stress[strain >= 1e-3][0] / 1e6, delta=0.5)
        self.assertNotEqual(got[0][0, 2], got[1][0, 2])

    def test_a_restart(self):
        slow = {"rate": "100mm/s", "max_strain": 0.005}
        with self.assertRaises(graincrack.GraincrackError) as caught:
            graincrack.uniaxial(self.pillar, **slow, walltime=(100, "ms"), output="stopped.h5")
        self.assertEqual(caught.exception.exit_code, 128 + signal.SIGTERM)
        shutil.copy("stopped.h5.checkpoint", "copy")
        self.same(graincrack.uniaxial(self.pillar, **slow, restart="stopped.h5.checkpoint"),
                  f"solve uniaxial pillar.h5 --material {ROCK} --rate 100mm/s --max-strain 0.005 --restart copy --quiet")

    def test_tables(self):
        for name, line in (("strength", "--all-columns"), ("moduli", "")):
            table = getattr(graincrack, name)(self.runs, **({"all_columns": True} if line else {}))
            printed = tool(f"post {name} brazilian.h5 uniaxial.h5 triaxial.h5 {line}")
            self.assertEqual(table.save(f"{name}.tsv").read_text(), printed)
            self.assertIn("<td>uniaxial.h5</td>", table._repr_html_())
        self.assertEqual(graincrack.strength(*self.runs, format="jsonl").count("\n"), 2)
        self.assertEqual(list(graincrack.summarize("strength.tsv", sql="SELECT test FROM strength WHERE seed = 1")["test"]),
                         ["brazilian", "uniaxial", "triaxial"])
        written = graincrack.strength(self.runs, output="of-three.tsv")
        self.assertEqual(list(written["seed"]), [1, 1, 1])
        swept = graincrack.map(lambda friction: graincrack.uniaxial(self.pillar, **QUICK, platen_friction=(friction, "deg")), [5, 10])
        told = graincrack.strength(swept, columns=["platen_friction", "seed"])
        self.assertEqual(([*told["platen_friction_deg"]], told.unit("platen_friction")), ([5, 10], "deg"))
        with self.assertRaisesRegex(graincrack.GraincrackError, "--columns friction: none of the runs has such an option"):
            graincrack.strength(swept, columns="friction")
        self.assertEqual(graincrack.material.value("contact.friction_angle", ROCK), tool(f"post material value contact.friction_angle {ROCK}").strip())

    def test_pictures_and_pages(self):
        picture = self.runs[0].plot("cracks", frame=["first", "last"])
        self.assertEqual((picture._repr_png_()[:4], picture.path), (b"\x89PNG", Path("graincrack-results/plot-cracks-1.png")))
        self.assertGreater(picture.save("copy.png").stat().st_size, 10000)
        self.assertIn("<svg", self.disc.plot(output="disc.svg")._repr_svg_())
        self.assertIn("<iframe sandbox=", graincrack.report(self.runs)._repr_html_())
        self.assertIn("DecompressionStream", self.runs[0].view()._repr_html_())
        self.assertIsNone(graincrack.cracks(self.runs[0], output="cracks")._repr_html_())
        frames = self.runs[0].plot("cracks", frame="all", output="frames")
        self.assertEqual((frames._repr_png_()[:4], frames._repr_html_()), (b"\x89PNG", None))

    def test_files_have_new_names_unless_they_are_named(self):
        def rings():
            return sorted(path.name for path in Path("elsewhere").iterdir())
        graincrack.folder = "elsewhere"
        try:
            sizes = {"diameter": "30mm", "edge": "4mm"}
            self.assertEqual(os.fspath(graincrack.ring(inner_diameter="10mm", **sizes)), "elsewhere/ring-1.h5")
            with self.assertRaises(graincrack.GraincrackError):
                graincrack.ring(inner_diameter="40mm", **sizes)
            self.assertEqual(rings(), ["ring-1.h5"])
            Path("elsewhere/ring-2.h5.checkpoint").touch()
            graincrack.ring(inner_diameter="10mm", **sizes)
            self.assertIn("ring-3.h5", rings())
            plan = graincrack.ring(inner_diameter="10mm", **sizes, output="elsewhere/ring-1.h5", dry_run=True)
            self.assertRegex(plan, r"ring of \d+ grains")
        finally:
            graincrack.folder = "graincrack-results"

    def test_a_calibration_is_what_its_outcome_says(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            with self.assertRaisesRegex(graincrack.GraincrackError, "no outcome.json"):
                graincrack.Calibration(folder)
            outcome = {"rock": "my rock", "state": "running", "files": {"wanted": "wanted.tsv"}, "targets": {
                "uniaxial": {"use": "fit", "value": 2e8}, "direct_tension": {"use": "predict", "value": 8e6}}}
            (folder / "outcome.json").write_text(json.dumps(outcome))
            with self.assertRaisesRegex(graincrack.GraincrackError, "has not ended"):
                graincrack.Calibration(folder)
            outcome.update(state="not reached", files={"report": "words.md", "material": "nearest.toml"})
            (folder / "outcome.json").write_text(json.dumps(outcome))
            (folder / "words.md").write_text("Calibration of a rock\n")
            found = graincrack.Calibration(folder)
            self.assertEqual((found.rock, found.end, found.report), ("my rock", "not reached", "Calibration of a rock\n"))
            self.assertEqual(os.fspath(found), str(folder / "nearest.toml"))
            self.assertEqual(list(found.fitted), ["uniaxial"])

    def test_an_argument_is_never_an_option_or_the_next_argument(self):
        for call, line in [(lambda: graincrack.strength("--version"), r"^graincrack-post: \./--version: no such file$"),
                           (lambda: graincrack.disc(diameter="", grains=50), "^diameter: '' is empty"),
                           (lambda: graincrack.disc(diameter=(), grains=50), r"^diameter: \(\) is empty"),
                           (lambda: graincrack.strength("a.h5", all_columns="no"), "^all_columns: 'no' is neither True nor False"),
                           (lambda: graincrack.calibrate("a$(touch ran).toml"), "^ROCK: .*: make takes no name with a space or one of"),
                           (lambda: graincrack.calibrate(ROCK, out="my `touch ran`"), "^OUT: .*: make takes no name")]:
            with self.assertRaisesRegex(graincrack.GraincrackError, line):
                call()
        self.assertFalse(Path("ran").exists())

    def test_what_does_not_fit_is_said(self):
        with self.assertRaises(graincrack.GraincrackError) as caught:
            graincrack.brazilian(self.disc, max_strain=2)
        line = tool(f"solve brazilian disc.h5 --max-strain 2 --material {ROCK} -o no.h5", fails=True)
        self.assertEqual((str(caught.exception), caught.exception.exit_code), (line.strip(), 2))
        imported = graincrack.ring(diameter="30mm", inner_diameter="10mm", edge="4mm")
        with self.assertRaisesRegex(graincrack.GraincrackError, "--material: missing"):
            graincrack.brazilian(imported)
        with self.assertRaisesRegex(graincrack.GraincrackError, "output '-'"):
            graincrack.brazilian(self.disc, output="-")
        with self.assertRaisesRegex(graincrack.GraincrackError, "ROCK=cheese: no such file, nor a name in share/materials"):
            graincrack.calibrate("cheese")
        with self.assertRaisesRegex(TypeError, "brazilian: .*'max_strian'"):
            graincrack.brazilian(self.disc, max_strian=2)
        with self.assertRaisesRegex(AttributeError, "graincrack has no brasilian; did you mean brazilian?"):
            graincrack.brasilian
        with self.assertRaisesRegex(AttributeError, "graincrack.plot has no maps; there are .*cracks"):
            self.disc.plot("maps")
        with self.assertWarnsRegex(graincrack.GraincrackWarning, "disc.h5: did not fail|crystals of the mean diameter"), warnings.catch_warnings():
            warnings.simplefilter("always")
            graincrack.strength(graincrack.brazilian(self.disc, **{**QUICK, "max_strain": 0.0005}))

    def test_functions_are_described_by_the_programs(self):
        said = json.loads(tool("solve --describe"))
        for command in said["commands"]:
            names = inspect.signature(getattr(graincrack, command["name"])).parameters
            own = {option["name"].replace("-", "_") for option in command["options"]} - {"help", "help_all"}
            self.assertLessEqual(own, set(names))
        parameters = inspect.signature(graincrack.brazilian).parameters
        self.assertEqual((parameters["max_strain"].default, parameters["sensitivity"].default), (0.015, False))
        self.assertEqual(parameters["specimen"].kind, inspect.Parameter.POSITIONAL_OR_KEYWORD)
        self.assertRegex(graincrack.plot.curve.__doc__, "label : .*may be a list\n")
        self.assertRegex(graincrack.uniaxial.__doc__, "contact_cohesion : quantity in Pa(.|\n)*MPa")
        self.assertRegex(graincrack.strength.__doc__, "Returns: Table\\.(.|\n)*Columns of `strength`(.|\n)*peak_compressive_stress_MPa : MPa\n")
        self.assertLessEqual({"half_disc", "import_", "size_effect", "calibrate", "map", "Run"}, set(dir(graincrack)))

    def test_programs_are_found_or_it_is_said(self):
        asks = "import graincrack; print(len(dir(graincrack)) < 20); graincrack.disc"
        missing = python(asks, GRAINCRACK_BIN="/nowhere")
        self.assertEqual(missing.stdout, "True\n")
        self.assertRegex(missing.stderr, "GraincrackError: .* are not in GRAINCRACK_BIN=/nowhere; install Graincrack, or set")
        Path("other").mkdir()
        for program in ("mesh", "solve", "post"):
            Path(f"other/graincrack-{program}").write_text(f"#!/bin/sh\n{BIN}/graincrack-{program} \"$@\" | sed 's/\"version\": *\"[^\"]*\"/\"version\":\"9.9\"/'\n")
            Path(f"other/graincrack-{program}").chmod(0o755)
        other = python("import graincrack; graincrack.disc", GRAINCRACK_BIN="other")
        self.assertRegex(other.stderr, f"graincrack-mesh is of Graincrack 9.9, this package of {graincrack.__version__}; install both")
        on_path = python("import graincrack; print(graincrack.programs.bin_folder())", GRAINCRACK_BIN="", PATH=f"{BIN}:{os.environ['PATH']}")
        self.assertTrue(Path(on_path.stdout.strip()).is_dir(), on_path.stderr)

    def test_ctrl_c_leaves_a_checkpoint(self):
        interrupt_when("long.h5.part")
        with self.assertRaisesRegex(KeyboardInterrupt, r"stopped; the test so far is in long.h5.checkpoint, and uniaxial\(…, restart='long.h5"):
            graincrack.uniaxial(self.pillar, rate="2mm/s", output="long.h5")
        self.assertTrue(Path("long.h5.checkpoint").exists())
        self.assertFalse(Path("long.h5").exists())

    def test_a_map_within_a_map_belongs_to_it(self):
        def calls(_):
            return graincrack.programs.Together.of_thread.calls
        inner = graincrack.map(lambda item: (calls(item), graincrack.map(calls, range(2))), range(2), jobs=2)
        self.assertEqual(len({id(each) for own, others in inner for each in (own, *others)}), 1)
        self.assertEqual(graincrack.map(lambda i: graincrack.map(lambda j: i * j, [1, 2]), [1, 2]), [[1, 2], [2, 4]])

    def test_map_has_the_order_of_its_items_and_stops_at_an_error(self):
        def one(item):
            time.sleep(0.2 - item / 20)
            return graincrack.brazilian(self.disc, **QUICK).provenance["threads"], item
        self.assertEqual(graincrack.map(one, range(4), jobs=2), [(1, item) for item in range(4)])

        def fails(item):
            if item == "wrong":
                appears("slow.h5.part")
            return graincrack.uniaxial(self.pillar, rate="2mm/s" if item == "slow" else item, output=f"{item}.h5")
        with self.assertRaisesRegex(graincrack.GraincrackError, '--rate: .*wrong'):
            graincrack.map(fails, ["slow", "wrong", "never"], jobs=2)
        self.assertTrue(Path("slow.h5.checkpoint").exists())

    def test_ctrl_c_leaves_a_checkpoint_of_each_test_of_a_map(self):
        # The large one leaves its checkpoint when the others have ended.
        large = graincrack.rectangle(width="60mm", height="120mm", grains=8000, material=ROCK, output="large.h5")
        files = {Path(f"of-{number}.h5"): specimen for number, specimen in enumerate([self.pillar, self.pillar, large])}

        def interrupt():
            if all(appears(f"{file}.part") for file in files):
                os.kill(os.getpid(), signal.SIGINT)
        threading.Thread(target=interrupt, daemon=True).start()
        with self.assertRaisesRegex(KeyboardInterrupt, "tests that were running have left RUN.checkpoint"):
            graincrack.map(lambda file: graincrack.uniaxial(files[file], rate="2mm/s", output=file), files, jobs=3)
        self.assertEqual([Path(f"{file}.checkpoint").exists() for file in files], [True] * 3)

    def on_a_terminal(self, program):
        """A process of Python whose stderr is a terminal, and that terminal."""
        master, slave = os.openpty()
        process = subprocess.Popen([sys.executable, "-W", "ignore", "-c", f"import graincrack; {program}"], stderr=slave,
                                   env={**os.environ, "PYTHONPATH": str(PYTHON)})
        os.close(slave)
        self.addCleanup(os.close, master)
        return process, master

    def test_progress_on_a_terminal(self):
        for quiet in (False, True):
            process, terminal = self.on_a_terminal(f"graincrack.uniaxial('pillar.h5', rate='10mm/s', max_strain=0.002, quiet={quiet})")
            told = b""
            with contextlib.suppress(OSError):  # the other end is closed
                while piece := os.read(terminal, 65536):
                    told += piece.replace(b"\033[K", b"")
            self.assertEqual(process.wait(), 0)
            self.assertEqual((b"\runiaxial [" in told, b"\runiaxial: ended by" in told), (not quiet, not quiet), told)
            if not quiet:  # as at the end
                self.assertRegex(told, rb"stress [\d.]+ MPa, cracks: \d+ tensile, \d+ shear, at most")

    def test_a_test_ends_with_python(self):
        process, _ = self.on_a_terminal("graincrack.uniaxial('pillar.h5', rate='2mm/s', output='left.h5')")
        self.assertTrue(appears("left.h5.part"))
        process.kill()
        process.wait()
        self.assertTrue(appears("left.h5.checkpoint"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
