#!/usr/bin/env python3
"""order_growth.py LIGNE [METHOD...] [--runs N] [--scenes NAME...]

How newell, bsp and convex-tree grow with the number of faces: prints for each a Markdown table over families of scenes that
grow fourfold from row to row. Times are processor seconds of one thread: those of a phase by the clock, times the share of the
processor that the whole study had; the least of the runs. The last column of a family's rows is the exponent with which the time
has grown since the row before."""

import argparse
import json
import math
import pathlib
import random
import subprocess
import tempfile


def terrain(n):
    """A height field over a square of n triangles, about: seen from aslant it hides parts of itself."""
    k = round(math.sqrt(n / 2))
    height = lambda x, y: 0.15 * math.sin(9 * x) * math.cos(7 * y) + 0.06 * math.sin(31 * x + 17 * y)
    points = [(i / k, j / k, height(i / k, j / k)) for j in range(k + 1) for i in range(k + 1)]
    faces = []
    for j in range(k):
        for i in range(k):
            a = j * (k + 1) + i
            faces += [(a, a + 1, a + k + 2), (a, a + k + 2, a + k + 1)]
    return points, faces


def plates(n):
    """Squares one behind the other, each a little aside: no two overlap in depth (thesis, figure 2.83)."""
    points, faces = [], []
    for i in range(n):
        x, z = math.cos(i), math.sin(i)
        faces.append(tuple(range(len(points), len(points) + 4)))
        points += [(x - 1, i, z - 1), (x + 1, i, z - 1), (x + 1, i, z + 1), (x - 1, i, z + 1)]
    return points, faces


def ball(n):
    """A convex body of triangles: an icosahedron whose sides are divided in four, again and again."""
    g = (1 + math.sqrt(5)) / 2
    points = [p for a in (-1, 1) for b in (-g, g) for p in ((0, a, b), (a, b, 0), (b, 0, a))]
    points = [tuple(c / math.sqrt(1 + g * g) for c in p) for p in points]
    near = lambda i, j: i != j and math.dist(points[i], points[j]) < 1.1
    faces = [(i, j, k) for i in range(12) for j in range(i) for k in range(j) if near(i, j) and near(j, k) and near(i, k)]
    while len(faces) < n:
        middles, divided = {}, []

        def middle(i, j):
            key = min(i, j), max(i, j)
            if key not in middles:
                middles[key] = len(points)
                p = [x + y for x, y in zip(points[i], points[j])]
                points.append(tuple(c / math.hypot(*p) for c in p))
            return middles[key]

        for i, j, k in faces:
            a, b, c = middle(i, j), middle(j, k), middle(k, i)
            divided += [(i, a, c), (a, j, b), (c, b, k), (a, b, c)]
        faces = divided
    return points, faces


def crossing(n):
    """Triangles through the middle, each through all others: the worst case."""
    draw = random.Random(1)
    points, faces = [], []
    for i in range(n):
        u, v = ([draw.gauss(0, 1) for _ in range(3)] for _ in range(2))
        faces.append(tuple(range(len(points), len(points) + 3)))
        for k in range(3):
            a, b = math.cos(2 * math.pi * k / 3), math.sin(2 * math.pi * k / 3)
            points.append(tuple(a * p + b * q for p, q in zip(u, v)))
    return points, faces


FAMILIES = {"terrain": (terrain, "iso", (6272, 25088, 100352, 401408)), "plates one behind the other": (plates, "front", (1000, 4000, 16000, 64000)),
            "convex body": (ball, "iso", (5120, 20480, 81920)), "all through each other": (crossing, "iso", (25, 50, 100))}
COMPILE = {"newell": ("elements", "list"), "bsp": ("tree",), "convex-tree": ("tree",)}
DISPLAY = {"newell": (), "bsp": ("order",), "convex-tree": ("order",)}
COUNTS = {"newell": {"pairs compared": "pairs compared", "moved": "moved to the head", "cuts": ("cuts by a plane", "cuts on the page"),
                     "elements": "final elements"},
          "bsp": {"splits": "splits", "nodes": "nodes", "depth": "depth of the tree"},
          "convex-tree": {"convex sets": "convex sets (nodes of type 1)", "complexity": "complexity (nodes of type 2)",
                          "splits": "splits", "depth": "depth of the tree"}}


def measured(ligne, model, view, method, folder, runs):
    """Counts and the least seconds of the phases."""
    counts, best = {}, {}
    for _ in range(runs):
        stats = folder / "stats.json"
        subprocess.run([ligne, "draw", model, "--view", view, "--up-axis", "z", "--quality", "exact", "--threads", "1", "-q", "--method",
                        method, "--stats-json", stats, "-o", folder / "x.svg"], check=True)
        found = json.loads(stats.read_text())
        counts = found["counts"]
        share = found["processor_seconds"]["study"] / found["stages"]["study"]
        for name, phases in (("compile", COMPILE[method]), ("display", DISPLAY[method])):
            seconds = sum(found["seconds"][p] for p in phases) * share
            best[name] = min(best.get(name, math.inf), seconds)
    return counts, best


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("ligne")
    parser.add_argument("methods", nargs="*", default=list(COUNTS))
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--scenes", nargs="*", default=list(FAMILIES))
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for method in arguments.methods:
            times = ["compile", "display"] if DISPLAY[method] else ["compile"]
            heads = ["scene", "faces", *COUNTS[method]] + [h for t in times for h in ({"compile": "list" if len(times) == 1 else "compile"}.get(t, t), "grows as n to the")]
            print(f"\n{method}\n\n| {' | '.join(heads)} |\n|{'---|' * len(heads)}")
            for family, (make, view, sizes) in ((f, FAMILIES[f]) for f in arguments.scenes):
                before = None
                for size in sizes:
                    points, faces = make(size)
                    model = folder / "model.obj"
                    model.write_text("".join("v %.9g %.9g %.9g\n" % p for p in points) +
                                     "".join("f " + " ".join(str(v + 1) for v in f) + "\n" for f in faces))
                    counts, best = measured(arguments.ligne, model, view, method, folder, arguments.runs)
                    row = [family, f"{len(faces):,}"]
                    for keys in COUNTS[method].values():
                        row.append(f"{sum(counts[k] for k in ([keys] if isinstance(keys, str) else keys)):,}")
                    for t in times:
                        grows = math.log(best[t] / before[1][t]) / math.log(len(faces) / before[0]) if before and before[1][t] > 0 else None
                        row += [f"{best[t]:.2g}", f"{grows:.2f}" if grows is not None else ""]
                    before = (len(faces), best)
                    print(f"| {' | '.join(row)} |", flush=True)


if __name__ == "__main__":
    main()
