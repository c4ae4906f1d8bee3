"""The programs: where they are, what they say of themselves, and their calls, one by one or side by side."""

from __future__ import annotations

import contextlib
import functools
import json
import os
import shutil
import signal
import subprocess
import sys
import sysconfig
import tempfile
import threading
import time
import warnings
from concurrent import futures
from pathlib import Path
from typing import Callable, Iterable

from .files import GraincrackError, GraincrackWarning

PROGRAMS = ("graincrack-mesh", "graincrack-solve", "graincrack-post")


def settings():
    """The package, whose `folder` and `quiet` users set."""
    return sys.modules[__package__]


@functools.cache
def bin_folder() -> Path:
    """The folder of the three programs: GRAINCRACK_BIN, else beside this package in its installation or build, else on PATH."""
    here = Path(__file__).resolve()
    own = os.environ.get("GRAINCRACK_BIN")
    beside = [here.parents[4] / "bin", here.parents[3] / "build" / "bin", Path(sysconfig.get_path("scripts"))]
    on_path = shutil.which(PROGRAMS[0])
    places = [Path(own)] if own else beside + ([Path(on_path).parent] if on_path else [])
    for place in places:
        if all(os.access(place / program, os.X_OK) for program in PROGRAMS):
            return place.absolute()
    where = f"in GRAINCRACK_BIN={own}" if own else f"in {', '.join(str(place) for place in beside)} or on PATH"
    raise GraincrackError(f"graincrack-mesh, graincrack-solve and graincrack-post are not {where}; install Graincrack, or set "
                          "GRAINCRACK_BIN to the folder of the three")


@functools.cache
def description(program: str) -> dict:
    """What a program says of itself: `PROGRAM --describe`."""
    path = bin_folder() / program
    asked = subprocess.run([path, "--describe"], stdin=subprocess.DEVNULL, capture_output=True, text=True)
    try:
        said = json.loads(asked.stdout)
    except ValueError:
        said = {}
    version = settings().__version__
    if "commands" not in said:
        raise GraincrackError(f"{path}: does not describe itself ({asked.stderr.strip()}); that of Graincrack {version} fits")
    if said["version"] != version:
        warnings.warn(f"{path} is of Graincrack {said['version']}, this package of {version}; install both from one source",
                      GraincrackWarning, stacklevel=2)
    return said


class Screen:
    """Shows what programs tell: on a terminal as they do, in a notebook as a line that changes, elsewhere by lines."""

    def __init__(self, quiet: bool | None):
        shell = getattr(sys.modules.get("IPython"), "get_ipython", lambda: None)()
        self._quiet = settings().quiet if quiet is None else quiet
        self._notebook = hasattr(shell, "kernel")
        self._place = None
        self._lines: list[str] = []
        self._next_line = time.monotonic() + 30  # s
        self.has_bar = not self._quiet and (self._notebook or sys.stderr.isatty())

    def show(self, text: str, *, stays: bool) -> None:
        """A line that stays (of a notebook's the last four do), or one of work in progress, which the next replaces."""
        if self._quiet or not (stays or self.has_bar):
            return
        if not self._notebook:
            sys.stderr.write(("\r\033[K" if self.has_bar else "") + text + "\n" * stays)
            sys.stderr.flush()
            return
        from IPython.display import display

        self._lines += [text] * stays
        shown = {"text/plain": "\n".join(self._lines[-4:]) if stays or not text else text}
        if self._place is not None:
            self._place.update(shown, raw=True)
        elif shown["text/plain"]:
            self._place = display(shown, raw=True, display_id=True)


    def show_progress(self, event: dict) -> None:
        """A bar, which the next text replaces; where there is none, a line every half minute."""
        if not self.has_bar and time.monotonic() < self._next_line:
            return
        self._next_line = time.monotonic() + 30
        done = int(24 * event["fraction"])
        bar = f" [{'#' * done}{'.' * (24 - done)}]" if self.has_bar else ":"
        self.show(f"{event['label']}{bar} {100 * event['fraction']:.0f} %, {event['text']}", stays=not self.has_bar)


class Together:
    """Calls that end together: those of a `map`."""

    of_thread = threading.local()

    def __init__(self):
        self._lock = threading.Lock()
        self._processes: set[subprocess.Popen] = set()
        self.is_stopped = False

    def start(self, *arguments, **options) -> subprocess.Popen:
        with self._lock:
            if self.is_stopped:
                raise GraincrackError("stopped, as another call has failed")
            # A session of its own: Ctrl-C of a terminal reaches Python alone, which passes it on once.
            process = subprocess.Popen(*arguments, **options, stdin=subprocess.DEVNULL, start_new_session=True)
            self._processes.add(process)
            return process

    def end(self, process: subprocess.Popen) -> None:
        with self._lock:
            self._processes.discard(process)
        if process.poll() is None:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()

    def stop(self, *, again: bool = False) -> None:
        """Interrupts what runs, once, as Ctrl-C does; `again`, and it ends at once."""
        with self._lock:
            if self.is_stopped and not again:
                return
            self.is_stopped = True
            for process in self._processes:
                with contextlib.suppress(ProcessLookupError):
                    os.killpg(process.pid, signal.SIGINT)


