"""Penetration, mutual and cyclic overlap."""

from .mesh import Mesh, Scene
from .shapes import block, box, cube, floor, polar, pyramid, rectangle, ring_of_bars, sheet, sideways, upright

TRIANGLE = [(0, 0), (12, 0), (6, 10)]
PENTAGON = [polar(10, k / 5 + 1 / 20, 4) for k in range(5)]
HEXAGON = [(8, 0), (4, 7), (-4, 7), (-8, 0), (-4, -7), (4, -7)]

# In 64ths: a ball of a tip, five rings of eight and another tip, its corners pulled in and out.
CRUMPLED = [(0, 0, -64), (15, 0, -30), (-3, 7, -4), (0, -15, -55), (-23, 23, -69), (-11, 0, -34), (-23, -17, -55), (0, -32, -55),
            (23, -23, -55), (55, 0, -32), (39, 39, -32), (0, 55, -32), (-39, 28, -32), (-40, 0, -32),
            (-39, -39, -44), (0, -73, -46), (39, -39, 11), (43, 0, 0), (45, 45, 0), (0, 69, 0), (-45, 45, 0),
            (-13, 0, 0), (-45, -42, 0), (0, -15, 0), (45, -45, 0), (55, 0, 14), (0, 39, 32), (0, 55, 21),
            (-2, 39, 32), (-34, 0, 47), (-14, -21, -15), (0, -71, 30), (39, -16, 32), (32, 0, 55), (23, 23, 64),
            (0, 32, 55), (-32, 23, 73), (4, 0, 55), (-23, 8, 55), (0, 3, 33), (23, -23, 55), (0, 0, 64)]


