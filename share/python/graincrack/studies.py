"""The calibration of a rock, which is a study: make with the programs of the package."""

from __future__ import annotations

import json
import re
from pathlib import Path

from . import functions, programs
from .files import GraincrackError, Table


class Calibration:
    """What a calibration found. It stands for its material: `uniaxial(specimen, material=found)`."""

    def __init__(self, folder: str | Path):
        self.folder = Path(folder)  #: with all files of the calibration
        try:
            #: outcome.json: values, targets, predictions and caveats (share/doc/tables.md, calibrate)
            self.outcome = json.loads((self.folder / "outcome.json").read_text(encoding="utf-8"))
        except FileNotFoundError:
            raise GraincrackError(f"{folder}: no outcome.json; graincrack.calibrate makes it") from None
        self.rock, self.end = self.outcome["rock"], self.outcome["state"]
        files = self.outcome["files"]
        if self.end == "running":
            raise GraincrackError(f"{folder}: has not ended; graincrack.calibrate resumes it")
        self.report = (self.folder / files["report"]).read_text(encoding="utf-8")  #: Markdown, which a notebook shows
        #: file of the material: with the values that were found, or the nearest to the targets; None: there are none
        self.material = self.folder / files["material"] if "material" in files else None
        #: strength, moduli, identify, draws …
        self.tables = {path.stem: Table(path) for path in sorted(self.folder.glob("*.tsv")) if path.stat().st_size > 0}

    @property
    def fitted(self) -> dict[str, dict]:
        """What each fitted target is in the laboratory, and the mean of new specimens with its interval (SI)."""
        return {name: row for name, row in self.outcome["targets"].items() if row["use"] == "fit"}

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
    variables = {"ROCK": str(rock), "OUT": str(out.absolute()), "BIN": str(programs.bin_folder())}
    settings = {key: functions.text_of(value) for key, value in (set or {}).items()}
    for name, text in [*variables.items(), *settings.items()]:
        if re.search(r"[\s$`'\"#\\;&|<>()*?]", text):
            raise GraincrackError(f"{name}: {text!r}: make takes no name with a space or one of $ ` ' \" # \\ ; & | < > ( ) * ?; "
                                  "rename it, or its folder")
    if settings:
        variables["SET"] = " ".join(f"{key}={text}" for key, text in settings.items())
    make = ["make", "-s", "--no-print-directory", f"-j{jobs or programs.processors()}", "-C", _studies(), "calibrate",
            *(f"{name}={text}" for name, text in variables.items())]
    outcome = folder / "outcome.json"
    outcome.unlink(missing_ok=True)
    try:
        programs.run(["sh", "-c", 'exec "$@" >&2', "calibrate", *make], has_events=False, quiet=quiet,
                     resume=lambda _: "; the same call resumes the calibration, and no test is repeated")
    except GraincrackError:
        if not outcome.exists() or json.loads(outcome.read_text(encoding="utf-8"))["state"] == "running":
            raise  # other ends than "calibrated" are errors of the study too
    return Calibration(folder)


def _studies() -> Path:
    """The folder of the studies, of the installation or of the source tree."""
    top = programs.bin_folder().parent
    for place in (top / "share" / "graincrack" / "studies", Path(__file__).resolve().parents[2] / "studies"):
        if (place / "Makefile").exists():
            return place
    raise GraincrackError(f"{top}/share/graincrack/studies: not there; calibrations need Graincrack with its studies")
