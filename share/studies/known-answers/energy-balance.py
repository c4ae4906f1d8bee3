#!/usr/bin/python3 -B
r"""
title = "Energy balance through failure"
section = "dynamics"
program = "physics_tests"
tests = ["EnergyBalance.ClosesThroughFailure"]
statement = "Every term of the energy is computed from its own definition. Does their sum equal the external work while a specimen breaks?"
theory = '$$W_{external} = E_{strain} + E_{contact} + E_{kinetic} + D_{fracture} + D_{friction} + D_{damping} + D_{platen}.$$'
source = "Conservation of energy; no term is a remainder."
model = "Small specimens of grains in uniaxial compression and in tension, every contact law."
tolerance = "0.1 % and 0.5 % of the largest stored energy: the scheme is of second order in the step."
misses = "Terms that are wrong in the same way twice; a further test mis-scales each term by 1 % and sees it."
"""
from answer import COMPUTED, arrow, box, main, view


def sketch(axes):
    box(axes, 0, 0, 1, 2)
    axes.plot([0.2, 0.45, 0.5, 0.8], [0.3, 0.9, 1.2, 1.8], color=COMPUTED[0], lw=2)
    for y, end in ((2.5, 2.05), (-0.5, -0.05)): arrow(axes, (0.5, y), (0.5, end))
    for y in (2.02, -0.02): axes.plot([-0.2, 1.2], [y, y], color="black", lw=2)
    view(axes, -0.6, 1.6, -0.6, 2.6)


if __name__ == "__main__": main(globals())
