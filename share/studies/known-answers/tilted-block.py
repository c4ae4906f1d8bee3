#!/usr/bin/python3 -B
r"""
title = "Toppling and sliding of a block on a slope"
section = "dynamics"
program = "verification_tests"
tests = ["TiltedBlock.TopplesOrSlidesAtTheLowerOfBothSlopes", "TiltedBlock.TopplesWhileItSlidesBelowTheTangentOfItsFriction"]
statement = "A block of the width b and the height h stands on a base that is tilted. At which slope does it topple, at which does it slide?"
caption = "Left: the block. Right: slope at which it moves, for friction of 20° and 30°."
theory = '''
A block topples at the slope $\alpha_t$, where its centre is above its edge, or slides at $\alpha_s$, whichever is less:

$$\tan \alpha_t = b/h, \qquad \tan \alpha_s = \tan \varphi.$$

If a slope is steeper than its friction, a block that slides is turned by the friction alone: it topples for $b/h < \tan \varphi$, not for $b/h < \tan \alpha$, and otherwise slides with $g (\sin \alpha - \cos \alpha \tan \varphi)$.
'''
source = "Goodman & Bray (1976), Toppling of rock slopes, ASCE; Sagaseta (1986), Rock Mech. Rock Eng. 19, 261–266."
model = "h 0.1 m, 6 cells of four triangles high, Augig granite, joint 1000 GPa/m, gravity 981 m/s² (thresholds are free of it). The block settles on a level base, damping 0.8. Gravity then turns in steps of 0.5 % of the tangent, 30 ms each, damping 0.5, until the block has turned by 0.005 or slid by 0.1 mm; or to 30° within 30 ms without damping."
tolerance = "0.75 %: the step of 0.5 %, and half a step for the sinking of the edge. All four have moved at the first step above the threshold; below it they stand. 1 % of the acceleration."
misses = "One block; no column of blocks that push each other. Steps are slow, so that a block that would be toppled by a shock is not tested."
"""
import math

from answer import COMPUTED, arrow, box, main, turned, view


def figure(sketch, plot, curves):
    box(sketch, -0.6, -0.15, 2, 0.15, 0.35)
    box(sketch, 0, 0, 0.5, 1.2, 0.35)
    sketch.plot([-0.56, 1.4], [-0.35, -0.35], color="black", lw=0.8)
    sketch.text(0.35, -0.22, r"$\alpha$")
    centre = turned([(0.25, 0.6)], 0.35)[0]
    arrow(sketch, centre, (centre[0], centre[1] - 0.6), "$g$", (centre[0] + 0.1, centre[1] - 0.55))
    sketch.text(*turned([(0.25, 1.3)], 0.35)[0], "$b$", ha="center", va="center")
    sketch.text(*turned([(0.6, 0.6)], 0.35)[0], "$h$", ha="center", va="center")
    view(sketch, -0.8, 1.7, -0.5, 1.7)
    slopes = [i / 200 for i in range(1, 201)]
    for colour, friction in ((COMPUTED[0], 30), (COMPUTED[1], 20)):
        plot.plot(slopes, [min(x, math.tan(math.radians(friction))) for x in slopes], ":", color=colour, label=rf"exact, $\varphi$ = {friction}°")
    for slenderness, friction in (("0.2", 30), ("0.4", 30), ("0.4", 20), ("0.8", 20)):
        c = curves(f"tilt-{slenderness}-{friction}")
        exact = min(float(slenderness), math.tan(math.radians(friction)))
        topples = float(slenderness) < math.tan(math.radians(friction))
        plot.plot(float(slenderness), c["slope_over_threshold"][-1] * exact, "^" if topples else "s", color=COMPUTED[0 if friction == 30 else 1],
                  ms=8, mfc="none", label=f"computed, {'topples' if topples else 'slides'}" if (slenderness, friction) in (("0.2", 30), ("0.8", 20)) else None)
    plot.set_xlabel("$b/h$")
    plot.set_ylabel(r"$\tan\,\alpha$ at which it moves")
    plot.legend(frameon=False, fontsize=8)


if __name__ == "__main__": main(globals())
