"""What a drawing has found beside its strokes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import List, Optional, Tuple

import numpy as np

from ._options import Array

_Point = Tuple[float, float, float]


def _ring_area(points: Array) -> float:
    x, y = points[:, 0], points[:, 1]
    return 0.5 * abs(float(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1))))


@dataclass(frozen=True)
class Region:
    """A visible part of a face on the page."""

    face: int  #: row of the faces that were given
    contours: List[Array]  #: (k, 2) float64 each, page mm, not closed; the first is outer, the others are holes
    level: int  #: how many transparent faces are in front of it
    lights: int  #: bit i: light i reaches it

    @property
    def area(self) -> float:
        """mm^2 on the page."""
        return _ring_area(self.contours[0]) - sum(_ring_area(hole) for hole in self.contours[1:])


@dataclass(frozen=True)
class FittedSurface:
    """A surface that faces of a mesh were tessellated from. Lengths are in model units."""

    kind: str  #: "cylinder", "cone", "sphere", "torus", "extruded" or "revolved"
    #: the centre of a sphere or a torus; of the others where its faces begin on the axis
    at: _Point
    axis: Optional[_Point]  #: unit vector; None for a sphere
    #: of a cone at `at`, of a torus that of the middle circle; None for an extruded or revolved surface
    radius: Optional[float]
    slope: Optional[float]  #: of a cone: growth of the radius per unit along the axis
    tube: Optional[float]  #: of a torus: radius of the tube
    #: where its faces begin and end along the axis, from `at`; None for a sphere or a torus
    along: Optional[Tuple[float, float]]
    #: of a cylinder, a cone or a revolved surface: degrees about the axis that its faces cover, 360 at the most
    turn: Optional[float]
    #: its faces look away from the axis, the centre or the middle circle: a boss, and not a bore
    outward: bool
    sag: float  #: median distance of the facets' middles from the surface
    faces: int  #: number of its faces in the scene
    object: int  #: index in scene.object_names
