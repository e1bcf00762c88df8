"""Many things, and sizes that are out of the common."""

from .mesh import Scene
from .shapes import box, cube, floor, pyramid, rectangle
from .solids import octahedron


def grid(n):
    return [cube(3 * i, 3 * j, 3 * k, 2, "box") for j in range(n) for k in range(n) for i in range(n)]


def odd_sizes(k, x=0, y=0, z=0):
    parts = cube(), box((6, 1, 0), (8, 5, 2)), octahedron(2).moved(2, 2, 6), floor(rectangle(-2, -2, 10, 8), name="table")
    return [m.scaled(k).moved(x, y, z) for m in parts]


def scenes():
    tiny = 2**-20
    return [
        Scene("grid_3", "3 x 3 x 3 boxes exactly aligned: from the front, each row is one box", *grid(3)),
        Scene("grid_10", "10 x 10 x 10 boxes exactly aligned behind each other: much is hidden, many edges lie on each other", *grid(10)),
        Scene("far_from_origin", "things of size ten at a million from the origin", *odd_sizes(1, 1000000, -2000000, 3000000)),
        Scene("very_large", "things of ten million units", *odd_sizes(1000000)),
        Scene("very_small", "things of a hundred-thousandth of a unit", *odd_sizes(tiny)),
        Scene("mixed_sizes", "a plate of a million units, a cube of one, a cube of a millionth on it",
              floor(rectangle(-500000, -500000, 500000, 500000)), cube(0, 0, 0, 1), cube(0.25, 0.25, 1, tiny, "speck"),
              cube(1000, 1000, 0, 4096, "tower"), pyramid(rectangle(-200000, 100000, 0, 300000), 0, (-100000, 200000, 150000))),
        Scene("sizes_in_a_row", "cubes in a row, each of half the size of the one before, flush on one side",
              *[cube(16 - 2 ** (4 - k), 0, 0, 2 ** (3 - k)) for k in range(12)]),
    ]
