"""Scenes of faces: holes, coplanar faces, open and odd surfaces, degenerate ones."""

import math

from .mesh import Mesh, Scene
from .shapes import CIRCLE, box, cube, dyadic, floor, rectangle, sheet, shifted, upright

SQUARE = rectangle(0, 0, 4, 4)


def holes():
    yield Scene("plate_one_hole", "a square plate with a square hole, a bar behind it seen in the hole",
                sheet(rectangle(0, 0, 8, 8), 0, [rectangle(2, 2, 6, 6)]), sheet(rectangle(-1, 3, 9, 4), 2, name="bar"))
    yield Scene("plate_many_holes", "a plate with nine holes before a slanted bar",
                sheet(rectangle(0, 0, 14, 14), 0, [rectangle(x, z, x + 2, z + 2) for x in (2, 6, 10) for z in (2, 6, 10)]),
                sheet([(-1, 1), (1, -1), (15, 13), (13, 15)], 3, name="bar"))
    yield Scene("plate_concave_holes", "holes in the shape of an L, a U and a star in one plate, a grille behind them",
                sheet(rectangle(0, 0, 32, 14), 0,
                      [[(2, 2), (8, 2), (8, 4), (4, 4), (4, 12), (2, 12)],
                       [(11, 2), (19, 2), (19, 12), (17, 12), (17, 4), (13, 4), (13, 12), (11, 12)],
                       shifted([(0, 6), (-1, 2), (-5, 2), (-2, 0), (-3, -4), (0, -1), (3, -4), (2, 0), (5, 2), (1, 2)], 26, 6)]),
                *[sheet(rectangle(0, z, 32, z + 1), 4, name="slat") for z in (3, 7, 11)])
    yield Scene("concave_plate_with_hole", "a U with a hole in each arm, behind it a triangle",
                sheet([(0, 0), (14, 0), (14, 12), (9, 12), (9, 5), (5, 5), (5, 12), (0, 12)], 0,
                      [rectangle(1, 6, 4, 10), [(10, 6), (13, 6), (11.5, 11)]], "U"),
                sheet([(-1, 3), (15, 3), (7, 14)], 3, name="triangle"))
    yield Scene("island_in_hole", "a face of its own in the hole of another, in the same plane",
                sheet(rectangle(0, 0, 10, 10), 0, [rectangle(2, 2, 8, 8)]).add(sheet(rectangle(4, 4, 6, 6))),
                sheet(rectangle(-1, 3, 11, 5), 3, name="bar"))
    yield Scene("hole_in_island", "rings within each other in one plane: island, hole in it, and an island in that",
                Mesh("rings").add(sheet(rectangle(0, 0, 18, 18), 0, [rectangle(2, 2, 16, 16)]))
                .add(sheet(rectangle(4, 4, 14, 14), 0, [rectangle(6, 6, 12, 12)])).add(sheet(rectangle(8, 8, 10, 10))),
                sheet([(-2, 8), (20, 8), (20, 9), (-2, 9)], 4, name="bar"))
    yield Scene("hole_filled_by_a_face", "the hole of a face is filled exactly by another face of the same object",
                sheet(rectangle(0, 0, 8, 8), 0, [rectangle(2, 2, 6, 6)]).add(sheet(rectangle(2, 2, 6, 6))))
    yield Scene("holes_behind_holes", "five plates with holes that shrink: seen from the front, hole within hole",
                *[sheet(rectangle(0, 0, 16, 16), 4 * k, [rectangle(2 + k, 2 + k, 14 - k, 14 - k)]) for k in range(5)])
    yield Scene("holes_aligned", "four equal plates with equal holes exactly behind each other in the front view",
                *[sheet(rectangle(0, 0, 12, 8), 3 * k, [rectangle(2, 2, 5, 6), rectangle(7, 2, 10, 6)]) for k in range(4)])
    yield Scene("round_hole", "a plate with a hole of twelve corners, a cube half in it",
                floor(rectangle(-8, -8, 8, 8), 0, [CIRCLE]), cube(-2, -2, -2))


