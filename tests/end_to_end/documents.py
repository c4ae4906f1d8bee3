#!/usr/bin/python3
"""Runs the commands of the documents as they stand there.

Usage: documents.py BIN [--whole-tests] [--only NAME]

BIN is the folder of the tools. The commands are the indented lines of README.md, CONTRIBUTING.md, share/doc/*.md and share/studies/*/README.md that call
a tool, a script, make or printf, with the pipelines that they begin and the lines that a \\ joins to them, and the lines in the heads of share/programs/*.toml;
behind them the blocks of Python that begin with the import of graincrack. Those of one document run one after the other in one folder, which has links to what
is called by a path from the top. A command fails the test if its exit code is not 0.

Studies are printed and not made (make -n, with one specimen of each kind; tests/studies/run makes them on tiny ones; STAND_INS are what later commands read of them),
share/quickstart has QUICK=1, and tests have a larger tolerance of the loading rate, those of LARGER_GRAINS larger grains too, unless
--whole-tests is given. A form with a word to be replaced (FILE.toml, RUN) is no command. NOT_HERE
lists what cannot run here, and why; a command that is in no list runs.
"""
import argparse
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

TOP = pathlib.Path(__file__).resolve().parent.parent.parent
CALLS = re.compile(r"(graincrack-(mesh|solve|post)|share/|tests/|make|cmake|sbatch|export|printf)\b(?!:)")
NOT_HERE = {
    "tests/run": "is what runs this test",
    "tests/rules": "reads all sources: .ci/run",
    "tests/layout": "is part of tests/rules",
    "tests/benchmark/": "needs a machine that does nothing else",
    "tests/verification_table": "needs the rows of tests/run --all",
    "make -C share/packaging": "builds the programs a second time: tests/python/wheel_test.py",
    "share/studies/job-array": "needs Slurm: tests/slurm/run",
    "share/studies/large-run": "needs Slurm: tests/slurm/run",
    "sbatch": "needs Slurm: tests/slurm/run",
}
PYTHON = "/usr/bin/python3 - <<'end'\n"
PLACEHOLDER = re.compile(r"(?<![\w$=/])[A-Z]{3,}(\.\w+)?(?![\w=])|…|►|\[")
# A rock of one's own, as README says: one of a kind, and its values entered.
INIT = "graincrack-post material init my-rock --kind granite"
ENTER_VALUES = "sed -i 's/^# \\([a-z_]* = \\)/\\1/' my-rock.toml\n"
# A study that is printed has one specimen of each kind where the command does not say how many: a dry run costs by the number of runs.
def one_of_each(command):
    return "".join(f" {name}=1" for name in ("RECTANGLES", "DISCS", "HALF_DISCS", "SEEDS", "NUMBER", "PAIRS") if f"{name}=" not in command)


QUICK = {
    "make -C share/studies": lambda command: command.replace("make ", "make -n ") + one_of_each(command),
    "share/quickstart": lambda command: "QUICK=1 " + command,
}
# Made in place of the results of a study, for the commands behind it.
STAND_INS = {
    "make -C share/studies calibrate ROCK=my-rock.toml":
        "mkdir -p results/calibrate/my-rock; cp my-rock.toml results/calibrate/my-rock/calibrated.toml",
    "make -C share/studies calibrate ROCK=marble.toml":
        "mkdir -p results/calibrate/marble; graincrack-post material with marble.toml --set 'contact.tensile_strength=7.13838 MPa' "
        "--set ratios.cohesion=4.10362 --set 'contact.friction_angle=32.13 deg' --set 'contact.residual_friction_angle=20.8213 deg' >results/calibrate/marble/calibrated.toml",
}
LARGER_GRAINS = {
    "README.md": {"--width 50mm --height 100mm": "--width 16mm --height 32mm", 'width="50mm", height="100mm"': 'width="16mm", height="32mm"',
                  "disc --diameter 68mm": "disc --diameter 24mm", "half-disc --diameter 84mm --slit 21mm": "half-disc --diameter 48mm --slit 12mm"},
    "file-format.md": {'diameter="68mm"': 'diameter="24mm"'},
    "from-udec-and-pfc.md": {"--width 50mm --height 100mm": "--width 16mm --height 32mm", 'width="50mm", height="100mm"': 'width="16mm", height="32mm"'},
    "loading.md": {"--edge 3mm": "--edge 5mm"},
    "specimens.md": {"--edge 3mm": "--edge 5mm", "--grains 300": "--grains 80", "--element-size 2.5mm": "--element-size 5mm"},
    "temperature.md": {"--width 36mm --height 72mm": "--width 12mm --height 24mm"},
    "tutorial.md": {"--width 30mm --height 60mm": "--width 12mm --height 24mm"},
    "gallery.md": {"--width 50mm --height 100mm": "--width 16mm --height 32mm", "--width 40mm --height 80mm": "--width 20mm --height 40mm",
                   "--diameter 68mm --inner-diameter 25mm": "--diameter 50mm --inner-diameter 25mm", "--diameter 68mm": "--diameter 32mm",
                   "--diameter 80mm --slit 20mm": "--diameter 40mm --slit 10mm", "0.006 --peak-drop none": "0.03 --peak-drop none"},
}


def without_comment(line):
    return re.sub(r"\s+#\s.*", "", line).strip()


def commands_of(path):
    """Commands of a document in their order; a pipeline over several lines is one."""
    lines = path.read_text().splitlines()
    if path.suffix == ".toml":
        lines = ["    " + line[1:].strip() for line in lines if line.startswith("#   ")]
    open_pipeline = ""
    for line in lines:
        if not line.startswith("    "):
            continue
        command = open_pipeline + without_comment(line)
        open_pipeline = ""
        if not CALLS.match(command):
            continue
        if command.endswith(("|", "\\")):
            open_pipeline = command.removesuffix("\\") + " "
            continue
        yield command


