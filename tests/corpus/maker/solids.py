"""Single solids and simple buildings."""

from .mesh import Mesh, Scene
from .shapes import CIRCLE, block, box, cube, floor, polar, pyramid, rectangle, sheet, shifted, sideways, times, upright

HEXAGON = [(4, 0), (2, 3), (-2, 3), (-4, 0), (-2, -3), (2, -3)]
STAR = [(0, 6), (-1, 2), (-5, 2), (-2, 0), (-3, -4), (0, -1), (3, -4), (2, 0), (5, 2), (1, 2)]
LETTER_E = [(0, 0), (6, 0), (6, 2), (2, 2), (2, 4), (5, 4), (5, 6), (2, 6), (2, 8), (6, 8), (6, 10), (0, 10)]


def convex():
    yield Scene("one_triangle", "a scene of one triangle and nothing else", Mesh("triangle").face([(0, 0, 0), (4, 0, 0), (1, 2, 3)]))
    yield Scene("cube", "a cube: twelve edges, nine of them seen in most views", cube())
    yield Scene("tetrahedron", "a regular tetrahedron on every second corner of a cube", tetrahedron())
    yield Scene("octahedron", "a regular octahedron, its corners on the axes", octahedron())
    yield Scene("hexagonal_prism", "a hexagonal prism: two of its sides are seen edge on from the front", upright(HEXAGON, 0, 6))
    yield Scene("triangular_prism", "a triangular prism that lies on a side, its edges end on from the left and the right",
                sideways([(0, 0), (4, 0), (2, 3)], 0, 7, name="prism"))
    yield Scene("needle_pyramids", "pyramids a hundred times as high as wide, and one that is flat",
                pyramid(rectangle(0, 0, 1, 1), 0, (0.5, 0.5, 100), "needle"),
                pyramid(rectangle(2, 0, 3, 1), 0, (2.75, 0.25, 100), "leaning needle"),
                pyramid([(5, 0), (7, 0), (6, 1)], 100, (6, 0.5, 0), "needle on its tip"),
                pyramid(rectangle(-40, 4, 40, 84), 0, (0, 44, 0.25), "flat pyramid"))
    yield Scene("pyramid_on_its_tip", "a pyramid that stands with its tip on a table", pyramid(rectangle(-3, -3, 3, 3), 5, (0, 0, 0)),
                floor(rectangle(-5, -5, 5, 5), name="table"))
    yield Scene("thin_slivers", "triangles and a wedge thousands of times as long as wide, side by side and crossing on the page",
                Mesh("fan").face([(0, 0, 0), (64, 0, 0), (64, 0, 1 / 64)]).face([(0, 0, 0), (64, 0, 1 / 64), (64, 1 / 64, 1 / 32)]),
                sheet([(0, 1), (64, 1 + 1 / 128), (64, 1 + 1 / 64)], 1, name="sliver"),
                sheet([(30, -8), (30 + 1 / 64, -8), (30 + 1 / 64, 12), (30, 12)], 2, name="slat behind"),
                block([(0, 4), (64, 4), (0, 4 + 1 / 16)], 0, 1 / 16, name="wedge"),
                sheet([(40, -8), (41, -8), (40.5, 12)], -1, name="spike before"))


def tetrahedron():
    a, b, c, d = (0, 0, 0), (4, 4, 0), (4, 0, 4), (0, 4, 4)
    return Mesh("tetrahedron", solid=True).face([a, c, d]).face([a, b, c]).face([a, d, b]).face([b, d, c])


def octahedron(r=4):
    mesh = Mesh("octahedron", solid=True)
    equator = [(r, 0, 0), (0, r, 0), (-r, 0, 0), (0, -r, 0)]
    for a, b in zip(equator, equator[1:] + equator[:1]):
        mesh.face([a, b, (0, 0, r)]).face([b, a, (0, 0, -r)])
    return mesh


def concave():
    yield Scene("l_block", "an L extruded: the smallest concave solid",
                block([(0, 0), (6, 0), (6, 2), (2, 2), (2, 6), (0, 6)], 0, 3, name="L"))
    yield Scene("u_block", "a U extruded: one arm hides the inside of the other",
                block([(0, 0), (7, 0), (7, 6), (5, 6), (5, 2), (2, 2), (2, 6), (0, 6)], 0, 4, name="U"))
    yield Scene("star_prism", "a star of five points extruded: concave on all sides", upright(STAR, 0, 4, name="star"))
    yield Scene("star_pyramid", "a pyramid over a star: silhouettes with valleys between them", pyramid(STAR, 0, (0, 0, 8), "star"))
    yield Scene("letter_e", "the letter E extruded: three arms behind each other from the right", block(LETTER_E, 0, 3, name="E"))
    yield Scene("stair", "a stair of six steps as one solid with polygon faces", sideways(stair_outline(6), 0, 8, name="stair"))
    yield Scene("huet_stair_triangles",
                "Huet's stair, all triangles: convex sets within each other, an object of complexity zero", huet_stair(5))
    yield Scene("tunnel", "a cube with a square tunnel right through: faces with a hole, walls seen through it",
                block(rectangle(0, 0, 6, 6), 0, 6, [rectangle(2, 2, 4, 4)], "cube with a tunnel"))
    yield Scene("two_tunnels", "a block with a round tunnel and a concave one",
                block(rectangle(0, 0, 32, 16), 0, 12,
                      [shifted(CIRCLE, 8, 8), [(18, 3), (28, 3), (28, 13), (24, 13), (24, 7), (18, 7)]], "block"))
    yield Scene("pocket", "a cube with a blind hole: a face with a hole that leads nowhere", pocket())
    yield Scene("gear", "a gear wheel with a round bore", gear())
    yield Scene("torus", "a torus of exactly planar quadrilaterals: a silhouette with cusps", torus())
    yield Scene("low_sphere", "a sphere of few exactly planar faces, all vertices on whole coordinates", sphere())


