"""Figures of the pages: a sketch on the left, computed and exact values on the right."""
import math

import matplotlib.pyplot as plt
from matplotlib.patches import Polygon, Rectangle

GRAIN, EXACT, COMPUTED = "#d9d4c7", "black", ["#c0392b", "#2471a3", "#1e8449", "#b9770e", "#6c3483"]
FIGURES = {}


def figure(name):
    def keep(function):
        FIGURES[name] = function
        return function
    return keep


def draw(name, path, rows, curves):
    plt.rcParams.update({"font.size": 9, "axes.spines.top": False, "axes.spines.right": False, "figure.dpi": 110})
    fig, (left, right) = plt.subplots(1, 2, figsize=(8.6, 3.4), width_ratios=[1, 1.7])
    left.set_aspect("equal")
    left.axis("off")
    if name in FIGURES:
        FIGURES[name](left, right, curves)
    else:
        left.remove()
        right.set_position([0.1, 0.18, 0.86, 0.76])
        errors(right, rows)
    if name in FIGURES: fig.tight_layout()
    fig.savefig(path, metadata={"Software": None})
    plt.close(fig)


def number(text):
    try: return float(text.replace("<", "").strip())
    except ValueError: return math.nan


def errors(axes, rows):
    """Errors of cases beside their tolerances."""
    kept = [row for row in rows if row[4]]
    for i, row in enumerate(kept):
        axes.plot(i + 1, max(number(row[3]), 1e-12), "o", color=COMPUTED[1], label="error" if i == 0 else None)
        axes.plot([i + 0.7, i + 1.3], [number(row[4])] * 2, color=EXACT, label="tolerance" if i == 0 else None)
    axes.set_yscale("log")
    axes.set_xticks(range(1, len(kept) + 1))
    axes.set_xlabel("case, in the order of the table")
    axes.set_ylabel("relative error")
    axes.legend(frameon=False)


def arrow(axes, start, end, text="", at=None, **options):
    axes.annotate("", end, start, arrowprops={"arrowstyle": "-|>", "color": "black", "shrinkA": 0, "shrinkB": 0, **options})
    if text: axes.text(*(at or end), text, ha="center", va="center")


def turned(points, angle, about=(0, 0)):
    c, s = math.cos(angle), math.sin(angle)
    return [(about[0] + c * (x - about[0]) - s * (y - about[1]), about[1] + s * (x - about[0]) + c * (y - about[1])) for x, y in points]


def box(axes, left, bottom, width, height, angle=0, about=(0, 0), **options):
    corners = [(left, bottom), (left + width, bottom), (left + width, bottom + height), (left, bottom + height)]
    axes.add_patch(Polygon(turned(corners, angle, about), facecolor=GRAIN, edgecolor="black", **options))


def view(axes, left, right, bottom, top):
    axes.set_xlim(left, right)
    axes.set_ylim(bottom, top)


@figure("shear-wave")
def shear_wave(sketch, plot, curves):
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


@figure("slipping-crack")
def slipping_crack(sketch, plot, curves):
    box(sketch, 0, 0, 1, 2)
    sketch.plot([0, 1], [0.5, 1.5], color="black", lw=1)
    sketch.plot([0.31, 0.69], [0.81, 1.19], color=COMPUTED[0], lw=3)
    sketch.text(1.06, 1.5, r"elastic, $k$", va="center")
    sketch.text(0.72, 1.05, r"slips, $k$, $\varphi$", va="center", ha="left", fontsize=8)
    arrow(sketch, (0.5, 2.45), (0.5, 2.02), "$P$, $u$", (0.75, 2.3))
    sketch.plot([-0.1, 1.1], [-0.02, -0.02], color="black", lw=2)
    view(sketch, -0.3, 1.8, -0.15, 2.6)
    for colour, name, values, scale, text in ((COMPUTED[0], "slipping-crack", (36.28, 38.89, 34.42), 1, "k 220 GPa/m"),
                                        (COMPUTED[1], "slipping-crack-soft", (0.627075, 0.764441, 0.547911), 1, "k 0.55 GPa/m")):
        c = curves(name)
        u, force = c["approach_m"], c["force_N"]
        peak = max(u)
        loading, stick, back = (1e9 * value for value in values)
        top = loading * peak
        meet = (top - stick * peak) / (back - stick)
        plot.plot([x / peak for x in u], [p / top for p in force], color=colour, lw=2.5, alpha=0.6, label=f"computed, {text}")
        plot.plot([0, 1, meet / peak, 0], [0, 1, back * meet / top, 0], ":", color=EXACT, lw=1.2, label="closed form" if scale and name.endswith("soft") else None)
    plot.set_xlabel("approach over its largest")
    plot.set_ylabel("force over its largest")
    plot.legend(frameon=False)


