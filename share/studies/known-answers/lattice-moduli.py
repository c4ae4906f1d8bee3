#!/usr/bin/python3 -B
r"""
title = "Moduli of an equilateral lattice"
section = "elements"
program = "physics_tests"
tests = ["Moduli.AreThoseOfAnEndlessEquilateralLattice", "Moduli.AreThoseOfTheIsotropicFormulaInRandomMeshes"]
statement = "Grains with elastic contacts: E and ν of the whole."
theory = '$$\frac{1}{E_{eff}} = \frac{1}{E} + S_v \left(\frac{3}{8 k_n} + \frac{1}{8 k_s}\right), \qquad \nu_{eff} = \left[\frac{\nu}{E} - \frac{S_v}{8} \left(\frac{1}{k_n} - \frac{1}{k_s}\right)\right] E_{eff}, \quad S_v = \frac{2 \sqrt 3}{a}.$$'
source = "Compliances of the contacts by direction; for random meshes S_v is their length per area."
model = "Equilateral triangles of edge a; random meshes of 1,152 and 1,840 grains."
tolerance = "1e-9 on the lattice, where the formula is exact; 0.5 % of E and 2 % of ν on random meshes."
misses = "Contacts that have failed."
"""
import math

from matplotlib.patches import Polygon

from answer import COMPUTED, GRAIN, main, view


def sketch(axes):
    h = math.sqrt(0.75)
    for row in range(2):
        for i in range(3):
            x = i + 0.5 * row
            axes.add_patch(Polygon([(x, row * h), (x + 1, row * h), (x + 0.5, row * h + h)], facecolor=GRAIN, edgecolor=COMPUTED[0]))
            axes.add_patch(Polygon([(x + 1, row * h), (x + 1.5, row * h + h), (x + 0.5, row * h + h)], facecolor=GRAIN, edgecolor=COMPUTED[0]))
    axes.text(0.5, -0.25, "$a$", ha="center")
    axes.text(4.1, h, "$k_n$, $k_s$", color=COMPUTED[0], ha="center")
    view(axes, -0.3, 4.7, -0.5, 2)


if __name__ == "__main__": main(globals())
