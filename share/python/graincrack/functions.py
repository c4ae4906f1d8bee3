"""The functions of the package: one for each command of the programs, made from what these say of themselves."""

from __future__ import annotations

import contextlib
import difflib
import functools
import inspect
import itertools
import keyword
import os
import types
from collections.abc import Mapping
from pathlib import Path

from . import programs
from .files import GraincrackError, Output, Run, Specimen, Table, material_of

# Options that are answered before a command runs, and that of each function.
_NONE_OF_A_FUNCTION = {"help", "help-all", "version", "describe", "events", "quiet"}
_MADE_BY = {"graincrack-mesh": Specimen.made, "graincrack-solve": Run.made, "graincrack-post": Output}


def _python_name(name: str) -> str:
    """The name of a command or option as Python has it: half_disc, class_."""
    name = name.replace("-", "_")
    return name + "_" * keyword.iskeyword(name)


def text_of(value) -> str:
    """A value as the command line has it."""
    if isinstance(value, (str, os.PathLike)):
        return os.fspath(value)
    if isinstance(value, Mapping):
        return ",".join(f"{key}={text_of(each)}" for key, each in value.items())
    if isinstance(value, tuple) and len(value) == 2 and isinstance(value[1], str) and not isinstance(value[0], str):
        return text_of(value[0]) + value[1]
    if isinstance(value, (list, tuple)):
        return ",".join(map(text_of, value))
    try:
        return str(value.__index__()) if hasattr(value, "__index__") else repr(float(value))
    except (TypeError, ValueError):
        raise GraincrackError(f"{value!r} is no value; a text such as '4mm', a pair (4, 'mm') or a number fits") from None


def _filled(name: str, value) -> str:
    """The text of an argument, which is not empty: the command line would take the next one for its value."""
    text = text_of(value)
    if not text:
        raise GraincrackError(f"{name}: {value!r} is empty; leave it out, or give a value")
    return text


def _place(name: str, value) -> str:
    """The same of a file or name, which is never an option."""
    text = _filled(name, value)
    return "./" + text if text.startswith("-") and text != "-" else text


def _new_file(stem: str, ending: str) -> Path:
    """A new, empty file of graincrack.folder (a folder where there is no ending): other calls take other names."""
    folder = Path(programs.settings().folder)
    if not folder.is_dir():
        folder.mkdir(parents=True, exist_ok=True)
        programs.Screen(None).show(f"graincrack: files without a name go to {folder}, which graincrack.folder sets", stays=True)
    for number in itertools.count(1):
        path = folder / f"{stem}-{number}{ending}"
        if not Path(f"{path}.checkpoint").exists():
            try:
                path.touch(exist_ok=False) if ending else path.mkdir()
                return path
            except FileExistsError:
                pass


def _remove_if_empty(path: Path) -> None:
    with contextlib.suppress(OSError):  # of a folder with files
        if path.is_dir():
            path.rmdir()
        elif path.stat().st_size == 0:
            path.unlink()


