#!/usr/bin/python3 -B
r"""
title = "A block slides down a slope"
section = "dynamics"
program = "physics_tests"
tests = ["Program.LetsABlockSlideDownASlope"]
statement = "A block that has settled on a slope is left to a friction below the slope: with which acceleration does it slide?"
theory = '$$\ddot s = g (\sin \alpha - \cos \alpha \tan \varphi),$$ and none where the slope is less than φ.'
source = "Coulomb's friction."
model = "A block of 40 × 5 mm on another of the same size, joint 10⁴ times softer than in Augig granite so that the block is rigid beside it, no damping while it slides. Of the three programs the base is 60 mm long, and the block slides for 10 ms."
tolerance = "0.5 %, of the acceleration or of g."
misses = "A stiff joint, on which an elastic block without damping chatters and is braked less, by up to a half."
"""
import math

from answer import arrow, block, box, compare, main, run_program, specimen_of, turned, view


def sketch(axes):
    box(axes, -1.2, -0.2, 2.6, 0.2, 0.5)
    box(axes, -0.5, 0, 0.9, 0.3, 0.5)
    arrow(axes, *turned([(-0.6, 0.15), (-1.1, 0.15)], 0.5), r"$\ddot s$", turned([(-1.2, 0.3)], 0.5)[0])
    axes.plot([-1.0, 1.2], [-0.75, -0.75], color="black", lw=0.8)
    axes.text(-0.2, -0.6, r"$\alpha$")
    view(axes, -1.5, 1.5, -0.9, 1)


G = 9.81  # m/s2
PROGRAM = """name = "block on a slope"
gravity = [{}, {}]
stages = ["run"]
row_every = "0.1 ms"
boundary.base = {{ box = ["-1 m", "1 m", "-1 m", "-2 mm"], velocity_x = 0, velocity_y = 0 }}
probe.block.point = ["0 mm", "2.5 mm"]
stage.run.until = {}
"""


def comparisons(folder):
    """The block settles, damped, with a friction of 60°; then it has no damping, and the friction that is wanted."""
    blocks = specimen_of(folder / "blocks", [block("rock base", 12, 1, -0.03, -0.005, 0.06, 0.005), block("rock block", 8, 1, -0.0185, 1e-6, 0.04, 0.005)])
    values = {"material": "augig-granite", "contact_law": "coulomb-slip", "contact_normal_stiffness": "68.7 GPa/m", "contact_shear_stiffness": "6.98 GPa/m"}
    for slope, friction in ((30, 20), (35, 30), (20, 30)):
        a, phi = math.radians(slope), math.radians(friction)
        pull = (-G * math.sin(a), -G * math.cos(a))
        settled = run_program(folder / f"settled-{slope}", blocks, PROGRAM.format(*pull, '{ time = "40 ms", rest = 1e-6 }'), damping=0.8, save_state=True,
                              contact_friction_angle="60 deg", mass_scaling="none", **values)
        run = run_program(folder / f"slides-{slope}", blocks, PROGRAM.format(*pull, '{ time = "10 ms" }'), damping="none", restart=settled,
                          contact_friction_angle=f"{friction} deg", **values)
        time, velocity = run.history["time"], run.probe("block")["velocity_x"]
        from_rest = time > settled.history["time"][-1] + 3e-4
        first, last = from_rest.argmax(), -1
        measured = (velocity[first] - velocity[last]) / (time[last] - time[first])
        exact = max(G * (math.sin(a) - math.cos(a) * math.tan(phi)), 0)
        yield compare(f"block on a slope of {slope} deg, friction {friction} deg, three programs, over g", measured / G, exact / G, 5e-3,
                      "sin a - cos a tan phi", 1)


if __name__ == "__main__": main(globals())
