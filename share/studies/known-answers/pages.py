#!/usr/bin/python3
"""Usage: pages.py [--tests FOLDER] --rows FOLDER --doc FOLDER [PROBLEM...]
       pages.py --index FILE

Writes the pages of problems.toml, all or those named, to the folder --doc. With --tests it first runs their tests by the programs in that
folder; their rows and curves go to the folder --rows. Without --tests a page whose tests left no rows there stays as it is. --index writes the
table of problems anew into the document FILE.
"""
import argparse
import csv
import os
import pathlib
import re
import subprocess
import sys
import tomllib

HERE = pathlib.Path(__file__).resolve().parent


def run_tests(problem, tests, rows):
    rows.mkdir(parents=True, exist_ok=True)
    command = [str(tests / problem["program"]), "--gtest_brief=1", "--gtest_filter=" + ":".join(problem["tests"])]
    done = subprocess.run(command, env={**os.environ, "GRAINCRACK_VERIFICATION": str(rows)}, stdout=subprocess.PIPE, text=True)
    if done.returncode != 0: sys.exit(f"{done.stdout}pages: {' '.join(command)} failed")


def rows_of(problem, folder):
    """Rows of the problem's tests: case, measured, expected, error, tolerance, source."""
    found = []
    for test in problem["tests"]:
        path = folder / f"{test}.tsv"
        if path.exists():
            for row in csv.reader(path.open(), delimiter="\t", quoting=csv.QUOTE_NONE):
                found.append([row[0].split(": ", 1)[1], *row[1:5], row[7]])
    return [row for row in found if any(row[0].startswith(start) for start in problem.get("rows", [""]))]


def curves_of(folder, name):
    """Columns of a curve by their names."""
    with (folder / f"{name}.csv").open() as file:
        lines = list(csv.reader(file))
    return {head: [float(line[i]) for line in lines[1:]] for i, head in enumerate(lines[0])}


def page(name, problem, rows):
    common = os.path.commonprefix([row[0] for row in rows]) if len(rows) > 1 else ""
    common = common[:common.rfind(", ") + 2] if ", " in common else ""
    lines = [f"# {problem['title']}", "", problem["statement"].strip(), "", f"![{problem['title']}]({name}.png)", "", problem["caption"].strip(), "",
             "## Closed form", "", problem["theory"].strip(), "", f"Source: {problem['source'].strip()}", "", "## Model", "", problem["model"].strip(), "",
             "## Computed and exact", "", "| case | computed | exact | error | tolerance |", "|---|---|---|---|---|"]
    for row in rows:
        lines.append(f"| {row[0][len(common):]} | " + " | ".join(row[1:5]).replace("|  ", "| ") + " |")
    lines += ["", problem["tolerance"].strip(), "", "## Command", "", "```sh", f"make -C share/studies/known-answers {name}", "```", "",
              f"runs `{problem['program']}` ({', '.join(f'`{test}`' for test in problem['tests'])}) and writes this page.", "",
              "## What it would miss", "", problem["misses"].strip(), ""]
    return "\n".join(lines)


def table(problems, link):
    """Problems with the first formula of each that stands in a line of its own, without spaces that TeX does not need."""
    lines = ["| problem | closed form | source |", "|---|---|---|"]
    for name, problem in problems.items():
        formula = re.search(r"\$\$(.*?)[.,;]?\$\$", problem["theory"], re.S)[1]
        formula = re.sub(r"(?<![A-Za-z])\s+|\s+(?![A-Za-z])", "", formula)
        lines.append(f"| {link(name, problem['title'])} | ${formula}$ | {problem['source'].strip().rstrip('.')} |")
    return "\n".join(lines) + "\n"


def write_index(problems, document):
    text = document.read_text()
    document.write_text(re.sub(r"(^\|.*\n)+", lambda _: table(problems, lambda name, title: f"{title}, `{name}`"), text, count=1, flags=re.M))


def draw(name, path, rows, folder):
    """The figure of a page; an index is made where matplotlib is not installed too."""
    sys.dont_write_bytecode = True
    import matplotlib
    matplotlib.use("Agg")
    import figures
    figures.draw(name, path, rows, lambda curve: curves_of(folder, curve))


def main():
    parser = argparse.ArgumentParser(add_help=False)
    parser.add_argument("-h", "--help", action="store_true")
    parser.add_argument("--tests", type=pathlib.Path)
    parser.add_argument("--rows", type=pathlib.Path)
    parser.add_argument("--doc", type=pathlib.Path)
    parser.add_argument("--index", type=pathlib.Path)
    parser.add_argument("problems", nargs="*")
    options = parser.parse_args()
    if options.help or not options.index and not (options.rows and options.doc):
        print(__doc__.strip(), file=sys.stdout if options.help else sys.stderr)
        return 0 if options.help else 2
    problems = tomllib.loads((HERE / "problems.toml").read_text())
    if options.index:
        write_index(problems, options.index)
        return 0
    for name in options.problems or problems:
        if name not in problems: sys.exit(f"pages: {name}: problems.toml has {', '.join(problems)}")
        problem = problems[name]
        if options.tests: run_tests(problem, options.tests, options.rows)
        rows = rows_of(problem, options.rows)
        if not rows and name in options.problems: sys.exit(f"pages: no rows of {problem['tests']}; run them by --tests, or by tests/run --all")
        if not rows: continue
        options.doc.mkdir(parents=True, exist_ok=True)
        draw(name, options.doc / f"{name}.png", rows, options.rows)
        (options.doc / f"{name}.md").write_text(page(name, problem, rows))
        print(options.doc / f"{name}.md")
    head = "# Problems with known answers\n\nEach page states a problem and its closed form, shows both and says what the comparison would miss.\n\n"
    (options.doc / "index.md").write_text(head + table(problems, lambda name, title: f"[{title}]({name}.md)"))
    return 0


if __name__ == "__main__":
    sys.exit(main())
