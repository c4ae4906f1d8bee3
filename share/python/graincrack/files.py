"""Reads what Graincrack writes: specimens, runs and tables.

    from graincrack import Run, Specimen, Table

    run = Run("uniaxial.h5")
    run.test, run["contact_cohesion"]              # attributes of /run, SI units
    run.history["axial_stress"]                    # a row of the history each, numpy arrays; tension is positive
    run.history.unit("axial_stress")               # "Pa"
    run.cracks["time_broken"]                      # a row for each contact point that failed
    run.frame("peak")["displacement"]              # also "last", a number from 0, or the nearest to a time: frame(time=0.01)
    run.specimen.nodes, run.specimen.elements      # positions (m) and triangles
    Table("strength.tsv")["peak_compressive_stress"]   # a column without its unit; numbers, or texts where not all are numbers

Files keep SI units and so do the arrays; a Table has the units of its columns. `frame_of_pandas()` of a history, the cracks or a
Table is a pandas DataFrame, if pandas is there. Needs numpy and h5py (Debian: python3-h5py). The format is described in
share/doc/file-format.md.
"""

from __future__ import annotations

import csv
import html
import io
import json
import re
import shutil
import sys
from functools import cached_property
from pathlib import Path
from typing import Iterator, Mapping

try:
    import h5py
    import numpy as np
except ImportError as error:
    raise ImportError(f"graincrack needs numpy and h5py, and {error.name} is not there; on Debian apt install python3-h5py") from None

SCHEMA_VERSION = 5  # as share/file/h5_file.hpp has it


class GraincrackError(Exception):
    """What this package raises, with a line that says what is wrong and what would be right."""

    def __init__(self, *arguments, exit_code: int | None = None):
        super().__init__(*arguments)
        self.exit_code = exit_code  #: of the program that refused, else None


class GraincrackWarning(UserWarning):
    """A warning of a program."""

    def __init__(self, text: str, *, code: str = ""):
        super().__init__(text)
        self.code = code  #: the program's short word for it, "few_crystals"


class MissingError(GraincrackError, KeyError):
    """A name, a frame or an attribute that a file does not have."""

    __str__ = Exception.__str__  # KeyError would quote the line


class FormatError(GraincrackError, ValueError):
    """A file that is none of Graincrack's, or of another kind than was asked for."""


def _text(value):
    """Attributes as Python has them: texts, lists of texts, numbers."""
    if isinstance(value, bytes):
        return value.decode()
    if isinstance(value, np.ndarray):
        return [_text(v) for v in value] if value.dtype.kind in "SO" else value
    return value.item() if isinstance(value, np.generic) else value


def _long_text(dataset: h5py.Dataset):
    """A text, or a list of texts, that is too long for an attribute."""
    rows = dataset[()]
    return rows.tobytes().decode() if rows.ndim == 1 else [row.tobytes().rstrip(b"\0").decode() for row in rows]


def _attributes(group: h5py.Group) -> dict:
    """All attributes of a group, also those that are datasets for their length."""
    long = {name: _long_text(item) for name, item in group.items() if isinstance(item, h5py.Dataset) and item.dtype == np.uint8}
    return {name: _text(value) for name, value in group.attrs.items()} | long


class Group(Mapping):
    """The datasets of an HDF5 group as arrays by name, each read when it is first asked for."""

    def __init__(self, group: h5py.Group):
        self._group = group
        self._read: dict[str, np.ndarray] = {}

    def __getitem__(self, name: str) -> np.ndarray:
        if name not in self._read:
            self._read[name] = self._dataset(name)[()]
        return self._read[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._group)

    def __len__(self) -> int:
        return len(self._group)

    def unit(self, name: str) -> str:
        """Its unit: "Pa", "m", "1" …"""
        return _text(self._dataset(name).attrs["unit"])

    def description(self, name: str) -> str:
        """What it is, in a line."""
        return _text(self._dataset(name).attrs["description"])

    def names(self, name: str) -> list[str]:
        """The meanings of 0, 1, … in a dataset of codes, as "tensile" and "shear" of the cracks' mode."""
        long = self._group.get(name + "_names")
        return _text(self._dataset(name).attrs["names"]) if long is None else _long_text(long)

    def frame_of_pandas(self):
        """As a pandas DataFrame; a dataset of several columns becomes name_0, name_1 …"""
        import pandas

        columns = {}
        for name, values in self.items():
            if values.ndim == 1:
                columns[name] = values
            else:
                for i, column in enumerate(values.reshape(len(values), -1).T):
                    columns[f"{name}_{i}"] = column
        return pandas.DataFrame(columns)

    def _dataset(self, name: str) -> h5py.Dataset:
        found = self._group.get(name)
        if not isinstance(found, h5py.Dataset):
            raise MissingError(f"{self._group.file.filename}: no {self._group.name}/{name}; there are {', '.join(self)}")
        return found


