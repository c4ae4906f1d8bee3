#!/usr/bin/python3 -B
r"""
title = "Column under its weight"
section = "dynamics"
program = "physics_tests"
tests = ["Program.LetsAColumnCarryItsWeight"]
statement = "A column settles under gravity: stress along its height and force at its foot."
theory = '$$\sigma_{yy} = -\rho g (h/2 - y).$$'
source = "Equilibrium."
model = "One grain of 25 × 100 mm, 4 × 16 cells of four triangles, on a smooth floor, damping 0.8."
tolerance = "0.1 % of the stress at the foot, 1e-6 of the weight."
misses = "Contacts: the column is one grain."
"""
from matplotlib.patches import Polygon

from answer import COMPUTED, arrow, block, box, compare, main, run_program, specimen_of, view


def sketch(axes):
    box(axes, 0, 0, 0.5, 2)
    axes.plot([-0.2, 0.7], [-0.02, -0.02], color="black", lw=2)
    arrow(axes, (0.25, 1.3), (0.25, 0.7), "$g$", (0.36, 1))
    axes.add_patch(Polygon([(0.9, 0), (1.5, 0), (0.9, 2)], fill=False, edgecolor=COMPUTED[0]))
    axes.text(1.3, 0.9, r"$-\sigma_{yy}$", color=COMPUTED[0])
    view(axes, -0.5, 2, -0.3, 2.2)


PROGRAM = """name = "column under its weight"
damping = 0.8
gravity = ["0 m/s2", "-9.81 m/s2"]
stages = ["settle"]
boundary.floor = { on = "bottom", velocity_y = 0 }
probe.low.circle = ["0 mm", "-31.25 mm", "6 mm"]
probe.middle.circle = ["0 mm", "0 mm", "6 mm"]
probe.high.circle = ["0 mm", "31.25 mm", "6 mm"]
stage.settle.until = { time = "20 ms", rest = 1e-9 }
stage.settle.must_end_by = "rest"
"""


def comparisons(folder):
    """The mean over a circle is exact where it lies evenly about a row of nodes, as elements have a constant stress and the column a linear one."""
    column = specimen_of(folder / "column", [block("rock", 4, 16, -0.0125, -0.05, 0.025, 0.1)])
    run = run_program(folder / "column", column, PROGRAM, material="augig-granite")
    foot = 2650 * 9.81 * 0.1  # Pa
    for probe, y in (("low", -31.25), ("middle", 0), ("high", 31.25)):
        yield compare(f"column under its weight, three programs, axial stress at y = {y} mm over that of the foot",
                      run.probe(probe)["stress_yy"][-1] / foot, -(0.5 - y / 100), 1e-3, "rho g (h/2 - y)", 1)
    yield compare("column under its weight, three programs, reaction over weight", run.probe("floor")["force_y"][-1] / (foot * 0.025), 1, 1e-6, "weight")


if __name__ == "__main__": main(globals())
