#!/usr/bin/env python3
"""Writes large models of any size without having them in memory: large_models.py TRIANGLES FILE.stl|FILE.ply

A torus with bumps, of about that many triangles, closed and wound outwards; float32. For measurements of --stream
(docs/streaming.md)."""

import math
import sys

import numpy

RING, TUBE, BUMP = 60.0, 25.0, 1.5
WAVES_ROUND, WAVES_TUBE = 40, 18
ROWS_AT_A_TIME = 64


def points(rows, around, along_tube):
    """The vertices of some rows round the ring: len(rows) x along_tube x 3."""
    u = (rows % around)[:, None] * (2 * math.pi / around)
    v = numpy.arange(along_tube)[None, :] * (2 * math.pi / along_tube)
    tube = TUBE + BUMP * numpy.sin(WAVES_ROUND * u) * numpy.sin(WAVES_TUBE * v)
    ring = RING + tube * numpy.cos(v)
    return numpy.stack([ring * numpy.cos(u), ring * numpy.sin(u), tube * numpy.sin(v)], axis=2).astype("<f4")


def write_stl(file, around, along_tube):
    file.write(b"bumpy torus".ljust(80) + numpy.array([2 * around * along_tube], "<u4").tobytes())
    record = numpy.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
    for first in range(0, around, ROWS_AT_A_TIME):
        count = min(ROWS_AT_A_TIME, around - first)
        p = points(numpy.arange(first, first + count + 1), around, along_tube)
        a, b = p[:-1], p[1:]
        c, d = numpy.roll(b, -1, axis=1), numpy.roll(a, -1, axis=1)
        triangles = numpy.zeros((count, along_tube, 2), record)
        for k, corners in enumerate([(a, b, c), (a, c, d)]):
            triangles["corners"][:, :, k] = numpy.stack(corners, axis=2)
        file.write(triangles.tobytes())


def write_ply(file, around, along_tube):
    header = ("ply\nformat binary_little_endian 1.0\n"
              f"element vertex {around * along_tube}\nproperty float x\nproperty float y\nproperty float z\n"
              f"element face {2 * around * along_tube}\nproperty list uchar uint vertex_indices\nend_header\n")
    file.write(header.encode("ascii"))
    for first in range(0, around, ROWS_AT_A_TIME):
        rows = numpy.arange(first, min(first + ROWS_AT_A_TIME, around))
        file.write(points(rows, around, along_tube).tobytes())
    record = numpy.dtype([("n", "u1"), ("corners", "<u4", 3)])
    for first in range(0, around, ROWS_AT_A_TIME):
        rows = numpy.arange(first, min(first + ROWS_AT_A_TIME, around))[:, None]
        columns = numpy.arange(along_tube)[None, :]
        a, b = rows * along_tube + columns, (rows + 1) % around * along_tube + columns
        c = (rows + 1) % around * along_tube + (columns + 1) % along_tube
        d = rows * along_tube + (columns + 1) % along_tube
        faces = numpy.zeros((len(rows), along_tube, 2), record)
        faces["n"] = 3
        for k, corners in enumerate([(a, b, c), (a, c, d)]):
            faces["corners"][:, :, k] = numpy.stack(corners, axis=2)
        file.write(faces.tobytes())


def main():
    triangles, name = int(sys.argv[1]), sys.argv[2]
    along_tube = max(3, round(math.sqrt(triangles / 4)))
    around = max(3, round(triangles / 2 / along_tube))
    with open(name, "wb") as file:
        (write_stl if name.endswith(".stl") else write_ply)(file, around, along_tube)


if __name__ == "__main__":
    main()
