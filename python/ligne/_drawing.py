"""Drawings: strokes as arrays, and as files."""

from __future__ import annotations

import os
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Callable, Dict, Iterable, List, Optional, Sequence, Tuple, Union

import numpy as np

from . import _core
from ._scene import Path, Scene, as_scene
from ._view import Vector, View, view_options

Length = Union[str, float]
Progress = Optional[Callable[[float], Any]]

_KINDS = np.array(_core.kinds)


def _ring_area(points: np.ndarray) -> float:
    x, y = points[:, 0], points[:, 1]
    return 0.5 * abs(float(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1))))


@dataclass(frozen=True)
class Region:
    """A visible part of a face on the page."""

    face: int  #: row of the faces that were given
    contours: List[np.ndarray]  #: (k, 2) float64 each, page mm, not closed; the first is outer, the others are holes
    level: int  #: how many transparent faces are in front of it
    lights: int  #: bit i: light i reaches it

    @property
    def area(self) -> float:
        """mm^2 on the page."""
        return _ring_area(self.contours[0]) - sum(_ring_area(hole) for hole in self.contours[1:])


def _format_of(file: Path, format: Optional[str]) -> str:
    if format is not None:
        return format
    suffix = os.path.splitext(os.fspath(file))[1].lower()
    known = {".plt": "hpgl", ".hpg": "hpgl", ".nc": "gcode", ".ngc": "gcode"}
    name = known.get(suffix, suffix[1:])
    if name not in ("svg", "pdf", "png", "json", "hpgl", "gcode"):
        raise _core.RequestError(f"format: {os.fspath(file)!r} does not end in .svg, .pdf, .png, .json, .hpgl or .gcode")
    return name


