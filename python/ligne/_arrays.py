"""Arrays of meshes, checked by their names."""

from __future__ import annotations

from itertools import accumulate
from typing import Any, Dict, List, Optional, Sequence, Tuple, Union

import numpy as np

from ._core import DtypeError, InputError
from ._options import Array

Faces = Union[Array, Sequence[Any]]


def _array(name: str, value: Any) -> Array:
    try:
        array = np.asarray(value)
    except (TypeError, ValueError) as error:
        raise InputError(f"{name}: is not an array: {error}") from None
    return array


def vertex_array(vertices: Any) -> Array:
    """(n, 3) of float64 or float32, which are handed on as they lie."""
    array = _array("vertices", vertices)
    if array.ndim != 2 or array.shape[1] != 3:
        raise InputError(f"vertices: the shape is {array.shape}, not (n, 3)")
    if array.dtype.kind not in "fiu":
        raise DtypeError(f"vertices: the dtype is {array.dtype}, not one of real numbers")
    if array.dtype not in (np.dtype("float64"), np.dtype("float32")) or not array.dtype.isnative:
        array = array.astype(np.float32 if array.dtype.itemsize == 4 and array.dtype.kind == "f" else np.float64)
    return array


def _index_array(array: Array) -> Array:
    if array.dtype.kind not in "iu":
        raise DtypeError(f"faces: the dtype is {array.dtype}, not one of integers")
    if array.dtype.itemsize < 4 or not array.dtype.isnative:
        return array.astype(np.int64)
    return array


def _is_ragged(faces: Any) -> bool:
    if isinstance(faces, np.ndarray):
        return bool(faces.dtype == object)
    if not isinstance(faces, (list, tuple)) or not faces:
        return False
    try:
        lengths = {len(face) for face in faces}
        nested = any(len(face) and hasattr(face[0], "__len__") for face in faces)
    except TypeError:
        return False
    return nested or len(lengths) > 1


def flat_faces(faces: Faces) -> Tuple[Array, List[int], List[int], int]:
    """Corners, ends of contours in these, ends of faces in those, and the number of faces; no ends for an (m, k) array."""
    if not _is_ragged(faces):
        array = _array("faces", faces)
        if array.ndim != 2 or array.shape[1] < 3:
            raise InputError(f"faces: the shape is {array.shape}, not (m, k) with three corners or more")
        if array.shape[0] == 0:
            raise InputError("faces: there are none")
        return _index_array(array), [], [], len(array)
    contours: List[Array] = []
    face_end: List[int] = []
    for number, face in enumerate(faces):
        if not hasattr(face, "__len__"):
            raise InputError(f"faces: face {number} is not a sequence of corners")
        nested = len(face) > 0 and hasattr(face[0], "__len__")
        for contour in face if nested else [face]:
            corners = _array("faces", contour)
            if corners.ndim != 1 or len(corners) < 3:
                raise InputError(f"faces: a contour of face {number} has fewer than three corners")
            contours.append(_index_array(corners))
        face_end.append(len(contours))
    contour_end = list(accumulate(len(contour) for contour in contours))
    return _index_array(np.concatenate(contours)), contour_end, face_end, len(face_end)


def labels(name: str, values: Optional[Sequence[Any]], count: int) -> Tuple[List[int], List[Any]]:
    """The number of the label of each face, by first appearance, and the labels."""
    if values is None:
        return [], []
    if isinstance(values, str) or not hasattr(values, "__len__"):
        raise InputError(f"{name}: is not a sequence of labels")
    if len(values) != count:
        raise InputError(f"{name}: there are {len(values)} labels, not {count}, one for each face")
    number: Dict[Any, int] = {}
    try:
        numbers = [number.setdefault(value, len(number)) for value in np.asarray(values).tolist()]
    except TypeError:
        raise DtypeError(f"{name}: labels are names or numbers") from None
    return numbers, list(number)


def material_list(names: Sequence[Any], colors: Optional[Dict[Any, Sequence[float]]]) -> List[Tuple[str, float, float, float, float]]:
    """(name, red, green, blue, opacity) of each material."""
    given = dict(colors or {})
    materials = []
    for name in names:
        color = [float(part) for part in given.pop(name, (0.8, 0.8, 0.8))]
        if len(color) not in (3, 4) or not all(0 <= part <= 1 for part in color):
            raise InputError(f"colors: {name!r} is not (red, green, blue[, opacity]) from 0 to 1")
        materials.append((str(name), color[0], color[1], color[2], color[3] if len(color) == 4 else 1.0))
    if given:
        raise InputError(f"colors: {next(iter(given))!r} is not a label of materials")
    return materials