def coplanar():
    yield Scene("triangulated_square", "a square cut along its diagonal: the diagonal lies between coplanar neighbours",
                sheet(SQUARE).triangulated())
    yield Scene("triangulated_cube", "a cube of twelve triangles: six edges that are no edges of the solid", cube().triangulated())
    yield Scene("coplanar_overlap_part", "two plates in one plane that overlap in part: neither hides the other",
                sheet(rectangle(0, 0, 6, 6)), sheet(rectangle(3, 2, 9, 8)))
    yield Scene("coplanar_overlap_whole", "a small plate lies in the plane of a larger one, wholly on it",
                sheet(rectangle(0, 0, 8, 8)), sheet([(2, 2), (6, 3), (4, 6)], name="triangle"))
    yield Scene("coplanar_overlap_sides", "plates in one plane that overlap with sides on each other",
                sheet(rectangle(0, 0, 6, 6)), sheet(rectangle(2, 0, 8, 6)), sheet(rectangle(0, 2, 4, 8)))
    yield Scene("coplanar_slender_strips", "slender strips in one plane that cross: flush like a grating, no strip penetrates another",
                *[floor(rectangle(4 * i, -2, 4 * i + 1, 18), name="strip along y") for i in range(5)],
                *[floor(rectangle(-2, 4 * i, 19, 4 * i + 1), name="strip along x") for i in range(5)])
    yield Scene("duplicate_faces", "a face that stands three times in one object, once wound the other way",
                sheet(SQUARE).face([(x, 0, z) for x, z in SQUARE]).face([(x, 0, z) for x, z in SQUARE[::-1]]))
    yield Scene("duplicate_objects", "the same cube twice, as two objects in the same place", cube(), cube(name="the same cube"))
    yield Scene("checkerboard", "coplanar squares of one object that touch at corners only, before a slanted bar",
                board(), sheet([(-1, 0), (0, -1), (9, 8), (8, 9)], 3, name="bar"))
    yield Scene("duplicate_parts", "two cubes in one place, one of squares, one of triangles", cube(), cube().triangulated())


def board():
    mesh = Mesh("checkerboard")
    for i in range(8):
        for k in range(i % 2, 8, 2):
            mesh.add(sheet(rectangle(i, k, i + 1, k + 1)))
    return mesh


def odd_surfaces():
    yield Scene("t_junction", "a long side of one face meets two faces: a vertex in the middle of an edge of the same object",
                Mesh("wall").add(sheet(rectangle(0, 0, 8, 4))).add(sheet(rectangle(0, 4, 3, 8)))
                .face([(3, 0, 4), (8, 0, 4), (8, 3, 8), (3, 3, 8)]))
    yield Scene("book_three", "three faces on one edge: a book with one page up", book([(-4, 1), (0, 5), (4, 1)]))
    yield Scene("book_four", "four faces on one edge", book([(-4, 1), (-2, 4), (1, 5), (4, 2)]))
    yield Scene("crossing_sheets_joined", "two plates that cross in an edge of both: four faces on the edge, two by two coplanar",
                book([(-4, 0), (0, 4), (4, 0), (0, -4)]))
    yield Scene("open_box", "a box without a lid: the inside is seen", open_box())
    yield Scene("open_strip", "a folded strip, open on all sides, hides parts of itself", folded_strip())
    yield Scene("inside_out_cube", "a cube wound inside out: looks as a cube does", cube().inside_out())
    yield Scene("mixed_winding", "a cube of whose faces every other is wound the wrong way", mixed_winding())
    yield Scene("moebius_strip", "a Moebius strip: no winding holds for it, it has one border", moebius())
    yield Scene("two_triangles_one_vertex", "two triangles that share a vertex and nothing else",
                Mesh("triangles").face([(0, 0, 0), (4, 0, 1), (3, 1, 4)]).face([(0, 0, 0), (-4, 1, -1), (-3, 0, -4)]))
    yield Scene("bow_of_two_tetrahedra", "two tetrahedra that meet in one vertex: the vertex is no manifold", *tetrahedra())
    yield Scene("height_field", "a hilly surface over a grid of sixteen by sixteen, in triangles", height_field())
    yield Scene("edge_on_plates", "plates seen edge on: from the front, from the left, from above, and one full on",
                floor(rectangle(0, 0, 6, 6), 1), sheet(rectangle(0, 2, 6, 8), 3),
                Mesh("plate").face([(8, 0, 0), (8, 6, 0), (8, 6, 6), (8, 0, 6)]),
                sheet(rectangle(3, 0, 10, 5), 8, name="plate behind"))
    yield Scene("end_on_iso", "a prism whose edges run along the line of sight of the isometric view, before a plate",
                upright([(0, 0), (3, 0), (2, 3)], 0, 4).mapped(lambda x, y, z: (x - z, y + z, -z), flip=True),
                sheet(rectangle(-8, -8, 6, 4), 8))
    # Rounded coordinates: the brace is edge on within a hundredth of a micrometre of the page, and not exactly.
    yield Scene("nearly_edge_on_iso", "a brace that is all but edge on in the isometric view, partly behind a plate",
                Mesh("plate").face([(0.5, 4.75, 14.5), (0.5, -4.75, 14.5), (0.5, 4.75, 13.5)]),
                Mesh("brace").face([(-0.25, -3.4311580657958984, 14.354567527770996),
                                    (0.25, -3.4311580657958984, 14.354567527770996),
                                    (0.25, -0.03704499825835228, 10.960454940795898)]))


