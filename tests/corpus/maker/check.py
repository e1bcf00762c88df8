"""What holds for every scene that is not degenerate on purpose, decided with exact fractions."""

from collections import Counter
from fractions import Fraction


def minus(a, b):
    return tuple(p - q for p, q in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def area_vector(points):
    total = (0, 0, 0)
    for a, b in zip(points, points[1:] + points[:1]):
        total = tuple(t + c for t, c in zip(total, cross(minus(a, points[0]), minus(b, points[0]))))
    return total


def turn(a, b, c):
    d = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    return (d > 0) - (d < 0)


def on_segment(p, a, b):
    return (turn(a, b, p) == 0 and min(a[0], b[0]) <= p[0] <= max(a[0], b[0])
            and min(a[1], b[1]) <= p[1] <= max(a[1], b[1]))


def segments_meet(a, b, c, d):
    if turn(a, b, c) * turn(a, b, d) < 0 and turn(c, d, a) * turn(c, d, b) < 0:
        return True
    return on_segment(c, a, b) or on_segment(d, a, b) or on_segment(a, c, d) or on_segment(b, c, d)


def sides(contour):
    return list(zip(contour, contour[1:] + contour[:1]))


def is_inside(p, contour):
    inside = False
    for a, b in sides(contour):
        if (a[1] > p[1]) != (b[1] > p[1]) and (turn(a, b, p) > 0) == (b[1] > a[1]):
            inside = not inside
    return inside


def face_faults(points):
    """Faults of one face, given as contours of points."""
    outer = points[0]
    normal = area_vector(outer)
    if normal == (0, 0, 0):
        return ["no area"]
    if any(dot(normal, minus(p, outer[0])) != 0 for contour in points for p in contour):
        return ["not planar"]
    axis = max(range(3), key=lambda k: abs(normal[k]))
    flat = [[p[:axis] + p[axis + 1:] for p in contour] for contour in points]
    faults = []
    for contour in flat:
        n = len(contour)
        if len(set(contour)) != n:
            faults.append("vertex twice in a contour")
        s = sides(contour)
        if any(segments_meet(*s[i], *s[j]) for i in range(n) for j in range(i + 2, n) if (i, j) != (0, n - 1)):
            faults.append("contour meets itself")
        if any(on_segment(s[i][0], *s[(i + 1) % n]) or on_segment(s[(i + 1) % n][1], *s[i]) for i in range(n)):
            faults.append("contour turns back on itself")
    for i in range(len(flat)):
        for j in range(i):
            if any(segments_meet(*a, *b) for a in sides(flat[i]) for b in sides(flat[j])):
                faults.append("contours meet")
            if i > 0 and j > 0 and (is_inside(flat[i][0], flat[j]) or is_inside(flat[j][0], flat[i])):
                faults.append("hole in a hole")
        if i > 0 and not is_inside(flat[i][0], flat[0]):
            faults.append("hole outside")
    return faults


def solid_faults(mesh, vertices):
    edges = Counter()
    volume = 0
    for contours in mesh.faces:
        for contour in contours:
            edges.update(sides(contour))
        # Holes are wound against their outer contour, so their volumes count against it by themselves.
        for contour in contours:
            for i in range(1, len(contour) - 1):
                volume += dot(vertices[contour[0]], cross(vertices[contour[i]], vertices[contour[i + 1]]))
    faults = []
    if any(n != 1 or edges[(b, a)] != 1 for (a, b), n in edges.items()):
        faults.append("an edge does not stand twice in opposite directions")
    if (volume < 0) != mesh.inverted:
        faults.append("wound inside out" if volume < 0 else "not wound inside out")
    return faults


def scene_faults(scene):
    """Lines that name what is wrong with a scene."""
    if scene.degenerate:
        return []
    faults = []
    for mesh in scene.meshes:
        vertices = [tuple(map(Fraction, v)) for v in mesh.vertices]
        for i, contours in enumerate(mesh.faces):
            found = face_faults([[vertices[v] for v in c] for c in contours])
            faults += [f"{scene.name}: {mesh.name}: face {i}: {f}" for f in found]
        if mesh.solid:
            faults += [f"{scene.name}: {mesh.name}: {f}" for f in solid_faults(mesh, vertices)]
    return faults
