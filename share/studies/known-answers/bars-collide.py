#!/usr/bin/python3 -B
r"""
title = "Two equal bars collide"
section = "dynamics"
program = "physics_tests"
tests = ["Bar.ExchangesItsVelocityWithAnEqualBar"]
statement = "A bar hits an equal one at rest: contact time, stress, and both velocities afterwards."
theory = '$$t = 2 L/c_0, \qquad \sigma = \rho c_0 v/2,$$ and the velocities are exchanged.'
source = "St. Venant's theory of impact."
model = "Bars of 0.1 m, 0.1 m/s, contact through the joint between them."
tolerance = "0.5 %: dispersion of the front in cells."
misses = "Bars of different impedance, three-dimensional effects."
"""
from answer import arrow, box, main, view


def sketch(axes):
    box(axes, 0, 0, 2, 0.3)
    box(axes, 2.15, 0, 2, 0.3)
    arrow(axes, (0.6, 0.5), (1.4, 0.5), "$v$", (1, 0.7))
    axes.text(1, -0.25, "$L$", ha="center")
    view(axes, -0.2, 4.4, -0.6, 1)


if __name__ == "__main__": main(globals())