class _File:
    """A file at `path`, which a call of the package takes as an argument."""

    def __init__(self, path: str | Path):
        self.path = Path(path)

    def __fspath__(self) -> str:
        return str(self.path)

    def __repr__(self) -> str:
        return f"{type(self).__name__}({str(self.path)!r})"


class _Hdf5File(_File):
    """One of Graincrack's files, opened when something of it is first asked for."""

    @classmethod
    def made(cls, path: Path):
        """What a program has just made, not opened yet: a thousand files cannot be open at a time."""
        made = cls.__new__(cls)
        _File.__init__(made, path)
        return made

    @cached_property
    def _file(self) -> h5py.File:
        return _open(self.path)

    @property
    def request(self) -> dict:
        """The effective values of the options by which it was made, SI; None for what was not given."""
        return json.loads(_attributes(self._file[self._group]).get("request", "{}"))

    @property
    def provenance(self) -> dict:
        """What made it: program, version, command line, configuration …"""
        return _attributes(self._file["provenance"])

    def plot(self, kind: str, **options) -> Output:
        """A picture of it by a command of `graincrack.plot`, whose options it takes: plot("cracks", frame="peak")."""
        return getattr(_package().plot, kind.replace("-", "_"))(self, **options)


class Specimen(_Hdf5File):
    """A particle assemblage. `Specimen("specimen.h5")`, or `run.specimen`."""

    _group = "/specimen"

    def __init__(self, source: str | Path | h5py.File):
        super().__init__(source.filename if isinstance(source, h5py.File) else source)
        self._file = source if isinstance(source, h5py.File) else _open(source)

    def __getitem__(self, attribute: str):
        return _attribute(self._file, "/specimen", attribute)

    def plot(self, kind: str = "specimen", **options) -> Output:
        """A picture of its grains, with the options of `graincrack.plot.specimen`."""
        return super().plot(kind, **options)

    @cached_property
    def nodes(self) -> np.ndarray:
        """Reference positions x y, [n, 2], m."""
        return self._file["nodes/position"][()]

    @cached_property
    def elements(self) -> np.ndarray:
        """Nodes of each triangle, counter-clockwise, [e, 3]."""
        return self._file["elements/nodes"][()]

    @cached_property
    def grains(self) -> Group:
        return Group(self._file["grains"])

    @cached_property
    def contacts(self) -> Group:
        return Group(self._file["contacts"])


