"""Graincrack from Python: drives its programs, and reads what they write.

    import graincrack

    specimen = graincrack.disc(diameter="68mm", material="augig-granite-calibrated", seed=1)
    run = graincrack.brazilian(specimen, rate_tolerance=0.006)
    run.plot("cracks", frame="peak")                            # shown by a notebook; .path, .save("cracks.png")
    graincrack.strength(run)                                    # a Table; .frame_of_pandas()
    runs = graincrack.map(graincrack.brazilian, specimens)      # side by side, each test with one thread

There is a function for each command of graincrack-mesh (its result is a Specimen), of graincrack-solve (a Run) and of
graincrack-post (a Table, a file or a text), made from what the programs say of themselves: `help(graincrack.brazilian)` has the
options of `graincrack-solve brazilian` with their units. `dir(graincrack)` has all, and `dir(graincrack.plot)` those of plots.

A value is what stands on the command line, "4mm", or (4, "mm"), or a bare number in SI units; a list where an option may be given
again. A test has the material that its specimen was made with unless another is given. What a program refuses raises a
GraincrackError with its line; its warnings are Python's. Ctrl-C ends a test, whose checkpoint stays.

`output="run.h5"` names the file that is made, and replaces one that is there, as on the command line. Without it files have a new
name in `graincrack.folder`. `graincrack.quiet = True`, or `quiet=True` of a call, shows nothing of what programs tell.

To read files alone: `from graincrack import Run, Specimen, Table`; graincrack/files.py says how.
"""

from __future__ import annotations

from . import functions as _functions
from .files import SCHEMA_VERSION, FormatError, GraincrackError, GraincrackWarning, Group, MissingError, Output, Run, Specimen, Table
from .programs import map
from .studies import Calibration, calibrate

__all__ = ["Calibration", "FormatError", "GraincrackError", "GraincrackWarning", "Group", "MissingError", "Output", "Run",
           "SCHEMA_VERSION", "Specimen", "Table", "calibrate"]  # without map, which is Python's own word too
__version__ = "0.1.0"

folder = "graincrack-results"  #: where files without a name go: beside the notebook or script, where people look for them
quiet = False  #: whether nothing is shown of what programs tell; warnings and errors come nevertheless


def __getattr__(name: str):
    commands = {} if name.startswith("_") else _functions.commands()
    return commands[name] if name in commands else _functions.refuse("graincrack", commands, name)


def __dir__() -> list[str]:
    names = {*__all__, "folder", "map", "quiet"}
    try:
        return sorted(names | {*_functions.commands()})
    except GraincrackError:  # no programs are here: files can be read nevertheless
        return sorted(names)
