#!/usr/bin/python3 -B
r"""
title = "Rayleigh wave on a free surface"
section = "dynamics"
program = "verification_tests"
tests = ["RayleighWave.HasItsSpeedAndItsMode"]
statement = "How fast is a wave along a free surface, and how far do its points move along and across it?"
caption = "Left: half a wavelength between smooth walls. Right: velocities of two points of the surface over six periods, plane strain."
theory = '''
$$(2 - \xi^2)^2 = 4 \sqrt{1 - \xi^2} \sqrt{1 - \xi^2 c_S^2/c_P^2}, \qquad \xi = c_R/c_S;$$

at the depth $z$, with $q^2 = 1 - c_R^2/c_P^2$, $s^2 = 1 - c_R^2/c_S^2$ and the wave number $k$,

$$u_x \propto \left(e^{-qkz} - \tfrac{2 q s}{1 + s^2} e^{-skz}\right) \sin kx, \qquad u_y \propto \left(\tfrac{2 q}{1 + s^2} e^{-skz} - q e^{-qkz}\right) \cos kx.$$
'''
source = "Rayleigh (1885), Proc. London Math. Soc. 17; Achenbach (1973), Wave Propagation in Elastic Solids."
model = "A strip of half a wavelength (50 mm) and three wavelengths deep between smooth walls, where a standing wave is the same as in a half-space; 20 × 120 cells of four triangles, Augig granite, ν 0.23, no damping. It starts with the velocities of the wave and swings six times; the speed is twice the width over the mean period."
tolerance = "40 cells a wave: errors are 2.3e-4 of the speed and 2.0e-3 of the ratio, and with 80 cells 3.6e-5 and 5.8e-4."
misses = "The wave is given, not excited by a load, and meets no crack. One direction of the grid; one wavelength."
"""
import math

from answer import COMPUTED, EXACT, arrow, box, main, view


def figure(sketch, plot, curves):
    box(sketch, 0, 0, 1, 3)
    xs = [i / 40 for i in range(41)]
    sketch.plot(xs, [3 + 0.25 * math.cos(math.pi * x) for x in xs], color=COMPUTED[0])
    for x, ha in ((-0.06, "right"), (1.06, "left")):
        for y in (0.4, 1.1, 1.8, 2.5): sketch.plot(x, y, "o", mfc="white", mec="black", ms=5)
    sketch.text(1.25, 1.5, "smooth walls", va="center")
    sketch.text(1.25, 3, "free", va="center")
    arrow(sketch, (0, -0.25), (1, -0.25), r"$\lambda/2$", (0.5, -0.5))
    arrow(sketch, (1, -0.25), (0, -0.25))
    view(sketch, -0.3, 2.3, -0.7, 3.4)
    speed, width = 1822.449, 0.05
    c = curves("rayleigh-strain")
    t = [1e6 * value for value in c["time_s"]]
    q, s = math.sqrt(1 - (speed / 3359.56) ** 2), math.sqrt(1 - (speed / 1989.39) ** 2)
    mixed = 2 * q / (1 + s * s)
    for column, amplitude, colour, text in (("velocity_y_m_s", mixed - q, COMPUTED[0], "across the surface, at a wall"),
                                            ("velocity_x_m_s", 1 - mixed * s, COMPUTED[1], "along it, in the middle")):
        plot.plot(t, c[column], color=colour, label=text)
        plot.plot(t, [amplitude * math.cos(math.pi * speed / width * x * 1e-6) for x in t], ":", color=EXACT, lw=1,
                  label="exact" if column == "velocity_x_m_s" else None)
    plot.set_xlabel("time (µs)")
    plot.set_ylabel("velocity (m/s)")
    plot.set_ylim(-0.9, 1.35)
    plot.legend(frameon=False, loc="upper right", ncols=2, fontsize=7)


if __name__ == "__main__": main(globals())
