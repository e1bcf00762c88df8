"""As much of trimesh as the recipes use, with its names: for machines that do not have it."""

from types import SimpleNamespace

import numpy as np


def _box(extents):
    corners = np.array([[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)]) * extents
    quads = np.array([[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]])
    return SimpleNamespace(vertices=corners, faces=np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]]))


def _translation(by):
    matrix = np.eye(4)
    matrix[:3, 3] = by
    return matrix


creation = SimpleNamespace(box=_box)
transformations = SimpleNamespace(translation_matrix=_translation)


class _Graph(dict):
    @property
    def nodes_geometry(self):
        return list(self)


class Scene:
    def __init__(self):
        self.geometry, self.graph = {}, _Graph()

    def add_geometry(self, geometry, node_name, transform=None):
        self.geometry[node_name] = geometry
        self.graph[node_name] = (np.eye(4) if transform is None else transform, node_name)
