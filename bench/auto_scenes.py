"""The scenes on which methods are measured for --method auto: generated ones, the same bytes every time, and the models that
lie at hand. Each is a name, a file, and the options with which it is drawn."""

import glob
import math
import os
import random

import cost_inputs
from cost_inputs import CUBE, Obj, box


def grid_mesh(n, height, obj, closed_u=False, closed_v=False):
    """A mesh of n x n quadrilaterals through height(i / n, j / n), a point."""
    nu, nv = n + (not closed_u), n + (not closed_v)
    vertices = [height(i / n, j / n) for j in range(nv) for i in range(nu)]
    at = lambda i, j: (j % nv) * nu + i % nu
    obj.add(vertices, [(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)) for j in range(n) for i in range(n)])


def triangle_mesh(n, height, obj, closed_u=False, closed_v=False):
    """The same, of triangles, which any point may have."""
    nu, nv = n + (not closed_u), n + (not closed_v)
    vertices = [height(i / n, j / n) for j in range(nv) for i in range(nu)]
    at = lambda i, j: (j % nv) * nu + i % nu
    faces = []
    for j in range(n):
        for i in range(n):
            faces += [(at(i, j), at(i + 1, j), at(i + 1, j + 1)), (at(i, j), at(i + 1, j + 1), at(i, j + 1))]
    obj.add(vertices, faces)


def terrain(n, obj):
    """Hills z = f(x, y)."""
    triangle_mesh(n, lambda u, v: (u, v, 0.06 * math.sin(17 * u) * math.cos(13 * v) + 0.1 * math.sin(5 * u * v)), obj)


def plain(n, obj):
    """A grid that hides nothing of itself."""
    triangle_mesh(n, lambda u, v: (u, v, 0.01 * u * v), obj)


def sphere(n, obj):
    """One convex body."""
    ball(n, (0, 0, 0), 1, obj)