class Drawing:
    """What draw() and surface() give: strokes, each a straight visible (or hidden) piece of one line.

    Arrays have one row for each of the n strokes, in the order of the JSON drawing. A surface that the floating horizon
    drew has polylines and files, but no strokes.
    """

    def __init__(self, core: Any, scene: Optional[Scene] = None) -> None:
        self._core = core
        #: what was drawn; None for surfaces
        self.scene = scene

    @cached_property
    def _arrays(self) -> Dict[str, np.ndarray]:
        return self._core.strokes()

    def __len__(self) -> int:
        return self._core.stroke_count

    def __repr__(self) -> str:
        width, height = self.page
        return f"<ligne.Drawing: {len(self)} strokes on {width:g} x {height:g} mm>"

    @property
    def points(self) -> np.ndarray:
        """(2 n, 2) float64, page mm, x to the right and y down: the two ends of each stroke."""
        return self._arrays["points"]

    @property
    def offsets(self) -> np.ndarray:
        """(n + 1,) int64: stroke i has the rows offsets[i] to offsets[i + 1] of `points`."""
        return np.arange(0, 2 * len(self) + 1, 2)

    @cached_property
    def kind(self) -> np.ndarray:
        """(n,) of text: the class of each stroke: outline, border, intersection, crease, mesh, shadow, profile, ..."""
        return _KINDS[self._arrays["kind"]]

    @property
    def visible(self) -> np.ndarray:
        """(n,) bool."""
        return self._arrays["visible"].view(bool)

    @property
    def edge(self) -> np.ndarray:
        """(n, 2) int64: the two vertices of the source edge, rows of scene.vertices; -1 for what is no edge of the mesh
        (intersections, smooth outlines, shadows)."""
        return self._arrays["edge"]

    @property
    def faces(self) -> np.ndarray:
        """(n, 2) int64: the two faces at the source edge, rows of the faces that were given; -1 where there is none."""
        return self._arrays["faces"]

    @property
    def parameter(self) -> np.ndarray:
        """(n, 2) float64: the interval on the source edge, 0 at its first end and 1 at its second, in model space."""
        return self._arrays["parameter"]

    @property
    def level(self) -> np.ndarray:
        """(n,) uint8: how many transparent faces are in front of it."""
        return self._arrays["level"]

    def points3d(self) -> np.ndarray:
        """(2 n, 3) float64, model units: where `points` are in space."""
        return self._arrays["points3d"]

    def polylines(self, kind: Optional[str] = None) -> List[np.ndarray]:
        """Strokes joined: (k, 2) float64 each, page mm; those of one layer, or of all in the order of painting."""
        return [line for name, _, lines in self._core.layers() if kind is None or name == kind for line in lines]

    @property
    def layers(self) -> Dict[str, List[np.ndarray]]:
        """Polylines by the layers of the file, in the order of painting: the classes, "hidden", "hatch", "axes", ..."""
        layers: Dict[str, List[np.ndarray]] = {}
        for name, _, lines in self._core.layers():
            layers.setdefault(name, []).extend(lines)
        return layers

    @cached_property
    def regions(self) -> List[Region]:
        """Visible faces as areas, of a drawing that was made with regions=True, fill, hatch or light."""
        regions = self._core.regions()
        if regions is None:
            raise _core.RequestError("regions: were not asked for: draw(..., regions=True)")
        return [Region(*region) for region in regions]

    @property
    def matrix(self) -> np.ndarray:
        """(4, 4) float64: (x, y, z, 1) of the model to (X, Y, Z, W); (X / W, Y / W) is the place on the page in mm, and
        Z / W a depth that grows with the distance from the viewer."""
        return self._core.matrix

    @property
    def page(self) -> Tuple[float, float]:
        """Width and height, mm."""
        return self._core.page_mm

    @property
    def statistics(self) -> Dict[str, Any]:
        """The method, its counts and times, and the times of all stages in seconds."""
        return self._core.report

    @property
    def warnings(self) -> List[str]:
        """What the drawing lacks, a line each."""
        return self._core.warnings

    def save(
        self,
        file: Path,
        *,
        format: Optional[str] = None,
        dpi: Optional[float] = None,
        curves: Union[str, bool, None] = None,
        title: Optional[str] = None,
        shade: Optional[bool] = None,
        device: Optional[str] = None,
        device_file: Optional[Path] = None,
        fit_device: Optional[bool] = None,
        pens: Optional[Path] = None,
        pen: Union[str, Sequence[str], Dict[str, str], None] = None,
        optimize: Optional[str] = None,
        join: Optional[Length] = None,
        simplify: Optional[Length] = None,
        report: Optional[bool] = None,
        preview: Optional[Path] = None,
        progress: Progress = None,
    ) -> str:
        """Writes svg, pdf, png, json, hpgl or gcode, by the suffix or `format`; the file is whole or not there.

        Options that are not given are those of draw(). The scene is studied again only where the format needs what was
        not studied: JSON of methods that give more than strokes, gray faces, hatching. Gives the table of report=True.
        """
        options = dict(
            format=_format_of(file, format), dpi=dpi, curves=curves, title=title, shade=shade, device=device,
            device_file=device_file, fit_device=fit_device, pens=pens, pen=pen, optimize=optimize, join=join,
            simplify=simplify, report=report, preview=preview,
        )  # fmt: skip
        return self._core.save(os.fspath(file), "" if preview is None else os.fspath(preview), options, progress)

    def plot(self, file: Path, *, optimize: str = "full", **options: Any) -> str:
        """save() with the path work for a pen: lines once, ends joined, ordered. Gives the table of strokes, lengths,
        lifts and, for a device, time, before and after."""
        options.setdefault("report", True)
        return self.save(file, optimize=optimize, **options)

    def to_bytes(self, format: str = "svg", **options: Any) -> bytes:
        """The bytes of the file that save() would write."""
        return self._core.write(dict(options, format=format), None)[0]

    def _repr_svg_(self) -> str:
        return self.to_bytes("svg").decode()

    def to_shapely(self, kind: Optional[str] = None) -> Any:
        """A shapely MultiLineString of polylines(kind), page mm."""
        from shapely.geometry import MultiLineString

        return MultiLineString([line for line in self.polylines(kind) if len(line) > 1])

    def to_line_collection(self, kind: Optional[str] = None, **style: Any) -> Any:
        """A matplotlib LineCollection of polylines(kind), page mm with y down: ax.invert_yaxis(), ax.set_aspect(1)."""
        from matplotlib.collections import LineCollection

        return LineCollection(self.polylines(kind), **style)


