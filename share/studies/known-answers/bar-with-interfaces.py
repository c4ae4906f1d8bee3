#!/usr/bin/python3 -B
r"""
title = "Bar with interfaces: modulus and dispersion"
section = "dynamics"
program = "physics_tests"
tests = ["Bar.HasTheModulusOfItsInterfaces", "Bar.DispersesWavesByItsInterfaces"]
statement = "A bar with a spring every s: how stiff is it, how fast are long waves, and which frequency has a wave of which length?"
theory = '$$\frac{1}{E_{eff}} = \frac{1}{E} + \frac{1}{k s}, \qquad \cos q s = \cos \frac{\omega s}{c} - \frac{\omega Z}{2 k} \sin \frac{\omega s}{c}, \quad Z = \rho c.$$'
source = "Bloch's theorem for a periodic bar."
model = "Cells of grains with contacts between them, k s/E = 10."
tolerance = "1e-9 of the modulus, 0.5 % of frequencies."
misses = "Waves shorter than two spacings; contacts in shear."
"""
from answer import COMPUTED, arrow, box, main, view


def sketch(axes):
    for i in range(5):
        box(axes, i * 0.9, 0, 0.75, 0.4)
        if i: axes.plot([i * 0.9 - 0.15, i * 0.9 - 0.11, i * 0.9 - 0.04, i * 0.9], [0.2, 0.3, 0.1, 0.2], color=COMPUTED[0])
    arrow(axes, (0.82, -0.2), (1.72, -0.2), "$s$", (1.27, -0.4))
    axes.text(1.72, 0.55, "$k$", color=COMPUTED[0], ha="center")
    view(axes, -0.2, 4.6, -0.7, 0.9)


if __name__ == "__main__": main(globals())
