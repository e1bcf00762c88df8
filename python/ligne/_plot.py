"""Drawings from files, ours or anybody's, made ready for pens."""

from __future__ import annotations

import json
import os
from dataclasses import dataclass
from typing import Any, Dict, List, Optional, Sequence, Tuple, Union

from . import _core
from ._drawing import Drawing
from ._options import Length, Path, Pens, arguments, file_name

Named = Union[str, float, Sequence[str], Dict[str, Any], None]


@dataclass(frozen=True)
class Plotted:
    """What plot() gives."""

    data: bytes  #: of the file, where none is written
    report: str  #: table of strokes, lengths, lifts and time before and after, with report=True
    warnings: List[str]  #: what of the drawing is left out or not as it was, a line each
    statistics: Dict[str, Any]  #: times of the stages in seconds

    def __str__(self) -> str:
        return self.report


def plot(
    drawing: Union[Path, bytes, Drawing],
    file: Optional[Path] = None,
    *,
    skip: Union[str, Sequence[str], None] = None,
    fill: Optional[str] = None,
    min_length: Length = 0,
    occlude: bool = False,
    hatch: Optional[str] = None,
    hatch_spacing: Named = None,
    hatch_angle: Named = None,
    hatch_cross: Union[bool, str, Sequence[str]] = False,
    page: Union[str, Tuple[float, float], None] = None,
    landscape: bool = False,
    portrait: bool = False,
    margin: Length = 10,
    pen_width: Optional[Length] = None,
    width: Union[str, Dict[str, Length], None] = None,
    scale: str = "1:1",
    format: Optional[str] = None,
    dpi: float = 150,
    device: Optional[str] = None,
    device_file: Optional[Path] = None,
    fit_device: bool = False,
    pens: Optional[Path] = None,
    pen: Pens = None,
    optimize: Optional[str] = None,
    join: Length = 0.05,
    simplify: Length = 0.02,
    report: bool = False,
    preview: Optional[Path] = None,
    threads: int = 0,
    max_memory: Union[str, float, None] = None,
) -> Plotted:
    """Makes a drawing ready for pens and plotters: strokes joined, drawn once and ordered.

    drawing: a file, SVG or ligne-drawing JSON; the bytes of one; or a Drawing.
    file: svg, pdf, png, hpgl or gcode by the suffix or `format`; None: Plotted.data holds the bytes, of an SVG unless
        `format` says otherwise.
    hatch_spacing, hatch_angle: of all fills, or {"layer or colour": value}; hatch_cross: True, or names of such.

    All others are the options of `ligne plot`, with the same defaults (docs/options.md). Raises RequestError, InputError,
    MemoryLimitError.
    """
    options = arguments(locals(), "drawing", "file")
    name, text = "drawing", None
    if isinstance(drawing, Drawing):
        text = drawing.to_bytes("json")
    elif isinstance(drawing, (bytes, bytearray)):
        text = bytes(drawing)
    elif isinstance(drawing, (str, os.PathLike)):
        name = os.fspath(drawing)
    else:
        raise _core.RequestError(f"drawing: {type(drawing).__name__} is neither a file, bytes nor a Drawing")
    data, table, warnings, statistics = _core.plot(name, text, file_name(file), options)
    return Plotted(data, table, warnings, json.loads(statistics))
