"""Figures of the pages: a sketch on the left, computed and exact values on the right."""
import math

import matplotlib.pyplot as plt
from matplotlib.collections import PolyCollection
from matplotlib.patches import Circle, Polygon

GRAIN, EXACT, COMPUTED = "#d9d4c7", "black", ["#c0392b", "#2471a3", "#1e8449", "#b9770e", "#6c3483"]
FIGURES, SKETCHES = {}, {}


def figure(name, kept=FIGURES):
    def keep(function):
        kept[name] = function
        return function
    return keep


def sketch_of(name):
    return figure(name, SKETCHES)


def draw(name, path, rows, curves):
    plt.rcParams.update({"font.size": 9, "axes.spines.top": False, "axes.spines.right": False, "figure.dpi": 110})
    fig, (left, right) = plt.subplots(1, 2, figsize=(8.6, 3.4), width_ratios=[1, 1.7])
    left.set_aspect("equal")
    left.axis("off")
    if name in FIGURES:
        FIGURES[name](left, right, curves)
    else:
        SKETCHES[name](left)
        errors(right, rows)
    fig.tight_layout()
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


def stress_of_strip(y):
    """Along the strip at a height (mm), MPa: that of strain minus free strain, which is the mean by modulus at the middle, less what bending adds there."""
    modulus, free, bending = (66845, 85573), (7.92e-4, 1.521e-3), 1.0893e-3  # feldspar below, quartz above, in plane strain; κ h
    middle = (modulus[0] * free[0] + modulus[1] * free[1] + (modulus[0] - modulus[1]) * bending / 4) / sum(modulus)
    return modulus[y > 0] * (middle + bending * y / 10 - free[y > 0])


@figure("temperature")
def temperature(sketch, plot, curves):
    """Stress of three problems as the programs leave it, above, and along a line beside the closed form, below."""
    fig = sketch.figure
    fig.clear()
    fig.set_size_inches(8.6, 5.2)
    maps, lines = fig.subplots(2, 3, height_ratios=[1.2, 1])
    closed = {"strip": (stress_of_strip, [k / 10 - 5 for k in range(101)], "$y$ (mm)", r"strip of two layers, $\sigma_x$"),
              "ring": (lambda r: 46.166 * (1 - math.log(20 / r) - (1 + (20 / r) ** 2) * math.log(2) / 3), [10 + k / 10 for k in range(101)], "$r$ (mm)", r"ring, warmer inside, $\sigma_\theta$"),
              "inclusion": (lambda r: -23.296 if r <= 5 else 23.296 * (5 / r) ** 2, [k / 10 for k in range(251)], "$r$ (mm)", r"quartz in feldspar, $\sigma_\theta$")}
    for map_, line, (name, (exact, places, label, title)) in zip(maps, lines, closed.items()):
        c = curves(f"temperature-{name}")
        corners = list(zip(*(c[f"{axis}{k}"] for k in range(3) for axis in "xy")))
        middles = list(zip(c["x"], c["y"]))
        if name == "strip":
            at, stress = c["y"], c["xx"]
            kept = [abs(x) < 0.4 for x in c["x"]]
        else:
            at = [math.hypot(x, y) for x, y in middles]
            stress = [(xx * y * y + yy * x * x - 2 * xy * x * y) / (x * x + y * y) for xx, yy, xy, (x, y) in zip(c["xx"], c["yy"], c["xy"], middles)]
            kept = [abs(math.atan2(y, x)) < 0.07 and r < 25 for r, (x, y) in zip(at, middles)]
        largest = max(abs(exact(place)) for place in places)
        map_.add_collection(PolyCollection([list(zip(row[0::2], row[1::2])) for row in corners], array=stress, cmap="RdBu_r", linewidth=0,
                                           antialiased=False, clim=(-largest, largest)))
        half = {"strip": 36, "ring": 26, "inclusion": 15}[name]
        view(map_, -half, half, -half * 0.8, half * 0.8)
        map_.set_aspect("equal")
        map_.axis("off")
        map_.set_title(title, fontsize=9)
        line.plot([place for place, keep in zip(at, kept) if keep], [s for s, keep in zip(stress, kept) if keep], ".", color=COMPUTED[0], label="computed")
        line.plot(places, [exact(place) for place in places], color=EXACT, lw=1, label="exact")
        line.set_xlabel(label)
        line.set_ylabel("stress (MPa)")
    lines[2].legend(frameon=False)


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
    sketch.text(1.06, 1.5, r"elastic, $k$", va="center", fontsize=8)
    sketch.text(1.06, 1.05, r"slips, $k$, $\varphi$", va="center", ha="left", fontsize=8)
    arrow(sketch, (0.5, 2.45), (0.5, 2.02), "$P$, $u$", (0.75, 2.3))
    sketch.plot([-0.1, 1.1], [-0.02, -0.02], color="black", lw=2)
    view(sketch, -0.3, 1.8, -0.15, 2.6)
    for colour, name, values, text in ((COMPUTED[0], "slipping-crack", (36.28, 38.89, 34.42), "220 GPa/m (Brady et al.)"),
                                       (COMPUTED[1], "slipping-crack-soft", (0.627075, 0.764441, 0.547911), "0.55 GPa/m (rigid halves)")):
        c = curves(name)
        u, force = c["approach_m"], c["force_N"]
        peak = max(u)
        loading, stick, back = (1e9 * value for value in values)
        top = loading * peak
        meet = (top - stick * peak) / (back - stick)
        # Less a straight line to the largest force, so that the loops open.
        plot.plot([x / peak for x in u], [100 * (p / top - x / peak) for x, p in zip(u, force)], color=colour, lw=2.5, alpha=0.6, label=f"k {text}")
        plot.plot([0, 1, meet / peak, 0], [0, 0, 100 * (back * meet / top - meet / peak), 0], ":", color=EXACT, lw=1.2,
                  label="closed forms" if name.endswith("soft") else None)
    plot.set_xlabel("approach over its largest")
    plot.set_ylabel("force less loading line,\n% of the largest")
    plot.legend(frameon=False, loc="lower left")


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


