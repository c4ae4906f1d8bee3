#!/usr/bin/env python3
"""Grains and cracks at the peak, displacements enlarged: python3 crack_map.py RUN.h5 PICTURE [FACTOR]"""

import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.collections import LineCollection, PolyCollection

from graincrack import Run

run = Run(sys.argv[1])
factor = float(sys.argv[3]) if len(sys.argv) > 3 else 10.0
peak = run.frame("peak")
position = 1e3 * (run.specimen.nodes + factor * peak["displacement"])

figure, axes = plt.subplots(figsize=(3.31, 5.5), layout="constrained")
axes.add_collection(PolyCollection(position[run.specimen.elements], facecolor="0.85", edgecolor="0.7", linewidth=0.2))
facing = run.specimen.contacts["nodes"]
states = peak.names("state")
for name, color in (("failed in tension", "tab:red"), ("failed in shear", "tab:blue")):
    failed = (peak["state"] == states.index(name)).any(axis=1)
    lines = (position[facing[failed][:, :2]] + position[facing[failed][:, 2:]]) / 2
    axes.add_collection(LineCollection(lines, colors=color, linewidth=0.8, label=f"{name}: {failed.sum()}"))
axes.set_aspect("equal")
axes.autoscale()
axes.set_xlabel("mm")
axes.set_ylabel("mm")
axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.08), frameon=False)
axes.set_title(f"at the peak, displacements × {factor:g}", fontsize="medium")
figure.savefig(sys.argv[2], dpi=300)
