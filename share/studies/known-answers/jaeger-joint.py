#!/usr/bin/python3 -B
r"""
title = "Jaeger's plane of weakness"
section = "specimens"
program = "physics_tests"
tests = ["Joint.SlidesAtJaegersStrengthWithDefaultOptions"]
statement = "A specimen with a joint at the angle β, under a pressure: at which axial stress does the joint slide?"
theory = '$$\sigma_1 = \sigma_3 + \frac{2 (c + \sigma_3 \tan \varphi)}{(1 - \tan \varphi/\tan \beta) \sin 2 \beta}.$$'
source = "Jaeger (1960), Geological Magazine 97; Jaeger, Cook & Zimmerman, Fundamentals of Rock Mechanics, § 4.8."
model = "Two blocks of one grain each, smooth platens, the automatic loading rate of the tests, 60 × 200 mm. Of the three programs the joint has a cohesion too, which it loses at once."
tolerance = "Inertia and damping that the automatic rate allows."
misses = "Failure of the blocks beside the joint."
"""
import math

from answer import COMPUTED, arrow, block, box, compare, main, specimen_of, view, without_warnings


def sketch(axes):
    box(axes, 0, 0, 1, 2)
    axes.plot([0, 1], [0.4, 1.6], color=COMPUTED[0], lw=2)
    arrow(axes, (0.5, 2.5), (0.5, 2.03), r"$\sigma_1$", (0.7, 2.3))
    for side, start in ((-0.03, -0.5), (1.03, 1.5)): arrow(axes, (start, 1), (side, 1))
    axes.text(1.35, 1.15, r"$\sigma_3$")
    axes.text(0.35, 0.55, r"$\beta$")
    view(axes, -0.7, 1.8, -0.2, 2.6)


FRICTION, COHESION = math.radians(30), 10  # MPa


def comparisons(folder):
    """The joint is the only contact; with coulomb-slip it keeps its friction and loses its cohesion at once."""
    import graincrack
    for slope, pressure in ((50, 5), (50, 20), (62, 5), (62, 20)):
        beta, width, height = math.radians(slope), 0.06, 0.2
        halves = [block("rock lower", 6, 6, -width / 2, -height / 2, width, height / 2), block("rock upper", 6, 6, -width / 2, 0, width, height / 2)]
        halves = [(name, [(x, y + (1 - 2 * abs(y) / height) * math.tan(beta) * x) for x, y in points], triangles) for name, points, triangles in halves]
        joint = specimen_of(folder / f"joint-{slope}", halves)
        strength = pressure + 2 * (COHESION + pressure * math.tan(FRICTION)) / ((1 - math.tan(FRICTION) / math.tan(beta)) * math.sin(2 * beta))
        run = without_warnings(graincrack.triaxial, joint, material="augig-granite", confining_pressure=(pressure, "MPa"), contact_law="coulomb-slip",
                               contact_tensile_strength="1 MPa", contact_cohesion=(COHESION, "MPa"), contact_friction_angle="30 deg", platen_friction=0,
                               max_strain=1.3 * strength / 25800, frames=0, threads=1, output=folder / f"joint-{slope}-{pressure}.h5")
        yield compare(f"strength of a joint, three programs, {slope} deg, {pressure} MPa, cohesion {COHESION} MPa (MPa)",
                      graincrack.strength(run)["peak_compressive_stress"][0], strength, 0.01, "Jaeger (1960), to 1 %")


if __name__ == "__main__": main(globals())
