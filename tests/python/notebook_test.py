"""Executes share/python/examples/granite.ipynb on small specimens, and looks at the outputs that are stored in it.

Usage: notebook_test.py BIN PYTHON. The cells run in a kernel where nbclient and ipykernel are installed, else in this process. Their specimens and
the specimens and numbers of tests of the calibration are smaller here, so that it may end otherwise; it is a calibration with all steps nevertheless.
"""

import ast
import importlib.util
import json
import os
import sys
import tempfile
import unittest
import warnings
from pathlib import Path

BIN, PYTHON = (Path(argument).resolve() for argument in sys.argv[1:3])
sys.path.insert(0, str(PYTHON))
os.environ |= {"GRAINCRACK_BIN": str(BIN), "PYTHONPATH": str(PYTHON), "PYDEVD_DISABLE_FILE_VALIDATION": "1"}

import graincrack  # noqa: E402

NOTEBOOK = PYTHON / "examples" / "granite.ipynb"
SMALL = 'set={"grains": 60, "disc_grains": 60, "elastic_specimens": 1, "confirmation_discs": 2, "confirmation_rectangles": 1, ' \
        '"predicted_specimens": 1, "corrections": 0, "zooms": 0}'
SMALLER = {'width="25mm", height="50mm"': 'width="10mm", height="20mm"', 'diameter="34mm"': 'diameter="14mm"', "0.006": "0.02", "range(1, 7)": "range(1, 4)",
           'calibrate("my-granite.toml")': f'calibrate("my-granite.toml", {SMALL})'}
# What the cells show, by its type.
SHOWN = ["image/png", "image/png", "text/html", "text/markdown", "text/html", "image/png", "text/plain"]


def sources(notebook):
    return ["".join(cell["source"]) for cell in notebook["cells"] if cell["cell_type"] == "code"]


def in_a_kernel(texts):
    """What each cell shows at its end, by type."""
    import nbformat
    from nbclient import NotebookClient

    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(text) for text in texts])
    NotebookClient(notebook, timeout=300, kernel_name="python3").execute()
    return [dict(cell.outputs[-1].data) for cell in notebook.cells]


def in_this_process(texts):
    warnings.simplefilter("ignore", graincrack.GraincrackWarning)  # so few crystals are no rock
    names, shown = {}, []
    for text in texts:
        *statements, last = ast.parse(text).body
        exec(compile(ast.Module(statements, []), "cell", "exec"), names)
        value = eval(compile(ast.Expression(last.value), "cell", "eval"), names)
        kinds = {"image/png": "_repr_png_", "text/html": "_repr_html_", "text/markdown": "_repr_markdown_", "text/plain": "__repr__"}
        made = {kind: getattr(value, method)() for kind, method in kinds.items() if hasattr(value, method)}
        shown.append({kind: each for kind, each in made.items() if each is not None})
    return shown


class Granite(unittest.TestCase):
    def test_its_cells_run(self):
        texts = sources(json.loads(NOTEBOOK.read_text()))
        self.assertEqual(len(texts), 7)
        for usual, small in SMALLER.items():
            self.assertIn(usual, "".join(texts))
            texts = [text.replace(usual, small) for text in texts]
        has_kernel = all(map(importlib.util.find_spec, ("nbclient", "ipykernel")))
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            shown = (in_a_kernel if has_kernel else in_this_process)(texts)
            ends = graincrack.Calibration("graincrack-results/calibrate/my-granite").end
            self.assertIn("</html>", Path("my-granite.html").read_text())
            os.chdir("/")
        for kind, each in zip(SHOWN, shown):
            self.assertIn(kind, each)
        self.assertIn("UCS", shown[4]["text/html"] + shown[3]["text/markdown"])
        self.assertIn(ends, ("calibrated", "not reached", "contradictory", "undecided"))

    def test_its_outputs_are_those_of_this_version(self):
        notebook = json.loads(NOTEBOOK.read_text())
        self.assertEqual(notebook["metadata"]["graincrack"]["version"], graincrack.__version__)
        for kind, cell in zip(SHOWN, (cell for cell in notebook["cells"] if cell["cell_type"] == "code")):
            self.assertIn(kind, cell["outputs"][-1]["data"])
            self.assertNotIn("error", [output["output_type"] for output in cell["outputs"]])
            told = json.dumps([output.get("text") or {**output["data"], "image/png": ""} for output in cell["outputs"]])
            self.assertNotRegex(told, r'[" (\']/(tmp|home|root|work|usr)/')  # of the machine on which it was executed


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
