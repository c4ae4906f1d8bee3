#!/usr/bin/python3
"""Usage: cell.py mesh OUTLINE AROUND JOINT    a mesh of the sample in its rubber sheath, in mm, to stdout, in Gmsh's format 2.2
       cell.py program LOAD                   its loading program, to stdout
       cell.py compare CASE_ROCK_LOAD_OUTLINE_JOINT_AROUND.tsv...    differences of runs' circles from every answer to their cases

OUTLINE is polygon (of 32 sides) or circle (of radius 98.9 mm), AROUND the number of elements round the rim, a multiple of 128; JOINT none,
inner (x from 0 to 40 mm), 94 or 97 (to both sides), with -closed for runs whose joint shuts at 1 µm. README.md has the source of all numbers.
"""
import csv
import math
import sys

import numpy as np

ROCK, CIRCLE, READ = 97.0, 98.9, 65.0  # radii, mm
PAD, CORNER, HALF = 98.94, 100.0, math.radians(8.35)  # normal distance of a pad, radius of its corners, half of its angle
RUBBER = (0.1e9, 0.4)  # E, ν
JOINTS = {"none": None, "inner": (0, 40), "94": (-94, 94), "97": (-ROCK, ROCK)}  # ends, mm
ELASTIC = {"greywacke": (26.87e9, 0.27), "gneiss": (83.9e9, 0.21)}
MEANINGS = {"94": "linear", "inner": "linear", "97-closed": "closed", "inner-closed": "closed"}
LOADS = {"A": [10.0, 6.64, 4.46, 1.17, 1.0, 3.82, 7.80, 9.95], "B": [7.80, 9.95, 10.0, 6.64, 4.46, 1.17, 1.0, 3.82],
         "C": [1.0, 3.82, 7.80, 9.95, 10.0, 6.64, 4.46, 1.17], "E": [9.95, 10.0, 6.64, 4.46, 1.17, 1.0, 3.82, 7.80],
         "F": [3.82, 7.80, 9.95, 10.0, 6.64, 4.46, 1.17, 1.0]}


def pressures(load):
    """Of the 32 sides: begin and end (rad), pressure (MPa); pads follow one another clockwise, each gap after its pad has the mean of both."""
    sides = []
    for k in range(16):
        middle = -k * math.pi / 8
        here, after = LOADS[load][k % 8], LOADS[load][(k + 1) % 8]
        sides.append((middle - HALF, middle + HALF, here))
        sides.append((middle - math.pi / 8 + HALF, middle - HALF, (here + after) / 2))
    return sides