def draw(
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
    crease: float = 30,
    hidden: str = "none",
    quality: Optional[str] = None,
    cull: bool = False,
    min_length: Optional[Length] = None,
    profile: Optional[str] = None,
    regions: bool = False,
    fill: str = "none",
    light: Union[Vector, Sequence[Vector], None] = None,
    hatch: str = "none",
    hatch_spacing: Optional[Length] = None,
    hatch_angle: Union[float, str] = 45,
    hatch_levels: Union[int, str] = 4,
    hatch_cross: bool = False,
    page: Union[str, Tuple[float, float]] = "A4",
    landscape: bool = False,
    portrait: bool = False,
    margin: Length = 10,
    pen_width: Length = 0.35,
    width: Union[str, Dict[str, Length], None] = None,
    scale: str = "fit",
    unit: Union[str, float, None] = None,
    group: str = "none",
    color: Union[str, Sequence[str], Dict[str, str], None] = None,
    title: Optional[str] = None,
    dpi: float = 150,
    curves: Union[str, bool, None] = None,
    shade: bool = False,
    device: Optional[str] = None,
    device_file: Optional[Path] = None,
    fit_device: bool = False,
    pens: Optional[Path] = None,
    pen: Union[str, Sequence[str], Dict[str, str], None] = None,
    optimize: Optional[str] = None,
    join: Length = 0.05,
    simplify: Length = 0.02,
    threads: int = 0,
    max_memory: Optional[float] = None,
    progress: Progress = None,
    **parameters: Any,
) -> Drawing:
    """Draws a model with its hidden lines removed.

    model: a Scene, a file, or an object of trimesh, pyvista or meshio.
    view: a name, or a View; direction, or eye with target and fov, are others.
    regions: visible faces as areas, too (Drawing.regions).
    threads: 0 is all processors. max_memory: bytes, refused beforehand where the counts tell it.
    progress: called with the fraction done, in this thread, at most twenty times a second; what it raises ends the work.
    parameters: the methods' own options, such as resolution=512.

    All others are the options of `ligne draw`, with the same defaults (docs/options.md). The interpreter's lock is given
    up meanwhile, and Ctrl-C ends the work. Raises RequestError, InputError, MemoryLimitError.
    """
    chosen: Dict[str, Any] = dict(direction=direction, eye=eye, target=target, fov=fov, up=up, up_axis=up_axis)
    given = {name: value for name, value in chosen.items() if value is not None}
    if "direction" not in given and "eye" not in given:
        given = {**view_options(view), **given}
    if isinstance(page, tuple):
        page = "x".join(f"{float(side)!r}" for side in page)
    if shade:
        given["format"] = "png"
    options = dict(
        given, method=method, edges=edges, crease=crease, hidden=hidden, cull=cull, min_length=min_length,
        profile=profile, regions=regions, fill=fill, light=light, hatch=hatch, hatch_spacing=hatch_spacing,
        hatch_angle=hatch_angle, hatch_levels=hatch_levels, hatch_cross=hatch_cross, page=page, landscape=landscape,
        portrait=portrait, margin=margin, pen_width=pen_width, width=width, scale=scale, unit=unit, group=group,
        color=color, title=title, dpi=dpi, curves=curves, shade=shade, device=device, device_file=device_file,
        fit_device=fit_device, pens=pens, pen=pen, optimize=optimize, join=join, simplify=simplify, threads=threads,
        max_memory=max_memory, **parameters,
    )  # fmt: skip
    scene = as_scene(model, quality, threads)
    return Drawing(_core.draw(scene._core, options, progress), scene)