def book(pages):
    """Pages on the edge along y at x = z = 0; each given by its far side in x, z."""
    mesh = Mesh("book")
    for x, z in pages:
        mesh.face([(0, 0, 0), (x, 0, z), (x, 6, z), (0, 6, 0)])
    return mesh


def open_box():
    mesh = Mesh("open box")
    whole = box((0, 0, 0), (6, 4, 3))
    for (outer,) in whole.faces:
        points = [whole.vertices[v] for v in outer]
        if any(p[2] != 3 for p in points):
            mesh.face(points)
    return mesh


def folded_strip():
    mesh = Mesh("strip")
    profile = [(0, 0), (4, 0), (5, 3), (1, 4), (2, 7), (7, 5)]
    for (y, z), (t, w) in zip(profile, profile[1:]):
        mesh.face([(0, y, z), (5, y, z), (5, t, w), (0, t, w)])
    return mesh


def mixed_winding():
    mesh = Mesh("cube")
    whole = cube()
    for i, (outer,) in enumerate(whole.faces):
        points = [whole.vertices[v] for v in outer]
        mesh.face(points[::-1] if i % 2 else points)
    return mesh


CRACK = 2 ** -13  # of a cube of 4: 3 to 6 micrometres on A4, where the oracle still sees it


def cube_with_crack():
    """The upper edge in front belongs to the lid; the front has a vertex in its middle, a crack lower."""
    mesh = Mesh("cube")
    for (outer,) in (whole := cube()).faces:
        points = [whole.vertices[v] for v in outer]
        if all(y == 0 for _, y, _ in points):
            points = [(0, 0, 0), (4, 0, 0), (4, 0, 4), (2, 0, 4 - CRACK), (0, 0, 4)]
        mesh.face(points)
    return mesh


def cube_with_loose_lid():
    mesh = Mesh("cube")
    for (outer,) in (whole := cube()).faces:
        points = [whole.vertices[v] for v in outer]
        mesh.face([(x, y, z + CRACK) for x, y, z in points] if all(z == 4 for _, _, z in points) else points)
    return mesh


def to_be_healed():
    """What --quality clear heals, and what it must leave alone."""
    twice = Mesh("cube")
    twice.add(cube().triangulated()).add(cube().triangulated().inside_out())
    yield Scene("cube_stored_twice", "a cube of triangles stored twice in one object, the second time inside out", twice)
    yield Scene("cube_with_crack", "a cube whose lid and front do not quite meet: a vertex of the front lies beside the lid's edge",
                cube_with_crack())
    yield Scene("cube_with_loose_lid", "a cube whose lid lies a little above its sides, each with vertices of its own",
                cube_with_loose_lid())
    apart = cube().add(cube(4 + CRACK)).mapped(lambda *p: p, name="two cubes")
    yield Scene("cubes_a_crack_apart", "two closed cubes of one object with a gap as narrow as a crack: they stay two", apart)
    lower = open_box()
    yield Scene("open_boxes_apart", "two open boxes of one object, rim to rim with a gap between them: they stay two",
                lower.add(lower.mapped(lambda x, y, z: (x, y, 6.125 - z), flip=True)).mapped(lambda *p: p, name="boxes"))


