"""Families of scenes that grow, for bench/cost.py: each function writes a scene of n parts to an OBJ file, the same bytes
every time. Most are what everyday files hold in small numbers: parts that stand twice, faces in one plane, parts that touch,
faces of many corners, many faces through one point."""

import math
import random

CUBE = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]


class Obj:
    """Collects the parts of a scene, each an object with vertices of its own."""

    def __init__(self):
        self.lines, self.vertex_count = [], 0

    def add(self, vertices, faces):
        self.lines.append(f"o part{len(self.lines)}")
        self.lines += ["v %.9g %.9g %.9g" % tuple(v) for v in vertices]
        self.lines += ["f " + " ".join(str(i + 1 + self.vertex_count) for i in f) for f in faces]
        self.vertex_count += len(vertices)

    def write(self, path):
        with open(path, "w", encoding="ascii") as file:
            file.write("\n".join(self.lines) + "\n")


def box(low, size):
    return [tuple(low[a] + size[a] * (k >> a & 1) for a in range(3)) for k in range(8)]


def identical_plates(n, obj):
    """n plates of 20 x 20 squares in one place."""
    side = 21
    vertices = [(i, j, 0) for j in range(side) for i in range(side)]
    faces = [(j * side + i, j * side + i + 1, (j + 1) * side + i + 1, (j + 1) * side + i)
             for j in range(side - 1) for i in range(side - 1)]
    for _ in range(n):
        obj.add(vertices, faces)


def identical_cubes(n, obj):
    """n unit cubes in one place."""
    for _ in range(n):
        obj.add(box((0, 0, 0), (1, 1, 1)), CUBE)


def nearly_identical_cubes(n, obj):
    """n unit cubes within 1e-7 of one place."""
    rng = random.Random(1)
    for _ in range(n):
        obj.add(box([rng.uniform(-1e-7, 1e-7) for _ in range(3)], (1, 1, 1)), CUBE)


def overlapping_sheets(n, obj):
    """n rectangles of all sizes in one plane."""
    rng = random.Random(4)
    for _ in range(n):
        x, y, w, h = rng.uniform(0, 3), rng.uniform(0, 3), rng.uniform(1, 5), rng.uniform(1, 5)
        obj.add([(x, y, 0), (x + w, y, 0), (x + w, y + h, 0), (x, y + h, 0)], [(0, 1, 2, 3)])


def needles(n, obj):
    """n slender triangles through one point."""
    rng = random.Random(2)
    for _ in range(n):
        d = [rng.gauss(0, 1) for _ in range(3)]
        length = math.sqrt(sum(c * c for c in d))
        d = [c / length for c in d]
        e = [rng.gauss(0, 1) for _ in range(3)]
        along = sum(a * b for a, b in zip(d, e))
        e = [b - along * a for a, b in zip(d, e)]
        length = math.sqrt(sum(c * c for c in e))
        e = [0.002 * c / length for c in e]
        obj.add([[-c for c in d], [a + b for a, b in zip(d, e)], [a - b for a, b in zip(d, e)]], [(0, 1, 2)])


def rotated(p, axis, angle):
    """The point turned about an axis of length 1."""
    c, s = math.cos(angle), math.sin(angle)
    along = sum(a * b for a, b in zip(axis, p)) * (1 - c)
    x, y, z = axis
    cross = (y * p[2] - z * p[1], z * p[0] - x * p[2], x * p[1] - y * p[0])
    return [c * a + s * b + along * e for a, b, e in zip(p, cross, axis)]


def random_direction(rng):
    d = [rng.gauss(0, 1) for _ in range(3)]
    length = math.sqrt(sum(c * c for c in d))
    return [c / length for c in d]


def boxes_about_a_point(n, obj):
    """n slender boxes about one point, turned at random."""
    rng = random.Random(6)
    for _ in range(n):
        axis, angle = random_direction(rng), rng.uniform(-2, 2)
        obj.add([rotated(v, axis, angle) for v in box((-0.05, -0.11, -0.06), (0.1, 0.22, 0.12))], CUBE)


def crosses_about_a_point(n, obj):
    """n crosses of two squares about one point, turned at random."""
    rng, half = random.Random(7), 0.1
    for _ in range(n):
        axis, angle = random_direction(rng), rng.uniform(-3, 3)
        corners = [(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0), (-1, 0, -1), (1, 0, -1), (1, 0, 1), (-1, 0, 1)]
        obj.add([rotated([half * c for c in v], axis, angle) for v in corners], [(0, 1, 2, 3), (4, 5, 6, 7)])


def boxes(n, obj):
    """n boxes that penetrate each other, as dense for every n."""
    rng, side = random.Random(3), n ** (1 / 3)
    for _ in range(n):
        size = [rng.uniform(0.3, 1.2) for _ in range(3)]
        obj.add(box([rng.uniform(0, side) for _ in range(3)], size), CUBE)