# --- sketches of problems whose figure is that of their errors ---------------------------------------------------------


@sketch_of("block-on-a-slope")
def block_on_a_slope(axes):
    box(axes, -1.2, -0.2, 2.6, 0.2, 0.5)
    box(axes, -0.5, 0, 0.9, 0.3, 0.5)
    arrow(axes, *turned([(-0.6, 0.15), (-1.1, 0.15)], 0.5), r"$\ddot s$", turned([(-1.2, 0.3)], 0.5)[0])
    axes.plot([-1.0, 1.2], [-0.75, -0.75], color="black", lw=0.8)
    axes.text(-0.2, -0.6, r"$\alpha$")
    view(axes, -1.5, 1.5, -0.9, 1)


@sketch_of("waves")
def waves(axes):
    box(axes, 0, 0, 4, 0.4)
    arrow(axes, (-0.7, 0.2), (-0.05, 0.2), r"$\sigma$", (-0.5, 0.45))
    arrow(axes, (0.8, 0.7), (1.8, 0.7), "$c$", (1.3, 0.95))
    arrow(axes, (3.4, -0.3), (2.4, -0.3), "reflected", (2.9, -0.6))
    view(axes, -0.9, 4.3, -0.9, 1.2)


@sketch_of("bar-with-interfaces")
def bar_with_interfaces(axes):
    for i in range(5):
        box(axes, i * 0.9, 0, 0.75, 0.4)
        if i: axes.plot([i * 0.9 - 0.15, i * 0.9 - 0.11, i * 0.9 - 0.04, i * 0.9], [0.2, 0.3, 0.1, 0.2], color=COMPUTED[0])
    arrow(axes, (0.82, -0.2), (1.72, -0.2), "$s$", (1.27, -0.4))
    axes.text(1.72, 0.55, "$k$", color=COMPUTED[0], ha="center")
    view(axes, -0.2, 4.6, -0.7, 0.9)


