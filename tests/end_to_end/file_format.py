#!/usr/bin/python3
"""Compares a run with what graincrack-solve --describe says of datasets, and with share/doc/file-format.md.

Usage: file_format.py RUN PAGE DESCRIPTION

Prints each dataset that DESCRIPTION lacks or has with another unit or meaning, and each group or attribute that the page does not name; fails
if there is one.
"""
import json
import pathlib
import sys

import h5py

OF_A_RUN = ("nodes", "elements", "grains", "contacts", "boundary", "history", "cracks", "frames/0000")


def described(run):
    found = {}

    def add(path, item):
        if isinstance(item, h5py.Dataset) and path.startswith(OF_A_RUN):
            found["/" + path.replace("frames/0000", "frames/NNNN")] = tuple(item.attrs[name].decode() for name in ("unit", "description"))

    run.visititems(add)
    return found


def names_of(run):
    names = set(run.attrs)

    def add(path, item):
        if path.startswith("VTKHDF") or path.startswith("frames/") and not path.startswith("frames/0000"):
            return
        if isinstance(item, h5py.Group) or not path.startswith(OF_A_RUN):
            names.update(part for part in path.split("/") if not part.isdigit())
        names.update(name for name in item.attrs if not name.endswith("_unit"))

    run.visititems(add)
    return names


def main():
    page = pathlib.Path(sys.argv[2]).read_text()
    told = {each["path"]: (each["unit"], each["meaning"]) for each in json.loads(pathlib.Path(sys.argv[3]).read_text())["datasets"]}
    with h5py.File(sys.argv[1]) as run:
        faults = [f"--describe has not {path}: {said}" for path, said in sorted(described(run).items()) if told.get(path) != said]
        faults += [f"{sys.argv[2]}: does not name {name}" for name in sorted(names_of(run)) if f"`{name}`" not in page and f"/{name}" not in page]
    print(*faults, sep="\n", end="\n" if faults else "")
    return bool(faults)


sys.exit(main())
