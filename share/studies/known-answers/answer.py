#!/usr/bin/python3 -B
"""Usage: answer.py [--links] DOCUMENT

Writes the table of problems with known answers anew into a document; with --links it is a page of its own, whose problems are links.

Each problem is a script NAME.py beside this module, which has what they share. The docstring of a script is its front matter, in TOML: title;
section in the table of all checks; program and tests in C++; statement, caption, theory, source, model, tolerance and misses, the texts of its
page. sketch(axes) draws the problem, beside the errors; or figure(sketch, plot, curves) draws both. Where a script has comparisons(folder), that
makes specimens and loading programs in the folder, runs the three programs and gives rows of compare().
"""
import argparse
import ast
import csv
import math
import os
import pathlib
import re
import subprocess
import sys
import tomllib
import warnings

HERE = pathlib.Path(__file__).resolve().parent
RESULTS = HERE.parent / "results" / "known-answers"
VERIFICATION = (HERE / "../../doc/verification.md").resolve()
GRAIN, EXACT, COMPUTED = "#d9d4c7", "black", ["#c0392b", "#2471a3", "#1e8449", "#b9770e", "#6c3483"]
CASE, MEASURED, EXPECTED, ERROR, TOLERANCE, VERDICT = 0, 1, 2, 3, 4, 6  # columns of rows, as tests/support/verify.cpp writes them
sys.path.insert(0, str((HERE / "../../python").resolve()))


# --- a script ------------------------------------------------------------------------------------------------------------


def main(script):
    """Runs a problem, by the globals of its script, and ends the process: 1 where a comparison or a test fails."""
    name, problem = pathlib.Path(script["__file__"]).stem, tomllib.loads(script["__doc__"])
    parser = argparse.ArgumentParser(description=f"{problem['title']}: compares what is computed with what is exact, and writes page and picture.")
    parser.add_argument("--tests", type=pathlib.Path, default=(HERE / "../../../build/tests").resolve(), help="folder of the test programs")
    parser.add_argument("--no-tests", action="store_true", help="takes the rows that tests have left in the folder --rows")
    parser.add_argument("--rows", type=pathlib.Path, default=RESULTS, help="folder of rows and curves")
    parser.add_argument("--doc", type=pathlib.Path, default=RESULTS / "pages", help="folder of the page")
    options = parser.parse_args()
    for folder in (options.rows / name, options.doc): folder.mkdir(parents=True, exist_ok=True)
    has_passed = options.no_tests or run_tests(problem, options.tests, options.rows)
    if "comparisons" in script: write_rows(options.rows / f"{name}.py.tsv", problem["section"], script["comparisons"](options.rows / name))
    rows = rows_of(name, problem, options.rows)
    if not rows: sys.exit(f"{name}: {options.rows} has no rows of {', '.join(problem['tests'])}; leave out --no-tests, or run tests/run --all")
    for row in rows:
        print(f"{row[VERDICT]:4}  {row[CASE]}: {row[MEASURED]}, exact {row[EXPECTED]}, error {row[ERROR]}, tolerance {row[TOLERANCE] or 'as exact'}")
    draw(script, options.doc / f"{name}.png", rows, lambda curve: read_curves(options.rows / f"{curve}.csv"))
    (options.doc / f"{name}.md").write_text(page(name, problem, rows, "comparisons" in script))
    print(options.doc / f"{name}.md")
    sys.exit(not has_passed or any(row[VERDICT] != "pass" for row in rows))


def run_tests(problem, tests, rows):
    """Whether the tests of C++ pass, which write rows and curves; what they print is shown where they fail."""
    command = [str(tests / problem["program"]), "--gtest_brief=1", "--gtest_filter=" + ":".join(problem["tests"])]
    if not os.access(command[0], os.X_OK): sys.exit(f"{command[0]} is not there; build it, or name its folder by --tests")
    for test in problem["tests"]: (rows / f"{test}.tsv").unlink(missing_ok=True)
    done = subprocess.run(command, env={**os.environ, "GRAINCRACK_VERIFICATION": str(rows)}, stdout=subprocess.PIPE, text=True)
    has_passed = done.returncode == 0 and all((rows / f"{test}.tsv").exists() for test in problem["tests"])
    if not has_passed: print(f"{done.stdout}{' '.join(command)} failed, or does not have all these tests", file=sys.stderr)
    return has_passed


def compare(case, computed, exact, tolerance, source, scale=0):
    """A row; the error is relative to the scale, which is the exact value unless given. What is not a number fails."""
    error = abs(computed - exact) / abs(scale or exact)
    return [case, f"{computed:.6g}", f"{exact:.6g}", f"{error:.1e}" if error >= 1e-12 else "< 1e-12", f"{tolerance:g}", "1",
            "pass" if error <= tolerance else "FAIL", source]


