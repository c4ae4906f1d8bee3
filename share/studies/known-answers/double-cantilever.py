#!/usr/bin/python3 -B
r"""
title = "Double cantilever"
section = "specimens"
program = "verification_tests"
tests = ["Fracture.OpensADoubleCantileverUnderEndMoments", "Fracture.OpensADoubleCantileverUnderForces"]
statement = "Two arms on an interface are bent apart: at which moment does the crack run, at which force?"
theory = '$$M_c = \sqrt{G_f E h^3/12}, \qquad F_c = \frac{M_c}{a + 0.64 h}.$$'
source = "Beam theory, with the rotation of the root for forces."
model = "Arms of 10 mm of solid grain, 8 triangles or more over h, contacts on the interface only; process zones of two lengths."
tolerance = "2 % under moments, whatever the length of the process zone; 10 % under forces, where the rotation of the root is an estimate."
misses = "Cracks that leave their plane."
"""
from matplotlib.patches import Polygon

from answer import COMPUTED, GRAIN, arrow, main, view


def sketch(axes):
    for sign in (1, -1):
        xs = [0.1 * i for i in range(41)]
        open_ = [0.03 + 0.12 * max(0, 2.2 - x) ** 2 for x in xs]
        axes.add_patch(Polygon([(x, sign * o) for x, o in zip(xs, open_)] + [(x, sign * (o + 0.4)) for x, o in reversed(list(zip(xs, open_)))],
                               facecolor=GRAIN, edgecolor="black"))
        arrow(axes, (-0.1, sign * 0.75), (-0.1, sign * 1.3))
    axes.plot([2.2, 4], [0, 0], color=COMPUTED[0], lw=2)
    arrow(axes, (0, 0), (2.2, 0), "$a$", (1.2, 0.2))
    axes.text(-0.5, 0.95, "$F$, $M$", ha="center")
    axes.text(4.1, 0.25, "$h$")
    view(axes, -0.9, 4.5, -1.4, 1.4)


if __name__ == "__main__": main(globals())
