#!/usr/bin/python3
"""Compares what the programs describe with what their help shows, and with what they take.

Usage: describe_test.py BIN, the folder of the tools.
"""
import json
import pathlib
import re
import subprocess
import sys
import unittest

BIN = pathlib.Path(sys.argv.pop(1)).resolve()
PROGRAMS = ["graincrack-mesh", "graincrack-solve", "graincrack-post"]


def run(*call):
    return subprocess.run([BIN / call[0], *call[1:]], capture_output=True, text=True)


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


if __name__ == "__main__":
    unittest.main()