def moebius(n=16):
    def rib(i):
        turn = 2 * math.pi * i / n
        return [tuple(dyadic(c) for c in ((10 + w * math.cos(turn / 2)) * math.cos(turn),
                                          (10 + w * math.cos(turn / 2)) * math.sin(turn), w * math.sin(turn / 2))) for w in (-3, 3)]

    ribs = [rib(i) for i in range(n)]
    ribs.append(ribs[0][::-1])
    mesh = Mesh("strip")
    for (a, b), (c, d) in zip(ribs, ribs[1:]):
        mesh.face([a, b, d]).face([a, d, c])
    return mesh


def tetrahedra():
    mesh = Mesh("bow")
    for s in (1, -1):
        corners = [(0, 0, 0), (5 * s, -1, -2), (5 * s, 3, -1), (5 * s, 0, 3)]
        for a, b, c in ((0, 2, 1), (0, 3, 2), (0, 1, 3), (1, 2, 3)):
            face = [corners[a], corners[b], corners[c]]
            mesh.face(face if s > 0 else face[::-1])
    return [mesh]


def height_field(n=16):
    def at(i, k):
        x, y = i - n / 2, k - n / 2
        return i, k, dyadic(3 * math.cos(math.hypot(x, y) * 0.75) + 0.25 * x)

    mesh = Mesh("hills")
    for i in range(n):
        for k in range(n):
            a, b, c, d = at(i, k), at(i + 1, k), at(i + 1, k + 1), at(i, k + 1)
            mesh.face([a, b, c]).face([a, c, d])
    return mesh


def degenerate():
    flat = Mesh("faces").add(sheet(SQUARE)).face([(0, 0, 4), (2, 0, 4), (4, 0, 4)]).face([(4, 0, 0), (6, 1, 2), (8, 2, 4)])
    yield Scene("zero_area_faces", "a square, a face without area on its side, another by itself. Degenerate on purpose", flat, degenerate=True)
    twice = Mesh("plates")
    twice.face([(0, 0, 0), (4, 0, 0), (4, 0, 0), (4, 0, 4), (0, 0, 4), (0, 0, 4)])
    twice.face([(6, 0, 0), (10, 0, 0), (8, 0, 2), (10, 0, 4), (6, 0, 4), (8, 0, 2)])
    yield Scene("repeated_vertices", "a contour with vertices repeated in a row, and one that comes twice through a vertex. "
                "Degenerate on purpose", twice, degenerate=True)
    lost = Mesh("faces").add(sheet(SQUARE)).face([(0, 1, 0), (4, 1, 0), (4, 1, 0)]).face([(1, 1, 1), (1, 1, 1), (1, 1, 1)])
    yield Scene("collapsed_faces", "a square, and faces of two vertices and of one, which are dropped. Degenerate on purpose",
                lost, degenerate=True)
    yield Scene("not_planar", "a quadrilateral with one corner lifted: cut into triangles. Degenerate on purpose",
                Mesh("quad").face([(0, 0, 0), (4, 0, 0), (4, 1, 4), (0, 0, 4)]), degenerate=True)
    spiked = Mesh("plate").face([(0, 0, 0), (4, 0, 0), (7, 0, 0), (4, 0, 0), (4, 0, 4), (0, 0, 4)])
    yield Scene("spike", "a contour that runs out and back on a line. Degenerate on purpose", spiked, degenerate=True)
    yield Scene("hole_touches_rim", "holes that touch the rim in a vertex, and each other. Degenerate on purpose",
                sheet(rectangle(0, 0, 8, 8), 0, [[(0, 4), (3, 2), (3, 6)], [(3, 2), (6, 1), (6, 3)]]),
                sheet(rectangle(-1, 3, 9, 4), 2, name="bar"), degenerate=True)


def scenes():
    return [*holes(), *coplanar(), *odd_surfaces(), *to_be_healed(), *degenerate()]
