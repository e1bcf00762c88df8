"""Methods side by side, and the experiments of the sources."""

from __future__ import annotations

import json
import os
from typing import Any, Dict, Optional, Sequence, Tuple, Union

from . import _core
from ._options import Length, Path, Progress, arguments
from ._scene import as_scene
from ._view import VIEW_OPTIONS, Vector, View, seen_from


def compare(
    model: Any,
    view: Union[str, View, None] = "iso",
    *,
    methods: Union[str, Sequence[str], None] = None,
    time_limit: float = 60,
    html: Optional[Path] = None,
    direction: Optional[Vector] = None,
    eye: Optional[Vector] = None,
    target: Optional[Vector] = None,
    fov: Optional[float] = None,
    up: Optional[Vector] = None,
    up_axis: Optional[str] = None,
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
    progress: Progress = None,
    **parameters: Any,
) -> Dict[str, Any]:
    """Draws a model by several methods, and puts their figures side by side, as `ligne compare --json` does: files,
    page_mm, traits, auto, reference, methods (what each drew, how far it is from the reference, its times in seconds,
    memory in bytes, and operations), differences_mm (each against each).

    methods: names, or a text with commas between them; None: all that give lines.
    time_limit: seconds; a method that takes longer is ended, and its entry says so.
    html: file of a page with the drawings, what differs in red, and the tables.
    parameters: the methods' own options, such as resolution=512; each goes to the methods that have it.

    All others are arguments as of draw(). Memory is that of the process: with other work beside it that counts too. Raises
    RequestError, InputError, MemoryLimitError.
    """
    options = arguments(locals(), "model", "view", "quality", "progress", "parameters", *VIEW_OPTIONS)
    options.update(seen_from(view, {name: value for name, value in locals().items() if name in VIEW_OPTIONS}))
    scene = as_scene(model, quality, threads)
    result: Dict[str, Any] = json.loads(_core.compare(scene._core, options, parameters, progress))
    return result


def study(
    name: str,
    *models: Path,
    size: str = "full",
    svg: Optional[Path] = None,
    csv: Optional[Path] = None,
    threads: int = 0,
    progress: Progress = None,
) -> Dict[str, Any]:
    """Makes an experiment of the sources again, or "all", as `ligne study NAME --json` does: size, and experiments with
    name, section, title, tables, finding and sentence (docs/study.md). experiments() lists their names.

    models: files, which are studied beside the scenes of experiments that go over scenes.
    size: "full", or "small": the same tables of smaller scenes.
    svg: file of the plots, where there are any; csv: of the figures, one a line.
    progress: called with the fraction of the experiments that is done.

    Raises RequestError, InputError.
    """
    options = arguments(locals(), "name", "models", "progress")
    result: Dict[str, Any] = json.loads(_core.study(name, [os.fspath(file) for file in models], options, progress))
    return result
