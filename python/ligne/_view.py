"""From where a scene is seen."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Dict, Optional, Sequence, Tuple, Union

import numpy as np

from . import _core
from ._core import RequestError
from ._options import Array

Vector = Sequence[float]


def _refusal(option: str, cause: str) -> RequestError:
    error = RequestError(f"{option}: {cause}")
    error.option = option
    return error


def _vector(name: str, value: Vector) -> Tuple[float, float, float]:
    try:
        x, y, z = (float(v) for v in value)
    except (TypeError, ValueError):
        raise _refusal(name, "is not three numbers") from None
    if not np.isfinite((x, y, z)).all():
        raise _refusal(name, "is not three finite numbers")
    return (x, y, z)


def _differ(eye: Tuple[float, float, float], target: Optional[Tuple[float, float, float]]) -> None:
    if eye == target:
        raise _refusal("target", "is the position of the eye, so the view has no direction")


@dataclass(frozen=True)
class View:
    """A view of a scene: one of named(), parallel() and perspective().

    All coordinates are the model's. `up` is what is up on the page, by default the up axis; `up_axis` is "x", "y" or "z",
    by default the scene's.
    """

    name: Optional[str] = None
    direction: Optional[Tuple[float, float, float]] = None
    eye: Optional[Tuple[float, float, float]] = None
    target: Optional[Tuple[float, float, float]] = None
    fov: float = 35
    up: Optional[Tuple[float, float, float]] = None
    up_axis: Optional[str] = None

    @staticmethod
    def named(name: str, up: Optional[Vector] = None, up_axis: Optional[str] = None) -> View:
        """front, back, left, right, top, bottom, iso, dimetric or trimetric; or "camera" or "camera:NAME", of the file."""
        if name not in _core.named_views and name.partition(":")[0] != "camera":
            meant = _core.suggestion(name, _core.named_views)
            raise RequestError(f"view: {name!r} is not one of {', '.join(_core.named_views)} or camera[:NAME]{meant}")
        return View(name=name, up=None if up is None else _vector("up", up), up_axis=up_axis)

    @staticmethod
    def parallel(direction: Vector, up: Optional[Vector] = None, up_axis: Optional[str] = None) -> View:
        """Along `direction`, from the viewer into the scene."""
        sight = _vector("direction", direction)
        if sight == (0, 0, 0):
            raise RequestError("direction: has no length")
        return View(direction=sight, up=None if up is None else _vector("up", up), up_axis=up_axis)

    @staticmethod
    def perspective(
        eye: Vector,
        target: Optional[Vector] = None,
        fov: float = 35,
        up: Optional[Vector] = None,
        up_axis: Optional[str] = None,
    ) -> View:
        """From `eye` towards `target` (the centre of the model), with the vertical angle `fov` in degrees."""
        place, at = _vector("eye", eye), None if target is None else _vector("target", target)
        _differ(place, at)
        if not 0 < float(fov) < 180:
            raise _refusal("fov", f"{fov} is not between 0 and 180 degrees")
        return View(
            eye=place,
            target=at,
            fov=float(fov),
            up=None if up is None else _vector("up", up),
            up_axis=up_axis,
        )

    @property
    def matrix(self) -> Array:
        """(3, 3) float64, a rotation: its rows are what is right, up, and towards the viewer, in model coordinates.

        Without an up_axis of its own the view takes z for it. A perspective view has one only with a target. The matrix
        from the model to the page, which depends on scale and page too, is Drawing.matrix.
        """
        if self.name is not None and self.name not in _core.named_views:
            raise RequestError("view: a camera of the file has a matrix only with its scene: Drawing.matrix")
        direction = self.direction
        if self.eye is not None:
            if self.target is None:
                raise RequestError("target: a perspective view without a target has a matrix only with a scene: Drawing.matrix")
            x, y, z = (t - e for t, e in zip(self.target, self.eye))
            direction = (x, y, z)
        return np.array(_core.camera_frame(self.name, direction, self.up, self.up_axis or "z"))

    def options(self) -> Dict[str, Any]:
        """As options of the command."""
        given: Dict[str, Any] = {"view": self.name, "direction": self.direction, "up": self.up, "up_axis": self.up_axis}
        if self.eye is not None:
            given.update(eye=self.eye, target=self.target, fov=self.fov)
        return given


VIEW_OPTIONS = ("direction", "eye", "target", "fov", "up", "up_axis")


def seen_from(view: Union[str, View, None], chosen: Dict[str, Any]) -> Dict[str, Any]:
    """The options of a view that is given by its name or as a View; those of `chosen` that are not None go before its."""
    given = {name: value for name, value in chosen.items() if value is not None}
    for name in ("direction", "eye", "target", "up"):
        if name in given and not isinstance(given[name], str):
            given[name] = _vector(name, given[name])
    if "eye" in given and not isinstance(given["eye"], str):
        _differ(given["eye"], given.get("target"))
    if view is None or "direction" in given or "eye" in given:
        return given
    if isinstance(view, str):
        view = View.named(view)
    if not isinstance(view, View):
        raise RequestError(f"view: {type(view).__name__} is neither a name nor a View")
    return {**view.options(), **given}
