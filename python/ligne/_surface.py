"""Surfaces z = f(x, y), and parametric ones."""

from __future__ import annotations

import os
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple, Union

import numpy as np

from . import _core
from ._core import DtypeError, InputError
from ._drawing import Drawing, Length, Progress
from ._scene import Path
from ._view import Vector, View, view_options

Range = Union[str, Sequence[float]]
Heights = Union[str, Path, np.ndarray, Callable[[np.ndarray, np.ndarray], Any]]

_CURVES, _SAMPLES_BETWEEN, _SAMPLES_ALONG = 40, 5, 1000


def _positions(name: str, values: Any, count: int) -> np.ndarray:
    if values is None:
        return np.arange(count, dtype=float)
    array = np.asarray(values)
    if array.dtype.kind not in "fiu":
        raise DtypeError(f"{name}: the dtype is {array.dtype}, not one of real numbers")
    if array.shape == (2,) and count != 2:
        return np.linspace(float(array[0]), float(array[1]), count)
    if array.shape != (count,):
        raise InputError(f"{name}: the shape is {array.shape}, not ({count},), one for each {'column' if name == 'x' else 'row'} of z")
    return array.astype(float)


def _heights(z: Any, x: Any, y: Any) -> Tuple[str, np.ndarray, np.ndarray, np.ndarray]:
    array = np.asarray(z)
    if array.ndim != 2:
        raise InputError(f"z: the shape is {array.shape}, not (rows of y, columns of x)")
    if array.dtype.kind not in "fiu":
        raise DtypeError(f"z: the dtype is {array.dtype}, not one of real numbers")
    if min(array.shape) < 2:
        raise InputError(f"z: the shape is {array.shape}; two rows and two columns are the least")
    if np.isinf(array).any():
        raise InputError("z: holds an infinite height; nan says that there is none")
    return "z", _positions("x", x, array.shape[1]), _positions("y", y, array.shape[0]), array