@sketch_of("bouncing-block")
def bouncing_block(axes):
    box(axes, 0, 0.6, 1, 1)
    for x in (0.15, 0.5, 0.85): axes.plot([x, x + 0.06, x - 0.06, x + 0.06, x], [0, 0.1, 0.25, 0.4, 0.5], color=COMPUTED[0])
    axes.plot([-0.3, 1.3], [0, 0], color="black", lw=2)
    arrow(axes, (0.5, 1.2), (0.5, 0.75), "$v$", (0.65, 1.0))
    axes.text(1.0, 0.25, "$k$", color=COMPUTED[0])
    view(axes, -0.6, 1.6, -0.2, 1.8)


@sketch_of("bars-collide")
def bars_collide(axes):
    box(axes, 0, 0, 2, 0.3)
    box(axes, 2.15, 0, 2, 0.3)
    arrow(axes, (0.6, 0.5), (1.4, 0.5), "$v$", (1, 0.7))
    axes.text(1, -0.25, "$L$", ha="center")
    view(axes, -0.2, 4.4, -0.6, 1)


@sketch_of("joint-in-shear")
def joint_in_shear(axes):
    box(axes, 0, 0, 2, 0.5)
    box(axes, 0.1, 0.5, 2, 0.5)
    axes.plot([0.1, 2], [0.5, 0.5], color=COMPUTED[0], lw=2)
    for x in (0.5, 1.1, 1.7): arrow(axes, (x, 1.4), (x, 1.03))
    arrow(axes, (2.15, 0.8), (2.75, 0.8), "$T$", (2.6, 1.0))
    axes.text(1.1, 1.5, "$N$", ha="center")
    axes.plot([-0.1, 2.1], [-0.02, -0.02], color="black", lw=2)
    view(axes, -0.3, 2.9, -0.2, 1.8)


@sketch_of("jaeger-joint")
def jaeger_joint(axes):
    box(axes, 0, 0, 1, 2)
    axes.plot([0, 1], [0.4, 1.6], color=COMPUTED[0], lw=2)
    arrow(axes, (0.5, 2.5), (0.5, 2.03), r"$\sigma_1$", (0.7, 2.3))
    for side, start in ((-0.03, -0.5), (1.03, 1.5)): arrow(axes, (start, 1), (side, 1))
    axes.text(1.35, 1.15, r"$\sigma_3$")
    axes.text(0.35, 0.55, r"$\beta$")
    view(axes, -0.7, 1.8, -0.2, 2.6)


@sketch_of("elastic-disc")
def elastic_disc(axes):
    axes.add_patch(Circle((0, 0), 1, facecolor=GRAIN, edgecolor="black"))
    arrow(axes, (0, 1.6), (0, 1.02), "$P$", (0.2, 1.4))
    arrow(axes, (0, -1.6), (0, -1.02))
    axes.plot([-1, 1], [0, 0], ":", color="black")
    axes.text(0.6, 0.1, "$x$")
    view(axes, -1.5, 1.5, -1.7, 1.7)


@sketch_of("spinning-disc")
def spinning_disc(axes):
    axes.add_patch(Circle((0, 0), 1, facecolor=GRAIN, edgecolor="black"))
    arrow(axes, (0.9, -0.9), (0.9, 0.9), r"$\omega$", (1.5, 0), connectionstyle="arc3,rad=0.45")
    arrow(axes, (0, 0), (-0.7, 0.7), "$R$", (-0.25, 0.5))
    view(axes, -1.4, 1.8, -1.3, 1.3)


@sketch_of("lattice-moduli")
def lattice_moduli(axes):
    h = math.sqrt(0.75)
    for row in range(2):
        for i in range(3):
            x = i + 0.5 * row
            axes.add_patch(Polygon([(x, row * h), (x + 1, row * h), (x + 0.5, row * h + h)], facecolor=GRAIN, edgecolor=COMPUTED[0]))
            axes.add_patch(Polygon([(x + 1, row * h), (x + 1.5, row * h + h), (x + 0.5, row * h + h)], facecolor=GRAIN, edgecolor=COMPUTED[0]))
    axes.text(0.5, -0.25, "$a$", ha="center")
    axes.text(4.1, h, "$k_n$, $k_s$", color=COMPUTED[0], ha="center")
    view(axes, -0.3, 4.7, -0.5, 2)


