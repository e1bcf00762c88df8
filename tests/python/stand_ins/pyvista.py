"""As much of pyvista as the recipes use, with its names: for machines that do not have it."""

from types import SimpleNamespace

import numpy as np


def Cone(resolution):
    turn = 2 * np.pi * np.arange(resolution) / resolution
    base = np.column_stack([np.full(resolution, -0.5), 0.5 * np.cos(turn), 0.5 * np.sin(turn)])
    faces = [np.concatenate([[resolution], np.arange(resolution)[::-1] + 1])]
    faces += [np.array([3, 0, 1 + i, 1 + (i + 1) % resolution]) for i in range(resolution)]
    points = np.concatenate([[[0.5, 0, 0]], base]).astype(np.float32)
    return SimpleNamespace(points=points, faces=np.concatenate(faces))
