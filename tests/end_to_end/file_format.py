#!/usr/bin/python3
"""Compares the tables of share/doc/file-format.md with the datasets of a run, whose descriptions they are.

Usage: file_format.py RUN PAGE [--write]

A table stands between the lines `<!-- datasets of GROUP -->` and `<!-- end -->`. --write writes the tables anew. Prints each name
of a dataset, group or attribute that the page does not have, and fails if there is one or a table differs.
"""
import pathlib
import re
import sys

import h5py

LETTERS = {"nodes": "n", "elements": "e", "grains": "g", "contacts": "c", "boundary": "b", "cracks": "m", "history": "k"}
TABLES = {"specimen": ["nodes", "elements", "grains", "contacts", "boundary"], "history": ["history"], "cracks": ["cracks"],
          "frames": ["frames/0000"]}


def shape(run, path, dataset):
    group = path.split("/")[0]
    letter = LETTERS.get(group)
    if group == "frames":
        letter = {run["nodes/position"].shape[0]: "n", run["elements/nodes"].shape[0]: "e", run["contacts/nodes"].shape[0]: "c"}[dataset.shape[0]]
    return "[" + ",".join([letter, *map(str, dataset.shape[1:])]) + "]"


def row(run, path, is_named_whole):
    dataset = run[path]
    meaning = dataset.attrs["description"].decode().replace("|", r"\|").replace("the attribute names", "`names`")
    if path.endswith(("kind", "mode", "state")):
        meaning += ": " + ", ".join(f"{i} `{name.decode()}`" for i, name in enumerate(dataset.attrs["names"]))
    name = "/" + path if is_named_whole else path.split("/")[-1]
    return f"| `{name}` | {dataset.dtype.name} {shape(run, path, dataset)} | {dataset.attrs['unit'].decode()} | {meaning} |"


def table(run, groups):
    whole = len(groups) > 1
    paths = [f"{group}/{name}" for group in groups for name in run[group]]
    paths.sort(key=lambda path: (groups.index(path.rsplit("/", 1)[0]), h5py.h5o.get_info(run[path].id).addr))
    rows = [row(run, path, whole) for path in paths if isinstance(run[path], h5py.Dataset)]
    return "\n".join([f"| {'path' if whole else 'name'} | type | unit | |", "|---|---|---|---|", *rows])


def names_of(run):
    names = set(run.attrs)

    def add(path, item):
        if path.startswith("VTKHDF") or path.startswith("frames/") and not path.startswith("frames/0000"):
            return
        names.update(part for part in path.split("/") if not part.isdigit())
        names.update(name for name in item.attrs if not name.endswith("_unit"))

    run.visititems(add)
    return names


def main():
    page = pathlib.Path(sys.argv[2])
    old = text = page.read_text()
    with h5py.File(sys.argv[1]) as run:
        for name, groups in TABLES.items():
            block = re.compile(rf"(<!-- datasets of {name} -->\n\n).*?(\n\n<!-- end -->)", re.S)
            assert len(block.findall(text)) == 1, f"{page}: no table of {name}"
            text = block.sub(lambda found: found[1] + table(run, groups) + found[2], text)
        missing = sorted(name for name in names_of(run) if f"`{name}`" not in text and f"/{name}" not in text)
    for name in missing:
        print(f"{page}: does not name {name}")
    if "--write" in sys.argv:
        page.write_text(text)
    elif text != old:
        print(f"{page}: tables are not those of the files; {pathlib.Path(__file__).name} RUN {page} --write renews them")
        return 1
    return bool(missing)


sys.exit(main())