def penetration():
    yield Scene("two_prisms_penetrating", "two square prisms cross in a right angle and penetrate",
                box((0, 4, 1), (12, 7, 4), "prism"), box((5, 0, 0), (7, 12, 3), "prism"))
    yield Scene("two_triangular_prisms_penetrating", "two triangular prisms penetrate: the intersection turns on slanted faces",
                sideways([(-3, 0), (3, 0), (0, 5)], -8, 8, name="prism"), block([(-3, -1), (3, -1), (0, 4)], -8, 8, name="prism"))
    yield Scene("three_prisms_penetrating", "three square prisms along the axes penetrate in one cube: coplanar faces where they cross",
                box((-6, -1, -1), (6, 1, 1), "along x"), box((-1, -6, -1), (1, 6, 1), "along y"), box((-1, -1, -6), (1, 1, 6), "along z"))
    yield Scene("three_prisms_unequal", "three prisms of different widths penetrate, no faces coplanar",
                box((-8, -3, -2), (8, 2, 3), "along x"), box((-1, -9, -1), (2, 7, 2), "along y"), box((-2, -1, -7), (1, 1, 8), "along z"))
    yield Scene("two_plates_penetrating", "two plates cross within both", sheet(rectangle(-4, -3, 4, 3)),
                sheet(rectangle(-3, -2, 3, 4), lambda x, z: x, name="slanted plate"))
    yield Scene("three_plates_penetrating", "three plates, each in a plane of two axes, all through one point",
                sheet(rectangle(-4, -4, 4, 4)), floor(rectangle(-4, -4, 4, 4)),
                Mesh("plate").face([(0, -4, -4), (0, 4, -4), (0, 4, 4), (0, -4, 4)]))
    yield Scene("penetrating_along_an_edge", "a prism is cut into by a plate exactly along its ridge: the intersection is an edge",
                sideways([(-3, 0), (3, 0), (0, 4)], -6, 6, name="prism"), sheet(rectangle(-4, -2, 4, 7), name="plate"))
    yield Scene("penetrating_plates_with_holes", "a plate passes through another, its edges partly in the other's hole",
                sheet(rectangle(-6, -6, 6, 6), 0, [rectangle(-3, -3, 3, 1)]),
                Mesh("plate").face([(-2, -5, -1), (5, -5, -1), (5, 5, 2), (-2, 5, 2)]))
    yield Scene("through_a_hole", "a bar goes through the hole of a plate without touching it",
                block(rectangle(-6, -6, 6, 6), 0, 1, [rectangle(-2, -2, 2, 2)], "plate"), block(rectangle(-1, -1, 1, 1), -6, 7, name="bar"))
    yield Scene("grazing_penetration", "the tip of a pyramid comes out of a plate by a thousandth of its height",
                sheet(rectangle(-6, -6, 6, 6)),
                pyramid(rectangle(-3, -3, 3, 3), 0, (0, 0, 6), "pyramid").mapped(lambda x, y, z: (x, 6 - 1 / 128 - z, y)))
    yield Scene("grazing_plates", "two plates penetrate at an angle so small that they are a hundredth apart at their ends",
                sheet(rectangle(-8, -4, 8, 4)), sheet(rectangle(-7, -5, 7, 5), lambda x, z: x / 512, name="nearly the same plane"))
    yield Scene("cross_of_plates", "two upright plates halved into each other, and a plate through both",
                sheet(rectangle(-5, 0, 5, 8)), Mesh("plate").face([(0, -5, 0), (0, 5, 0), (0, 5, 8), (0, -5, 8)]),
                Mesh("tilted plate").face([(-4, -4, 2), (4, -4, 4), (4, 4, 6), (-4, 4, 4)]))
    yield Scene("pyramid_in_cube", "the tip of a pyramid comes out of the top of a cube", cube(-4, -4, 0, 6),
                pyramid([(-3, -3), (1, -2), (0, 1), (-3, 1)], 1, (-1, -1, 9)))
    yield Scene("lattice_of_bars", "bars in three directions cross without touching", *lattice())
    yield Scene("lattice_of_bars_merged", "bars in two directions cross and penetrate in one plane",
                *[box((4 * i, -2, 0), (4 * i + 1, 18, 1), "bar") for i in range(5)],
                *[box((-2, 4 * i, 0), (19, 4 * i + 1, 1), "bar") for i in range(5)])
    yield Scene("dent_through_the_roof", "a box whose floor is dented so far that the dent comes out of its roof, inside out", dented_box())
    yield Scene("crumpled_ball", "a closed ball that penetrates itself in many places, and is inside out in some", crumpled_ball())


def dented_box():
    x0, x1, y0, y1, top = 0, 8, 0, 8, 4
    low, high = [(x0, y0, 0), (x1, y0, 0), (x1, y1, 0), (x0, y1, 0)], [(x0, y0, top), (x1, y0, top), (x1, y1, top), (x0, y1, top)]
    mesh = Mesh("dented box", solid=True).face(high)
    for i in range(4):
        k = (i + 1) % 4
        mesh.face([low[i], low[k], high[k], high[i]]).face([low[k], low[i], (3, 5, 8)])
    return mesh


def crumpled_ball():
    corner = [tuple(c / 64 for c in p) for p in CRUMPLED]
    rings = [range(1 + 8 * i, 9 + 8 * i) for i in range(5)]
    mesh = Mesh("crumpled ball", solid=True)
    for i in range(8):
        k = (i + 1) % 8
        mesh.face([corner[0], corner[rings[0][k]], corner[rings[0][i]]])
        for low, high in zip(rings, rings[1:]):
            a, b, c, d = corner[low[i]], corner[low[k]], corner[high[k]], corner[high[i]]
            mesh.face([a, b, c]).face([a, c, d])
        mesh.face([corner[rings[4][i]], corner[rings[4][k]], corner[41]])
    return mesh


