#!/usr/bin/python3 -B
r"""
title = "Waves in a bar and their reflections"
section = "dynamics"
program = "physics_tests"
tests = ["Program.SendsWavesThatAreReflected"]
statement = "A pulse of stress at one end of a bar: speed, velocity of the points, and what comes back from a free and from a held end."
theory = '$$c_P^2 = \frac{\lambda + 2 \mu}{\rho}, \quad c_S^2 = \frac{\mu}{\rho}, \quad c_0^2 = \frac{E}{\rho}, \qquad v = \frac{\sigma}{\rho c};$$ a free end gives back the same velocity, a held end the opposite one.'
source = "Achenbach (1973), Wave Propagation in Elastic Solids."
model = "One grain of 200 cells of 1 mm, a sin² pulse of 1 MPa and 8 µs, in plane strain and plane stress, sides held or free, no damping."
tolerance = "0.5 % of speeds, 1 % of amplitudes: 27 cells a pulse, whose dispersion is 6e-4."
misses = "Oblique waves; waves through contacts (see the bar with interfaces)."
"""
from answer import arrow, box, main, view


def sketch(axes):
    box(axes, 0, 0, 4, 0.4)
    arrow(axes, (-0.7, 0.2), (-0.05, 0.2), r"$\sigma$", (-0.5, 0.45))
    arrow(axes, (0.8, 0.7), (1.8, 0.7), "$c$", (1.3, 0.95))
    arrow(axes, (3.4, -0.3), (2.4, -0.3), "reflected", (2.9, -0.6))
    view(axes, -0.9, 4.3, -0.9, 1.2)


if __name__ == "__main__": main(globals())
