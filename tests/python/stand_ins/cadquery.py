"""As much of CadQuery as the recipes use, with its names: for machines that do not have it."""

from types import SimpleNamespace

import trimesh


class Workplane:
    def __init__(self, plane):
        self._mesh = None

    def box(self, *sides):
        self._mesh = trimesh.creation.box(extents=sides)
        return self

    def val(self):
        vertices = [SimpleNamespace(toTuple=lambda p=tuple(p): p) for p in self._mesh.vertices]
        triangles = [tuple(int(v) for v in face) for face in self._mesh.faces]
        return SimpleNamespace(tessellate=lambda tolerance: (vertices, triangles))
