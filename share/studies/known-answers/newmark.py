#!/usr/bin/python3 -B
r"""
title = "Newmark's sliding block"
section = "dynamics"
program = "verification_tests"
tests = ["NewmarkBlock.SlidesAsNewmarkHasIt"]
statement = "A base with a block on it is accelerated by $a$ over $t$ and then keeps its speed. How far does the block slide?"
caption = "Left: base and block. Right: slip, computed and exact: 1 g for 0.1 s on a level base, and for 0.08 s up a slope of 10°; φ 20°."
theory = '''
Friction gives the block $A = g (\cos \beta \tan \varphi - \sin \beta)$. It is as fast as the base, $v = a t$, after $v/A$, and has slid

$$s = \frac{v^2}{2 A} \left(1 - \frac{A}{a}\right).$$
'''
source = "Newmark (1965), Géotechnique 15, 139–160."
model = "A block of 0.4 × 0.1 m (8 × 2 cells of four triangles) on a base of 1 m, its nodes nowhere above those of the base; joint 10 GPa/m, Augig granite. The block settles with damping 0.8; then the base moves and there is no damping. The block passes edges of the base while it slides."
tolerance = "0.5 % of the slip and 1 % of the acceleration: friction is mobilised after a quarter of the period of the block on its springs, 0.25 ms, the block swings on them, and edges are passed. Springs are soft on purpose: an elastic block that slides on a stiff joint without damping chatters."
misses = "One pulse, not an earthquake; slip in one direction. Friction that falls with rate or slip is not in the model."
"""
import math

from answer import COMPUTED, EXACT, arrow, block, box, compare, main, run_program, specimen_of, turned, view, write_curves


def figure(sketch, plot, curves):
    box(sketch, -1.2, -0.2, 2.6, 0.2, 0.18)
    box(sketch, -0.5, 0, 0.9, 0.4, 0.18)
    arrow(sketch, *turned([(-0.6, -0.45), (0.6, -0.45)], 0.18), "$a$ for $t$", turned([(0.9, -0.45)], 0.18)[0])
    sketch.text(*turned([(-0.05, 0.2)], 0.18)[0], r"$\varphi$", ha="center", va="center")
    sketch.text(1.25, -0.15, r"$\beta$")
    view(sketch, -1.4, 1.6, -0.9, 1)
    for colour, slope, duration in ((COMPUTED[0], 0, 0.1), (COMPUTED[1], 10, 0.08)):
        c = curves(f"newmark-{slope}")
        exact = [slipped(math.radians(slope), duration, time) for time in c["time_s"]]
        plot.plot(c["time_s"], [1e3 * slip for slip in c["slip_m"]], color=colour, label=rf"computed, $\beta$ = {slope}°")
        plot.plot(c["time_s"], [1e3 * slip for slip in exact], ":", color=EXACT, label="exact" if slope else None)
    plot.set_xlabel("time (s)")
    plot.set_ylabel("slip (mm)")
    plot.legend(frameon=False)


G, FRICTION = 9.81, math.radians(20)  # m/s2
PROGRAM = """name = "Newmark's block"
gravity = [{}, {}]
stages = ["run"]
row_every = "0.5 ms"
boundary.base = {{ box = ["-1 m", "1 m", "-1 m", "-10 mm"], velocity_x = 0, velocity_y = 0 }}
probe.block.point = ["163 mm", "50 mm"]
stage.run = {{ {} }}
"""
JOINT = {"contact_law": "coulomb-slip", "contact_normal_stiffness": "10 GPa/m", "contact_shear_stiffness": "10 GPa/m", "contact_friction_angle": "20 deg"}


def slipped(slope, duration, time):
    """Slip (m) under 1 g over the duration: the base is ahead, until the block is as fast."""
    pull = G * (math.cos(slope) * math.tan(FRICTION) - math.sin(slope))
    time = min(time, G * duration / pull)
    return G * min(time, duration) * (time - min(time, duration) / 2) - pull * time ** 2 / 2


def comparisons(folder):
    """The block settles, damped; then the base moves, and nothing is damped. A gap of a micrometre parts them at first."""
    blocks = specimen_of(folder / "blocks", [block("rock base", 10, 1, -0.5, -0.1, 1, 0.1), block("rock block", 8, 2, -0.037, 1e-6, 0.4, 0.1)])
    for slope, duration in ((0, 0.1), (10, 0.08)):
        angle = math.radians(slope)
        pull = G * (math.cos(angle) * math.tan(FRICTION) - math.sin(angle))
        end = G * duration / pull
        program = [-G * math.sin(angle), -G * math.cos(angle)]
        settled = run_program(folder / f"settled-{slope}", blocks, PROGRAM.format(*program, 'until = { time = "200 ms", rest = 1e-6 }, must_end_by = "rest"'),
                              material="augig-granite", damping=0.8, save_state=True, mass_scaling="none", **JOINT)
        pulse = f"base.velocity_x = {{ times = [0, {duration}], values = [0, {G * duration}] }}, until.time = {1.3 * end}"
        run = run_program(folder / f"newmark-{slope}", blocks, PROGRAM.format(*program, pulse), material="augig-granite", damping="none",
                          restart=settled, **JOINT)
        begin = settled.history["time"][-1]
        rows = run.history["time"] >= begin
        time, base, top, speed = (values[rows] for values in (run.history["time"] - begin, run.probe("base")["displacement_x"],
                                                              run.probe("block")["displacement_x"], run.probe("block")["velocity_x"]))
        slip = base - base[0] - top + top[0]
        write_curves(folder.parent / f"newmark-{slope}.csv", {"time_s": time, "slip_m": slip})
        case, half = f"Newmark's block, slope {slope} deg, three programs, ", len(time) // 2
        yield compare(case + "slip (mm)", 1e3 * slip[-1], 1e3 * slipped(angle, duration, 1.3 * end), 0.005, "Newmark (1965)")
        yield compare(case + "acceleration of the block (m/s2)", speed[half] / time[half], pull, 0.01, "g (cos b tan phi - sin b)")


if __name__ == "__main__": main(globals())
