#!/usr/bin/python3 -B
r"""
title = "A block bounces on a penalty floor"
section = "dynamics"
program = "physics_tests"
tests = ["Platen.LetsABlockBounceAsASpring"]
statement = "A block hits a floor of springs: how long does it stay, and with which speed does it leave?"
theory = '$$t = \pi \sqrt{m/k},$$ and the speed of before.'
source = "Harmonic oscillator."
model = "One grain of two triangles, 20 × 20 mm, on a platen of 10⁸ N/m per metre; no damping."
tolerance = "0.1 %; the compliance of the block adds 1e-4."
misses = "Impact of a corner; friction at the floor."
"""
from answer import COMPUTED, arrow, box, main, view


def sketch(axes):
    box(axes, 0, 0.6, 1, 1)
    for x in (0.15, 0.5, 0.85): axes.plot([x, x + 0.06, x - 0.06, x + 0.06, x], [0, 0.1, 0.25, 0.4, 0.5], color=COMPUTED[0])
    axes.plot([-0.3, 1.3], [0, 0], color="black", lw=2)
    arrow(axes, (0.5, 1.2), (0.5, 0.75), "$v$", (0.65, 1.0))
    axes.text(1.0, 0.25, "$k$", color=COMPUTED[0])
    view(axes, -0.6, 1.6, -0.2, 1.8)


if __name__ == "__main__": main(globals())