def lattice():
    bars = []
    for i in range(4):
        for k in range(3):
            bars.append(box((-1, 4 * i, 4 * k), (14, 4 * i + 1, 4 * k + 1), "along x"))
            bars.append(box((4 * i, -1, 4 * k + 1.25), (4 * i + 1, 14, 4 * k + 2.25), "along y"))
        for k in range(4):
            bars.append(box((4 * i + 1.5, 4 * k + 1.5, -1), (4 * i + 2.5, 4 * k + 2.5, 12), "along z"))
    return bars


def mutual():
    yield Scene("cyclic_3", "three plates, each over the next: no order of painting", *ring_of_bars(TRIANGLE, 1 / 16, 0, 4, 1 / 4))
    yield Scene("cyclic_4", "four plates, each over the next", *ring_of_bars(rectangle(0, 0, 12, 12), 1 / 16, 0, 4, 1 / 4))
    yield Scene("cyclic_5", "five plates, each over the next", *ring_of_bars(PENTAGON, 1 / 16, 0, 4, 1 / 4))
    yield Scene("cyclic_6", "six plates, each over the next", *ring_of_bars(HEXAGON, 1 / 16, 0, 4, 1 / 4))
    yield Scene("cyclic_3_solid", "three solid bars, each over the next", *ring_of_bars(TRIANGLE, 1 / 16, 0, 4, 1 / 4, 1))
    yield Scene("cyclic_6_solid", "six solid bars, each over the next", *ring_of_bars(HEXAGON, 1 / 16, 0, 4, 1 / 4, 1))
    yield Scene("mutual_us", "two plates shaped as a U: one arm of each is over the other's, one under it, nothing penetrates",
                sheet([(-2, 1), (9, 1), (9, 7), (-2, 7), (-2, 5), (7, 5), (7, 3), (-2, 3)], 0, name="U on its side"),
                sheet([(0, -2), (2, -2), (2, 9), (4, 9), (4, -2), (6, -2), (6, 11), (0, 11)], lambda x, z: (x - 3) / 2, name="U upside down"))
    yield Scene("mutual_combs", "two combs: of each one half of the teeth is over the other's, one half under them",
                sheet(comb(3), 0, name="comb on its side"),
                sheet([(z, -2 - x + 12) for x, z in comb(4)], lambda x, z: (x - 7) / 4, name="comb upside down"))
    yield Scene("mutual_l_and_bar", "an L and a slanted bar: the bar is over one arm of the L and under the other",
                sheet([(0, 0), (10, 0), (10, 2), (2, 2), (2, 10), (0, 10)], 0, name="L"),
                sheet([(-2, 8), (-1, 9), (9, -1), (8, -2)], lambda x, z: (x - 3) / 2, name="bar"))
    yield Scene("woven_strips", "six folded strips woven over and under each other", *woven())


def comb(teeth):
    """Teeth towards -x, in x, z: a back of width 2, teeth of width 2 at steps of 4."""
    points = [(16, 0), (16, 4 * teeth - 2)]
    for k in reversed(range(teeth)):
        points += [(-2, 4 * k + 2), (-2, 4 * k)] if k == teeth - 1 else [(14, 4 * k + 2), (-2, 4 * k + 2), (-2, 4 * k)]
        if k:
            points.append((14, 4 * k))
    return points


def woven():
    strips = []
    for i in range(3):
        for across in (False, True):
            mesh = Mesh("strip across" if across else "strip along")
            for k in range(6):
                # At crossing j, in the middle of piece 2j, the strip is near or far by turns.
                near = lambda j: -1 if (i + j + across) % 2 else 1
                a, b = near(k // 2), near((k + 1) // 2)
                s, t = ((3 * k, a), (3 * k + 3, b))
                low, high = 6 * i + 0.5, 6 * i + 2.5
                points = [(s[0], s[1], low), (t[0], t[1], low), (t[0], t[1], high), (s[0], s[1], high)]
                mesh.face(points)
            if across:
                mesh = mesh.mapped(lambda x, y, z: (z, y, x), flip=True)
            strips.append(mesh)
    return strips


def scenes():
    return [*penetration(), *mutual()]
