"""Scenes after the figures of the thesis on visibility methods, chapter 2. README.md says what its text gives of each.

Its z axis, the depth, is our y; its x and y on the screen are our x and z in the front view.
"""

from .mesh import Scene
from .shapes import block, box, rectangle, ring_of_bars, sheet, shifted, sideways, turned, upright

# Cosine and sine, times 241, of the angle with whole ones that is next to 30 degrees: 29.86 degrees.
NEARLY_30 = (209, 120)
TURNED_SQUARE = turned(rectangle(-2, -2, 2, 2), 4, 3)  # by 36.87 degrees, side 20


def squares(n, c, s):
    """Squares in a row along the diagonal of x and depth, turned in that plane; each is the section of a box."""
    boxes = []
    for i in range(n):
        square = turned(shifted(rectangle(0, 0, 2, 2), 3 * i, 3 * i), c, s)
        boxes.append(upright(square, 0, 3 * abs(complex(c, s)) // 1, name=f"square {i + 1}"))
    return boxes


def figure_2_52():
    text = {"a": "sides along the axes, no one hides another, one side of each is seen",
            "c": "turned by 45 degrees: one behind the other, one zone, only the first is seen",
            "d": "turned by 30 degrees: each hides a part of the next"}
    for letter, (c, s) in {"a": (1, 0), "c": (1, 1), "d": NEARLY_30}.items():
        for n in range(1, 6):
            about = f"thesis, figure 2.52 {letter}: {n} square{'s' * (n > 1)} along a diagonal, {text[letter]}"
            yield Scene(f"thesis_2_52{letter}_n{n}", about, *squares(n, c, s))
    yield Scene("thesis_2_52d_60_n5", "thesis, figure 2.52 d: 5 squares turned by 60 degrees, the mirror image of those turned by 30",
                *squares(5, *NEARLY_30[::-1]))


def warnock():
    yield Scene("thesis_2_2", "thesis, figure 2.2: a scene given by three views, its front view divided into windows; "
                "here a stepped block before a wedge",
                block([(0, 0), (6, 0), (6, 2), (3, 2), (3, 5), (0, 5)], 0, 3, name="stepped block"),
                sideways([(4, 0), (8, 0), (8, 4)], 2, 9, name="wedge"))
    square = sheet(TURNED_SQUARE, 0, name="square")
    yield Scene("thesis_2_20", "thesis, figures 2.20 to 2.23: a square that hides a triangle; about 60 windows, 20 from the bounding square, "
                "one along the square's sides", square, sheet([(-6, -5), (7, -3), (1, 8)], 4, name="triangle"))
    yield Scene("thesis_2_22_moved", "thesis, figure 2.22: the triangle moved slightly, still hidden: the number of windows grows considerably",
                square, sheet([(-7, -4), (6, -2), (0, 9)], 4, name="triangle"))
    yield Scene("thesis_2_22_seen", "thesis, figure 2.22: the triangle moved so far that a corner comes out",
                square, sheet([(-1, -5), (16, -3), (6, 8)], 4, name="triangle"))


def watkins():
    yield Scene("thesis_2_59a", "thesis, figure 2.59, first case: a face with corners C, A, B, D; at A and B only the bounding edge changes",
                sheet([(3, 8), (0, 5), (2, 0), (7, 3)], 0, name="CADB"))
    yield Scene("thesis_2_59b", "thesis, figure 2.59, second case: the corner A of a face is hidden, and so is the change at it",
                sheet(rectangle(0, 2, 5, 7), 0, name="in front"), sheet([(8, 8), (2, 5), (8, 0)], 3, name="with corner A"))
    yield Scene("thesis_2_59c", "thesis, figure 2.59, third case: the order of the ends of two faces changes, both are hidden",
                sheet(rectangle(0, 0, 12, 10), 0, name="in front"), sheet([(2, 1), (7, 1), (4, 9)], 3, name="leaning right"),
                sheet([(6, 2), (10, 2), (3, 8)], 5, name="leaning left"))


def atherton_weiler():
    yield Scene("thesis_2_63", "thesis, figure 2.63: a set of faces that falls into three zones, studied independently of each other",
                sheet([(0, 0), (5, 1), (2, 6)], 0, name="zone 1"), sheet(rectangle(1, 2, 6, 7), 2, name="zone 1"),
                sheet(rectangle(9, 0, 14, 4), 1, name="zone 2"), sheet([(12, 2), (16, 3), (13, 6)], 0, name="zone 2"),
                sheet(rectangle(10, 3, 13, 5), 4, name="zone 2"),
                sheet([(8, 9), (15, 8), (14, 13), (9, 12)], 3, name="zone 3"))
    yield Scene("thesis_2_64", "thesis, figure 2.64: a zone of five faces that falls into three slabs, of two faces, one and two",
                sheet(rectangle(0, 0, 6, 5), lambda x, z: x / 4, name="slab 1"), sheet(rectangle(4, 3, 9, 8), lambda x, z: z / 4, name="slab 1"),
                sheet([(2, 2), (12, 1), (8, 7)], 4, name="slab 2"),
                sheet(rectangle(1, 4, 8, 10), lambda x, z: 5 + z / 4, name="slab 3"),
                sheet([(6, 0), (14, 3), (10, 9)], lambda x, z: 6 + x / 8, name="slab 3"))
    yield Scene("thesis_2_66", "thesis, figure 2.66: slab 1 of four faces, three of them cut by the fourth, all hidden by the one face of slab 2",
                sheet(rectangle(0, 0, 14, 12), 0, name="slab 2, screen face"), sheet(rectangle(5, 1, 8, 11), 4, name="slab 1, nearest"),
                sheet([(2, 8), (7, 9), (3, 11)], 5, name="slab 1"), sheet(rectangle(6, 5, 12, 7), 5, name="slab 1"),
                sheet([(1, 1), (6, 2), (2, 4)], 5, name="slab 1"))
    yield Scene("thesis_2_68", "thesis, figure 2.68: keys of the sort: by their nearest points P comes before Q and R, which are before it",
                sheet(rectangle(0, 0, 14, 6), lambda x, z: x / 2, name="P"), sheet(rectangle(8, 1, 10, 8), 2, name="Q"),
                sheet([(11, -1), (13, 3), (10, 4)], 3, name="R"))
    yield Scene("thesis_2_67", "thesis, figure 2.67: each face is cut by one other face only, into r + 1 = 3 parts of which r = 2 are seen",
                *[sheet(rectangle(*r), 2 * k, name=f"face {k + 1}") for k, r in enumerate(
                    ((4, 0, 6, 10), (0, 6, 14, 8), (10, 2, 12, 14), (8, 10, 20, 12), (16, 8, 18, 18)))])


def newell():
    yield Scene("thesis_2_72", "thesis, figure 2.72: two faces in a valid order, F1 and then F2 which hides a part of it",
                sheet(rectangle(0, 0, 8, 6), 4, name="F1"), sheet([(4, 2), (12, 3), (7, 9)], 0, name="F2"))
    yield Scene("thesis_2_73", "thesis, figure 2.73: two faces that hide each other in part: one is cut by the plane of the other",
                sheet([(0, 0), (10, 0), (10, 8), (8, 8), (8, 2), (2, 2), (2, 8), (0, 8)], 0, name="F1"),
                sheet(rectangle(-2, 4, 12, 6), lambda x, z: (x - 5) / 2, name="F2"))
    yield Scene("thesis_2_81a", "thesis, figure 2.81 a: P has a point farther than all of Q and hides Q",
                sheet(rectangle(0, 0, 12, 6), lambda x, z: x - 2, name="P"), sheet(rectangle(1, 1, 4, 8), 3, name="Q"))
    yield Scene("thesis_2_81b", "thesis, figure 2.81 b: P and Q have the same key in the sort and stand in any order",
                sheet([(0, 0), (8, 0), (8, 6), (0, 6)], lambda x, z: 4 - x / 2, name="P"), sheet(rectangle(5, 2, 11, 9), 4, name="Q"))
    yield Scene("thesis_2_81c", "thesis, figure 2.81 c: P and Q penetrate",
                sheet([(0, 0), (10, 1), (4, 8)], lambda x, z: 2, name="P"), sheet(rectangle(2, -1, 7, 6), lambda x, z: z, name="Q"))
    yield Scene("thesis_2_81d", "thesis, figure 2.81 d: P and Q overlap mutually, which asks for a face that is not convex",
                sheet([(0, 0), (10, 0), (10, 3), (3, 3), (3, 7), (10, 7), (10, 10), (0, 10)], 0, name="P"),
                sheet([(5, -2), (8, -2), (8, 12), (5, 12)], lambda x, z: (z - 5) / 2, name="Q"))
    p, q, r = ring_of_bars([(0, 0), (16, 0), (8, 12)], 1 / 8, 0, 4, 1 / 4)
    for mesh, name in ((p, "P"), (q, "Q"), (r, "R")):
        mesh.name = name
    yield Scene("thesis_2_81e", "thesis, figure 2.81 e: cyclic overlap of P, Q and R", p, q, r)
    yield Scene("thesis_2_82", "thesis, figure 2.82: the set Q_P: of Q1 to Q4 only Q2 and Q3 end within the depth of P",
                sheet(rectangle(0, 0, 12, 6), lambda x, z: x / 2, name="P"), sheet(rectangle(1, 1, 5, 9), 8, name="Q1"),
                sheet(rectangle(2, -3, 4, 3), 5, name="Q2"), sheet(rectangle(8, 2, 10, 8), lambda x, z: x / 4, name="Q3"),
                sheet(rectangle(5, 4, 7, 10), -2, name="Q4"))
    yield Scene("thesis_2_83", "thesis, figure 2.83: the depths of all faces are apart, nothing is compared",
                *[sheet(rectangle(2 * k, k, 2 * k + 8, k + 5), lambda x, z, k=k: 3 * k + (x - 2 * k) / 4, name=f"F{k + 1}")
                  for k in range(5)])
    yield Scene("thesis_2_84", "thesis, figure 2.84: each of three faces is in mutual overlap with P, and sorted wrongly with it",
                sheet(rectangle(-1, -1, 11, 28), lambda x, z: x - 4, name="P"),
                *[sheet([(0, k), (10, k), (10, k + 6), (8, k + 6), (8, k + 2), (2, k + 2), (2, k + 6), (0, k + 6)],
                        lambda x, z: 6 - x / 2, name=f"F{k // 9 + 1}") for k in (0, 9, 18)])
    yield Scene("thesis_2_85", "thesis, figure 2.85: a cut of F, with r corners, into r/2 + 1 faces",
                sheet([(0, 0), (10, 0), (10, 2), (2, 2), (2, 4), (10, 4), (10, 6), (2, 6), (2, 8), (10, 8), (10, 10), (0, 10)], 0,
                      name="F"),
                sheet([(4, -2), (8, -2), (8, 12), (4, 12)], lambda x, z: x - 6, name="P"))
    zones = [sheet(rectangle(0, 0, 6, 6), 4, name="zone 1"), sheet(rectangle(2, 2, 4, 8), lambda x, z: x, name="zone 1"),
             sheet(rectangle(10, 0, 16, 6), lambda x, z: x - 10, name="zone 2"), sheet(rectangle(11, 1, 15, 3), 7, name="zone 2")]
    yield Scene("thesis_2_86", "thesis, figure 2.86: two zones that have no influence on each other", *zones)
    boxes = [sheet(rectangle(0, 0, 8, 6), lambda x, z: 10 + x / 4, name="box 1"),
             sheet(rectangle(1, 1, 7, 8), lambda x, z: 11 - z / 8, name="box 1"),
             sheet(rectangle(2, -2, 6, 4), lambda x, z: x / 2, name="box 2"),
             sheet([(3, -3), (9, 2), (4, 5)], lambda x, z: 4 - z / 4, name="box 2")]
    yield Scene("thesis_2_87", "thesis, figure 2.87: a zone of two boxes with a plane between them", *boxes)
    yield Scene("thesis_2_88", "thesis, first figure 2.88: zones of slabs of zones, each of one face in the end",
                sheet(rectangle(0, 0, 10, 10), lambda x, z: 9 - x / 10, name="left"),
                sheet(rectangle(0, 0, 10, 4), lambda x, z: 3 - x / 10, name="left, near, below"),
                sheet(rectangle(0, 6, 10, 10), lambda x, z: 3 - x / 5, name="left, near, above"),
                sheet(rectangle(20, 0, 30, 10), lambda x, z: 9 - (x - 20) / 4 * 3, name="right"),
                sheet(rectangle(20, 2, 30, 8), lambda x, z: (x - 20) / 20, name="right, near"))


def scenes():
    return [*warnock(), *figure_2_52(), *watkins(), *atherton_weiler(), *newell()]
