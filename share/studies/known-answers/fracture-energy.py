#!/usr/bin/python3 -B
r"""
title = "Fracture energy of an interface that is pulled apart"
section = "specimens"
program = "verification_tests"
tests = ["Fracture.TakesItsEnergyOnAStraightInterface"]
statement = "A straight interface is pulled apart: which energy does it take?"
theory = '$$W_{external} - W_{elastic} - W_{kinetic} - W_{damping} = G_f A.$$'
source = "Definition of the fracture energy."
model = "Two blocks with one interface; each law, mode I and mixed values of Gf."
tolerance = "1 %; oscillations at this rate are 1 % of the strength."
misses = "A crack that runs: see the double cantilever."
"""
from answer import COMPUTED, arrow, box, main, view


def sketch(axes):
    box(axes, 0, 0, 1.4, 0.8)
    box(axes, 0, 0.9, 1.4, 0.8)
    axes.plot([0, 1.4], [0.85, 0.85], color=COMPUTED[0], lw=2)
    arrow(axes, (0.7, 1.72), (0.7, 2.2))
    arrow(axes, (0.7, -0.02), (0.7, -0.5))
    axes.text(1.5, 0.85, "$G_f$", color=COMPUTED[0], va="center")
    view(axes, -0.4, 2, -0.6, 2.3)


if __name__ == "__main__": main(globals())
