"""Installs the sources, and the wheel that needs glibc alone, into environments, and makes a test and a picture in each.

Usage: wheel_test.py BUILD. Ends with 77, "skipped", and the reason, where venv or namespaces of users are not to be had. Of the machine the
second environment sees its glibc and nothing else: no library, no font. Dependencies, which an index would give, are Debian's.
"""
import hashlib
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]
# A disc is meshed, broken, measured and drawn with the programs of $BIN, called by $RUN, in $WORK.
TEST = """set -e
$RUN $BIN/graincrack-mesh disc --diameter 25mm --edge 4mm --material augig-granite-triangles --quiet -o $WORK/disc.h5
$RUN $BIN/graincrack-solve brazilian $WORK/disc.h5 --material augig-granite-triangles --quiet -o $WORK/run.h5
$RUN $BIN/graincrack-post strength $WORK/run.h5 --quiet --format table
$RUN $BIN/graincrack-post plot cracks $WORK/run.h5 -o $WORK/cracks.png >&2
$RUN $BIN/graincrack-post plot cracks $WORK/run.h5 --quiet -o $WORK/cracks.pdf
"""


def run(*command, **variables):
    """What a command prints, without variables of this process but PATH and those that are given."""
    names = ("PATH", "HOME", "CMAKE_CXX_COMPILER_LAUNCHER", "CCACHE_DIR")
    variables = {name: os.environ[name] for name in names if name in os.environ} | {name: str(value) for name, value in variables.items()}
    result = subprocess.run(list(map(str, command)), cwd="/", env=variables, text=True, capture_output=True)
    if result.returncode != 0:
        raise AssertionError(f"{command}: {result.returncode}\n{result.stdout}\n{result.stderr}")
    return result.stdout, result.stderr


class Wheel(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp(prefix="graincrack-wheel-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.pip = ["install", "--quiet", "--no-index", "--no-deps"]
        os.chdir(cls.folder)
        run("/usr/bin/python3", "-m", "venv", "--system-site-packages", cls.folder / "first")
        run(cls.folder / "first/bin/pip", *cls.pip, "--no-build-isolation", "--config-settings", f"build-dir={BUILD}", TOP)
        cls.strength, _ = run("bash", "-c", TEST, RUN="", BIN=cls.folder / "first/bin", WORK=cls.folder)

    def test_the_sources_are_installed_by_pip(self):
        self.assertIn("Brazilian, plane stress", self.strength)
        script = "import graincrack, sys; print(graincrack.__file__, *graincrack.strength(graincrack.Run(sys.argv[1]))['test'])"
        printed, _ = run(self.folder / "first/bin/python", "-c", script, self.folder / "run.h5")
        self.assertTrue(printed.startswith(str(self.folder / "first/lib")), printed)
        self.assertTrue(printed.endswith("brazilian\n"), printed)
        self.assertTrue(os.access(self.folder / "first/share/graincrack/studies/lib/crate", os.X_OK))
        run(self.folder / "first/bin/pip", "uninstall", "--yes", "graincrack")
        self.assertEqual([path for path in (self.folder / "first").rglob("*graincrack*") if path.is_file()], [])

    def test_the_wheel_needs_glibc_alone(self):
        run("make", "-s", "-C", TOP / "share/packaging", "wheel", "PYTHON=/usr/bin/python3", f"BUILD={BUILD}/wheel", f"OUT={self.folder}/made")
        [wheel] = (self.folder / "made").glob("*.whl")
        print(f"{wheel.name}: {wheel.stat().st_size / 1e6:.1f} MB", file=sys.stderr)
        self.assertRegex(wheel.name, r"-py3-none-manylinux_2_\d+_\w+\.whl$")
        self.assertLess(wheel.stat().st_size, 60e6)
        second, bare = self.folder / "second", self.folder / "bare"
        run("/usr/bin/python3", "-m", "venv", second)
        run(second / "bin/pip", *self.pip, wheel)
        for name in ("proc", "environment", "results"):
            (bare / name).mkdir(parents=True)
        loaded, _ = run("ldd", second / "bin/graincrack-post")
        needed = [line.split()[-2] for line in loaded.splitlines() if "/" in line and str(second) not in line]
        glibc = {"libc", "libm", "libdl", "librt", "libpthread", "libresolv", "ld-linux-x86-64"}
        self.assertLessEqual({Path(each).name.split(".")[0] for each in needed}, glibc)
        for each in needed:
            (bare / each[1:]).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(each, bare / each[1:])
        hide = f"mount --rbind /proc {bare}/proc; mount --bind {second} {bare}/environment\n"
        places = {"RUN": f"chroot {bare}", "BIN": "/environment/bin", "WORK": "/results", "HOME": "/results"}
        strength, said = run(*NAMESPACE, "bash", "-c", f"set -e\n{hide}{TEST}", **places)
        self.assertEqual(strength.replace("/results/", f"{self.folder}/").split(), self.strength.split())
        self.assertNotIn("ontconfig", said)
        self.assertIn(b"LiberationSans", (bare / "results/cracks.pdf").read_bytes())
        pictures = [hashlib.sha256((folder / "cracks.png").read_bytes()).hexdigest() for folder in (self.folder, bare / "results")]
        self.assertEqual(pictures[0], pictures[1])
        licences = [path.parent.name for path in second.glob("lib/python*/site-packages/*.dist-info/licenses/*/copyright")]
        self.assertLessEqual({"libcgal-dev", "libgsl27", "libhdf5-103-1", "libvtk9.1", "libpango-1.0-0", "fonts-liberation"}, set(licences))


if __name__ == "__main__":
    BUILD = Path(sys.argv.pop()).resolve()
    NAMESPACE = ["unshare", "--map-root-user", "--mount"]
    for needed in (NAMESPACE + ["chroot", "--version"], ["/usr/bin/python3", "-c", "import ensurepip, venv"]):
        if shutil.which(needed[0]) is None or subprocess.run(needed, stdout=subprocess.DEVNULL).returncode != 0:
            print(f"skipped: {' '.join(needed)} does not work here")
            sys.exit(77)
    unittest.main()
