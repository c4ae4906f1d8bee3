#!/usr/bin/env python3
"""Strength against confining pressure, of a table that graincrack-post strength printed: python3 strengths.py TABLE.tsv PICTURE"""

import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from graincrack import Table

table = Table(sys.argv[1])
pressure = table["confining_pressure"]
strength = table["peak_compressive_stress"]

figure, axes = plt.subplots(figsize=(3.31, 2.6), layout="constrained")
axes.plot(pressure, strength, "o", color="0.6", label="specimens")
pressures = np.unique(pressure)
axes.plot(pressures, [strength[pressure == p].mean() for p in pressures], "_", color="black", markersize=14, label="means")
axes.set_xlabel("confining pressure, " + table.unit("confining_pressure"))
axes.set_ylabel("largest axial stress, " + table.unit("peak_compressive_stress"))
axes.set_ylim(bottom=0)
axes.legend(frameon=False)
figure.savefig(sys.argv[2], dpi=300)