def stair_outline(n):
    """In y, z: rises towards +y."""
    steps = [p for i in range(n) for p in ((2 * i, i), (2 * i, i + 1))]
    return steps[1:] + [(2 * n, n), (2 * n, 0), (0, 0)]


def huet_stair(n):
    """Steps of 2 by 1; the sides are cut into triangles along the steps."""
    mesh = Mesh("stair", solid=True)
    width = 6

    def quad(a, b, c, d):
        mesh.face([a, b, c]).face([a, c, d])

    # Corners of the sides: bottom[i] under top[i] and low[i], the two ends of a riser.
    for i in range(n):
        y, z = 2 * i, i
        low, top = z, z + 1
        quad((0, y, low), (width, y, low), (width, y, top), (0, y, top))  # riser
        quad((0, y, top), (width, y, top), (width, y + 2, top), (0, y + 2, top))  # tread
        quad((0, y, 0), (0, y + 2, 0), (width, y + 2, 0), (width, y, 0))  # bottom
        for x, flip in ((0, True), (width, False)):
            left = [(x, y, k) for k in sorted({0, low, top})]
            right = [(x, y + 2, k) for k in (0, top)]
            triangles = [[left[k], right[0], left[k + 1]] for k in range(len(left) - 1)] + [[left[-1], right[0], right[1]]]
            for t in triangles:
                mesh.face(t[::-1] if flip else t)
    y = 2 * n
    quad((width, y, 0), (0, y, 0), (0, y, n), (width, y, n))
    return mesh


def pocket():
    mesh = Mesh("cube with a pocket", solid=True)
    mesh.face([(0, 0, 6), (6, 0, 6), (6, 6, 6), (0, 6, 6)], [(1, 1, 6), (1, 4, 6), (4, 4, 6), (4, 1, 6)])
    for outer in cube(size=6).faces:
        points = [cube(size=6).vertices[v] for v in outer[0]]
        if any(p[2] != 6 for p in points):
            mesh.face(points)
    hollow = box((1, 1, 3), (4, 4, 6)).inside_out()
    for (outer,) in hollow.faces:
        points = [hollow.vertices[v] for v in outer]
        if any(p[2] != 6 for p in points):
            mesh.face(points)
    return mesh


def gear(teeth=12):
    outline = []
    for i in range(teeth):
        for radius, part in ((8, -0.3), (10, -0.15), (10, 0.15), (8, 0.3)):
            outline.append(polar(radius, (i + part) / teeth))
    return upright(outline, 0, 3, [times(CIRCLE, 0.5)], "gear")


def ring(k, z):
    return [(u * k, v * k, z) for u, v in CIRCLE]


def skin(mesh, lower, upper):
    n = len(lower)
    for i in range(n):
        j = (i + 1) % n
        mesh.face([lower[i], lower[j], upper[j], upper[i]])


def torus():
    """Circle of radius 5 at distance 10, both in steps of five: profile (k, z) becomes rings k times CIRCLE."""
    mesh = Mesh("torus", solid=True)
    rings = [ring(10 + u, 5 * v) for u, v in CIRCLE]
    for lower, upper in zip(rings, rings[1:] + rings[:1]):
        skin(mesh, lower, upper)
    return mesh


def sphere():
    """Radius 25: circles of latitude of radius 15, 20 and 25 have whole heights."""
    mesh = Mesh("sphere", solid=True)
    rings = [ring(3, -20), ring(4, -15), ring(5, 0), ring(4, 15), ring(3, 20)]
    for lower, upper in zip(rings, rings[1:]):
        skin(mesh, lower, upper)
    for i in range(len(CIRCLE)):
        j = (i + 1) % len(CIRCLE)
        mesh.face([rings[-1][i], rings[-1][j], (0, 0, 25)]).face([rings[0][j], rings[0][i], (0, 0, -25)])
    return mesh


