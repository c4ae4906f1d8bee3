#!/usr/bin/env python3
"""Draws thin-section.png, thin-section.tsv and minerals.png: pictures as the segmentation of a thin section gives them, made up.

Usage: thin_section.py

Every pixel has the number of its grain (8 bit, grey), 0.1 mm a pixel. Grains are cells of a weighted Voronoi tessellation with bent
boundaries and some wrong pixels; the table has their minerals, and minerals.png a colour for each mineral (8 bit, palette).
"""
import struct
import zlib

import numpy

HEIGHT, WIDTH = 640, 320
N_GRAINS = 170
MINERALS = {"quartz": 0.32, "k_feldspar": 0.33, "plagioclase": 0.29, "mica": 0.06}  # of granite
COLOURS = {"quartz": (192, 48, 32), "k_feldspar": (240, 180, 160), "plagioclase": (255, 255, 255), "mica": (16, 32, 48)}


def smooth_noise(random, wave):
    """A field of about unit size that varies over `wave` pixels."""
    field = random.standard_normal((HEIGHT // wave + 3, WIDTH // wave + 3))
    y, x = numpy.mgrid[0:HEIGHT, 0:WIDTH] / wave
    i, j = y.astype(int), x.astype(int)
    v, u = (f * f * (3 - 2 * f) for f in (y - i, x - j))
    row = lambda k: field[i + k, j] * (1 - u) + field[i + k, j + 1] * u
    return row(0) * (1 - v) + row(1) * v


def png(labels, palette=()):
    """A picture of 8 bits as the bytes of a file: grey, or of a palette."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    rows = b"".join(b"\0" + row.tobytes() for row in labels.astype(numpy.uint8))
    header = struct.pack(">IIBBBBB", labels.shape[1], labels.shape[0], 8, 3 if palette else 0, 0, 0, 0)
    colours = chunk(b"PLTE", bytes(sum(palette, ()))) if palette else b""
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + colours + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b"")


def main():
    random = numpy.random.default_rng(5)
    seeds = random.uniform((0, 0), (HEIGHT, WIDTH), (N_GRAINS, 2))
    weights = random.uniform(0, 150, N_GRAINS)
    y, x = numpy.mgrid[0:HEIGHT, 0:WIDTH].astype(float)
    y, x = y + 2.5 * smooth_noise(random, 12), x + 2.5 * smooth_noise(random, 12)
    labels = numpy.zeros((HEIGHT, WIDTH), int)
    nearest = numpy.full((HEIGHT, WIDTH), numpy.inf)
    for grain, ((row, column), weight) in enumerate(zip(seeds, weights)):
        distance = (y - row) ** 2 + (x - column) ** 2 - weight
        labels[distance < nearest] = grain + 1
        nearest = numpy.minimum(nearest, distance)
    wrong = random.random(labels.shape) < 0.002
    labels[wrong] = random.integers(1, N_GRAINS + 1, int(wrong.sum()))
    minerals = random.choice(list(MINERALS), N_GRAINS, p=list(MINERALS.values()))
    with open("thin-section.png", "wb") as file:
        file.write(png(labels))
    mineral_of_label = numpy.array([0] + [list(COLOURS).index(mineral) for mineral in minerals])
    with open("minerals.png", "wb") as file:
        file.write(png(mineral_of_label[labels], tuple(COLOURS.values())))
    with open("thin-section.tsv", "w") as file:
        file.write("key\tphase\n" + "".join(f"{grain + 1}\t{mineral}\n" for grain, mineral in enumerate(minerals)))


if __name__ == "__main__":
    main()