class _Command:
    """A command of a program, by its names and what the program says of it."""

    def __init__(self, program: str, names: tuple[str, ...], said: dict, of_program: list[dict]):
        self.program, self.names, self.meaning = program, names, said["description"]
        own = said["options"]
        known = {option["name"] for option in own}
        others = [option for option in of_program if option["name"] not in known]
        self.options = {_python_name(each["name"]): each for each in own + others if each["name"] not in _NONE_OF_A_FUNCTION}
        self._makes_table = program == "graincrack-post" and "format" in self.options and not self.options["output"].get("required")
        self.output = None if self._makes_table else self.options.get("output")  # tables have a file only where it is named

    @property
    def name(self) -> str:
        return ".".join(map(_python_name, self.names))

    def signature(self) -> inspect.Signature:
        kinds = inspect.Parameter
        places, others = [], []
        for name, option in self.options.items():
            is_needed = option.get("required") and name not in ("material", "output")
            default = kinds.empty if is_needed else _default_of(option)
            if not option.get("positional"):
                others.append(kinds(name, kinds.KEYWORD_ONLY, default=default))
            elif option.get("many"):
                places.append(kinds(name, kinds.VAR_POSITIONAL))
            else:
                places.append(kinds(name, kinds.POSITIONAL_OR_KEYWORD, default=default))
        return inspect.Signature([*places, *others, kinds("quiet", kinds.KEYWORD_ONLY, default=None)])

    def documentation(self, tables: list[dict]) -> str:
        result = {"graincrack-mesh": "Specimen", "graincrack-solve": "Run"}.get(self.program)
        result = result or ("Output, a file" if self.output else "Table" if self._makes_table else "text")
        lines = [f"{self.meaning}: `{' '.join((self.program, *self.names))}`.", "", f"Returns: {result}.", "", "Parameters", "----------"]
        for name, option in self.options.items():
            lines += [f"{name} : {_kind_of(option)}", f"    {option['meaning']}"]
        lines += ["quiet : True, False", "    whether nothing is shown of what the program tells; default: graincrack.quiet"]
        own = " ".join(self.names)
        for table in (each for each in tables if f"{each['command']} ".startswith(f"{own} ")):
            lines += ["", f"Columns of `{table.get('file', table['command'])}`", "----------"]
            for column in table["columns"]:
                lines += [column["name"] + f" : {column['unit']}" * bool(column["unit"]), f"    {column['meaning']}"]
        return "\n".join(lines)

    def __call__(self, given: dict):
        quiet, output = given.pop("quiet", None), given.get("output")
        if output == "-":
            raise GraincrackError(f"{self.name}: output '-' is for the pipes of a shell; the name of a file fits")
        words = self._words(given)
        is_new = self.output is not None and output is None
        if is_new:
            output = _new_file("-".join(self.names), self.output.get("endings", [""])[0])
            words.append(f"--output={output}")
        try:
            printed, outcome = programs.run([programs.bin_folder() / self.program, *self.names, *words], quiet=quiet, stacklevel=3,
                                            resume=self._how_to_resume)
        finally:
            if is_new:
                _remove_if_empty(output)
        is_table = self._makes_table and given.get("format") in (None, "tsv")
        if output and os.fspath(output) in outcome["outputs"]:
            return (Table if is_table else _MADE_BY[self.program])(Path(output))
        return Table(self.name, printed) if is_table else printed.rstrip("\n")

    def _words(self, given: dict) -> list[str]:
        """The arguments of a call; the material is that of the files unless given, and a test of a `map` has one thread."""
        places, words = [], []
        for name, value in given.items():
            option = self.options[name]
            if option.get("positional"):
                values = value if option.get("many") else [value]
                places += [_place(name, each) for one in values for each in (one if isinstance(one, (list, tuple)) else [one])]
            elif option["type"] == "flag":
                if value not in (True, False, None):
                    raise GraincrackError(f"{name}: {value!r} is neither True nor False")
                words += [f"--{option['name']}"] * bool(value)
            elif value is not None:
                several = isinstance(value, list) and option.get("repeatable")
                words += [f"--{option['name']}={_filled(name, each)}" for each in (value if several else [value])]
        material = self.options.get("material", {})
        if material.get("required") and not material.get("positional") and given.get("material") is None:
            words += [f"--material={name}" for name in map(material_of, filter(os.path.isfile, places[:1])) if name]
        if "threads" in self.options and programs.is_side_by_side() and given.get("threads") is None:
            words.append("--threads=1")
        return places + words

    def _how_to_resume(self, outcome: dict) -> str:
        if "checkpoint" not in outcome:
            return ""
        return f"; the test so far is in {outcome['checkpoint']}, and {self.name}(…, restart={outcome['checkpoint']!r}) resumes it"


def _default_of(option: dict):
    """The default as a number where it is one."""
    if option["type"] == "flag":
        return False
    text = option.get("default")
    try:
        return {"integer": int, "quantity": float}[option["type"]](text)
    except (KeyError, TypeError, ValueError):
        return text


def _kind_of(option: dict) -> str:
    """What an option takes, in a line: type, unit, words, default. Its meaning has bounds and other units."""
    words = " | ".join(map(repr, option.get("choices", [])))
    kind = {"flag": "True, False", "choice": words}.get(option["type"], option["type"])
    if option.get("unit", "1") != "1":
        kind += f" in {option['unit']}, or with its unit"
    if option["type"] != "choice" and words:
        kind += f" | {words}"
    default = f", default {option['default']}" if "default" in option else ""
    return kind + ", may be a list" * bool(option.get("repeatable")) + default


def _function(command: _Command, tables: list[dict]):
    signature = command.signature()

    def call(*arguments, **options):
        try:
            given = signature.bind(*arguments, **options).arguments
        except TypeError as error:
            raise TypeError(f"{command.name}: {error}") from None
        return command(given)

    call.__name__ = call.__qualname__ = command.name
    call.__doc__, call.__signature__, call.__module__ = command.documentation(tables), signature, __package__
    return call


def refuse(where: str, there: dict, name: str):
    """Raises the error of a name that is not there."""
    near = difflib.get_close_matches(name, there, 1)
    fits = f"did you mean {near[0]}?" if near else "there are " + ", ".join(each for each in there if each[0] != "_")
    raise AttributeError(f"{where} has no {name}; {fits}")


def _functions(said: dict, part: dict, names: tuple[str, ...] = ()) -> dict:
    """Those of a program, or of a command that has others."""
    made = {}
    for each in part["commands"]:
        own = (*names, each["name"])
        if each.get("commands"):  # becomes a module, as graincrack.plot
            function = types.ModuleType(f"{__package__}.{_python_name(each['name'])}", each["description"])
            vars(function).update(_functions(said, each, own), __getattr__=functools.partial(refuse, function.__name__, vars(function)))
        else:
            function = _function(_Command(said["program"], own, each, said["options"]), said["tables"])
        made[_python_name(each["name"])] = function
    return made


@functools.cache
def commands() -> dict:
    """The functions by their names. Raises GraincrackError where the programs are not found."""
    all_said = map(programs.description, programs.PROGRAMS)
    return {name: function for said in all_said for name, function in _functions(said, said).items()}
