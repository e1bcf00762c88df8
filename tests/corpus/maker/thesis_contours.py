"""Scenes after the figures on clipping a face by a face in chapter 3 of the thesis (3.2.3.4, figures 3.24 to 3.33).

The clip face is always the nearer one, at y = 0; the subject face stands at y = 3. README.md says what its text gives of each. Figures 2.61
and 2.65 are of the same kind.
"""

from .mesh import Scene
from .shapes import rectangle, sheet

S = rectangle(0, 0, 4, 4)


def pair(name, figure, about, clip, subject, clip_holes=(), subject_holes=()):
    return Scene(name, f"thesis, figure {figure}: {about}", sheet(clip, 0, clip_holes, "clip face"),
                 sheet(subject, 3, subject_holes, "subject face"))


def in_general():
    comb = [(0, 1), (13, 1), (13, 3), (2, 3), (2, 5), (13, 5), (13, 7), (2, 7), (2, 9), (13, 9), (13, 11), (0, 11)]
    return [
        Scene("thesis_2_61", "thesis, figure 2.61: scene and visibility model: a face with a hole before a face before a third, three visible polygons",
              sheet(rectangle(0, 0, 8, 8), 0, [rectangle(2, 2, 6, 6)], "near"), sheet([(4, 4), (14, 5), (12, 12), (3, 11)], 3, name="middle"),
              sheet(rectangle(1, 1, 16, 10), 6, name="far")),
        pair("thesis_2_65", "2.65", "clipping a face gives two inner faces, C and D, and two outer ones, A and B",
             rectangle(0, 3, 14, 6), [(1, 0), (4, 0), (6, 7), (8, 0), (13, 0), (10, 10), (3, 10)], (), [rectangle(4, 8, 6, 9)]),
        pair("thesis_3_25", "3.25", "points of the two types alternate: each tooth of the subject enters the clip face and leaves it",
             rectangle(0, 4, 14, 8), [(1, 0), (13, 0), (12, 6), (10, 6), (9, 2), (7, 2), (6, 6), (4, 6), (3, 2), (2, 2)]),
        pair("thesis_3_24", "3.24", "the greatest number of intersections: every long side of one comb cuts every long side of the other",
             comb, [(z, x) for x, z in reversed(comb)]),
    ]


def one_contains_the_other():
    frame = rectangle(0, 0, 12, 12)
    return [
        pair("thesis_3_26a", "3.26 a", "the clip face has a hole round the subject face, which is outside of it: all of it is seen",
             frame, [(4, 4), (8, 5), (6, 9)], [rectangle(3, 3, 10, 10)]),
        pair("thesis_3_26b", "3.26 b", "a hole of the clip face cuts the subject face within it: an inner face, and an outer one that is seen",
             frame, rectangle(2, 3, 7, 8), [rectangle(5, 5, 10, 10)]),
        pair("thesis_3_26c", "3.26 c", "holes of the inner face: the union of a hole of the clip face and one of the subject face that meet",
             frame, rectangle(1, 1, 11, 11), [rectangle(3, 3, 7, 7)], [rectangle(5, 5, 9, 9)]),
        pair("thesis_3_26d", "3.26 d", "outer faces: a hole of the clip face with the subject's outer contour, and another with its hole",
             frame, rectangle(1, 2, 9, 10), [rectangle(7, 3, 11, 6), [(2, 6), (5, 5), (5, 9)]], [rectangle(3, 6, 7, 8)]),
        pair("thesis_3_27", "3.27", "the subject face contains the clip face, which becomes a hole together with the hole that it meets",
             rectangle(4, 4, 8, 8), frame, (), [rectangle(6, 6, 10, 9)]),
        pair("thesis_3_27_in_hole", "3.27", "the clip face lies in a hole of the subject face: its holes stay as they are",
             rectangle(5, 5, 7, 8), frame, (), [rectangle(3, 3, 9, 9)]),
        pair("thesis_3_27_clip_with_hole", "3.27", "the clip face is contained and has a hole: an outer face of its own is seen in it",
             rectangle(2, 2, 10, 10), frame, [rectangle(4, 4, 8, 8)]),
    ]


def outer_contours_cross():
    comb = [(0, 0), (14, 0), (14, 8), (11, 8), (11, 3), (8, 3), (8, 8), (5, 8), (5, 3), (2, 3), (2, 8), (0, 8)]
    return [
        pair("thesis_3_28", "3.28", "the outer contours cut each other", [(0, 0), (8, 1), (6, 7), (1, 6)], [(4, 3), (12, 2), (10, 9), (5, 10)]),
        pair("thesis_3_29", "3.29", "outer faces: a bar over the teeth of a comb leaves several outer contours, one of them with a hole",
             rectangle(-1, 5, 15, 7), comb, (), [rectangle(3, 1, 6, 2)]),
        pair("thesis_3_30", "3.30", "inner face: two concave faces, with holes of both in what they have in common",
             [(0, 0), (12, 0), (12, 6), (6, 6), (6, 12), (0, 12)], [(3, 1), (14, 1), (14, 10), (10, 10), (10, 5), (3, 5)],
             [rectangle(7, 2, 8, 3)], [rectangle(4, 2, 5, 4)]),
        pair("thesis_3_31", "3.31", "two convex contours that cut on one side of the clip contour only: the outer contour stays convex",
             rectangle(0, 0, 10, 6), [(3, 4), (7, 4), (9, 11), (1, 11)]),
        pair("thesis_3_31_corner", "3.31", "two convex contours that cut on two sides of the clip contour: the outer contour is not convex",
             rectangle(0, 0, 8, 8), rectangle(5, 5, 12, 12)),
        pair("thesis_3_32", "3.32", "an inner contour with two points of entry, which would be produced twice without marks",
             rectangle(4, 0, 8, 12), rectangle(0, 4, 12, 8)),
    ]


def singular_points():
    return [
        pair("thesis_3_33a", "3.33, first case", "the contours share a part of a side from outside: both points are rejected",
             S, rectangle(4, 1, 8, 3)),
        pair("thesis_3_33b", "3.33, second case", "a strip across the square, its ends on the square's sides: the four points are kept",
             S, rectangle(1, 0, 3, 4)),
        pair("thesis_3_33c", "3.33, third case", "a common part of a side that goes outside at one end and inside at the other: one point is rejected",
             S, [(1, 0), (1, -2), (6, -2), (6, 2), (3, 2), (3, 0)]),
        pair("thesis_3_33d", "3.33, fourth case", "a side from a point of a side to a corner of the square, through its inside: no point is rejected",
             S, [(2, 0), (4, -2), (8, 2), (5, 6)]),
        pair("thesis_3_33_same", "3.33", "two equal contours: all points are singular", S, S),
    ]


def scenes():
    return [*in_general(), *one_contains_the_other(), *outer_contours_cross(), *singular_points()]
