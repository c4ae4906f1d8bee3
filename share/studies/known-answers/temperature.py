#!/usr/bin/python3
"""Usage: temperature.py specimens FOLDER
       temperature.py fields FOLDER

The fields of the page on temperature: a strip of two layers, a ring and a round grain of quartz. `specimens` writes what the three programs
need: of each the mesh NAME.msh, whose physical groups are the minerals, and the material NAME.toml; and heat.toml, the loading program.
`fields` writes of each run NAME.h5 the table ../temperature-NAME.csv: middles of the elements, their displaced corners (mm; displacements of the
strip are a hundredfold) and their stress (MPa).
"""
import csv
import math
import pathlib
import sys

import numpy as np

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "python"))
from graincrack import Run

QUARTZ, FELDSPAR = (83.1, 0.17, 13e-6), (60, 0.32, 6e-6)  # E (GPa), ν, α (1/K)
ROCK = (60, 0.25, 8e-6)
WARMER = 100  # K
RINGS = [0.0105 + 0.001 * k for k in range(10)]  # mean radii of the rings of a ring from 10 to 20 mm
PROGRAM = """name = "heat"
damping = 0.8
stages = ["heat"]
stage.heat.temperature = {{ to = "{} K", over = "1 ms" }}
stage.heat.until = {{ time = "10 ms", rest = 1e-5 }}
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


def rings(around, radii, mineral_of):
    """Triangles around the origin, in rings between radii, of which the first may be 0."""
    points, triangles, rows = [], [], []
    for radius in radii:
        count = around if radius else 1
        rows.append([len(points) + k % count for k in range(around + 1)])
        points += [(radius * math.cos(2 * math.pi * k / around), radius * math.sin(2 * math.pi * k / around)) for k in range(count)]
    for ring, (inner, outer) in enumerate(zip(rows, rows[1:])):
        for k in range(around):
            triangles.append((inner[k], outer[k], outer[k + 1], mineral_of(ring)))
            if inner[k] != inner[k + 1]: triangles.append((inner[k], outer[k + 1], inner[k + 1], mineral_of(ring)))
    return points, triangles


def strip(across, along, size):
    """Rows of squares of four triangles, half of them quartz above feldspar."""
    points = [(size * i, size * j) for j in range(across + 1) for i in range(along + 1)]
    triangles = []
    for j in range(across):
        for i in range(along):
            first = j * (along + 1) + i
            corners = [first, first + 1, first + along + 2, first + along + 1]
            triangles += [(a, b, len(points), "feldspar" if 2 * j < across else "quartz") for a, b in zip(corners, corners[1:] + corners[:1])]
            points.append((size * (i + 0.5), size * (j + 0.5)))
    return points, triangles


def write(folder, name, points, triangles, minerals):
    """A mesh in Gmsh's format 2.2 and the material of its minerals."""
    group = {mineral: i + 1 for i, mineral in enumerate(minerals)}
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", len(group), *(f'2 {i} "{mineral}"' for mineral, i in group.items()),
             "$EndPhysicalNames", "$Nodes", len(points), *(f"{i + 1} {x:.12g} {y:.12g} 0" for i, (x, y) in enumerate(points)), "$EndNodes",
             "$Elements", len(triangles)]
    lines += [f"{i + 1} 2 2 {group[mineral]} {group[mineral]} {a + 1} {b + 1} {c + 1}" for i, (a, b, c, mineral) in enumerate(triangles)]
    (folder / f"{name}.msh").write_text("\n".join(map(str, [*lines, "$EndElements", ""])))
    text = MATERIAL + "".join(MINERAL.format(mineral, 1 / len(minerals), *values) for mineral, values in minerals.items())
    (folder / f"{name}.toml").write_text(text)


def specimens(folder):
    minerals = {"feldspar": FELDSPAR, "quartz": QUARTZ}
    write(folder, "strip", *strip(16, 96, 0.01 / 16), minerals)
    radii = [0.005 * k / 9 for k in range(10)] + [0.005 * math.exp(0.2 / 3 * k) for k in range(1, 46)]
    write(folder, "inclusion", *rings(96, radii, lambda ring: "quartz" if ring < 9 else "feldspar"), minerals)
    # The temperature of a ring through which heat flows is as ln(b/r)/ln(b/a). Temperature here is uniform, and minerals expand so instead.
    warm = {f"ring_{k}": (*ROCK[:2], ROCK[2] * math.log2(0.02 / r)) for k, r in enumerate(RINGS)}
    write(folder, "ring", *rings(96, [0.01 + 0.001 * k for k in range(11)], lambda ring: f"ring_{ring}"), warm)
    (folder / "heat.toml").write_text(PROGRAM.format(WARMER))


def fields(folder):
    for name, magnified in (("strip", 100), ("ring", 0), ("inclusion", 0)):
        run = Run(folder / f"{name}.h5")
        last = run.frame("last")
        middles = 1e3 * run.specimen.nodes[run.specimen.elements].mean(axis=1)
        corners = 1e3 * (run.specimen.nodes + magnified * last["displacement"])[run.specimen.elements]
        stress = 1e-6 * last["element_stress"][:, [0, 1, 2]]
        with (folder.parent / f"temperature-{name}.csv").open("w", newline="") as file:
            rows = csv.writer(file, lineterminator="\n")
            rows.writerow(["x", "y", "x0", "y0", "x1", "y1", "x2", "y2", "xx", "yy", "xy"])
            rows.writerows([f"{value:.6g}" for value in row] for row in np.hstack([middles, corners.reshape(len(corners), 6), stress]))


def main():
    steps = {"specimens": specimens, "fields": fields}
    if len(sys.argv) != 3 or sys.argv[1] not in steps:
        print(__doc__.strip())
        return 0 if sys.argv[1:] in (["-h"], ["--help"]) else 2
    steps[sys.argv[1]](pathlib.Path(sys.argv[2]))
    return 0


if __name__ == "__main__":
    sys.exit(main())