@figure("rayleigh-wave")
def rayleigh_wave(sketch, plot, curves):
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


def quarter(alpha, rate, turn, steps=400):
    """Time and turn of the fall of a rocking block, by the midpoint rule in x, turn (1 - x^2)."""
    time, times, turns = 0, [0], [turn]
    for i in range(steps):
        x = (i + 0.5) / steps
        theta = turn * (1 - x * x)
        fall = 2 * math.sin(alpha - (turn + theta) / 2) * math.sin((turn - theta) / 2)
        time += 2 * turn * x / math.sqrt(2 * fall) / steps / rate
        times.append(time)
        turns.append(turn * (1 - ((i + 1) / steps) ** 2))
    return times, turns


@figure("rocking-block")
def rocking_block(sketch, plot, curves):
    box(sketch, -1, -0.2, 2.2, 0.2)
    box(sketch, 0, 0, 0.5, 2, -0.2, (0.5, 0))
    sketch.text(0.75, 2.1, "$2h$, $2b$", ha="left")
    sketch.text(-0.05, 0.35, r"$\theta$", ha="right")
    sketch.plot([0.5, 0.5], [0, 2.2], ":", color="black", lw=1)
    view(sketch, -1.1, 1.9, -0.4, 2.5)
    alpha, rate = math.atan(0.25), math.sqrt(3 * 9.81 / (4 * math.hypot(1, 0.25)))
    for colour, share in ((COMPUTED[0], 0.5), (COMPUTED[1], 0.8)):
        c = curves(f"rocking-{share}")
        plot.plot(c["time_s"], [turn / alpha for turn in c["turn_rad"]], color=colour, label=rf"$\theta_0$ = {share} $\alpha$")
        times, turns = quarter(alpha, rate, share * alpha)
        plot.plot(times, [turn / alpha for turn in turns], ":", color=EXACT, label="exact, up to the impact" if share == 0.8 else None)
        left = (1 - 1.5 * math.sin(alpha) ** 2) ** 2
        after = 1 - math.sqrt(1 - left * (1 - (1 - share) ** 2))
        plot.plot([times[-1] + 0.05, max(c["time_s"])], [-after] * 2, "--", color=colour, lw=0.8, label="Housner's impact" if share == 0.8 else None)
    plot.axhline(0, color="black", lw=0.5)
    plot.set_xlabel("time (s)")
    plot.set_ylabel(r"turn over $\alpha$")
    plot.legend(frameon=False, fontsize=7)


@figure("tilted-block")
def tilted_block(sketch, plot, curves):
    box(sketch, -0.6, -0.15, 2, 0.15, 0.35)
    box(sketch, 0, 0, 0.5, 1.2, 0.35)
    sketch.plot([-0.56, 1.4], [-0.35, -0.35], color="black", lw=0.8)
    sketch.text(0.35, -0.22, r"$\alpha$")
    centre = turned([(0.25, 0.6)], 0.35)[0]
    arrow(sketch, centre, (centre[0], centre[1] - 0.6), "$g$", (centre[0] + 0.1, centre[1] - 0.55))
    sketch.text(0.2, 1.42, "$b$")
    sketch.text(0.32, 1.0, "$h$")
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


@figure("newmark")
def newmark(sketch, plot, curves):
    box(sketch, -1.2, -0.2, 2.6, 0.2, 0.18)
    box(sketch, -0.5, 0, 0.9, 0.4, 0.18)
    arrow(sketch, *turned([(-0.6, -0.45), (0.6, -0.45)], 0.18), "$a$ for $t$", turned([(0.9, -0.45)], 0.18)[0])
    sketch.text(*turned([(-0.05, 0.2)], 0.18)[0], r"$\varphi$", ha="center", va="center")
    sketch.text(1.25, -0.15, r"$\beta$")
    view(sketch, -1.4, 1.6, -0.9, 1)
    for colour, name, slope, duration in ((COMPUTED[0], "newmark-level", 0, 0.1), (COMPUTED[1], "newmark-slope", 10, 0.08)):
        c = curves(name)
        b, g = math.radians(slope), 9.81
        pull = g * (math.cos(b) * math.tan(math.radians(20)) - math.sin(b))
        speed = g * duration
        exact = []
        for t in c["time_s"]:
            s = min(t, speed / pull)
            exact.append((0.5 * g * s * s if s < duration else speed * (s - duration / 2)) - 0.5 * pull * s * s)
        plot.plot(c["time_s"], [1e3 * slip for slip in c["slip_m"]], color=colour, label=rf"computed, $\beta$ = {slope}°")
        plot.plot(c["time_s"], [1e3 * slip for slip in exact], ":", color=EXACT, label="exact" if slope else None)
    plot.set_xlabel("time (s)")
    plot.set_ylabel("slip (mm)")
    plot.legend(frameon=False)