def is_side_by_side() -> bool:
    """Whether this is a call of a `map`, which has a processor of its own."""
    return getattr(Together.of_thread, "calls", None) is not None


def _event(line: bytes) -> dict:
    """What a program tells by a line; one of another program is a note."""
    return json.loads(line) if line.startswith(b'{"event":') else {"event": "note", "text": line.decode(errors="replace").rstrip("\n")}


def run(command: list, *, has_events: bool = True, quiet: bool | None = None, resume: Callable[[dict], str] = lambda outcome: "",
        stacklevel: int = 2) -> tuple[str, dict]:
    """What a command prints on stdout, and its outcome (share/doc/file-format.md). Its warnings become Python's.

    Raises GraincrackError with the line by which it fails and its exit code, and KeyboardInterrupt with what `resume` says.
    """
    calls = getattr(Together.of_thread, "calls", None) or Together()
    screen = Screen(True if is_side_by_side() else quiet)
    notes, cautions, outcome, interrupted = [], [], {}, False
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as others, contextlib.ExitStack() as ends:
        reader, writer = os.pipe()
        told = ends.enter_context(open(reader, "rb"))
        options = {"stderr": others, "pass_fds": [writer]} if has_events else {"stderr": writer}
        try:
            process = calls.start([command[0], *[f"--events={writer}"] * has_events, *command[1:]], stdout=out, **options)
        finally:
            os.close(writer)
        ends.callback(calls.end, process)
        while process.returncode is None:
            try:
                for event in (_event(line) for line in told):
                    if event["event"] == "progress":
                        screen.show_progress(event)
                    elif event["event"] == "note":
                        notes.append(event["text"])
                        screen.show(event["text"], stays=True)
                    elif event["event"] == "warning":
                        cautions.append(event)
                    else:
                        outcome = event
                process.wait()
            except KeyboardInterrupt:
                calls.stop(again=interrupted)
                interrupted = True
        out.seek(0)
        others.seek(0)
        printed = out.read().decode(errors="replace")
        unforeseen = [*notes, *others.read().decode(errors="replace").splitlines()][-3:]
    screen.show("", stays=False)
    for each in cautions:
        caution = GraincrackWarning(f"{each['subject']}: {each['text']}", code=each["code"])
        warnings.warn(caution, stacklevel=stacklevel + 1)
    if interrupted:
        raise KeyboardInterrupt("stopped" + resume(outcome))
    if code := process.returncode:
        code = code if code > 0 else 128 - code
        error = outcome.get("error") or "\n".join(unforeseen) or f"{command[0]}: ended with exit code {code}"
        raise GraincrackError(error, exit_code=code)
    return printed, outcome


def processors() -> int:
    """Those that this process may use."""
    return len(os.sched_getaffinity(0))


def map(f: Callable, items: Iterable, jobs: int | None = None, *, quiet: bool | None = None) -> list:
    """[f(item) for item in items], `jobs` at a time: as many as there are processors unless given.

    Tests that f makes have one thread each. The first error, or Ctrl-C, stops all others, which leave their checkpoints, and is
    raised when they have ended. A `map` that f calls belongs to this one, and makes one call at a time unless given.
    """
    outer = getattr(Together.of_thread, "calls", None)
    items, calls, screen, errors = list(items), outer or Together(), Screen(True if outer else quiet), []

    def call(item):
        Together.of_thread.calls = calls
        try:
            return None if calls.is_stopped else f(item)
        except BaseException as error:
            errors.append(error)
            calls.stop()
        finally:
            Together.of_thread.calls = None

    interrupted = False
    with futures.ThreadPoolExecutor(jobs or (1 if outer else processors())) as pool:
        waiting = all_calls = [pool.submit(call, item) for item in items]
        while waiting:
            try:
                screen.show(f"{len(items) - len(waiting)} of {len(items)} are done", stays=False)
                _, waiting = futures.wait(waiting, return_when=futures.FIRST_COMPLETED)
            except KeyboardInterrupt:
                calls.stop(again=interrupted)
                interrupted = True
    screen.show(f"{len(items)} of {len(items)} are done" if not errors else "", stays=screen.has_bar and not errors)
    if interrupted:
        raise KeyboardInterrupt("stopped; tests that were running have left RUN.checkpoint beside their files")
    if errors:
        raise errors[0]
    return [each.result() for each in all_calls]
