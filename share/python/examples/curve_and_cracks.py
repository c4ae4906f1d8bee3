#!/usr/bin/env python3
"""Stress and cracks over strain: python3 curve_and_cracks.py RUN.h5 PICTURE"""

import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

from graincrack import Run

run = Run(sys.argv[1])
shortening = -100 * run.history["axial_strain"]

figure, left = plt.subplots(figsize=(3.31, 2.6), layout="constrained")
left.plot(shortening, -run.history["axial_stress"] / 1e6, color="black")
left.set_xlabel("axial shortening, %")
left.set_ylabel("axial stress, MPa")
right = left.twinx()
right.plot(shortening, run.history["tensile_cracks"], color="tab:red", linestyle="--", label="failed open")
right.plot(shortening, run.history["shear_cracks"], color="tab:blue", linestyle=":", label="failed closed")
right.set_ylabel("contacts past their peak")
right.legend(loc="upper left", frameon=False)
left.set_title(f"{run['material']}, {run.test}, {run.specimen['grains']} grains", fontsize="medium")
figure.savefig(sys.argv[2], dpi=300)
