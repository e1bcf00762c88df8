"""Objects and scenes, and how they are written.

Coordinates are ints, or floats that hold a dyadic number exactly. Up is z; the front view looks along +y, with x to the right,
so what has the smaller y is the nearer. Faces are wound counter-clockwise seen from outside.
"""


class Mesh:
    """One object: vertices told apart by position, faces as lists of contours (the outer one, then holes)."""

    def __init__(self, name, solid=False, inverted=False, opacity=1):
        self.name = name
        self.opacity = opacity  # below 1 it is of glass
        self.solid = solid  # closed: every edge twice, in opposite directions
        self.inverted = inverted  # wound inside out
        self.vertices = []
        self.faces = []
        self._index = {}

    def vertex(self, point):
        point = tuple(point)
        if point not in self._index:
            self._index[point] = len(self.vertices)
            self.vertices.append(point)
        return self._index[point]

    def face(self, outer, *holes):
        """Adds a face from points."""
        self.faces.append([[self.vertex(p) for p in contour] for contour in (outer, *holes)])
        return self

    def add(self, other):
        """Adds the faces of another mesh; vertices in the same place become one."""
        for outer, *holes in other.faces:
            self.face([other.vertices[v] for v in outer], *[[other.vertices[v] for v in h] for h in holes])
        return self

    def mapped(self, f, name=None, flip=False):
        """The same with f applied to every point; flip when f mirrors."""
        mesh = Mesh(name or self.name, self.solid, self.inverted, self.opacity)
        for contours in self.faces:
            points = [[f(*self.vertices[v]) for v in contour] for contour in contours]
            mesh.face(*[p[::-1] for p in points] if flip else points)
        return mesh

    def moved(self, x=0, y=0, z=0, name=None):
        return self.mapped(lambda a, b, c: (a + x, b + y, c + z), name)

    def scaled(self, k, name=None):
        return self.mapped(lambda a, b, c: (a * k, b * k, c * k), name)

    def inside_out(self):
        mesh = self.mapped(lambda *p: p, flip=True)
        mesh.inverted = not self.inverted
        return mesh

    def of_glass(self, opacity):
        mesh = self.mapped(lambda *p: p)
        mesh.opacity = opacity
        return mesh

    def triangulated(self):
        """Convex faces without holes as fans."""
        mesh = Mesh(self.name, self.solid, self.inverted, self.opacity)
        for (outer,) in self.faces:
            for i in range(1, len(outer) - 1):
                mesh.face([self.vertices[v] for v in (outer[0], outer[i], outer[i + 1])])
        return mesh


class Scene:
    """`degenerate`: faces that no check holds for, on purpose; the text of `about` must say so too."""

    def __init__(self, name, about, *meshes, degenerate=False):
        self.name = name
        self.about = about
        self.meshes = list(meshes)
        self.degenerate = degenerate
        assert degenerate == ("Degenerate on purpose" in about), name

    def text(self):
        kinds = [1] + sorted({m.opacity for m in self.meshes} - {1})  # materials: stone first, then glass
        objects = ",\n".join(object_text(m, kinds.index(m.opacity)) for m in self.meshes)
        return ('{"format": "ligne-scene", "version": 1,\n'
                f'"about": "{self.about}",\n{materials_text(kinds)}"objects": [\n{objects}\n]}}\n')


VERTICES_IN_A_LINE = 8


def number_text(x):
    return str(int(x)) if x == int(x) else repr(x)


def materials_text(kinds):
    if kinds == [1]:
        return ""
    glass = [f'{{"name": "glass", "color": [0.5, 0.7, 0.9], "opacity": {opacity}}}' for opacity in kinds[1:]]
    return '"materials": [' + ", ".join(['{"name": "stone", "color": [0.8, 0.8, 0.8]}'] + glass) + "],\n"


def object_text(mesh, material):
    points = ["[" + ",".join(number_text(x) for x in p) + "]" for p in mesh.vertices]
    lines = [", ".join(points[i:i + VERTICES_IN_A_LINE]) for i in range(0, len(points), VERTICES_IN_A_LINE)]
    faces = ",\n".join(face_text(f, material) for f in mesh.faces)
    return f'{{"name": "{mesh.name}",\n"vertices": [\n' + ",\n".join(lines) + f'],\n"faces": [\n{faces}]}}'


def face_text(contours, material):
    outer, *holes = ("[" + ",".join(map(str, c)) + "]" for c in contours)
    return f'{{"outer": {outer}' + (f', "holes": [{", ".join(holes)}]' if holes else "") + (
        f', "material": {material}' if material else "") + "}"
