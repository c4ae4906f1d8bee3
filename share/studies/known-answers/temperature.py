#!/usr/bin/python3 -B
r"""
title = "Minerals that expand unlike"
section = "phases"
program = "physics_tests"
tests = ["Temperature.PressesAClampedMineral", "Temperature.PressesARoundGrainOfQuartzInFeldspar", "Temperature.BendsAStripOfTwoLayers", "Temperature.PressesTheWarmInsideOfARing", "Minerals.ExpandByTheirMeansInLaminates", "Temperature.OpensAClampedPairOfMinerals"]
rows = ["clamped", "quartz", "strip", "ring, plane strain", "laminate"]
statement = "What stress do minerals make that expand by different amounts, 100 K warmer?"
caption = '''
Above: stress from the three programs, plane strain; red: tension; displacements of the strip a hundredfold. Below: across it, along radii.
'''
theory = '''
Plane stress; plane strain takes $E/(1-\nu^2)$, $\nu/(1-\nu)$, $(1+\nu)\alpha$ of each mineral. Clamped: $-E\alpha\Delta{}T/(1-\nu)$. A grain $i$ in a
ring of $R$ times its radius, a strip of equal layers, a ring with a temperature as $\ln(b/r)$:

$$p=\frac{\Delta\alpha\Delta{}T}{\frac{1+\nu}{E}+\frac{2}{E(R^2-1)}+\frac{1-\nu_i}{E_i}},\quad\kappa h=\frac{24\Delta\alpha\Delta{}T}{14+n+1/n},\quad\sigma_\theta=\frac{E\alpha\Delta{}T}{2\ln(b/a)}\left[1-\ln\frac{b}{r}-\frac{1+b^2/r^2}{b^2/a^2-1}\ln\frac{b}{a}\right].$$

Bars $L\times{}h$ between ends of a frame $\alpha_f$ crack where tension and, of free sides, sliding reach the strength together:

$$\frac{1}{\Delta{}T^2}=\left[\frac{(\alpha_1+\alpha_2-2\alpha_f)L}{t_cL(1/E_1+1/E_2)+\delta_{ct}}\right]^2+\left[\frac{(\alpha_1-\alpha_2)h}{2\delta_{so}}\right]^2.$$
'''
source = "Lamé; Timoshenko (1925); Timoshenko & Goodier (1970); contact law."
model = '''
Quartz: 83.1 GPa, ν 0.17, 13e-6/K; feldspar: 60, 0.32, 6e-6; clamped mineral, ring ($b=2a$, 20 minerals): 60, 0.25, 8e-6. Contacts are rigid, the pair's
Augig granite's. In an endless plane quartz has 21.883 and 23.296 MPa.
'''
tolerance = "1e-4: limit of meshes whose error falls by 4 with each halving (tested). 0.2 %: 20 rings; waves. Of the programs the square of an element over height or radius. 0.5 %: shear of soft contacts."
misses = "Free sides at contacts stiff in shear, which have no closed form; crystal axes."
"""
import math

from matplotlib.collections import PolyCollection

from answer import COMPUTED, EXACT, block, compare, main, run_program, specimen_of, view, write_curves


QUARTZ, FELDSPAR = (83.1, 0.17, 13e-6), (60, 0.32, 6e-6)  # E (GPa), ν, α (1/K)
ROCK = (60, 0.25, 8e-6)
RINGS = [0.0105 + 0.001 * k for k in range(10)]  # mean radii of the rings of a ring from 10 to 20 mm
PROGRAM = """name = "heat"
damping = 0.8
stages = ["heat"]
stage.heat.temperature = { to = "100 K", over = "1 ms" }
stage.heat.until = { time = "10 ms", rest = 1e-5 }
stage.heat.must_end_by = "rest"
"""
MATERIAL = """name = "minerals that do not crack"
platen.friction_angle = "0 deg"
[rock]
young_modulus = "60 GPa"
poisson_ratio = 0.25
density = "2650 kg/m3"
tensile_strength = "8 MPa"
mode_i_toughness = "1 MPa.m^0.5"
mode_ii_toughness = "2 MPa.m^0.5"
[contact]
tensile_strength = "1 GPa"
cohesion = "1 GPa"
friction_angle = "30 deg"
normal_stiffness = "1e7 GPa/m"
shear_stiffness = "1e7 GPa/m"
"""
MINERAL = """[phases.{}]
fraction = {}
young_modulus = "{} GPa"
poisson_ratio = {}
thermal_expansion = "{:.6g} 1/K"
"""


def ring(name, inner, outer, around=96):
    """A block between two circles, the inner one of which may be a point."""
    directions = [(math.cos(2 * math.pi * k / around), math.sin(2 * math.pi * k / around)) for k in range(around)]
    triangles = []
    for k in range(around):
        following = (k + 1) % around
        triangles += [(k, around + k, around + following)] + [(k, around + following, following)] * (inner > 0)
    return name, [(radius * x, radius * y) for radius in (inner, outer) for x, y in directions], triangles