def write_rows(path, section, rows):
    path.write_text("".join("\t".join([f"{section}: {row[CASE]}", *row[1:]]) + "\n" for row in rows))


def rows_of(name, problem, folder):
    """Rows of the problem's tests and of its script."""
    found = []
    for path in (folder / f"{source}.tsv" for source in [*problem["tests"], f"{name}.py"]):
        if path.exists():
            found += [[row[CASE].split(": ", 1)[1], *row[1:]] for row in csv.reader(path.open(), delimiter="\t", quoting=csv.QUOTE_NONE)]
    return [row for row in found if row[CASE].startswith(tuple(problem.get("rows", [""])))]


def write_curves(path, columns):
    with path.open("w", newline="") as file:
        rows = csv.writer(file, lineterminator="\n")
        rows.writerow(columns)
        rows.writerows([f"{value:.6g}" for value in row] for row in zip(*columns.values()))


def read_curves(path):
    """Columns of a curve by their names."""
    with path.open() as file:
        lines = list(csv.reader(file))
    return {head: [float(line[i]) for line in lines[1:]] for i, head in enumerate(lines[0])}


# --- specimens and runs of the three programs ------------------------------------------------------------------------------


def block(name, across, up, left, bottom, width, height):
    """A rectangle of cells of four triangles: its name, points (m) and triangles."""
    points = [(left + width * i / across, bottom + height * j / up) for j in range(up + 1) for i in range(across + 1)]
    triangles = []
    for j in range(up):
        for i in range(across):
            first = j * (across + 1) + i
            corners = [first, first + 1, first + across + 2, first + across + 1]
            triangles += [(a, b, len(points)) for a, b in zip(corners, corners[1:] + corners[:1])]
            points.append((left + width * (i + 0.5) / across, bottom + height * (j + 0.5) / up))
    return name, points, triangles


def without_warnings(function, *arguments, **options):
    """A call of the package, which warns of what no rock has: grains that do not touch, a test of two grains."""
    import graincrack
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", graincrack.GraincrackWarning)
        return function(*arguments, quiet=True, **options)


def specimen_of(path, blocks):
    """The specimen of a mesh in Gmsh's format 2.2. Blocks of one name are a grain, whose first word is its phase; grains that touch have contacts."""
    import graincrack
    names = {name: i + 1 for i, name in enumerate(dict.fromkeys(name for name, _, _ in blocks))}
    phases = {phase: i + 1 for i, phase in enumerate(dict.fromkeys(name.split()[0] for name in names))}
    nodes, elements = [], []
    for name, points, triangles in blocks:
        elements += [f"{len(elements) + k} 2 2 {phases[name.split()[0]]} {names[name]} {' '.join(str(len(nodes) + 1 + node) for node in triangle)}"
                     for k, triangle in enumerate(triangles, 1)]
        nodes += [f"{len(nodes) + k} {x:.12g} {y:.12g} 0" for k, (x, y) in enumerate(points, 1)]
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", len(phases), *(f'2 {i} "{phase}"' for phase, i in phases.items()),
             "$EndPhysicalNames", "$Nodes", len(nodes), *nodes, "$EndNodes", "$Elements", len(elements), *elements, "$EndElements", ""]
    path.with_suffix(".msh").write_text("\n".join(map(str, lines)))
    return without_warnings(graincrack.import_, path.with_suffix(".msh"), grain="entity", origin="0,0", output=path.with_suffix(".specimen.h5"))


def run_program(path, specimen, program, **options):
    """The run of a loading program, which is given as text; specimens are so small that threads would wait for each other."""
    import graincrack
    path.with_suffix(".toml").write_text(program)
    return graincrack.program(specimen, program=path.with_suffix(".toml"), output=path.with_suffix(".h5"), frames=0, threads=1,
                              discard_checkpoint=True, quiet=True, **options)


# --- pages ---------------------------------------------------------------------------------------------------------------


def page(name, problem, rows, has_programs):
    common = os.path.commonprefix([row[CASE] for row in rows]) if len(rows) > 1 else ""
    common = common[:common.rfind(", ") + 2] if ", " in common else ""
    caption = problem.get("caption", "Left: the problem. Right: errors of the cases of the table beside their tolerances.")
    lines = [f"# {problem['title']}", "", problem["statement"].strip(), "", f"![{problem['title']}]({name}.png)", "", caption.strip(), "",
             "## Closed form", "", problem["theory"].strip(), "", f"Source: {problem['source'].strip()}", "", "## Model", "", problem["model"].strip(), "",
             "## Computed and exact", "", "| case | computed | exact | error | tolerance |", "|---|---|---|---|---|"]
    for row in rows:
        lines.append(f"| {row[CASE][len(common):]} | " + " | ".join(row[MEASURED:TOLERANCE + 1]).replace("|  ", "| ") + " |")
    lines += ["", problem["tolerance"].strip(), "", "## Command", "", "```sh", f"make -C share/studies/known-answers {name}", "```", "",
              f"runs `{problem['program']}` ({', '.join(f'`{test}`' for test in problem['tests'])}){f' and the three programs, on what `{name}.py` makes,' * has_programs} "
              "and writes this page.", "", "## What it would miss", "", problem["misses"].strip(), ""]
    return "\n".join(lines)


