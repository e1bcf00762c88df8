"""The shapes that scenes are made of. Contours are lists of (u, v), counter-clockwise; holes may be wound either way."""

import math

from .mesh import Mesh

# Twelve points on a circle of radius 5, all whole: a round thing without rounding.
CIRCLE = [(5, 0), (4, 3), (3, 4), (0, 5), (-3, 4), (-4, 3), (-5, 0), (-4, -3), (-3, -4), (0, -5), (3, -4), (4, -3)]


def rectangle(u0, v0, u1, v1):
    return [(u0, v0), (u1, v0), (u1, v1), (u0, v1)]


def shifted(contour, du, dv):
    return [(u + du, v + dv) for u, v in contour]


def times(contour, k):
    return [(u * k, v * k) for u, v in contour]


def doubled_area(contour):
    return sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(contour, contour[1:] + contour[:1]))


def wound(contour, positive=True):
    return contour if (doubled_area(contour) > 0) == positive else contour[::-1]


def dyadic(x, bits=8):
    """The nearest multiple of 2^-bits."""
    return math.floor(x * 2**bits + 0.5) / 2**bits


def polar(radius, part, bits=8):
    """Point at `part` of a full turn, rounded."""
    return dyadic(radius * math.cos(2 * math.pi * part), bits), dyadic(radius * math.sin(2 * math.pi * part), bits)


def upright(outer, lo, hi, holes=(), name="prism"):
    """Prism over a contour in x, y, from z = lo to z = hi; holes go right through."""
    mesh = Mesh(name, solid=True)
    outer, holes = wound(outer), [wound(h, False) for h in holes]
    mesh.face([(u, v, lo) for u, v in outer[::-1]], *[[(u, v, lo) for u, v in h[::-1]] for h in holes])
    mesh.face([(u, v, hi) for u, v in outer], *[[(u, v, hi) for u, v in h] for h in holes])
    for contour in (outer, *holes):
        for (u, v), (s, t) in zip(contour, contour[1:] + contour[:1]):
            mesh.face([(u, v, lo), (s, t, lo), (s, t, hi), (u, v, hi)])
    return mesh


def block(outer, near, far, holes=(), name="block"):
    """Prism over a contour in x, z (as the front view shows it), from y = near to y = far."""
    return upright(outer, -far, -near, holes, name).mapped(lambda u, v, w: (u, -w, v))


def sideways(outer, lo, hi, holes=(), name="bar"):
    """Prism over a contour in y, z, from x = lo to x = hi."""
    return upright(outer, lo, hi, holes, name).mapped(lambda u, v, w: (w, u, v))


def box(low, high, name="box"):
    return upright(rectangle(low[0], low[1], high[0], high[1]), low[2], high[2], name=name)


def cube(x=0, y=0, z=0, size=4, name="cube"):
    return box((x, y, z), (x + size, y + size, z + size), name)


def pyramid(base, lo, apex, name="pyramid"):
    """Over a contour in x, y at z = lo; the apex may stand below it."""
    mesh = Mesh(name, solid=True)
    base = wound(base, apex[2] > lo)
    mesh.face([(u, v, lo) for u, v in base[::-1]])
    for (u, v), (s, t) in zip(base, base[1:] + base[:1]):
        mesh.face([(u, v, lo), (s, t, lo), apex])
    return mesh


def sheet(outer, depth=0, holes=(), name="plate"):
    """One face over a contour in x, z, looking at the front; `depth` is its y, a number or a linear function of x and z."""
    at = depth if callable(depth) else lambda x, z: depth
    return Mesh(name).face(*[[(x, at(x, z), z) for x, z in c]
                             for c in (wound(list(outer)), *[wound(list(h), False) for h in holes])])


def floor(outer, z=0, holes=(), name="plate"):
    """One face over a contour in x, y, looking up."""
    return Mesh(name).face(*[[(x, y, z) for x, y in c]
                             for c in (wound(list(outer)), *[wound(list(h), False) for h in holes])])


def turned(contour, c, s):
    """Turned by the angle with cosine c/r and sine s/r, and enlarged by r."""
    return [(u * c - v * s, u * s + v * c) for u, v in contour]


def ring_of_bars(corners, width, near, far, reach, thickness=0):
    """A bar along each side of a polygon, each over the next: at its first corner it is `near`, at its last `far`.

    `reach` is the length by which it goes on, as a part of the side. With a thickness the bars are solids.
    """
    bars = []
    for i, ((x0, z0), (x1, z1)) in enumerate(zip(corners, corners[1:] + corners[:1])):
        dx, dz = x1 - x0, z1 - z0
        wx, wz = -dz * width, dx * width
        ends = [(x0 - dx * reach, near - (far - near) * reach, z0 - dz * reach),
                (x1 + dx * reach, far + (far - near) * reach, z1 + dz * reach)]
        (ax, ay, az), (bx, by, bz) = ends
        corners_of_bar = [(ax - wx, ay, az - wz), (bx - wx, by, bz - wz), (bx + wx, by, bz + wz), (ax + wx, ay, az + wz)]
        bars.append(thick(corners_of_bar, thickness, f"bar {i + 1}"))
    return bars


def thick(points, thickness, name):
    """The face itself, or with a thickness the solid that it sweeps along +y. Points run counter-clockwise from the front."""
    if not thickness:
        return Mesh(name).face(points)
    back = [(x, y + thickness, z) for x, y, z in points]
    mesh = Mesh(name, solid=True).face(points).face(back[::-1])
    for i in range(len(points)):
        j = (i + 1) % len(points)
        mesh.face([points[i], back[i], back[j], points[j]])
    return mesh
