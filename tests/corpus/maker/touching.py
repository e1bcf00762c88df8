"""Things that touch, and things that line up on the page."""

from .mesh import Mesh, Scene
from .shapes import block, box, cube, floor, pyramid, rectangle, sheet, sideways


def touching():
    table = floor(rectangle(-4, -4, 8, 8), name="table")
    yield Scene("vertex_on_edge", "the tip of a triangle stands in the middle of an edge of a cube",
                cube(), Mesh("triangle").face([(2, 0, 4), (0, -2, 8), (4, -2, 8)]))
    yield Scene("vertex_on_vertex", "two cubes touch in one corner", cube(), cube(4, 4, 4, 3))
    yield Scene("edge_on_edge_part", "two cubes touch along a part of an edge of each", cube(), cube(4, 2, 4))
    yield Scene("edge_on_edge_whole", "two cubes touch along a whole edge", cube(), cube(4, 0, 4))
    yield Scene("vertex_on_face", "a pyramid stands with its tip on the top of a cube",
                cube(), pyramid(rectangle(0, 0, 4, 4), 8, (1, 2, 4)))
    yield Scene("edge_on_face", "a prism lies with an edge on the top of a cube",
                cube(), sideways([(1, 4), (4, 6), (0, 8)], -1, 6, name="prism"))
    yield Scene("cube_on_table", "a cube stands on a table: its lower edges lie in the table's face", cube(), table)
    yield Scene("cube_under_table", "a cube hangs below a plate, its top in the plate's plane", cube(0, 0, -4), table)
    yield Scene("cubes_stacked_shifted", "three cubes on each other, each shifted: touching faces that overlap in part",
                cube(0, 0, 0), cube(1, 1, 4), cube(-1, 2, 8))
    yield Scene("cubes_stacked_flush", "three cubes on each other, flush: coplanar neighbours of different objects",
                cube(0, 0, 0), cube(0, 0, 4), cube(0, 0, 8))
    yield Scene("boxes_flush_sizes", "boxes of different sizes side by side, their tops and fronts in one plane",
                box((0, 0, 0), (4, 4, 4)), box((4, 0, 1), (7, 2, 4)), box((7, 0, 0), (9, 6, 4)))
    yield Scene("peg_in_hole", "a square peg fills a hole exactly and stands out on both sides",
                block(rectangle(0, 0, 8, 8), 0, 3, [rectangle(3, 3, 5, 5)], "plate"),
                block(rectangle(3, 3, 5, 5), -3, 6, name="peg"))
    yield Scene("bricks", "a wall of bricks in bond: faces touch, edges lie on faces, vertices on edges",
                *[box((4 * i - 2 * (k % 2), 0, 2 * k), (4 * i - 2 * (k % 2) + 4, 2, 2 * k + 2), "brick") for k in range(4) for i in range(3)])
    yield Scene("ramp_against_block", "a ramp leans with its upper edge on the edge of a block",
                box((0, 4, 0), (6, 8, 4)), sideways([(0, 0), (4, 0), (4, 4)], 1, 5, name="ramp"))
    yield Scene("leaning_plates", "two plates lean against each other: their upper edges are one line, partly",
                Mesh("plate").face([(0, 0, 0), (6, 0, 0), (6, 3, 5), (0, 3, 5)]),
                Mesh("plate").face([(2, 6, 0), (2, 3, 5), (8, 3, 5), (8, 6, 0)]))


def lined_up():
    yield Scene("plate_behind_rim", "a plate whose side lies exactly behind the rim of another in the front view, on either bank",
                sheet(rectangle(0, 0, 6, 6)), sheet(rectangle(6, 1, 10, 5), 3, name="beside"),
                sheet(rectangle(3, 2, 6, 8), 5, name="behind"))
    yield Scene("line_behind_common_side", "an edge exactly behind the common side of two faces in the front view: hidden by both",
                Mesh("fold").face([(0, 1, 0), (4, 0, 0), (4, 0, 6), (0, 1, 6)]).face([(4, 0, 0), (8, 1, 0), (8, 1, 6), (4, 0, 6)]),
                sheet(rectangle(4, -2, 7, 8), 4, name="plate behind"))
    yield Scene("two_banks", "an edge behind the sides of two plates that meet on the page, at different depths",
                sheet(rectangle(0, 0, 4, 6)), sheet(rectangle(4, 2, 8, 8), 2), sheet(rectangle(4, -2, 6, 10), 5, name="plate behind"))
    yield Scene("collinear_on_page", "plates at three depths whose sides lie on one line in the front view, overlapping in part",
                sheet(rectangle(0, 0, 4, 4)), sheet(rectangle(2, 4, 6, 8), 2), sheet(rectangle(5, 1, 9, 4), 4),
                sheet([(1, 4), (8, 4), (4, 6)], 6, name="triangle"))
    yield Scene("same_outline_two_depths", "two equal plates exactly behind each other in the front view",
                sheet(rectangle(0, 0, 5, 4)), sheet(rectangle(0, 0, 5, 4), 3))
    yield Scene("vertex_behind_vertex", "triangles that meet on the page in one point, each at a depth of its own",
                *[sheet(t, 2 * i, name=f"triangle {i + 1}") for i, t in enumerate(
                    ([(0, 0), (4, 1), (1, 4)], [(0, 0), (-1, 4), (-4, 1)], [(0, 0), (-4, -1), (-1, -4)], [(0, 0), (1, -4), (4, -1)]))])
    yield Scene("side_behind_a_later_rim", "triangles through each other; in the isometric view a side of the second lies exactly behind "
                "one of the third, which hides it",
                *[Mesh(f"triangle {i + 1}").face(t) for i, t in enumerate(
                    ([(0, 3, 2), (1, 1, 3), (2, 3, 2)], [(1, 1, 1), (1, 3, 0), (3, 0, 2)], [(3, 2, 1), (1, 0, 0), (3, 3, 2)],
                     [(3, 1, 3), (2, 3, 0), (0, 2, 0)], [(0, 1, 2), (2, 0, 3), (0, 0, 1)]))])
    yield Scene("stack_of_plates", "eight parallel plates close behind each other, each a little larger",
                *[sheet(rectangle(-k, -k, 8 + k, 6 + k), k / 4) for k in range(8)])
    yield Scene("stack_of_equal_plates", "eight equal parallel plates on each other",
                *[floor(rectangle(0, 0, 10, 6), k / 2) for k in range(8)])


def scenes():
    return [*touching(), *lined_up()]