def problems():
    """Front matter of all problems, in the order of the table in share/doc/verification.md; those that it does not have come last."""
    text = VERIFICATION.read_text()
    names = sorted(path.stem for path in HERE.glob("*.py") if path.stem != pathlib.Path(__file__).stem)
    names.sort(key=lambda name: text.find(f"`{name}` |") % len(text))
    return {name: tomllib.loads(ast.get_docstring(ast.parse((HERE / f"{name}.py").read_text()), clean=False)) for name in names}


def table(link):
    """Problems with the first formula of each that stands in a line of its own, without spaces that TeX does not need."""
    lines = ["| problem | closed form | source |", "|---|---|---|"]
    for name, problem in problems().items():
        formula = re.search(r"\$\$(.*?)[.,;]?\$\$", problem["theory"], re.S)[1]
        formula = re.sub(r"(?<![A-Za-z])\s+|\s+(?![A-Za-z])", "", formula)
        lines.append(f"| {link(name, problem['title'])} | ${formula}$ | {problem['source'].strip().rstrip('.')} |")
    return "\n".join(lines) + "\n"


def write_tables():
    arguments = [argument for argument in sys.argv[1:] if argument != "--links"]
    if len(arguments) != 1 or arguments[0].startswith("-"):
        print(__doc__.strip())
        return 0 if arguments in (["-h"], ["--help"]) else 2
    document = pathlib.Path(arguments[0])
    if "--links" in sys.argv:
        head = "# Problems with known answers\n\nEach page states a problem and its closed form, shows both and says what the comparison would miss.\n\n"
        document.write_text(head + table(lambda name, title: f"[{title}]({name}.md)"))
    else:
        made = table(lambda name, title: f"{title}, `{name}`")
        document.write_text(re.sub(r"(^\|.*\n)+", lambda _: made, document.read_text(), count=1, flags=re.M))
    return 0


# --- drawing: matplotlib is asked for where a picture is drawn, not by the table ---------------------------------------------


def draw(script, path, rows, curves):
    """A sketch on the left, computed and exact values on the right."""
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    plt.rcParams.update({"font.size": 9, "axes.spines.top": False, "axes.spines.right": False, "figure.dpi": 110})
    fig, (left, right) = plt.subplots(1, 2, figsize=(8.6, 3.4), width_ratios=[1, 1.7])
    left.set_aspect("equal")
    left.axis("off")
    if "figure" in script:
        script["figure"](left, right, curves)
    else:
        script["sketch"](left)
        errors(right, rows)
    fig.tight_layout()
    fig.savefig(path, metadata={"Software": None})


def errors(axes, rows):
    """Errors of cases beside their tolerances."""
    kept = [row for row in rows if row[TOLERANCE]]
    for i, row in enumerate(kept):
        error, tolerance = (float(row[column].replace("<", "").strip() or "nan") for column in (ERROR, TOLERANCE))
        axes.plot(i + 1, max(error, 1e-12), "o", color=COMPUTED[1], label="error" if i == 0 else None)
        axes.plot([i + 0.7, i + 1.3], [tolerance] * 2, color=EXACT, label="tolerance" if i == 0 else None)
    axes.set_yscale("log")
    axes.set_xticks(range(1, len(kept) + 1))
    axes.set_xlabel("case, in the order of the table")
    axes.set_ylabel("relative error")
    axes.legend(frameon=False)


def arrow(axes, start, end, text="", at=None, **options):
    axes.annotate("", end, start, arrowprops={"arrowstyle": "-|>", "color": "black", "shrinkA": 0, "shrinkB": 0, **options})
    if text: axes.text(*(at or end), text, ha="center", va="center")


def turned(points, angle, about=(0, 0)):
    c, s = math.cos(angle), math.sin(angle)
    return [(about[0] + c * (x - about[0]) - s * (y - about[1]), about[1] + s * (x - about[0]) + c * (y - about[1])) for x, y in points]


def box(axes, left, bottom, width, height, angle=0, about=(0, 0), **options):
    from matplotlib.patches import Polygon
    corners = [(left, bottom), (left + width, bottom), (left + width, bottom + height), (left, bottom + height)]
    axes.add_patch(Polygon(turned(corners, angle, about), facecolor=GRAIN, edgecolor="black", **options))


def view(axes, left, right, bottom, top):
    axes.set_xlim(left, right)
    axes.set_ylim(bottom, top)


if __name__ == "__main__":
    sys.exit(write_tables())