class Run(_Hdf5File):
    """A run of graincrack-solve. `run["damping"]` is an attribute of /run."""

    _group = "/run"

    def __init__(self, path: str | Path):
        super().__init__(path)
        if "run" not in self._file:
            raise FormatError(f"{path}: a specimen, no run; give a file that graincrack-solve wrote")

    def __getitem__(self, attribute: str):
        return _attribute(self._file, "/run", attribute)

    def __enter__(self) -> Run:
        return self

    def __exit__(self, *_) -> None:
        self.close()

    def close(self) -> None:
        """Closes the file; what was not read before cannot be read any more."""
        self._file.close()

    @property
    def test(self) -> str:
        """uniaxial, triaxial, brazilian, tension, bend or program."""
        return self["test"]

    @property
    def attributes(self) -> dict:
        """All attributes of /run, without their units."""
        return {name: value for name, value in _attributes(self._file["run"]).items() if not name.endswith("_unit")}

    def view(self, **options) -> Output:
        """A page on which the test is turned over, with the options of `graincrack.view`."""
        return _package().view(self, **options)

    @cached_property
    def specimen(self) -> Specimen:
        return Specimen(self._file)

    @cached_property
    def history(self) -> Group:
        return Group(self._file["history"])

    @cached_property
    def cracks(self) -> Group:
        return Group(self._file["cracks"])

    @property
    def frame_times(self) -> np.ndarray:
        """s, ascending."""
        return np.array([frame.attrs["time"] for frame in self._file["frames"].values()])

    def frame(self, which: str | int = "last", *, time: float | None = None) -> Frame:
        """A state: "last"; "peak", that of the strength; a number from 0; the one nearest to `time` (s)."""
        frames = list(self._file["frames"].values())
        if which == "peak" and time is None:
            return self._frame_of_peak()
        if time is not None:
            which = int(np.argmin(np.abs(self.frame_times - time)))
        elif which == "last":
            which = len(frames) - 1
        if not isinstance(which, int) or not -len(frames) <= which < len(frames):
            raise MissingError(f"{self._file.filename}: no frame {which!r}; \"peak\", \"last\" or a number below {len(frames)} fits")
        return Frame(frames[which])

    def _frame_of_peak(self) -> Frame:
        times, sense = self.history["time"], 1 if self.test == "tension" else -1
        frame = self.frame(time=self["peak_time"])
        stress = [sense * self.history["axial_stress"][np.argmin(np.abs(times - time))] for time in (frame.time, self["peak_time"])]
        if stress[0] < 0.95 * stress[1]:
            raise MissingError(f"{self._file.filename}: no frame of the peak was kept; make the run with --frames 20")
        return frame

    def probe(self, name: str) -> Group:
        """The rows of a program's probe."""
        if f"probes/{name}" not in self._file:
            there = ", ".join(self._file.get("probes", {})) or "none"
            raise MissingError(f"{self._file.filename}: no probe {name!r}; there are {there}")
        return Group(self._file[f"probes/{name}"])


class Frame(Group):
    """Displacements, stresses and contact states at a time."""

    def __init__(self, group: h5py.Group):
        super().__init__(group)
        self.time = float(group.attrs["time"])  #: s
        self.step = int(group.attrs["step"])


class Table(Mapping):
    """A table of graincrack-post (TSV): columns by name, with or without the unit that ends it."""

    def __init__(self, path: str | Path, text: str | None = None):
        """Reads a file, or the text of a table that is in none; then `path` is a name for messages."""
        try:
            self._text = Path(path).read_text(encoding="utf-8") if text is None else text
            rows = list(csv.reader(io.StringIO(self._text, newline=""), delimiter="\t", quoting=csv.QUOTE_NONE))
        except (UnicodeDecodeError, csv.Error):
            rows = []
        if not rows or any(len(row) != len(rows[0]) for row in rows):
            raise FormatError(f"{path}: no table; a line of names and rows of as many fields, divided by tabulators, fit")
        self._path = path
        self._columns = {name: [row[i] for row in rows[1:]] for i, name in enumerate(rows[0])}

    def __getitem__(self, name: str) -> np.ndarray:
        cells = self._columns[self.column(name)]
        if any(cell and not _NUMBER.fullmatch(cell) for cell in cells):
            return np.array(cells, dtype=object)
        return np.array([float(cell) if cell else np.nan for cell in cells])

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    def column(self, name: str) -> str:
        """The full name of a column, which ends in its unit: "peak_compressive_stress" is "peak_compressive_stress_MPa"."""
        fits = [c for c in self._columns if c == name] or [c for c in self._columns if c.rpartition("_")[0] == name]
        if len(fits) != 1:
            raise MissingError(f"{self._path}: {'several columns' if fits else 'no column'} {name!r}; there are {', '.join(self)}")
        return fits[0]

    def unit(self, name: str) -> str:
        """The unit that ends the column's name, "" where it has none."""
        full = self.column(name)
        unit = full.rpartition("_")[2]
        return unit if unit in _UNITS else ""

    def frame_of_pandas(self):
        """As a pandas DataFrame."""
        import pandas

        return pandas.DataFrame({name: self[name] for name in self})

    def save(self, path: str | Path) -> Path:
        """Writes it as the file (TSV) that commands such as `summarize` read."""
        Path(path).write_text(self._text, encoding="utf-8")
        return Path(path)

    def __repr__(self) -> str:
        rows = [(name, *cells) for name, cells in self._columns.items() if any(cells)]
        texts = [[cell.rjust(max(map(len, row))) for cell in row] for row in rows]
        return "\n".join("  ".join(line) for line in zip(*texts))

    def _repr_html_(self) -> str:
        filled = {name: cells for name, cells in self._columns.items() if any(cells)}
        rows = [*zip(*filled.values())]
        head = "".join(f"<th>{html.escape(name.removesuffix('_' + self.unit(name)))}<br>{self.unit(name)}</th>" for name in filled)
        body = "".join("<tr>" + "".join(f"<td>{html.escape(_short(cell))}</td>" for cell in row) + "</tr>" for row in rows[:_MOST_ROWS])
        more = f"<p>{len(rows) - _MOST_ROWS} rows more</p>" if len(rows) > _MOST_ROWS else ""
        return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>{more}"


