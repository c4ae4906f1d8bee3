#!/usr/bin/python3 -B
r"""
title = "A joint in direct shear, forth and back"
section = "specimens"
program = "physics_tests"
tests = ["Program.ShearsAJointAtItsFriction"]
statement = "A joint under a constant pressure is sheared forth and back: which force does it bear?"
theory = '$$T = \pm N \tan \varphi.$$'
source = "Coulomb's friction, as signed increments."
model = "Two grains of 40 × 5 mm, φ 30°, 10 MPa as a follower pressure, 50 mm/s, damping 0.8."
tolerance = "0.5 %."
misses = "Dilation; friction that changes with slip."
"""
from answer import COMPUTED, arrow, box, main, view


def sketch(axes):
    box(axes, 0, 0, 2, 0.5)
    box(axes, 0.1, 0.5, 2, 0.5)
    axes.plot([0.1, 2], [0.5, 0.5], color=COMPUTED[0], lw=2)
    for x in (0.5, 1.1, 1.7): arrow(axes, (x, 1.4), (x, 1.03))
    arrow(axes, (2.15, 0.8), (2.75, 0.8), "$T$", (2.6, 1.0))
    axes.text(1.1, 1.5, "$N$", ha="center")
    axes.plot([-0.1, 2.1], [-0.02, -0.02], color="black", lw=2)
    view(axes, -0.3, 2.9, -0.2, 1.8)


if __name__ == "__main__": main(globals())