def angles(around):
    """Of the nodes round the rim: three quarters of them on pads, one on gaps, at 0 the middle of a pad."""
    pad, gap = around // 16 * 3 // 4, around // 16 // 4
    found = []
    for k in range(16):
        middle = k * math.pi / 8
        found += [middle + HALF * (2 * i / pad - 1) for i in range(pad)]
        found += [middle + HALF + (math.pi / 8 - 2 * HALF) * i / gap for i in range(gap)]
    return found[pad // 2:] + [a + 2 * math.pi for a in found[:pad // 2]]


def rim(outline, angle):
    """Radius of the outline, mm."""
    if outline == "circle": return CIRCLE
    side = round(angle / (math.pi / 8)) * math.pi / 8
    if abs(angle - side) <= HALF + 1e-9: return PAD / math.cos(angle - side)
    gap = (math.floor(angle / (math.pi / 8)) + 0.5) * math.pi / 8
    return CORNER * math.cos(math.pi / 16 - HALF) / math.cos(angle - gap)


def rings(around):
    """Radii (mm) and numbers of nodes of rings from the rim inwards, as far apart as their nodes are; every second node is left out where these
    come close. The ends of the joints and the circle that is read are on rings."""
    edge, radius, count = 2 * math.pi * ROCK / around, ROCK, around
    found = [(radius, count)]
    for stop in (94, READ, 40, 0):
        while radius > stop:
            steps = max(1, round((radius - stop) / (0.9 * 2 * math.pi * radius / count)))
            radius = stop + (radius - stop) * (steps - 1) / steps
            if 2 * math.pi * radius / count < 0.7 * edge: count //= 2
            if radius > 0: found.append((radius, count))
    return found


def mesh(outline, around, joint):
    rays = angles(around)
    points, rows, triangles = [(0.0, 0.0)], [], []
    radii = rings(around)
    for radius, count in reversed(radii):
        rows.append(list(range(len(points), len(points) + count)))
        points += [(radius * math.cos(a), radius * math.sin(a)) for a in rays[::around // count]]
    if outline != "bare":
        layers = max(1, round(2.5 * around / 256))
        for i in range(1, layers + 1):
            rows.append(list(range(len(points), len(points) + around)))
            radius_at = [ROCK + (rim(outline, a % (2 * math.pi)) - ROCK) * i / layers for a in rays]
            points += [(r * math.cos(a), r * math.sin(a)) for r, a in zip(radius_at, rays)]
    n_rock = len(radii)
    first = rows[0]
    for k in range(len(first)): triangles.append((0, first[k], first[(k + 1) % len(first)], 0))
    for ring, (inner, outer) in enumerate(zip(rows, rows[1:])):
        kind = 0 if ring + 1 < n_rock else 1
        share = len(outer) // len(inner)
        for k in range(len(inner)):
            a, b = inner[k], inner[(k + 1) % len(inner)]
            out = [outer[(share * k + i) % len(outer)] for i in range(share + 1)]
            if share == 2:
                triangles += [(a, out[0], out[1], kind), (a, out[1], b, kind), (b, out[1], out[2], kind)]
            elif (k + ring) % 2:
                triangles += [(a, out[0], out[1], kind), (a, out[1], b, kind)]
            else:
                triangles += [(a, out[0], b, kind), (b, out[0], out[1], kind)]
    write(points, triangles, [] if joint == "none" else along_x(points, rows[:n_rock]), joint)


def along_x(points, rows):
    """The nodes of the rock on y = 0, by x."""
    nodes = [0] + [row[i] for row in rows for i in (0, len(row) // 2)]
    return sorted(nodes, key=lambda i: points[i][0])


def write(points, triangles, joint_nodes, joint):
    """Entities 1 and 2 are the upper and the lower half of the rock, or 1 all of it, 3 the sheath."""
    names = [(1, 1, "flaw-joint"), (1, 2, "flaw-weld"), (2, 3, "rock"), (2, 4, "rubber")]
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", len(names), *(f'{d} {i} "{n}"' for d, i, n in names), "$EndPhysicalNames",
             "$Nodes", len(points), *(f"{i + 1} {x:.15g} {y:.15g} 0" for i, (x, y) in enumerate(points)), "$EndNodes", "$Elements"]
    elements = []
    for a, b in zip(joint_nodes, joint_nodes[1:]):
        middle = (points[a][0] + points[b][0]) / 2
        group = 1 if JOINTS[joint][0] < middle < JOINTS[joint][1] else 2
        elements.append(f"1 2 {group} {10 + group} {a + 1} {b + 1}")
    for a, b, c, kind in triangles:
        upper = not joint_nodes or points[a][1] + points[b][1] + points[c][1] > 0
        elements.append(f"2 2 {3 + kind} {3 if kind else 1 if upper else 2} {a + 1} {b + 1} {c + 1}")
    lines += [len(elements), *(f"{i + 1} {row}" for i, row in enumerate(elements)), "$EndElements", ""]
    print("\n".join(map(str, lines)), end="")


def program(load):
    print('name = "GREAT cell"\ndamping = 0.8\nstages = ["load"]\n[boundary]')
    for k, (begin, end, pressure) in enumerate(pressures(load)):
        print(f'side_{k:02} = {{ angles = ["{math.degrees(begin):.6f} deg", "{math.degrees(end):.6f} deg"], '
              f'pressure = {{ to = "{pressure:g} MPa", over = "0.5 ms" }} }}')
    print('bottom = { at = [0, "-98.94 mm"], velocity_x = 0, velocity_y = 0 }\nleft = { at = ["-98.94 mm", 0], velocity_y = 0 }')
    print(f'[probe.circle]\nring = [0, 0, "{READ:g} mm"]\npoints = 144\nreach = "4 mm"\n[stage.load]\nuntil = {{ time = "20 ms", rest = 1e-5 }}')


# --- answers ---------------------------------------------------------------------------------------------------------------------


def transmitted(n, young_modulus, poisson_ratio):
    """The n-th harmonic of the trace of stress that reaches the rock's rim through a sheath of radius 98.9 mm, over that of a bare disc, by Airy
    functions r^n, r^(n+2), r^-n, r^(2-n) of both (plane strain)."""
    kappa = [3 - 4 * poisson_ratio, 3 - 4 * RUBBER[1]]
    twice_mu = [young_modulus / (1 + poisson_ratio), RUBBER[0] / (1 + RUBBER[1])]
    x = CIRCLE / ROCK
    if n == 0:  # r² in the rock; r² and ln r in the sheath
        rows = [[2, -2, -1], [(kappa[0] - 1) / twice_mu[0], -(kappa[1] - 1) / twice_mu[1], 1 / twice_mu[1]], [0, 2, x**-2]]
        rows[1] = [young_modulus * value for value in rows[1]]
        return -2 * np.linalg.solve(np.array(rows), [0, 0, -1])[0]

    def terms(r, body):
        """Radial stress, shear, radial and tangential displacement (times E) of the four functions at r, by cos nθ and sin nθ."""
        k, scale = kappa[body], young_modulus / twice_mu[body]
        return np.array([[-n * (n - 1) * r**(n - 2), n * (n - 1) * r**(n - 2), -n * r**(n - 1) * scale, n * r**(n - 1) * scale],
                         [-(n + 1) * (n - 2) * r**n, n * (n + 1) * r**n, (k - n - 1) * r**(n + 1) * scale, (k + n + 1) * r**(n + 1) * scale],
                         [-n * (n + 1) * r**(-n - 2), -n * (n + 1) * r**(-n - 2), n * r**(-n - 1) * scale, n * r**(-n - 1) * scale],
                         [-(n + 2) * (n - 1) * r**-n, -n * (n - 1) * r**-n, (k + n - 1) * r**(1 - n) * scale, -(k - n + 1) * r**(1 - n) * scale]]).T

    rows = np.zeros((6, 6))
    rows[:4, :2] = terms(1, 0)[:, :2]
    rows[:4, 2:] = -terms(1, 1)
    rows[4:, 2:] = terms(x, 1)[:2]
    return -2 * (n + 1) * np.linalg.solve(rows, [0, 0, 0, 0, -1, 0])[1]


def exact(load, young_modulus, poisson_ratio, degrees):
    """Volumetric strain on the circle that is read, of the sheath as a ring: −2 (1 + ν)(1 − 2ν)/E Σ t_n (r/R)^n p_n."""
    total = np.zeros(len(degrees))
    for n in range(0, 61):
        sides = pressures(load)
        part = sum(p * ((e - b) if n == 0 else (np.exp(-1j * n * e) - np.exp(-1j * n * b)) / (-1j * n)) for b, e, p in sides) / (2 * math.pi)
        if abs(part) < 1e-12: continue
        total += transmitted(n, young_modulus, poisson_ratio) * (READ / ROCK)**n * (1 if n == 0 else 2) * \
            (part * np.exp(1j * n * np.radians(degrees))).real
    return -2e6 * (1 + poisson_ratio) * (1 - 2 * poisson_ratio) / young_modulus * total


def table(name):
    with open(name) as file:
        return list(csv.DictReader(file, delimiter="\t"))


def around_circle(degrees, known_degrees, known):
    """Between known values at angles, periodic."""
    order = np.argsort(np.array(known_degrees) % 360)
    return np.interp(np.array(degrees) % 360, np.array(known_degrees)[order] % 360, np.array(known)[order], period=360)


def compared(run):
    """Rows of differences of a run, NAME.tsv, from each answer to its case, in % of the answer's mean: mean, largest and its angle, root mean square;
    of cases with a joint beyond 20° of it, and the largest nearer."""
    case, rock, load, outline, joint, around = run.split("/")[-1].removesuffix(".tsv").split("_")
    rows = table(run)
    degrees = [float(row["angle_deg"]) for row in rows]
    ours = np.array([float(row["volumetric_strain"]) for row in rows])
    answers = {}
    if case == "M1" and outline == "circle":
        answers["closed form"] = exact(load, *ELASTIC[rock], degrees)
    for row in table("curves.tsv"):
        if [row["case"], row["rock"], row["load"]] == [case, rock, load] and (case == "M1" or MEANINGS[joint] in row["joint"]):
            answers.setdefault(row["code"], []).append((float(row["angle_deg"]), float(row["vol_strain"])))
    for code, answer in answers.items():
        if isinstance(answer, list):
            known_at, known = zip(*answer)
            theirs, here = np.array(known), around_circle(known_at, degrees, ours)
        else:
            known_at, theirs, here = degrees, answer, ours
        far = np.array([far_from_joint(case, a) for a in known_at])
        everywhere = 100 * (here - theirs) / abs(np.mean(theirs))
        off, near = everywhere[far], everywhere[~far]
        yield [case, rock, load, outline, joint, around, code, np.sum(far), f"{np.mean(off):.2f}", f"{np.max(np.abs(off)):.2f}",
               f"{np.sqrt(np.mean(off**2)):.2f}", f"{known_at[int(np.flatnonzero(far)[np.argmax(np.abs(off))])]:.0f}",
               f"{np.max(np.abs(near)):.2f}" if len(near) else ""]


def far_from_joint(case, degrees):
    """More than 20° from where the circle crosses the joint, or its line."""
    from_line = abs((degrees + 180) % 360 - 180)
    return case == "M1" or (from_line > 20 and (case == "M2b" or from_line < 160))


def compare(runs):
    print("\t".join(["case", "rock", "load", "outline", "joint", "around", "beside", "points", "mean_off", "largest_off", "rms_off", "at_deg", "near_joint_off"]))
    for run in runs:
        for row in compared(run): print("\t".join(map(str, row)))


def main():
    command, *words = sys.argv[1:] or [""]
    if command == "mesh": mesh(words[0], int(words[1]), words[2])
    elif command == "program": program(words[0])
    elif command == "compare": compare(words)
    else:
        print(__doc__.strip())
        return 0 if command in ("-h", "--help") else 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
