#!/usr/bin/python3 -B
r"""
title = "Elastic disc between two points"
section = "specimens"
program = "verification_tests"
tests = ["ElasticDisc.HasTheStressOfTwoPointLoads"]
statement = "The Brazilian test before it cracks: stress in the centre and along the horizontal diameter."
theory = '$$\sigma_x = \frac{2 P}{\pi D t} \left[\frac{D^2 - 4 x^2}{D^2 + 4 x^2}\right]^2, \qquad \sigma_y(0) = -\frac{6 P}{\pi D t}.$$'
source = "Hertz; Timoshenko & Goodier, Theory of Elasticity."
model = "A disc of 452 triangular grains with stiff contacts between platens; at rest, and of the three programs at 1 mm/s."
tolerance = "3 % inside half of the radius: cells, and platens that are no points."
misses = "Stress near the platens, where the loads are spread."
"""
import math

from matplotlib.patches import Circle

from answer import GRAIN, arrow, compare, main, view


def sketch(axes):
    axes.add_patch(Circle((0, 0), 1, facecolor=GRAIN, edgecolor="black"))
    arrow(axes, (0, 1.6), (0, 1.02), "$P$", (0.2, 1.4))
    arrow(axes, (0, -1.6), (0, -1.02))
    axes.plot([-1, 1], [0, 0], ":", color="black")
    axes.text(0.6, 0.1, "$x$")
    view(axes, -1.5, 1.5, -1.7, 1.7)


DIAMETER = 80  # mm


def stress_of(force, x, y):
    """σx and σy (MPa) of a disc of the thickness 1 m between two forces (MN)."""
    radius, above, below = DIAMETER / 2000, DIAMETER / 2000 - y, DIAMETER / 2000 + y
    upper, lower = (x * x + above ** 2) ** 2, (x * x + below ** 2) ** 2
    factor = -2 * force / math.pi
    return (factor * (above * x * x / upper + below * x * x / lower - 0.5 / radius),
            factor * (above ** 3 / upper + below ** 3 / lower - 0.5 / radius))


def comparisons(folder):
    """Means over the elements of a region, beside those of the formula at their centres; contacts are ten times as stiff as those of Augig granite."""
    import graincrack
    disc = graincrack.disc(diameter=(DIAMETER, "mm"), grains=452, elements_per_edge=2, output=folder / "disc.h5", quiet=True)
    run = graincrack.brazilian(disc, material="augig-granite", rate="1 mm/s", max_strain=1.25e-4, contact_normal_stiffness="6.87e6 MPa/mm", frames=0, threads=1,
                               contact_shear_stiffness="6.98e5 MPa/mm", output=folder / "run.h5", quiet=True)
    force = -1e-6 * (run.history["force_top"][-1] + run.history["force_bottom"][-1]) / 2
    corners = run.specimen.nodes[run.specimen.elements]
    x, y = corners.mean(axis=1).T
    (x0, y0), (x1, y1), (x2, y2) = corners.transpose(1, 2, 0)
    area = (x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)
    radius, scale = DIAMETER / 2000, 2 * force / (math.pi * DIAMETER / 1000)

    def compared(region, axis):
        mean = lambda values: (area * values)[region].sum() / area[region].sum()
        return mean(1e-6 * run.frame("last")["element_stress"][:, axis]), mean(stress_of(force, x, y)[axis])

    for axis, name in enumerate(("sigma_x", "sigma_y")):
        yield compare(f"elastic disc, three programs, mean around the centre, {name} (MPa)", *compared(x * x + y * y < (radius / 6) ** 2, axis), 0.03,
                      "2P/(pi D t), -6P/(pi D t)")
    for part in range(-3, 3):
        yield compare(f"elastic disc, three programs, sigma_x on the horizontal diameter at x/R = {100 * (2 * part + 1) / 12:.0f} % (MPa)",
                      *compared((6 * x / radius >= part) & (6 * x / radius < part + 1) & (abs(y) < radius / 8), 0), 0.03,
                      "(2P/pi D t) [(D^2 - 4x^2)/(D^2 + 4x^2)]^2", scale)


if __name__ == "__main__": main(globals())
