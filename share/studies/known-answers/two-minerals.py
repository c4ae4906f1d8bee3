#!/usr/bin/python3 -B
r"""
title = "A pulse at the boundary of two minerals, and a laminate"
section = "phases"
program = "physics_tests"
tests = ["Minerals.ShareAPulseAtTheirBoundary", "Minerals.HaveTheModulusOfReussInSeries", "Minerals.HaveTheModulusOfVoigtInParallel"]
statement = "A pulse meets the boundary of quartz and biotite: what passes, what comes back? How stiff is a laminate?"
theory = '$$T = \frac{2 Z_2}{Z_1 + Z_2}, \quad R = \frac{Z_2 - Z_1}{Z_1 + Z_2}, \qquad \frac{1}{E_R} = \sum \frac{f_i}{E_i}, \quad E_V = \sum f_i E_i.$$'
source = "Continuity of stress and velocity; Voigt (1889), Reuss (1929)."
model = "A bar of quartz (83.1 GPa, 2,650 kg/m³) and biotite (29.3 GPa, 3,000); a laminate of 62, 32 and 6 % of 60, 83.1 and 29.3 GPa."
tolerance = "2 % of the waves, 0.5 % of the moduli."
misses = "Oblique boundaries, more than two minerals for waves."
"""
from matplotlib.patches import Polygon

from answer import arrow, box, main, view


def sketch(axes):
    box(axes, 0, 0, 2, 0.4)
    axes.add_patch(Polygon([(2, 0), (4, 0), (4, 0.4), (2, 0.4)], facecolor="#8a8378", edgecolor="black"))
    arrow(axes, (0.5, 0.7), (1.4, 0.7), "1", (0.95, 0.9))
    arrow(axes, (2.3, 0.7), (3.1, 0.7), "$T$", (2.7, 0.9))
    arrow(axes, (1.7, -0.3), (1.2, -0.3), "$R$", (1.45, -0.55))
    axes.text(1, 0.2, "$Z_1$", ha="center", va="center")
    axes.text(3, 0.2, "$Z_2$", ha="center", va="center")
    view(axes, -0.2, 4.2, -0.8, 1.2)


if __name__ == "__main__": main(globals())