def inline_commands(text):
    """Commands within sentences that can run as they stand: those that name what they write."""
    for command in re.findall(r"`(graincrack-[^`]*)`", text.replace("\n", " ")):
        if re.search(r" -o |material init|--version", command) and not PLACEHOLDER.search(command):
            yield command


def python_blocks(text):
    """Code that drives the programs, as commands."""
    return [f"{PYTHON}{code}end" for code in re.findall(r"^```python\n((?:import|from) graincrack\b.*?)^```", text, re.M | re.S)]


def with_larger_grains(command, document):
    for small, large in (LARGER_GRAINS.get(document, {}) | {"--rate-tolerance 0.006": "--rate-tolerance 0.04", "--frames 100": "--frames 10"}).items():
        command = command.replace(small, large)
    return command


def as_run(command):
    for start, quick in QUICK.items():
        if command.startswith(start):
            return quick(command)
    return command


def reason_not_to_run(command, printed):
    """Why, or "". A study that a document before has printed (`printed`) is the same in each."""
    if command.startswith("make -C share/studies") and command in printed:
        return "was printed before"
    if command.startswith("export PATH="):
        return "the tools are on the PATH"
    for start, reason in NOT_HERE.items():
        if command.startswith(start):
            return reason
    return "is a form" if PLACEHOLDER.search(command) and not command.startswith(PYTHON) else ""


def run(command, folder, environment):
    return subprocess.run(["bash", "-o", "pipefail", "-c", command], cwd=folder, env=environment, stdin=subprocess.DEVNULL,
                          capture_output=True, text=True, errors="replace")


def write_solver(folder, bin_folder, settings):
    """A graincrack-solve in `folder` with one thread and these settings, unless flags or --config say otherwise."""
    tests = ("uniaxial", "triaxial", "brazilian", "tension", "bend")
    sections = ["[program]\nthreads = 1\n"] + ["\n".join([f"[{test}]", "threads = 1", *settings, ""]) for test in tests]
    (folder / "solve.toml").write_text("".join(sections))
    solver = folder / "graincrack-solve"
    solver.write_text(f"""#!/bin/sh
case " $* " in *" --config "*) ;; *) set -- --config {folder}/solve.toml "$@" ;; esac
exec {bin_folder}/graincrack-solve "$@"
""")
    solver.chmod(0o755)


def check(path, bin_folder, whole_tests, printed):
    """The number of commands that ran, and what failed, of one document."""
    environment = {k: v for k, v in os.environ.items() if not k.startswith("GRAINCRACK_") and not k.startswith("MAKE")}
    ran, failed = 0, []
    with tempfile.TemporaryDirectory(prefix="graincrack-documents-") as folder, tempfile.TemporaryDirectory() as own:
        write_solver(pathlib.Path(own), bin_folder, [] if whole_tests else ["rate-tolerance = 0.04"])
        for program in ("graincrack-mesh", "graincrack-post"):
            os.symlink(bin_folder / program, pathlib.Path(own, program))
        environment |= {"PATH": f"{own}:{os.environ['PATH']}", "GRAINCRACK_BIN": own, "PYTHONPATH": str(TOP / "share" / "python"), "LC_ALL": "C.UTF-8"}
        for name in ("share", "tests"):
            os.symlink(TOP / name, pathlib.Path(folder, name))
        for program in (TOP / "share" / "programs").glob("*.toml"):
            os.symlink(program, pathlib.Path(folder, program.name))
        commands = list(commands_of(path))
        if path.suffix == ".md":
            commands = [*inline_commands(path.read_text()), *commands, *python_blocks(path.read_text())]
        if not any(command == INIT for command in commands) and any("my-rock" in command for command in commands):
            run(INIT + "; " + ENTER_VALUES, folder, environment)
        for command in commands:
            reason = reason_not_to_run(command, printed)
            printed.add(command)
            if reason:
                print(f"  not run: {command}: {reason}")
                continue
            called = as_run(command if whole_tests else with_larger_grains(command, path.name))
            start = time.monotonic()
            result = run(called, folder, environment)
            took = time.monotonic() - start
            if command == INIT:
                run(ENTER_VALUES, folder, environment)
            for call, stand_in in STAND_INS.items():
                if command.startswith(call):
                    run(stand_in, folder, environment)
            ran += 1
            print(f"  {'ran' if result.returncode == 0 else 'FAILED'}, {took:.1f} s: {called}", flush=True)
            if result.returncode != 0:
                failed.append(f"{path.name}: {command}: exit code {result.returncode}\n{result.stderr[-2000:]}")
    return ran, failed


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("bin")
    parser.add_argument("--whole-tests", action="store_true")
    parser.add_argument("--only", metavar="NAME", help="one document, as tutorial.md")
    options = parser.parse_args()
    documents = [TOP / "README.md", TOP / "CONTRIBUTING.md", *sorted((TOP / "share" / "doc").glob("*.md")),
                 *sorted((TOP / "share" / "studies").glob("*/README.md")), *sorted((TOP / "share" / "programs").glob("*.toml"))]
    documents = [path for path in documents if options.only in (None, path.name)]
    total, failures, printed = 0, [], set()
    for path in documents:
        print(path.relative_to(TOP))
        ran, failed = check(path, pathlib.Path(options.bin).resolve(), options.whole_tests, printed)
        total += ran
        failures += failed
    print(f"{total} commands ran, {len(failures)} failed")
    for failure in failures:
        print(failure, file=sys.stderr)
    # README alone has more than ten: fewer would mean that the commands were not found.
    return 1 if failures or total < (1 if options.only else 20) else 0


if __name__ == "__main__":
    sys.exit(main())
