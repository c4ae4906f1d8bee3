"""The calibration of a rock, which is a study: make with the programs of the package."""

from __future__ import annotations

import re
import time
from pathlib import Path

from . import functions, programs
from .files import GraincrackError, Table


class Calibration:
    """What a calibration found. It stands for its material: `uniaxial(specimen, material=found)`."""

    def __init__(self, folder: str | Path):
        self.folder = Path(folder)  #: with all files of the calibration
        self.report = (self.folder / "report.md").read_text(encoding="utf-8")  #: Markdown, which a notebook shows
        #: the word of its end: "calibrated", "not reached", "contradictory" or "undecided"
        self.rock, _, self.end = self.report.partition("\n")[0].removeprefix("# ").rpartition(": ")
        #: file of the material: with the values that were found, or the nearest to the targets
        self.material = self.folder / ("calibrated.toml" if self.end == "calibrated" else "nearest.toml")
        #: strength, moduli, identify, draws …
        self.tables = {path.stem: Table(path) for path in sorted(self.folder.glob("*.tsv")) if path.stat().st_size > 0}

    @property
    def fitted(self) -> dict[str, str]:
        """What each fitted property was fitted to, and what new specimens have."""
        table = self.material.read_text(encoding="utf-8").partition("[fitted]")[2].partition("\n[")[0]
        return dict(re.findall(r'^(\w+) = "(.*)"', table, re.MULTILINE))

    def __fspath__(self) -> str:
        return str(self.material)

    def __repr__(self) -> str:
        return f"Calibration of {self.rock}: {self.end}; {self.material}"

    def _repr_markdown_(self) -> str:
        return self.report.partition("\n## Values")[0]


def calibrate(material, *, out=None, jobs: int | None = None, set: dict | None = None, quiet: bool | None = None) -> Calibration:
    """Finds the contact values with which specimens have the strengths that the laboratory measured.

    material: a file or a name, with the values of the laboratory.
    out: the folder below which results go, in calibrate/ROCK; default: graincrack.folder. A calibration that is there is resumed.
    jobs: tests at a time; default: as many as there are processors.
    set: other values for keys of [study], as {"zooms": 2} (share/doc/tables.md, calibrate).

    The calibration may end otherwise than "calibrated": its `end` says how, its `report` what to do next. A rock of a known kind
    takes some minutes.
    """
    rock = functions.text_of(material)
    out = Path(programs.settings().folder if out is None else out)
    folder = out / "calibrate" / Path(rock).name.removesuffix(".toml")
    rock = Path(rock).absolute() if Path(rock).is_file() else rock
    variables = [f"ROCK={rock}", f"OUT={out.absolute()}", f"BIN={programs.bin_folder()}"]
    if set:
        variables.append("SET=" + " ".join(f"{key}={functions.text_of(value)}" for key, value in set.items()))
    make = ["make", "-s", "--no-print-directory", f"-j{jobs or programs.processors()}", "-C", _studies(), "calibrate", *variables]
    begin = time.time() - 1
    try:
        programs.run(["sh", "-c", 'exec "$@" >&2', "calibrate", *make], quiet=quiet,
                     resume=lambda: "; the same call resumes the calibration, and no test is repeated")
    except GraincrackError:
        report = folder / "report.md"
        if (folder / "wanted.tsv").exists() or not report.exists() or report.stat().st_mtime < begin:
            raise  # other ends than "calibrated" are errors of the study too, which leave a report
    return Calibration(folder)


def _studies() -> Path:
    """The folder of the studies, of the installation or of the source tree."""
    top = programs.bin_folder().parent
    for place in (top / "share" / "graincrack" / "studies", Path(__file__).resolve().parents[2] / "studies"):
        if (place / "Makefile").exists():
            return place
    raise GraincrackError(f"{top}/share/graincrack/studies: not there; calibrations need Graincrack with its studies")