def touching_cubes(n, obj):
    """n unit cubes, face to face."""
    side = round(n ** (1 / 3))
    for k in range(side ** 3):
        obj.add(box((k % side, k // side % side, k // side ** 2), (1, 1, 1)), CUBE)


def fan(n, obj):
    """n squares with one common edge, as separate parts."""
    for k in range(n):
        a = math.pi * k / n
        x, y = math.cos(a), math.sin(a)
        obj.add([(0, 0, 0), (x, y, 0), (x, y, 1), (0, 0, 1)], [(0, 1, 2, 3)])


def star(n, obj):
    """One face of n corners, near and far from the middle by turns."""
    ring = [((0.5 + 0.5 * (i % 2)) * math.cos(2 * math.pi * i / n), (0.5 + 0.5 * (i % 2)) * math.sin(2 * math.pi * i / n), 0)
            for i in range(n)]
    obj.add(ring, [tuple(range(n))])


def comb(n, obj):
    """One face of n corners: long teeth."""
    m, ring = n // 4, []
    for i in range(m):
        ring += [(i / m, 0.01, 0), (i / m, 1, 0), ((i + 0.5) / m, 1, 0), ((i + 0.5) / m, 0.01, 0)]
    ring += [(1, 0.01, 0), (1, 0, 0), (0, 0, 0)]
    obj.add(ring, [tuple(range(len(ring)))])


def shells(n, obj):
    """n closed boxes, each in the next."""
    for k in range(n):
        r = 1 + k / n
        obj.add(box((-r, -r, -r), (2 * r, 2 * r, 2 * r)), CUBE)


def skins(n, obj):
    """n closed spheres of 12 x 24 cells, each in the next."""
    rows, columns = 12, 24
    for k in range(n):
        r = 1 + k / n
        vertices, faces = [(0, 0, r), (0, 0, -r)], []
        for i in range(1, rows):
            for j in range(columns):
                t, p = math.pi * i / rows, 2 * math.pi * j / columns
                vertices.append((r * math.sin(t) * math.cos(p), r * math.sin(t) * math.sin(p), r * math.cos(t)))
        ring = lambda i, j: 2 + (i - 1) * columns + j % columns
        for j in range(columns):
            faces += [(0, ring(1, j), ring(1, j + 1)), (1, ring(rows - 1, j + 1), ring(rows - 1, j))]
            faces += [(ring(i, j), ring(i + 1, j), ring(i + 1, j + 1), ring(i, j + 1)) for i in range(1, rows - 1)]
        obj.add(vertices, faces)


def stack(n, obj):
    """n plates above each other, each with a rim of its own."""
    rng = random.Random(5)
    for k in range(n):
        x, y = rng.uniform(0, 0.2), rng.uniform(0, 0.2)
        obj.add(box((x, y, k / n), (1, 1, 0.5 / n)), CUBE)


# Family: function, three sizes, options beside the default ones.
FAMILIES = {
    "identical plates, all edges": (identical_plates, (100, 300, 900), ["--edges", "all"]),
    "identical cubes": (identical_cubes, (1000, 3000, 9000), []),
    "nearly identical cubes": (nearly_identical_cubes, (1000, 3000, 9000), []),
    "sheets in one plane": (overlapping_sheets, (100, 300, 900), []),
    "needles": (needles, (500, 1500, 4500), ["--edges", "outline,crease,border"]),
    "needles with intersections": (needles, (150, 450, 1350), []),
    "needles, hidden dashed": (needles, (50, 100, 200), ["--hidden", "dashed"]),
    "boxes about a point": (boxes_about_a_point, (50, 150, 450), []),
    "boxes about a point, hidden dashed": (boxes_about_a_point, (30, 60, 120), ["--hidden", "dashed"]),
    "crosses about a point, hidden dashed": (crosses_about_a_point, (30, 60, 120), ["--hidden", "dashed"]),
    "penetrating boxes": (boxes, (1000, 3000, 9000), []),
    "penetrating boxes, hidden dashed": (boxes, (1000, 3000, 9000), ["--hidden", "dashed"]),
    "touching cubes": (touching_cubes, (1000, 3375, 10648), []),
    "squares on one edge": (fan, (300, 900, 2700), []),
    "star, one face": (star, (10000, 30000, 90000), []),
    "star seen edge on": (star, (20000, 60000, 180000), ["--view", "left"]),
    "comb, one face": (comb, (10000, 30000, 90000), []),
    "comb, one face, hidden dashed": (comb, (10000, 30000, 90000), ["--hidden", "dashed"]),
    "spheres in spheres, hidden dashed": (skins, (30, 100, 300), ["--hidden", "dashed"]),
    "boxes in boxes": (shells, (1000, 3000, 9000), []),
    "stack of plates": (stack, (300, 900, 2700), []),
}


def write(family, n, path):
    obj = Obj()
    FAMILIES[family][0](n, obj)
    obj.write(path)