_MOST_ROWS = 60  # of a table that a notebook shows
_NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?")  # as tables have it: 1_2, nan and inf are texts


def _short(cell: str) -> str:
    """A number with digits behind its point in the four that a person reads; anything else as it is."""
    return f"{float(cell):.4g}" if re.fullmatch(r"-?\d+\.\d+(e[-+]\d+)?", cell) else cell


class Output(_File):
    """A picture, page or folder that a command made; a notebook shows it."""

    def save(self, path: str | Path) -> Path:
        """Copies it."""
        return Path((shutil.copytree if self.path.is_dir() else shutil.copyfile)(self.path, path))

    def _repr_png_(self) -> bytes | None:
        pictures = sorted(self.path.glob("*.png"))[-1:] if self.path.is_dir() else [self.path] * (self.path.suffix == ".png")
        return pictures[0].read_bytes() if pictures else None

    def _repr_svg_(self) -> str | None:
        return self.path.read_text() if self.path.suffix == ".svg" else None

    def _repr_html_(self) -> str | None:
        if self.path.suffix != ".html":
            return None
        page = html.escape(self.path.read_text(encoding="utf-8"))
        return f'<iframe sandbox="allow-scripts allow-downloads" srcdoc="{page}" style="width: 100%; height: 640px; border: 0"></iframe>'


def _package():
    """The functions that programs make of files."""
    return sys.modules[__package__]


def material_of(path: str | Path) -> str | None:
    """The material with which a specimen or run was made, as its command line had it."""
    with _open(path) as file:
        return _attributes(file["provenance"]).get("material")


# Units that end the names of columns (share/doc/tables.md).
_UNITS = {"MPa", "GPa", "Pa", "mm", "m", "um", "deg", "rad", "percent", "J", "J/m2", "s", "N", "m/s", "kPa", "MPa/mm", "MPa.m^0.5"}


def _open(path: str | Path) -> h5py.File:
    try:
        file = h5py.File(path, "r")
    except FileNotFoundError:
        raise
    except OSError as error:
        raise FormatError(f"{path}: no HDF5 file ({error})") from None
    version = file.attrs.get("schema_version")
    if "specimen" not in file or version is None:
        raise FormatError(f"{path}: none of Graincrack's files; one of graincrack-mesh or graincrack-solve fits")
    if int(version) != SCHEMA_VERSION:
        raise FormatError(f"{path}: has schema version {int(version)}, but this module reads {SCHEMA_VERSION}; use the module of the "
                          "Graincrack that wrote the file")
    return file


def _attribute(file: h5py.File, group: str, name: str):
    attributes = _attributes(file[group])
    if name not in attributes:
        there = ", ".join(sorted(a for a in attributes if not a.endswith("_unit")))
        raise MissingError(f"{file.filename}: {group} has no {name!r}; there are {there}")
    return attributes[name]