def heated(folder, name, blocks, minerals, magnified=0):
    """The run of a specimen whose contacts do not crack, and its fields: middles of the elements, their corners (mm), stress (MPa)."""
    material = MATERIAL + "".join(MINERAL.format(mineral, 1 / len(minerals), *values) for mineral, values in minerals.items())
    (folder / f"{name}-minerals.toml").write_text(material)
    run = run_program(folder / name, specimen_of(folder / name, blocks), PROGRAM, material=folder / f"{name}-minerals.toml", contact_law="coulomb-slip")
    nodes, elements, last = run.specimen.nodes, run.specimen.elements, run.frame("last")
    corners = 1e3 * (nodes + magnified * last["displacement"])[elements]
    x, y = 1e3 * nodes[elements].mean(axis=1).T
    fields = dict(zip(("x", "y", "x0", "y0", "x1", "y1", "x2", "y2"), (x, y, *corners.reshape(len(corners), 6).T)))
    fields.update(zip(("xx", "yy", "xy"), 1e-6 * last["element_stress"].T))
    write_curves(folder.parent / f"temperature-{name}.csv", fields)
    return run, fields


def comparisons(folder):
    """Errors are of second order in the size of the elements: the tolerance is the square of their part of the height or of a radius."""
    minerals, height = {"feldspar": FELDSPAR, "quartz": QUARTZ}, 0.01
    layers = [block("feldspar", 96, 8, -0.03, -height / 2, 0.06, height / 2), block("quartz", 96, 8, -0.03, 0, 0.06, height / 2)]
    run, _ = heated(folder, "strip", layers, minerals, magnified=100)
    deflection = [run.frame("last")["displacement"][((run.specimen.nodes - (x, -height / 2)) ** 2).sum(axis=1).argmin(), 1] for x in (-height, 0, height)]
    yield compare("strip, three programs, curvature times height, plane strain", (2 * deflection[1] - deflection[0] - deflection[2]) / height, 1.0893e-3, 1 / 16 ** 2,
                  "Timoshenko (1925)")
    radii = [0.005 * k / 9 for k in range(10)] + [0.005 * math.exp(0.2 / 3 * k) for k in range(1, 46)]
    grain = [ring("quartz" if outer < 0.00501 else "feldspar", inner, outer) for inner, outer in zip(radii, radii[1:])]
    _, c = heated(folder, "inclusion", grain, minerals)
    within = c["x"] ** 2 + c["y"] ** 2 < 4 ** 2
    (e_i, nu_i, alpha_i), (e, nu, alpha) = ((young / (1 - nu ** 2), nu / (1 - nu), (1 + nu) * alpha) for young, nu, alpha in (QUARTZ, FELDSPAR))
    pressure = (alpha_i - alpha) * 1e5 / ((1 + nu) / e + 2 / e / ((radii[-1] / 0.005) ** 2 - 1) + (1 - nu_i) / e_i)
    yield compare("quartz, three programs, plane strain (MPa)", -(c["xx"] + c["yy"])[within].mean() / 2, pressure, 1 / 9 ** 2, "Lamé")
    # The temperature of a ring through which heat flows is as ln(b/r)/ln(b/a). Temperature here is uniform, and minerals expand so instead.
    warm = {f"ring_{k}": (*ROCK[:2], ROCK[2] * math.log2(0.02 / r)) for k, r in enumerate(RINGS)}
    _, c = heated(folder, "ring", [ring(f"ring_{k}", 0.01 + 0.001 * k, 0.011 + 0.001 * k) for k in range(10)], warm)
    square = c["x"] ** 2 + c["y"] ** 2
    hoop = (c["xx"] * c["y"] ** 2 + c["yy"] * c["x"] ** 2 - 2 * c["xy"] * c["x"] * c["y"]) / square
    for k in range(10):
        of_ring = ((10 + k) ** 2 < square) & (square < (11 + k) ** 2)
        yield compare(f"ring, plane strain, three programs, at {10.5 + k} mm (MPa)", hoop[of_ring].mean(), stress_of_ring(10.5 + k), 1 / 10 ** 2,
                      "Timoshenko & Goodier", 46.166)


def stress_of_ring(r):
    """Along a ring at a radius (mm), MPa."""
    return 46.166 * (1 - math.log(20 / r) - (1 + (20 / r) ** 2) * math.log(2) / 3)


def stress_of_strip(y):
    """Along the strip at a height (mm), MPa: that of strain minus free strain, which is the mean by modulus at the middle, less what bending adds there."""
    modulus, free, bending = (66845, 85573), (7.92e-4, 1.521e-3), 1.0893e-3  # feldspar below, quartz above, in plane strain; κ h
    middle = (modulus[0] * free[0] + modulus[1] * free[1] + (modulus[0] - modulus[1]) * bending / 4) / sum(modulus)
    return modulus[y > 0] * (middle + bending * y / 10 - free[y > 0])


def figure(sketch, plot, curves):
    """Stress of three problems as the programs leave it, above, and along a line beside the closed form, below."""
    fig = sketch.figure
    fig.clear()
    fig.set_size_inches(8.6, 5.2)
    maps, lines = fig.subplots(2, 3, height_ratios=[1.2, 1])
    closed = {"strip": (stress_of_strip, [k / 10 - 5 for k in range(101)], "$y$ (mm)", r"strip of two layers, $\sigma_x$"),
              "ring": (stress_of_ring, [10 + k / 10 for k in range(101)], "$r$ (mm)", r"ring, warmer inside, $\sigma_\theta$"),
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


if __name__ == "__main__": main(globals())
