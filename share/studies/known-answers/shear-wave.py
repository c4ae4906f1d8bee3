#!/usr/bin/python3 -B
r"""
title = "Slip of a joint under a harmonic shear wave"
section = "specimens"
program = "verification_tests"
tests = ["ShearWave.SlipsOnAJoint"]
statement = "A plane harmonic shear wave of the amplitude τ0 meets a joint that bears τs, at right angles to its direction. Which fractions of its energy are transmitted, reflected and absorbed, and how far does the joint slip?"
caption = "Left: column with its joint. Right: stress behind the joint in five strengths, computed and exact; the dotted lines are τ0 sin ωt cut off at ±τs."
theory = '''
A joint without a stiffness of its own sticks while it bears what the wave brings and slides at τs when the wave brings more. The stress behind it is

$$\tau_T = \max(-\tau_s, \min(\tau_s, \tau_0 \sin \omega t)), \qquad \tau_R = \tau_0 \sin \omega t - \tau_T, \qquad \dot s = 2 \tau_R / Z, \quad Z = \rho c_S.$$

With $r = \tau_s/\tau_0$ and $\theta = \arcsin r$ the fractions of the incident energy are

$$T^2 = \tfrac{4}{\pi} \left[\tfrac{\theta}{2} - \tfrac{\sin 2\theta}{4} + r^2 (\tfrac{\pi}{2} - \theta)\right], \qquad
R^2 = \tfrac{4}{\pi} \left[\tfrac{1}{2} (\tfrac{\pi}{2} - \theta) + \tfrac{\sin 2\theta}{4} - 2 r \cos \theta + r^2 (\tfrac{\pi}{2} - \theta)\right], \qquad A^2 = 1 - R^2 - T^2,$$

and a half wave makes the joint slip by $(2 \tau_0/\pi f Z) [\sqrt{1 - r^2} - r (\pi/2 - \theta)]$.
'''
source = "Miller (1978), Int. J. Num. Anal. Meth. Geomech. 2, 391–407; the integrals are elementary."
model = "A column of 200 cells of four triangles and 2.5 wavelengths (Augig granite, 10 kHz, τ0 0.1 MPa) in two grains, moving across only. The joint is broken from the start, 70 GPa/mm stiff and closed by 10 MPa; tan φ = τs/10 MPa. No damping. The second period of the wave passes before reflections from the ends arrive."
tolerance = "Errors of energies are relative to the incident energy. They are of second order in the cell: with 40 instead of 80 cells a wave they are four times as large (at most 0.0074; of the slip 0.030)."
misses = "Normal incidence alone: no wave that opens the joint. The joint is almost rigid, ωZ/2ks = 0.0024, so that a wrong ks passes. Friction does not depend on rate in this model, and it is not tested that it could."
"""
import math

from answer import COMPUTED, EXACT, arrow, box, main, view


def figure(sketch, plot, curves):
    box(sketch, 0, 0, 0.6, 2)
    box(sketch, 0, 2, 0.6, 2)
    sketch.plot([-0.2, 0.8], [2, 2], color=COMPUTED[0], lw=2)
    sketch.text(0.9, 2, r"joint, $\tau_s$", va="center")
    arrow(sketch, (-0.1, -0.25), (0.7, -0.25), r"$\tau_0\,\sin\,\omega t$", (0.3, -0.6))
    for y, text in ((1, "incident,\nreflected"), (3, "transmitted")):
        arrow(sketch, (0.3, y - 0.4), (0.3, y + 0.4))
        sketch.text(0.9, y, text, va="center")
    view(sketch, -0.6, 2.6, -0.9, 4.2)
    impedance = 2650 * math.sqrt(25.8e9 / (2 * 1.23 * 2650))
    for colour, ratio in zip(COMPUTED, ("0.1", "0.25", "0.5", "0.75", "0.9")):
        c = curves(f"shear-wave-{ratio}")
        t = [1e6 * value for value in c["time_s"]]
        plot.plot(t, [impedance * v / 1e5 for v in c["velocity_above_m_s"]], color=colour, label=ratio)
        plot.plot(t, [s / 1e5 for s in c["exact_stress_above_Pa"]], ":", color=EXACT, lw=1, label="exact" if ratio == "0.9" else None)
    plot.set_xlim(110, 330)
    plot.set_xlabel("time (µs)")
    plot.set_ylabel(r"transmitted stress over $\tau_0$")
    plot.legend(frameon=False, title=r"$\tau_s/\tau_0$", ncols=2, fontsize=7, loc="lower left")


if __name__ == "__main__": main(globals())