@sketch_of("fracture-energy")
def fracture_energy(axes):
    box(axes, 0, 0, 1.4, 0.8)
    box(axes, 0, 0.9, 1.4, 0.8)
    axes.plot([0, 1.4], [0.85, 0.85], color=COMPUTED[0], lw=2)
    arrow(axes, (0.7, 1.72), (0.7, 2.2))
    arrow(axes, (0.7, -0.02), (0.7, -0.5))
    axes.text(1.5, 0.85, "$G_f$", color=COMPUTED[0], va="center")
    view(axes, -0.4, 2, -0.6, 2.3)


@sketch_of("double-cantilever")
def double_cantilever(axes):
    for sign in (1, -1):
        xs = [0.1 * i for i in range(41)]
        open_ = [0.03 + 0.12 * max(0, 2.2 - x) ** 2 for x in xs]
        axes.add_patch(Polygon([(x, sign * o) for x, o in zip(xs, open_)] + [(x, sign * (o + 0.4)) for x, o in reversed(list(zip(xs, open_)))],
                               facecolor=GRAIN, edgecolor="black"))
        arrow(axes, (-0.1, sign * 0.75), (-0.1, sign * 1.3))
    axes.plot([2.2, 4], [0, 0], color=COMPUTED[0], lw=2)
    arrow(axes, (0, 0), (2.2, 0), "$a$", (1.2, 0.2))
    axes.text(-0.5, 0.95, "$F$, $M$", ha="center")
    axes.text(4.1, 0.25, "$h$")
    view(axes, -0.9, 4.5, -1.4, 1.4)


@sketch_of("column-under-weight")
def column_under_weight(axes):
    box(axes, 0, 0, 0.5, 2)
    axes.plot([-0.2, 0.7], [-0.02, -0.02], color="black", lw=2)
    arrow(axes, (0.25, 1.3), (0.25, 0.7), "$g$", (0.36, 1))
    axes.add_patch(Polygon([(0.9, 0), (1.5, 0), (0.9, 2)], fill=False, edgecolor=COMPUTED[0]))
    axes.text(1.3, 0.9, r"$-\sigma_{yy}$", color=COMPUTED[0])
    view(axes, -0.5, 2, -0.3, 2.2)


@sketch_of("two-minerals")
def two_minerals(axes):
    box(axes, 0, 0, 2, 0.4)
    axes.add_patch(Polygon([(2, 0), (4, 0), (4, 0.4), (2, 0.4)], facecolor="#8a8378", edgecolor="black"))
    arrow(axes, (0.5, 0.7), (1.4, 0.7), "1", (0.95, 0.9))
    arrow(axes, (2.3, 0.7), (3.1, 0.7), "$T$", (2.7, 0.9))
    arrow(axes, (1.7, -0.3), (1.2, -0.3), "$R$", (1.45, -0.55))
    axes.text(1, 0.2, "$Z_1$", ha="center", va="center")
    axes.text(3, 0.2, "$Z_2$", ha="center", va="center")
    view(axes, -0.2, 4.2, -0.8, 1.2)


@sketch_of("energy-balance")
def energy_balance(axes):
    box(axes, 0, 0, 1, 2)
    axes.plot([0.2, 0.45, 0.5, 0.8], [0.3, 0.9, 1.2, 1.8], color=COMPUTED[0], lw=2)
    for y, end in ((2.5, 2.05), (-0.5, -0.05)): arrow(axes, (0.5, y), (0.5, end))
    for y in (2.02, -0.02): axes.plot([-0.2, 1.2], [y, y], color="black", lw=2)
    view(axes, -0.6, 1.6, -0.6, 2.6)
