"""Heights of surfaces, from wherever they come."""

from __future__ import annotations

import os
from typing import Any, Callable, Dict, Optional, Sequence, Tuple, Union

import numpy as np

from . import _core
from ._core import DtypeError, InputError
from ._options import Array, Path

Heights = Union[str, Path, Array, Callable[[Array, Array], Any]]

_CURVES, _SAMPLES_BETWEEN, _SAMPLES_ALONG = 40, 5, 1000


#: Suffixes of files of heights: a text that ends so is the name of a file, and no formula.
_FILES = (".csv", ".tsv", ".txt", ".dat", ".xyz", ".asc", ".png", ".pgm", ".tif", ".tiff", ".hgt", ".nc", ".h5")


def _is_grid(array: Array) -> bool:
    """Whether it is a matrix of positions x, all of whose rows are one that ascends."""
    return array.ndim == 2 and bool((array == array[:1]).all() and (np.diff(array[0]) > 0).all())


def _of_meshgrid(name: str, array: Array, shape: Tuple[int, ...]) -> Array:
    """The positions in what numpy.meshgrid() makes of them."""
    own = array if name == "x" else array.T
    if array.shape == shape and _is_grid(own):
        positions: Array = own[0]
        return positions
    if array.shape == shape and _is_grid(own.T):
        raise InputError(f"{name}: comes from meshgrid(indexing=\"ij\"); z has rows of y and columns of x: give z.T, x.T and y.T")
    raise InputError(f"{name}: the shape is {array.shape}, not one-dimensional, and it does not come from a meshgrid of z")


def _positions(name: str, values: Any, shape: Tuple[int, ...]) -> Array:
    count = shape[1] if name == "x" else shape[0]
    if values is None:
        return np.arange(count, dtype=float)
    array = np.asarray(values)
    if array.dtype.kind not in "fiu":
        raise DtypeError(f"{name}: the dtype is {array.dtype}, not one of real numbers")
    if array.ndim == 2:
        array = _of_meshgrid(name, array, shape)
    if array.shape == (2,) and count != 2:
        return np.linspace(float(array[0]), float(array[1]), count)
    if array.shape != (count,):
        raise InputError(f"{name}: the shape is {array.shape}, not ({count},), one for each {'column' if name == 'x' else 'row'} of z")
    return array.astype(float)


def _heights(z: Any, x: Any, y: Any) -> Tuple[str, Array, Array, Array]:
    array = np.asarray(z)
    if array.ndim != 2:
        raise InputError(f"z: the shape is {array.shape}, not (rows of y, columns of x)")
    if array.dtype.kind not in "fiu":
        raise DtypeError(f"z: the dtype is {array.dtype}, not one of real numbers")
    if min(array.shape) < 2:
        raise InputError(f"z: the shape is {array.shape}; at least two rows and two columns are needed")
    if np.isinf(array).any():
        raise InputError("z: has an infinite height; use nan for a missing height")
    return "z", _positions("x", x, array.shape), _positions("y", y, array.shape), array


def _are_positions(value: Any) -> bool:
    """A range, or numbers in a row: no surface is written so."""
    if isinstance(value, (str, os.PathLike)) or callable(value) and not hasattr(value, "__array__"):
        return False
    try:
        return bool(np.asarray(value).ndim == 1)
    except ValueError:
        return False


def _are_meshgrids(z: Any, x: Any, y: Any) -> bool:
    """Whether x and y are what numpy.meshgrid() makes of the positions of z, in either order of indices."""
    if any(isinstance(one, (str, os.PathLike)) or callable(one) and not hasattr(one, "__array__") for one in (z, x, y)):
        return False
    z, x, y = np.asarray(z), np.asarray(x), np.asarray(y)
    if z.ndim != 2 or not x.shape == y.shape == z.shape or min(z.shape) < 2:
        return False
    return (_is_grid(x) and _is_grid(y.T)) or (_is_grid(x.T) and _is_grid(y))


def split_positions(sources: Sequence[Any], x: Any, y: Any) -> Tuple[Sequence[Any], Any, Any]:
    """Of surface(z, x, y): z, and the positions; several surfaces stay what they are."""
    behind = sources[1:]
    if not 1 <= len(behind) <= 2:
        return sources, x, y
    grids = list(sources) if len(behind) == 2 else [*sources, y]
    if not all(_are_positions(one) for one in behind) and not _are_meshgrids(*grids):
        return sources, x, y
    if x is not None or (y is not None and len(behind) == 2):
        raise _core.RequestError("x, y: are given both after z and by name")
    return sources[:1], behind[0], behind[1] if len(behind) == 2 else y


def _samples(name: str, range_: Any, samples: Optional[int]) -> Tuple[Array, int]:
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
        raise InputError("x, y: for a function, give both the same number of curves, or samples=...")
    heights = np.broadcast_to(np.asarray(z(*np.meshgrid(xs, ys))), (len(ys), len(xs)))
    if heights.dtype.kind not in "fiu":
        raise DtypeError(f"z: the function gives the dtype {heights.dtype}, not one of real numbers")
    return _heights(np.where(np.isfinite(heights), heights, np.nan), xs, ys), x_stride


def height_sources(sources: Sequence[Heights], options: Dict[str, Any]) -> Dict[str, Any]:
    """The options of surfaces with their sources: formulas, paths of grids, arrays and functions, of which x and y of the
    options are the positions."""
    x, y, samples = (options.get(name) for name in ("x", "y", "samples"))
    formulas = [source for source in sources if isinstance(source, str)]
    for formula in formulas:
        if formula.lower().endswith(_FILES):
            raise _core.RequestError(f"z: {formula!r} is the name of a file; for its heights give pathlib.Path({formula!r})")
    grids = [os.fspath(source) for source in sources if not isinstance(source, str) and isinstance(source, os.PathLike)]
    heights, every = [], options.get("every")
    for source in sources:
        if isinstance(source, (str, os.PathLike)):
            continue
        if callable(source) and not hasattr(source, "__array__"):
            made, stride = _of_callable(source, x, y, samples)
            heights.append(made)
            every = stride if every in (None, "auto") else every
        else:
            heights.append(_heights(source, x, y))
    whole = dict(options, formulas=formulas, grids=grids, heights=heights, every=every)
    if heights:
        if formulas or grids:
            raise _core.RequestError("z: arrays and functions can not be combined with formulas and files")
        whole.update(x=None, y=None, samples=None)
    return whole
