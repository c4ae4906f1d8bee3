#!/usr/bin/python3
"""Compares what the programs describe with what their help shows, and with what they take.

Usage: describe_test.py BIN, the folder of the tools.
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import h5py

BIN = pathlib.Path(sys.argv.pop(1)).resolve()
PROGRAMS = ["graincrack-mesh", "graincrack-solve", "graincrack-post"]


# A test so small and fast has no peak but one of 1 %.
QUICK = "--material augig-granite --mass-scaling none --rate 400mm/s --max-strain 0.03 --peak-drop 0.01 --threads 1 --quiet".split()
MATERIAL = ["--material", "augig-granite"]


def run(*call, folder=None):
    return subprocess.run([BIN / call[0], *call[1:]], capture_output=True, text=True, cwd=folder)


def description(program):
    return json.loads(run(program, "--describe").stdout)


def commands(own, path=()):
    """The program and each of its commands, with what is typed to call it."""
    yield path, own
    for command in own["commands"]:
        yield from commands(command, (*path, command["name"]))


def shown(program, path, titles):
    """The options below these titles of --help-all, each as one line with single spaces."""
    texts, here = [], False
    for line in run(program, *path, "--help-all").stdout.splitlines():
        if not line.startswith(" "):
            here = line.rstrip(":") in titles if line.endswith(":") else here and line == ""
        elif here and not line.startswith("   "):
            texts.append(line)
        elif here:
            texts[-1] += line
    return sorted(" ".join(text.split()) for text in texts)


def entry(option):
    """An option as help shows it, but for the type of its value, which is TYPE."""
    name = option["name"] if "positional" in option else "--" + option["name"]
    text = f"-{option['short']},{name}" if "short" in option else name
    text += "" if option["type"] == "flag" else " TYPE"
    text += " REQUIRED" if "required" in option else f" = {option['default']}" if "default" in option else ""
    return " ".join(f"{text}{' ...' if 'many' in option else ''} {option['meaning']}".split())


def bounds(option):
    """The bounds of a pure number, as help shows them."""
    pair = (f"{option['minimum']:.4g}", f"{option['maximum']:.4g}")
    return "above {} and at most {}".format(*pair) if "exclusive_minimum" in option else "from {} to {}".format(*pair)


class Description(unittest.TestCase):
    def test_has_the_options_of_help_and_no_others(self):
        for program in PROGRAMS:
            own = description(program)
            self.assertEqual((own["program"], own["schema"]), (program, 1))
            for path, command in commands(own):
                call = f"{program} {' '.join(path)}"
                told = command["options"] + ([] if path == () else own["options"][:2])  # --help and --help-all
                texts = shown(program, path, ("Positionals", "Options"))
                self.assertEqual([re.sub(r"^((?:-\w,)?--[\w-]+|\w+) [^ ]+", r"\1", text) for text in texts],
                                 [re.sub(r"^((?:-\w,)?--[\w-]+|\w+) [^ ]+", r"\1", text) for text in sorted(map(entry, told))], call)
                self.assertEqual(shown(program, path, ("Subcommands",)),
                                 sorted(f"{sub['name']} {sub['description']}" for sub in command["commands"]), call)

    def test_has_the_bounds_and_words_of_help(self):
        found = 0
        for program in PROGRAMS:
            for path, command in commands(description(program)):
                texts = " ".join(shown(program, path, ("Positionals", "Options")))
                for option in command["options"]:
                    if option["type"] == "choice":
                        self.assertIn(f"--{option['name']} {'|'.join(option['choices'])}", texts)
                    if option.get("unit") == "1" and option["maximum"] <= 10:
                        found += 1
                        self.assertIn(f"[{bounds(option)}", option["meaning"])
        self.assertGreater(found, 50)

    def test_is_what_is_refused(self):
        found = 0
        for program, name in (("graincrack-mesh", "disc"), ("graincrack-solve", "uniaxial")):
            command = next(each for path, each in commands(description(program)) if path == (name,))
            for option in command["options"]:
                for end, beyond in (("minimum", -1), ("maximum", 1)):
                    if end not in option:
                        continue
                    found += 1
                    bound = option[end]
                    outside = bound + beyond * (1 if option["type"] == "integer" else 1e-6 * (1 + abs(bound)))
                    takes = {bound: end == "minimum" and "exclusive_minimum" in option, outside: True}
                    for value, is_refused in takes.items():
                        done = run(program, name, f"--{option['name']}={value!r}", "--print-config")
                        self.assertEqual(done.returncode, 2 if is_refused else 0, f"{option['name']} {value}: {done.stderr}")
                        self.assertEqual("--" + option["name"] in done.stderr, is_refused, done.stderr)
        self.assertGreater(found, 60)


class Files(unittest.TestCase):
    maxDiff = None
    """What is described of tables and datasets is what a specimen, a run and the tables of the run have."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        for call in (["graincrack-mesh", "rectangle", "--width=20mm", "--height=40mm", "--edge=5mm", "-o", "specimen.h5"],
                     ["graincrack-solve", "uniaxial", "specimen.h5", "-o", "uniaxial.h5", *QUICK],
                     ["graincrack-solve", "triaxial", "specimen.h5", "--confining-pressure=1MPa", "-o", "triaxial.h5", *QUICK],
                     ["graincrack-post", "cracks", "uniaxial.h5", "-o", "cracks"]):
            done = run(*call, folder=cls.folder.name)
            assert done.returncode == 0, done.stderr

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_datasets(self):
        for program, name in (("graincrack-mesh", "specimen.h5"), ("graincrack-solve", "uniaxial.h5")):
            told = {dataset["path"]: (dataset["unit"], dataset["meaning"]) for dataset in description(program)["datasets"]}
            there = {}

            with h5py.File(pathlib.Path(self.folder.name) / name) as file:
                for group in {path.rpartition("/")[0] for path in told}:
                    for path, item in file[group.replace("NNNN", "0000")].items():
                        there[f"{group}/{path}"] = item.attrs["unit"].decode(), item.attrs["description"].decode()
                self.assertEqual(set(file) - {"VTKHDF", "run", "provenance", "specimen"}, {path.split("/")[1] for path in told})
            for path in ("/grains/crystal", "/contacts/strength_factor", "/contacts/class", "/grains/axis", "/history/temperature"):
                told.pop(path, None)  # of other specimens and runs
            self.assertEqual(there, told, program)

    def test_tables(self):
        tables = {(table["command"], table.get("file")): {column["name"] for column in table["columns"]}
                  for table in description("graincrack-post")["tables"]}
        tables["history", None].remove("temperature_K")  # of runs that have one
        for command, options in (("history", ["uniaxial.h5"]), ("strength", ["uniaxial.h5", "--all-columns"]),
                                 ("strength --summary", ["uniaxial.h5"]), ("moduli", ["uniaxial.h5", "--all-columns"]),
                                 ("envelope", ["uniaxial.h5", "triaxial.h5"]), ("properties", ["uniaxial.h5", *MATERIAL]), ("kind", []),
                                 ("kind --rocks", []), ("fpz", MATERIAL), ("classes", ["uniaxial.h5"])):
            done = run("graincrack-post", *command.split(), *options, "--format=tsv", folder=self.folder.name)
            self.assertEqual(set(done.stdout.split("\n")[0].split("\t")), tables[command, None], command + done.stderr)
        for file in pathlib.Path(self.folder.name, "cracks").glob("*.tsv"):
            names = file.read_text().split("\n")[0].replace("rock-rock", "CLASS").split("\t")
            self.assertEqual(set(names), tables[("classes", None) if file.name == "classes.tsv" else ("cracks", file.name)], file.name)

    def test_units_of_columns(self):
        columns = {column["name"]: column["unit"] for table in description("graincrack-post")["tables"] for column in table["columns"]}
        for name, unit in {"strain_at_peak": "", "specimens_for_3_percent": "", "drop_percent": "percent", "moment_N_m": "N_m", "x_m": "m",
                           "tensile_share_within_30_deg": "", "seed_cohesion_low_MPa": "MPa", "platen_speed_m/s": "m/s",
                           "time_damaged_10_s": "s", "seed_cohesion_deviation_MPa": "MPa"}.items():
            self.assertEqual(columns[name], unit, name)


if __name__ == "__main__":
    unittest.main()
