#!/usr/bin/python3
"""Usage: figure.py FOLDER PICTURE    volumetric strain round the circle of 65 mm, the finest runs in FOLDER beside the answers of curves.tsv"""
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

sys.dont_write_bytecode = True
import cell

PANELS = [("M1", "A", ["none"], "M1, load A: no joint"), ("M1", "B", ["none"], "M1, load B"),
          ("M2a", "A", ["94", "97-closed"], "M2a, load A: joint through the sample"), ("M2b", "A", ["inner", "inner-closed"], "M2b, load A: joint from 0 to 40 mm")]
COLOURS = {"KAERI TOUGH-3DEC": "#7fb6d6", "KIGAM OGS-3DEC": "#8fc98f", "SNU PINN": "#d9b26f", "LBNL MOOSE phase field": "#b08fc9"}


def draw(axes, folder, case, load, joints):
    for code, colour in COLOURS.items():
        rows = [row for row in cell.table("curves.tsv") if (row["case"], row["load"], row["code"]) == (case, load, code)]
        if rows: axes.plot([float(r["angle_deg"]) for r in rows], [1e4 * float(r["vol_strain"]) for r in rows], color=colour, lw=1, label=code)
    for joint, style in zip(joints, ("-", "--")):
        meaning = cell.MEANINGS.get(joint, "none")
        rows = cell.table(f"{folder}/{case}_greywacke_{load}_polygon_{joint}_256.tsv")
        axes.plot([float(r["angle_deg"]) for r in rows], [1e4 * float(r["volumetric_strain"]) for r in rows], "k" + style, lw=0.9,
                  label="Graincrack" + ("" if meaning == "none" else f", {meaning}"))
        answer = [row for row in cell.table("curves.tsv") if (row["case"], row["load"]) == (case, load) and row["code"].startswith("reference")
                  and meaning in row["joint"]]
        axes.plot([float(r["angle_deg"]) for r in answer], [1e4 * float(r["vol_strain"]) for r in answer], "o", ms=2.5, color="#c03020",
                  label="reference" if joint == joints[0] else None)


def main():
    if len(sys.argv) != 3:
        print(__doc__.strip())
        return 2
    figure, panels = plt.subplots(2, 2, figsize=(8.4, 5.6), sharex=True, layout="constrained")
    for axes, (case, load, joints, title) in zip(panels.flat, PANELS):
        draw(axes, sys.argv[1], case, load, joints)
        axes.set_title(title, fontsize=9)
        axes.tick_params(labelsize=8)
        axes.set_xticks(range(0, 361, 60))
        axes.legend(fontsize=6, frameon=False)
    for axes in panels[1]: axes.set_xlabel("angle (°)", fontsize=8)
    for axes in panels[:, 0]: axes.set_ylabel("volumetric strain (1e-4)", fontsize=8)
    figure.savefig(sys.argv[2], dpi=110)
    return 0


if __name__ == "__main__":
    sys.exit(main())