def buildings():
    yield Scene("house", "a house of open walls with a door and windows, a roof that stands over, a chimney through the roof", *house())
    yield Scene("spiral_stair", "twelve steps round a column, each over the one before", *spiral_stair())
    yield Scene("nested_shells", "three boxes within each other, each with a window in its front: open shells, seen through windows",
                *[shell(k) for k in (1, 2, 3)])
    yield Scene("nested_cubes", "closed cubes within each other: all but the outermost are hidden",
                cube(0, 0, 0, 12, "outer cube"), cube(2, 2, 2, 8, "middle cube"), cube(4, 4, 4, 4, "inner cube"))
    yield Scene("cube_in_glass", "a closed cube of opacity 0.4 with a cube inside: back faces may go of the inner one alone",
                cube(0, 0, 0, 8, "glass").of_glass(0.4), cube(2, 2, 2, 4, "stone"))
    yield Scene("panes_round_a_block", "a block between panes of glass: one before it, one behind it, one across a corner of both",
                sheet([(1, 1), (9, 1), (9, 7), (1, 7)], -3, name="pane before").of_glass(0.5), box((3, 0, 2), (8, 4, 9), "block"),
                sheet([(0, 0), (12, 0), (12, 10), (0, 10)], 6, name="pane behind").of_glass(0.5),
                sheet([(6, 4), (11, 4), (11, 11), (6, 11)], -5, name="pane across").of_glass(0.25))
    yield Scene("window_frames", "a wall with four windows, their frames, and a cross of bars in each", *window_frames())
    yield Scene("room", "a room of three walls with a table in its corner, open to the viewer",
                Mesh("room").face([(0, 0, 0), (12, 0, 0), (12, 12, 0), (0, 12, 0)]).face([(0, 12, 0), (12, 12, 0), (12, 12, 9), (0, 12, 9)])
                .face([(0, 0, 0), (0, 12, 0), (0, 12, 9), (0, 0, 9)]),
                box((2, 6, 4), (9, 11, 5), "table top"),
                *[box((x, y, 0), (x + 1, y + 1, 4), "leg") for x in (2, 8) for y in (6, 10)])


def house():
    walls = Mesh("walls")
    door, window = [(2, 0.5), (4, 0.5), (4, 5), (2, 5)], rectangle(6, 2, 9, 5)
    walls.add(sheet([(0, 0), (12, 0), (12, 7), (6, 11), (0, 7)], 0, [door, window]))
    walls.add(sheet([(0, 0), (12, 0), (12, 7), (6, 11), (0, 7)], 10).mapped(lambda *p: p, flip=True))
    side = rectangle(2, 2, 4, 5), rectangle(6, 2, 8, 5)
    walls.face([(12, y, z) for y, z in rectangle(0, 0, 10, 7)], *[[(12, y, z) for y, z in h[::-1]] for h in side])
    walls.face([(0, y, z) for y, z in rectangle(0, 0, 10, 7)[::-1]], *[[(0, y, z) for y, z in h] for h in side])
    roof = Mesh("roof").face([(-1.5, -1, 6), (6, -1, 11), (6, 11, 11), (-1.5, 11, 6)])
    roof.face([(6, -1, 11), (13.5, -1, 6), (13.5, 11, 6), (6, 11, 11)])
    return walls, roof, box((8, 6, 8), (10, 8, 13), "chimney"), floor(rectangle(-4, -4, 16, 14), name="ground")


def spiral_stair():
    steps = []
    for i in range(12):
        a, b = CIRCLE[i], CIRCLE[(i + 1) % 12]
        outline = [(a[0], a[1]), (a[0] * 4, a[1] * 4), (b[0] * 4, b[1] * 4), (b[0], b[1])]
        steps.append(upright(outline, 4 * i, 4 * i + 2, name=f"step {i + 1}"))
    return [upright(CIRCLE, 0, 56, name="column"), *steps]


def shell(k):
    """Box of half-size 4k, its front with a window of half-size 3k - 1; one face thick."""
    r, w = 4 * k, 3 * k - 1
    mesh = Mesh(f"shell {k}")
    whole = box((-r, -r, -r), (r, r, r))
    for (outer,) in whole.faces:
        points = [whole.vertices[v] for v in outer]
        if any(p[1] != -r for p in points):
            mesh.face(points)
    return mesh.add(sheet(rectangle(-r, -r, r, r), -r, [rectangle(-w, -w, w, w)]))


def window_frames():
    openings = [rectangle(x, z, x + 6, z + 5) for z in (2, 9) for x in (2, 10)]
    parts = [block(rectangle(0, 0, 18, 16), 0, 2, openings, "wall")]
    for (x, z), *_ in openings:
        panes = [rectangle(x + a, z + b, x + a + 2, z + b + 1.5) for a in (0.5, 3.5) for b in (0.5, 3)]
        parts.append(block(rectangle(x, z, x + 6, z + 5), 0.5, 1, panes, "frame"))
    return parts


def scenes():
    return [*convex(), *concave(), *buildings()]
