#!/usr/bin/python3 -B
r"""
title = "Spinning disc"
section = "elements"
program = "physics_tests"
tests = ["SpinningDisc.BearsItsCentrifugalStressThroughAWholeTurn"]
statement = "A disc that turns by itself: stress in its centre, and whether it stays through a whole turn."
theory = '$$\sigma(0) = \frac{3 + \nu}{8} \rho \omega^2 R^2.$$'
source = "Timoshenko & Goodier, Theory of Elasticity."
model = "R 40 mm, 100 rad/s, plane stress, grains with contacts; 13 times in a turn."
tolerance = "1.25 % beside theory (compliance of contacts), 0.1 % through the turn."
misses = "Strains that are not small."
"""
from matplotlib.patches import Circle

from answer import GRAIN, arrow, main, view


def sketch(axes):
    axes.add_patch(Circle((0, 0), 1, facecolor=GRAIN, edgecolor="black"))
    arrow(axes, (0.9, -0.9), (0.9, 0.9), r"$\omega$", (1.5, 0), connectionstyle="arc3,rad=0.45")
    arrow(axes, (0, 0), (-0.7, 0.7), "$R$", (-0.25, 0.5))
    view(axes, -1.4, 1.8, -1.3, 1.3)


if __name__ == "__main__": main(globals())
