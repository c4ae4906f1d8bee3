#!/usr/bin/python3
"""Damages files one object at a time and demands that every tool which reads them says so.

Usage: hostile_files.py BIN [--every N] [--seed S]

BIN is the folder of the tools. A small specimen, a run and a checkpoint are made; each dataset and attribute of them is removed, emptied,
made a scalar, given another type or length, or values that are no numbers, infinite, huge or negative; rows of groups are repeated, or
exchanged; groups are linked in a circle; and bytes anywhere in the file are changed. Each damaged file is read by each tool that reads such files. Right is exit code 0 where the damage is none to that tool, or 3 with one line;
4 with one line where a number can be right and leads a test astray. --every takes one in N of the cases, from the seed on.
"""
import argparse
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile

import h5py
import numpy as np

LIMIT_S = 60
FLIPS = 1000
TEST = "--material augig-granite --rate 400mm/s --max-strain 0.004 --quiet --frames 2".split()
# What has no part in what is read back: any content of it is right.
IDLE = ("/provenance", "/VTKHDF")


def values_of(data):
    """Damaged values of an array or number, by name."""
    data = np.asarray(data)
    yield "empty", np.empty((0,) + data.shape[1:], data.dtype)
    yield "scalar", data.dtype.type(1) if data.dtype.kind in "fiu" else np.bytes_("x")
    yield "text", np.full(data.shape or (1,), b"damaged")
    yield "short", data[:-1] if data.ndim and len(data) else np.empty(0, data.dtype)
    yield "long", np.concatenate([data, data[-1:]]) if data.ndim and len(data) else np.zeros(3)
    yield "flat", data.reshape(-1) if data.ndim > 1 else data.reshape(-1, 1)
    if data.dtype.kind == "f" and data.size:
        for name, value in (("nan", np.nan), ("infinite", np.inf), ("huge", 1e300), ("negative", -1.0), ("fraction", 0.37)):
            changed = data.copy()
            changed[...] = value
            yield "all " + name, changed
            changed = data.copy()
            changed.reshape(-1)[changed.size // 2] = value
            yield "one " + name, changed
    if data.dtype.kind in "iu" and data.size:
        for name, value in (("largest", np.iinfo(data.dtype).max), ("smallest", np.iinfo(data.dtype).min)):
            changed = data.copy()
            changed.reshape(-1)[changed.size // 2] = value
            yield "one " + name, changed


def replace(group, name, values):
    attributes = dict(group[name].attrs)
    del group[name]
    group[name] = values
    for key, value in attributes.items():
        group[name].attrs[key] = value


def set_dataset(path, values):
    return lambda file: replace(file[str(pathlib.PurePosixPath(path).parent)], pathlib.PurePosixPath(path).name, values)


def declare(path, length):
    """Declares values that are not there."""
    def act(file):
        dtype = file[path].dtype
        del file[path]
        file.create_dataset(path, shape=(length,), dtype=dtype, chunks=(1 << 20,))
    return act


def edit_rows(group, rows):
    """Replaces the datasets of a group by some of their rows."""
    def act(file):
        for name in list(file[group]):
            values = file[group][name][()]
            replace(file[group], name, values[rows(len(values))])
    return act


def row_damages():
    """Specimens that mean nothing though their arrays fit each other."""
    for group in ("contacts", "boundary", "elements", "grains"):
        yield f"/{group} with its last row twice", edit_rows(group, lambda n: [*range(n), n - 1])
        yield f"/{group} all twice", edit_rows(group, lambda n: [*range(n), *range(n)])
        yield f"/{group} without the first row", edit_rows(group, lambda n: [*range(1, n)])
        yield f"/{group} in reverse", edit_rows(group, lambda n: [*reversed(range(n))])

    def shift(file):
        file["nodes/position"][...] += 1e-2

    def unused(file):
        replace(file["nodes"], "position", np.concatenate([file["nodes/position"][()], [[0, 0]]]))

    def inner(file):
        file["boundary/edges"][0] = file["elements/nodes"][0][:2]

    def area(file):
        file["grains/area"][...] *= 2

    def shape(file):
        file["specimen"].attrs["shape"] = np.bytes_("hexagon")
    for act in (shift, unused, inner, area, shape):
        yield f"specimen: {act.__name__}", act


def flips(name, count):
    """Changes of one to four bytes."""
    size = name.stat().st_size
    for number in range(count):
        chance = random.Random(number)
        changes = [(chance.randrange(size), chance.randrange(256)) for _ in range(chance.choice((1, 1, 1, 2, 4)))]
        def act(path, changes=changes):
            with open(path, "r+b") as file:
                for place, byte in changes:
                    file.seek(place)
                    file.write(bytes([byte]))
        yield f"bytes {changes}", act


def damages(name):
    """Of a file, (description, function of the open file)."""
    yield from row_damages()
    with h5py.File(name) as file:
        objects = []
        file.visititems(lambda path, thing: objects.append(("/" + path, thing)))
        for path, thing in objects:
            if path.startswith(IDLE):
                continue
            def remove(f, path=path):
                del f[path]
            yield f"{path} removed", remove
            if isinstance(thing, h5py.Dataset):
                for how, values in values_of(thing[()]):
                    yield f"{path} {how}", set_dataset(path, values)
                for length in (10**9, 10**12, 5 * 10**18):
                    yield f"{path} declared {length} long", declare(path, length)
            for key, value in list(thing.attrs.items()):
                if key in ("unit", "description") or key.endswith("_unit"):
                    continue
                def remove_attribute(f, path=path, key=key):
                    del f[path].attrs[key]
                yield f"{path}@{key} removed", remove_attribute
                for how, values in values_of(value):
                    def set_attribute(f, path=path, key=key, values=values):
                        f[path].attrs[key] = values
                    yield f"{path}@{key} {how}", set_attribute
                yield f"{path}@{key} of variable length", lambda f, path=path, key=key: f[path].attrs.__setitem__(key, "variable")

    def circle(f):
        f["specimen/again"] = f["/"]

    def soft(f):
        f["specimen/again"] = h5py.SoftLink("/")

    def external(f):
        f["specimen/again"] = h5py.ExternalLink("/dev/zero", "/")

    def deep(f):
        group = f["specimen"]
        for _ in range(2000):
            group = group.create_group("a")
    for how, act in (("groups in a circle", circle), ("soft circle", soft), ("external link", external), ("nested deep", deep)):
        yield how, act


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bin", type=pathlib.Path)
    parser.add_argument("--every", type=int, default=1)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    solve, post = options.bin / "graincrack-solve", options.bin / "graincrack-post"
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        specimen, run, checkpoint = (folder / name for name in ("specimen.h5", "run.h5", "run.h5.checkpoint"))
        subprocess.run([options.bin / "graincrack-mesh", *"rectangle --width 20mm --height 40mm --edge 5mm --quiet -o".split(), specimen],
                       check=True)
        kept = folder / "kept.h5"
        # The last of the checkpoints, which are gone when the run is there.
        test = subprocess.Popen([solve, "uniaxial", specimen, *TEST, "--checkpoint-every", "1ms", "-o", run])
        while test.poll() is None:
            try:
                shutil.copy(checkpoint, kept)
            except FileNotFoundError:
                pass
        damaged = folder / "damaged.h5"
        readers = {
            specimen: [[solve, "uniaxial", damaged, *TEST, "--dry-run"], [post, "info", "--check", damaged], [post, "info", damaged]],
            run: [[post, "info", "--check", damaged], [post, "strength", damaged], [post, "info", damaged, "--digest"],
                  [post, "cracks", damaged, "-o", folder / "cracks"], [post, "history", damaged],
                  [post, "view", damaged, "-o", folder / "view.html"],
                  [post, "plot", "cracks", damaged, "--frame", "all", "-o", folder / "frames"]],
            kept: [[solve, "uniaxial", specimen, *TEST, "--restart", damaged, "-o", folder / "again.h5"], [post, "info", "--check", damaged]],
        }

        def edited(act):
            def on_path(path):
                with h5py.File(path, "r+") as opened:
                    act(opened)
            return on_path
        cases = [(file, what, edited(act)) for file in readers for what, act in damages(file)]
        cases += [(file, what, act) for file in readers for what, act in flips(file, FLIPS)]
        random.Random(options.seed).shuffle(cases)
        wrong = tried = 0
        for file, what, act in cases[::options.every]:
            shutil.copy(file, damaged)
            try:
                act(damaged)
            except (TypeError, ValueError, KeyError, OSError, RuntimeError):
                continue  # h5py cannot write it
            for command in readers[file]:
                tried += 1
                try:
                    done = subprocess.run(command, capture_output=True, timeout=LIMIT_S, text=True, errors="replace")
                    code, lines = done.returncode, done.stderr.splitlines()
                except subprocess.TimeoutExpired:
                    code, lines = "hang", []
                right = code == 0 or (code in (3, 4) and len(lines) == 1)
                if not right:
                    wrong += 1
                    print(f"WRONG {file.name}: {what}: {' '.join(map(str, command[:3]))}: exit {code}", *lines[-2:], sep="\n    ", flush=True)
    print(f"hostile files: {tried} tries, {wrong} wrong (seed {options.seed}, one in {options.every})")
    sys.exit(wrong > 0)


if __name__ == "__main__":
    main()