def _samples(name: str, range_: Any, samples: Optional[int]) -> Tuple[np.ndarray, int]:
    """Sample positions over a range, and every how many of them there is a curve."""
    low, high, curves = -5.0, 5.0, _CURVES
    if range_ is not None:
        parts = range_.split(":") if isinstance(range_, str) else list(range_)
        if len(parts) not in (2, 3):
            raise InputError(f"{name}: is not (from, to) or (from, to, curves)")
        low, high = float(parts[0]), float(parts[1])
        curves = int(parts[2]) if len(parts) == 3 else _CURVES
    if not (low < high and curves >= 2):
        raise InputError(f"{name}: the range does not ascend, or has fewer than two curves")
    between = curves - 1
    stride = max(1, -(-(samples - 1) // between)) if samples else min(max(_SAMPLES_ALONG // between, 1), _SAMPLES_BETWEEN)
    return np.linspace(low, high, stride * between + 1), stride


def _of_callable(z: Callable[..., Any], x: Any, y: Any, samples: Optional[int]) -> Tuple[Any, int]:
    xs, x_stride = _samples("x", x, samples)
    ys, y_stride = _samples("y", y, samples)
    if x_stride != y_stride:
        raise InputError("x, y: of a function both have as many curves, or samples=... is given for both alike")
    heights = np.broadcast_to(np.asarray(z(*np.meshgrid(xs, ys))), (len(ys), len(xs)))
    if heights.dtype.kind not in "fiu":
        raise DtypeError(f"z: the function gives the dtype {heights.dtype}, not one of real numbers")
    return _heights(np.where(np.isfinite(heights), heights, np.nan), xs, ys), x_stride


def surface(
    *z: Heights,
    x: Optional[Any] = None,
    y: Optional[Any] = None,
    parametric: Sequence[Tuple[str, str, str]] = (),
    u: Union[Range, List[Range], None] = None,
    v: Union[Range, List[Range], None] = None,
    samples: Optional[int] = None,
    every: Union[int, str] = "auto",
    gridded: Optional[int] = None,
    ground: Optional[str] = None,
    max_slope: Optional[float] = None,
    lines: str = "xy",
    azimuth: Optional[float] = None,
    elevation: Optional[float] = None,
    aspect: Optional[str] = None,
    z_scale: Optional[float] = None,
    exaggeration: Optional[float] = None,
    log_x: bool = False,
    log_y: bool = False,
    log_z: bool = False,
    z_range: Optional[Range] = None,
    skirt: Union[bool, float] = False,
    horizon: Optional[str] = None,
    resolution: Optional[int] = None,
    contours: Optional[int] = None,
    contour_step: Optional[float] = None,
    contours_base: Union[bool, float] = False,
    outline: Union[str, bool, None] = None,
    underside: str = "same",
    hidden_by: str = "surface",
    ridgeline: Union[bool, float] = False,
    axes: Union[bool, str] = False,
    x_label: Optional[str] = None,
    y_label: Optional[str] = None,
    z_label: Optional[str] = None,
    text: str = "font",
    text_height: Optional[Length] = None,
    view: Union[str, View, None] = None,
    direction: Optional[Vector] = None,
    eye: Optional[Vector] = None,
    target: Optional[Vector] = None,
    fov: Optional[float] = None,
    up: Optional[Vector] = None,
    method: str = "auto",
    hidden: str = "none",
    progress: Progress = None,
    **options: Any,
) -> Drawing:
    """Draws surfaces as curves with their hidden parts removed.

    z: each a formula in x and y ("sin(r)/r"), a path of a grid file (a pathlib.Path), an array of heights (rows of y,
        columns of x; nan where there is none), or a function of two arrays.
    x, y: for formulas and functions (from, to) or (from, to, curves), by default (-5, 5, 40); for an array the positions of
        its columns and rows, or (from, to), by default 0, 1, 2, ...
    parametric: surfaces as three formulas in u and v.

    All others are the options of `ligne surface` and, for the page, hatching and pens, of draw(). Raises RequestError,
    InputError, DtypeError.
    """
    formulas: List[str] = []
    grids: List[str] = []
    heights: List[Any] = []
    for source in z:
        if isinstance(source, str):
            formulas.append(source)
        elif isinstance(source, os.PathLike):
            grids.append(os.fspath(source))
        elif callable(source) and not hasattr(source, "__array__"):
            made, stride = _of_callable(source, x, y, samples)
            heights.append(made)
            every = stride if every == "auto" else every
        else:
            heights.append(_heights(source, x, y))
    if heights:
        if formulas or grids:
            raise _core.RequestError("z: arrays and functions do not go together with formulas and files")
        x = y = samples = None
    surface_options: Dict[str, Any] = dict(
        x=x, y=y, u=u, v=v, samples=samples, every=every, lines=lines, azimuth=azimuth, elevation=elevation,
        gridded=gridded, ground=ground, max_slope=max_slope, aspect=aspect, z_scale=z_scale, exaggeration=exaggeration,
        log_x=log_x, log_y=log_y, log_z=log_z, z_range=z_range, skirt=skirt, horizon=horizon, resolution=resolution,
        contours=contours, contour_step=contour_step, contours_base=contours_base, outline=outline, underside=underside,
        hidden_by=hidden_by, ridgeline=ridgeline, axes=axes, x_label=x_label, y_label=y_label, z_label=z_label, text=text,
        text_height=text_height,
    )  # fmt: skip
    chosen: Dict[str, Any] = dict(direction=direction, eye=eye, target=target, fov=fov, up=up)
    given = {**view_options(view), **{name: value for name, value in chosen.items() if value is not None}}
    if (azimuth is not None or elevation is not None) and any(given.get(n) is not None for n in ("view", "direction", "eye")):
        raise _core.RequestError("azimuth, elevation: do not go with view, direction or eye")
    given.update(options, method=method, hidden=hidden)
    triples = [tuple(str(formula) for formula in three) for three in parametric]
    return Drawing(_core.surface(formulas, grids, heights, triples, surface_options, given, progress))
