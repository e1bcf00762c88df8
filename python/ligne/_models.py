"""What a model contains, and models prepared for many views."""

from __future__ import annotations

import json
import os
from typing import Any, Dict, Optional, Sequence, Tuple, Union

from . import _core
from ._options import Length, Path, arguments
from ._scene import as_scene
from ._view import VIEW_OPTIONS, Vector, View, seen_from


def info(
    model: Any,
    view: Union[str, View, None] = "iso",
    *,
    direction: Optional[Vector] = None,
    eye: Optional[Vector] = None,
    target: Optional[Vector] = None,
    fov: Optional[float] = None,
    up: Optional[Vector] = None,
    up_axis: Optional[str] = None,
    method: str = "auto",
    edges: Union[str, Sequence[str], None] = None,
    crease: Optional[float] = None,
    tangent: str = "auto",
    hidden: str = "none",
    quality: Optional[str] = None,
    cull: bool = False,
    min_length: Optional[Length] = None,
    page: Union[str, Tuple[float, float]] = "A4",
    landscape: bool = False,
    portrait: bool = False,
    margin: Length = 10,
    pen_width: Length = 0.35,
    width: Union[str, Dict[str, Length], None] = None,
    scale: str = "fit",
    unit: Union[str, float, None] = None,
    threads: int = 0,
    max_memory: Union[str, float, None] = None,
    **parameters: Any,
) -> Dict[str, Any]:
    """What a model contains and what that means for each method, as `ligne info --json` tells it: files, scene (counts,
    bounds, objects, materials, cameras), view (edges by class, depth, size on the page), methods.

    Arguments as of draw().
    """
    options = arguments(locals(), "model", "view", "quality", *VIEW_OPTIONS)
    options.update(seen_from(view, {name: value for name, value in locals().items() if name in VIEW_OPTIONS}))
    result: Dict[str, Any] = json.loads(_core.info(as_scene(model, quality, threads, groups=True)._core, options))
    return result


def compile(
    model: Any,
    file: Path,
    *,
    method: str = "bsp",
    quality: Optional[str] = None,
    threads: int = 0,
    **parameters: Any,
) -> None:
    """Writes a model with what the method ("bsp" or "convex-tree") makes of it for all views, as a .tree file, which read()
    and `ligne draw` take. parameters: candidates, partition."""
    _core.compile(as_scene(model, quality, threads)._core, os.fspath(file), method, parameters, threads)
