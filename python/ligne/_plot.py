"""Drawings from files, ours or anybody's, made ready for pens."""

from __future__ import annotations

import json
import os
from dataclasses import dataclass
from typing import Any, Dict, List, Optional, Sequence, Tuple, Union, cast

from . import _core
from ._drawing import Drawing
from ._options import (
    Length, Output, Path, Pens, Writable, arguments, file_name, format_for, open_output, write_to,
)

Named = Union[str, float, Sequence[str], Dict[str, Any], None]


@dataclass(frozen=True)
class Plotted:
    """What plot() gives."""

    data: bytes  #: of the file, where none is written; of the first, where there are several
    files: List[str]  #: names of the files that were written
    parts: List[bytes]  #: of all files, where none is written
    report: str  #: table of strokes, lengths, lifts and time before and after, with report=True
    warnings: List[str]  #: what of the drawing is left out or not as it was, a line each
    statistics: Dict[str, Any]  #: times of the stages in seconds

    def __str__(self) -> str:
        return self.report


def plot(
    drawing: Union[Path, bytes, Drawing, Sequence[Union[Path, bytes, Drawing]]],
    file: Optional[Output] = None,
    *,
    skip: Union[str, Sequence[str], None] = None,
    strict: bool = False,
    input_dpi: float = 96,
    fill: Optional[str] = None,
    material: Named = None,
    min_length: Length = 0,
    occlude: Union[bool, str] = False,
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
    tile: Union[str, Tuple[float, float], None] = None,
    overlap: Length = 5,
    grid: Union[str, Tuple[int, int], None] = None,
    split: Optional[str] = None,
    from_stroke: int = 1,
    from_time: Optional[str] = None,
    every: Optional[Length] = None,
    do: Optional[str] = None,
    park: Optional[str] = None,
    format: Optional[str] = None,
    dpi: float = 150,
    curves: Union[str, bool, None] = None,
    device: Optional[str] = None,
    device_file: Optional[Path] = None,
    fit_device: bool = False,
    pens: Optional[Path] = None,
    pen: Pens = None,
    optimize: Optional[str] = None,
    join: Length = 0.05,
    simplify: Length = 0.01,
    report: bool = False,
    preview: Optional[Path] = None,
    threads: int = 0,
    max_memory: Union[str, float, None] = None,
) -> Plotted:
    """Makes a drawing ready for pens and plotters: strokes joined, drawn once and ordered.

    drawing: a file, SVG or ligne-drawing JSON; the bytes of one; or a Drawing; or several for the cells of a `grid`.
    file: svg, pdf, png, hpgl or gcode by the suffix or `format`; "%d" and "%p" are the numbers of the part and of the pen.
        Or a file that is open for writing, text or binary.
        None: Plotted.data holds the bytes, of an SVG unless `format` says otherwise, and Plotted.parts those of all files.
    hatch_spacing, hatch_angle: of all fills, or {"layer or colour": value}; hatch_cross: True, or names of such.
    material: colours of materials for `fill`, {"name": "colour"}.

    All others are the options of `ligne plot`, with the same defaults (docs/options.md). Raises RequestError, InputError,
    MemoryLimitError.
    """
    options = arguments(locals(), "drawing", "file")
    drawings = drawing if isinstance(drawing, (list, tuple)) else [drawing]
    if not drawings:
        raise _core.RequestError("drawing: no drawing is given")
    opened = None if file is None else open_output(file)
    if opened is not None:
        options["format"] = format_for(opened, format)
        file = None
    path = file_name(cast(Optional[Path], file))
    files, table, warnings, statistics = _core.plot([_named(one) for one in drawings], path, options)
    if opened is not None:
        _write_only(opened, files, str(options["format"]))
    written = [] if file is None else [name for name, _ in files]
    data = [content for _, content in files] if file is None and opened is None else []
    return Plotted(data[0] if data else b"", written, data, table, warnings, json.loads(statistics))


def _write_only(file: Writable, files: List[Tuple[str, bytes]], format: str) -> None:
    if len(files) > 1:
        raise _core.RequestError(f"file: the plot has {len(files)} parts; its name needs %d or %p")
    write_to(file, files[0][1], format)


def _named(drawing: Any) -> Tuple[str, Optional[bytes]]:
    """The name of a file, or a text with the name that stands for it in messages."""
    if isinstance(drawing, Drawing):
        return "drawing", drawing.to_bytes("json")
    if isinstance(drawing, (bytes, bytearray)):
        return "drawing", bytes(drawing)
    if isinstance(drawing, (str, os.PathLike)):
        return os.fspath(drawing), None
    raise _core.RequestError(f"drawing: {type(drawing).__name__} is neither a file, bytes nor a Drawing")