def ball(n, centre, radius, obj):
    vertices = [(centre[0], centre[1], centre[2] - radius)]
    rings = max(n // 2, 2)
    for r in range(1, rings):
        a = math.pi * (r / rings - 0.5)
        for i in range(n):
            b = 2 * math.pi * i / n
            vertices.append((centre[0] + radius * math.cos(a) * math.cos(b), centre[1] + radius * math.cos(a) * math.sin(b),
                             centre[2] + radius * math.sin(a)))
    vertices.append((centre[0], centre[1], centre[2] + radius))
    at = lambda r, i: 1 + (r - 1) * n + i % n
    faces = [(0, at(1, i + 1), at(1, i)) for i in range(n)]
    for r in range(1, rings - 1):
        for i in range(n):
            faces += [(at(r, i), at(r, i + 1), at(r + 1, i + 1)), (at(r, i), at(r + 1, i + 1), at(r + 1, i))]
    faces += [(at(rings - 1, i), at(rings - 1, i + 1), len(vertices) - 1) for i in range(n)]
    obj.add(vertices, faces)


def prism(n, obj):
    """One convex body whose two ends are faces of n corners."""
    ring = [(math.cos(2 * math.pi * i / n), math.sin(2 * math.pi * i / n)) for i in range(n)]
    vertices = [(x, y, 0) for x, y in ring] + [(x, y, 1) for x, y in ring]
    faces = [tuple(reversed(range(n))), tuple(range(n, 2 * n))]
    faces += [(i, (i + 1) % n, n + (i + 1) % n, n + i) for i in range(n)]
    obj.add(vertices, faces)


def torus(n, obj):
    def at(u, v):
        a, b = 2 * math.pi * u, 2 * math.pi * v
        return ((1 + 0.4 * math.cos(b)) * math.cos(a), (1 + 0.4 * math.cos(b)) * math.sin(a), 0.4 * math.sin(b))
    triangle_mesh(n, at, obj, True, True)


def knot(n, obj):
    """A tube along a torus knot: closed, hidden by itself many times."""
    def path(t):
        return ((2 + math.cos(3 * t)) * math.cos(2 * t), (2 + math.cos(3 * t)) * math.sin(2 * t), math.sin(3 * t))
    def at(u, v):
        t, a = 2 * math.pi * u, 2 * math.pi * v
        p, q = path(t), path(t + 1e-4)
        d = [b - c for b, c in zip(q, p)]
        length = math.sqrt(sum(c * c for c in d))
        d = [c / length for c in d]
        e = [-d[1], d[0], 0.0]
        length = math.hypot(e[0], e[1])
        e = [c / length for c in e]
        f = [d[1] * e[2] - d[2] * e[1], d[2] * e[0] - d[0] * e[2], d[0] * e[1] - d[1] * e[0]]
        return tuple(p[k] + 0.45 * (math.cos(a) * e[k] + math.sin(a) * f[k]) for k in range(3))
    triangle_mesh(n, at, obj, True, True)


def waves(n, obj):
    """A sheet with deep folds: each hides the next."""
    grid_mesh(n, lambda u, v: (u, v, 0.3 * math.sin(40 * (u + 0.2 * v))), obj, False, False)


def city(n, obj):
    """n houses that stand beside each other."""
    rng, side = random.Random(11), math.ceil(math.sqrt(n))
    for k in range(n):
        obj.add(box((k % side, k // side, 0), (rng.uniform(0.3, 0.9), rng.uniform(0.3, 0.9), rng.uniform(0.3, 4))), CUBE)


def apart(n, obj):
    """n boxes in one layer, of which none hides another: n zones."""
    side = math.ceil(math.sqrt(n))
    for k in range(n):
        obj.add(box((3 * (k % side), 3 * (k // side), 0), (1, 1, 0.3)), CUBE)


def balls(n, obj):
    """n balls that do not touch."""
    rng, side = random.Random(12), math.ceil(n ** (1 / 3))
    for k in range(n):
        ball(10, [3 * c + rng.uniform(0, 0.8) for c in (k % side, k // side % side, k // side ** 2)], 1, obj)


def soup(n, obj):
    """n triangles that penetrate each other."""
    rng = random.Random(13)
    size = 1.5 / n ** (1 / 3)
    for _ in range(n):
        c = [rng.random() for _ in range(3)]
        obj.add([[a + rng.uniform(-size, size) for a in c] for _ in range(3)], [(0, 1, 2)])


def curtains(n, obj):
    """n upright plates one behind the other: deep overlap."""
    rng = random.Random(14)
    for k in range(n):
        x, z = rng.uniform(0, 0.5), rng.uniform(0, 0.5)
        obj.add([(x, k / n, z), (x + 1, k / n, z), (x + 1, k / n, z + 1), (x, k / n, z + 1)], [(0, 1, 2, 3)])


def lattice(n, obj):
    """Bars of three directions that pass by each other: overlaps without an order."""
    for k in range(n):
        t = 1.0 * k
        obj.add(box((t, 0, 0.3), (0.25, n, 0.25)), CUBE)
        obj.add(box((0, t, 0.6), (n, 0.25, 0.25)), CUBE)
        obj.add(box((t + 0.4, t + 0.4, 0), (0.2, 0.2, n / 2)), CUBE)


def pipes(n, obj):
    """n pipes of 24 sides, side by side and across."""
    rng = random.Random(15)
    for k in range(n):
        ring = [(0.3 * math.cos(math.pi * i / 12), 0.3 * math.sin(math.pi * i / 12)) for i in range(24)]
        x, z, upright = 0.7 * (k // 2), rng.uniform(0, 3), k % 2
        ends = []
        for t in (0, 0.35 * n):
            ends += [((x + a, t, z + b) if upright else (t, x + a, z + 0.8 + b)) for a, b in ring]
        faces = [(i, (i + 1) % 24, 24 + (i + 1) % 24, 24 + i) for i in range(24)]
        faces += [tuple(reversed(range(24))), tuple(range(24, 48))]
        obj.add(ends, faces if upright else [tuple(reversed(f)) for f in faces])


def stairs(n, obj):
    """A spiral of n steps that penetrate a column."""
    obj.add(box((-0.2, -0.2, 0), (0.4, 0.4, n * 0.1)), CUBE)
    for k in range(n):
        a = 0.35 * k
        c, s = math.cos(a), math.sin(a)
        obj.add([(c * x - s * y, s * x + c * y, z + 0.1 * k) for x, y, z in box((0, -0.2, 0), (1, 0.4, 0.06))], CUBE)


# Family: function, sizes.
FAMILIES = {
    "terrain": (terrain, (20, 100, 160, 220)),
    "plain": (plain, (20, 140, 220)),
    "sphere": (sphere, (16, 120, 200, 280)),
    "prism": (prism, (12, 200, 2000)),
    "torus": (torus, (16, 120, 180)),
    "knot": (knot, (24, 100, 140)),
    "waves": (waves, (30, 120, 180)),
    "city": (city, (30, 1200, 2500)),
    "apart": (apart, (30, 2000, 4000)),
    "balls": (balls, (8, 150, 300)),
    "soup": (soup, (100, 2500, 5000)),
    "curtains": (curtains, (20, 100, 250)),
    "lattice": (lattice, (5, 25, 35)),
    "pipes": (pipes, (6, 30, 60)),
    "stairs": (stairs, (12, 300, 800)),
    "plates in one place": (cost_inputs.identical_plates, (5, 40)),
    "cubes in one place": (cost_inputs.identical_cubes, (10, 1000)),
    "sheets in one plane": (cost_inputs.overlapping_sheets, (20, 100, 200)),
    "needles": (cost_inputs.needles, (30, 60, 100)),
    "penetrating boxes": (cost_inputs.boxes, (20, 1000, 2000)),
    "touching cubes": (cost_inputs.touching_cubes, (27, 1331, 2744)),
    "squares on one edge": (cost_inputs.fan, (20, 150, 300)),
    "star": (cost_inputs.star, (200, 4000)),
    "comb": (cost_inputs.comb, (200, 4000)),
    "boxes in boxes": (cost_inputs.shells, (20, 200)),
    "stack of plates": (cost_inputs.stack, (20, 150, 600)),
}

# How each generated scene is drawn.
DRAWN = {
    "iso": ["--view", "iso"],
    "iso, all edges": ["--view", "iso", "--edges", "all"],
    "oblique, hidden": ["--direction=-3,5,-1", "--hidden", "dashed"],
}


def scenes(folder, root, models):
    """Yields (name, drawn, file, options); generated files are written into the folder."""
    for family, (function, sizes) in FAMILIES.items():
        for n in sizes:
            path = os.path.join(folder, f"{family.replace(' ', '_')}_{n}.obj")
            obj = Obj()
            function(n, obj)
            obj.write(path)
            for drawn, options in DRAWN.items():
                yield f"{family} {n}", drawn, path, options
    real = sorted(glob.glob(os.path.join(root, "examples/models/*.json")))
    if models:
        for kind in ("obj", "stl", "ply", "glb", "gltf", "ASC"):
            real += sorted(glob.glob(os.path.join(models, "*." + kind)))
    for path in real:
        for drawn in ("iso", "oblique, hidden"):
            yield os.path.basename(path), drawn, path, DRAWN[drawn]
