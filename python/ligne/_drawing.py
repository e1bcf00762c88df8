"""Drawings: strokes as arrays, and as files."""

from __future__ import annotations

import importlib
import os
import pathlib
from functools import cached_property
from typing import Any, Dict, List, Optional, Sequence, Tuple, Union, cast

import numpy as np

from . import _core
from ._found import FittedSurface, Region
from ._heights import Heights, height_sources
from ._options import (
    Array, Length, Output, Path, Pens, Progress, Range, arguments, file_name, format_for, open_output, write_to,
)
from ._scene import Scene, as_scene
from ._view import VIEW_OPTIONS, Vector, View, seen_from

_KINDS = np.array(_core.kinds)
_MadeOf = Tuple[Optional[Scene], Dict[str, Any], Dict[str, Any]]


def _frozen(array: Array) -> Array:
    array.flags.writeable = False
    return array


class Drawing:
    """What draw() and surface() give: strokes, each a straight visible (or hidden) piece of one line.

    Arrays have one row for each of the n strokes, in the order of the JSON drawing, and are read-only: they belong to the
    drawing. A surface that the floating horizon drew has polylines and files, but no strokes. A drawing never changes: its
    copy is itself. pickle keeps what it was made of, and draws it again.
    """

    def __init__(self, core: _core.Drawing, scene: Optional[Scene], made_of: _MadeOf) -> None:
        self._core = core
        #: what was drawn; None for surfaces
        self.scene = scene
        self._made_of = made_of

    @classmethod
    def of_scene(
        cls, scene: Scene, surfaces: Dict[str, Any], options: Dict[str, Any], progress: Progress = None
    ) -> Drawing:
        """What draw() does with its arguments."""
        return cls(_core.draw(scene._core, surfaces, options, progress), scene, (scene, surfaces, options))

    @classmethod
    def of_surface(cls, surfaces: Dict[str, Any], options: Dict[str, Any], progress: Progress = None) -> Drawing:
        """What surface() does with its arguments."""
        return cls(_core.surface(surfaces, options, progress), None, (None, surfaces, options))

    def __reduce__(self) -> Tuple[Any, ...]:
        return _draw_again, self._made_of

    def __copy__(self) -> Drawing:
        return self

    def __deepcopy__(self, memo: Any) -> Drawing:
        return self

    def __bool__(self) -> bool:
        return True  # a drawing without strokes is one, too

    @cached_property
    def _arrays(self) -> Dict[str, Array]:
        return self._core.strokes()

    def __len__(self) -> int:
        return self._core.stroke_count

    def __repr__(self) -> str:
        width, height = self.page
        lines = f"{len(self)} strokes" if self._core.has_strokes else f"{self._core.polyline_count} polylines"
        return f"<ligne.Drawing: {lines} on {width:g} x {height:g} mm>"

    @property
    def points(self) -> Array:
        """(2 n, 2) float64, page mm, x to the right and y down: the two ends of each stroke."""
        return self._arrays["points"]

    @property
    def offsets(self) -> Array:
        """(n + 1,) int64: stroke i has the rows offsets[i] to offsets[i + 1] of `points`."""
        return _frozen(np.arange(0, 2 * len(self) + 1, 2))

    @cached_property
    def kind(self) -> Array:
        """(n,) of text: the class of each stroke: outline, border, intersection, crease, mesh, shadow, profile,
        tangent, suggestive, ridge, valley, detail, ..."""
        return _frozen(_KINDS[self._arrays["kind"]])

    @property
    def visible(self) -> Array:
        """(n,) bool."""
        return self._arrays["visible"].view(bool)

    @property
    def edge(self) -> Array:
        """(n, 2) int64: the two vertices of the source edge, rows of scene.vertices; -1 for what is no edge of the mesh
        (intersections, smooth outlines, shadows)."""
        return self._arrays["edge"]

    @property
    def faces(self) -> Array:
        """(n, 2) int64: the two faces at the source edge, rows of the faces that were given; -1 where there is none."""
        return self._arrays["faces"]

    @property
    def stroke_surfaces(self) -> Array:
        """(n, 2) int64: the surfaces of the two `faces`, numbers in `surfaces`; -1 where a face has none."""
        return self._arrays["surfaces"]

    @property
    def parameter(self) -> Array:
        """(n, 2) float64: the interval on the source edge, 0 at its first end and 1 at its second, in model space."""
        return self._arrays["parameter"]

    @property
    def level(self) -> Array:
        """(n,) uint8: how many transparent faces are in front of it."""
        return self._arrays["level"]

    def points3d(self) -> Array:
        """(2 n, 3) float64, model units: where `points` are in space."""
        return self._arrays["points3d"]

    def polylines(self, kind: Optional[str] = None) -> List[Array]:
        """Strokes joined: (k, 2) float64 each, page mm; those of one layer, or of all in the order of painting."""
        return [line for name, _, lines in self._core.layers() if kind is None or name == kind for line in lines]

    @property
    def layers(self) -> Dict[str, List[Array]]:
        """Polylines by the layers of the file, in the order of painting: the classes, "hidden", "hatch", "axes", ..."""
        layers: Dict[str, List[Array]] = {}
        for name, _, lines in self._core.layers():
            layers.setdefault(name, []).extend(lines)
        return layers

    @cached_property
    def regions(self) -> List[Region]:
        """Visible faces as areas, of a drawing that was made with regions=True, fill, hatch or light."""
        regions = self._core.regions()
        if regions is None:
            raise _core.RequestError("regions: were not requested: draw(..., regions=True)")
        return [Region(*region) for region in regions]

    @cached_property
    def surfaces(self) -> Tuple[FittedSurface, ...]:
        """The surfaces that the mesh stands for (docs/patches.md), by object; none with
        quality="exact" and where no creases were asked for."""
        return tuple(FittedSurface(*surface) for surface in self._core.surfaces())

    @property
    def matrix(self) -> Array:
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
        file: Output,
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
        pen: Pens = None,
        optimize: Optional[str] = None,
        join: Optional[Length] = None,
        simplify: Optional[Length] = None,
        report: Optional[bool] = None,
        preview: Optional[Path] = None,
        as_mesh: bool = False,
        progress: Progress = None,
    ) -> str:
        """Writes svg, pdf, png, json, hpgl or gcode, by the suffix or `format`; the file is whole or not there.

        file: a path, or a file that is open for writing: in text mode (not for pdf and png), or binary.
        Options that are not given are those of draw(). The scene is studied again only where the format needs what was
        not studied: JSON of methods that give more than strokes, gray faces, hatching. Gives the table of report=True.
        as_mesh: surfaces as a mesh file, .json (ligne-scene) or .obj, instead of their picture.
        """
        options = arguments(locals(), "self", "file", "preview", "as_mesh", "progress")
        opened = open_output(file)
        if opened is not None:
            return self._save_to(opened, preview, as_mesh, options, progress)
        path = os.fspath(cast(Path, file))
        if as_mesh:
            self._core.save_mesh(path)
            return ""
        return self._core.save(path, file_name(preview), dict(options, preview=preview), progress)

    def _save_to(
        self, file: Any, preview: Optional[Path], as_mesh: bool, options: Dict[str, Any], progress: Progress
    ) -> str:
        format = format_for(file, options["format"])
        if as_mesh:
            write_to(file, self._core.write_mesh(format), format)
            return ""
        if preview is not None:
            raise _core.RequestError("preview: needs a named file")
        data, _, report = self._core.write(dict(options, format=format), progress)
        write_to(file, data, format)
        return report

    def plot(self, file: Output, *, optimize: str = "full", **options: Any) -> str:
        """save() with the path work for a pen: lines once, ends joined, ordered. Gives the table of strokes, lengths,
        lifts and, for a device, time, before and after."""
        options.setdefault("report", True)
        return self.save(file, optimize=optimize, **options)

    def to_bytes(self, format: str = "svg", *, as_mesh: bool = False, **options: Any) -> bytes:
        """The bytes of the file that save() would write."""
        if as_mesh:
            return self._core.write_mesh(format)
        return self._core.write(dict(options, format=format), None)[0]

    def _repr_svg_(self) -> str:
        return self.to_bytes("svg").decode()

    def to_shapely(self, kind: Optional[str] = None) -> Any:
        """A shapely MultiLineString of polylines(kind), page mm."""
        geometry = importlib.import_module("shapely.geometry")  # has types in some of its versions only

        return geometry.MultiLineString([line for line in self.polylines(kind) if len(line) > 1])

    def to_line_collection(self, kind: Optional[str] = None, **style: Any) -> Any:
        """A matplotlib LineCollection of polylines(kind), page mm with y down: ax.invert_yaxis(), ax.set_aspect(1)."""
        collections = importlib.import_module("matplotlib.collections")  # has types in some of its versions only

        return collections.LineCollection(self.polylines(kind), **style)


def _draw_again(scene: Optional[Scene], surfaces: Dict[str, Any], options: Dict[str, Any]) -> Drawing:
    return Drawing.of_surface(surfaces, options) if scene is None else Drawing.of_scene(scene, surfaces, options)


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
    crease: Optional[float] = None,
    tangent: str = "auto",
    hidden: str = "none",
    quality: Optional[str] = None,
    cull: bool = False,
    min_length: Optional[Length] = None,
    profile: Optional[str] = None,
    regions: bool = False,
    surface: Union[Heights, Sequence[Heights], None] = None,
    grid: Union[Path, Sequence[Path], None] = None,
    parametric: Sequence[Tuple[str, str, str]] = (),
    x: Optional[Range] = None,
    y: Optional[Range] = None,
    u: Union[Range, List[Range], None] = None,
    v: Union[Range, List[Range], None] = None,
    samples: Optional[int] = None,
    every: Optional[int] = None,
    z_scale: Optional[float] = None,
    z_range: Optional[Range] = None,
    fill: str = "none",
    light: Union[Vector, Sequence[Vector], None] = None,
    hatch: str = "none",
    hatch_spacing: Optional[Length] = None,
    hatch_angle: Union[float, str] = 45,
    hatch_levels: Union[int, str, None] = None,
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
    shade_tone: str = "face",
    device: Optional[str] = None,
    device_file: Optional[Path] = None,
    fit_device: bool = False,
    pens: Optional[Path] = None,
    pen: Pens = None,
    optimize: Optional[str] = None,
    join: Length = 0.05,
    simplify: Length = 0.01,
    threads: int = 0,
    max_memory: Union[str, float, None] = None,
    progress: Progress = None,
    **parameters: Any,
) -> Drawing:
    """Draws a model with its hidden lines removed.

    model: a Scene, a file, or an object of trimesh, pyvista or meshio. With a file, options of read() (only, hide, move,
        weld, merge_coplanar, subdivide, assume) may stand among the others.
    view: a name, or a View; direction, or eye with target and fov, are others.
    regions: visible faces as areas, too (Drawing.regions).
    surface: among the models: formulas in x and y, or arrays as surface() takes them; grid: files of heights; parametric:
        surfaces as three formulas in u and v; x, y, u, v, samples, every, z_scale, z_range: of these.
    threads: 0 is all processors. max_memory: bytes or a text such as "2G", refused beforehand where the counts tell it.
    progress: called with the fraction done, in this thread, at most twenty times a second; what it raises ends the work.
    parameters: the methods' own options, such as resolution=512.

    All others are the options of `ligne draw`, with the same defaults (docs/options.md). The interpreter's lock is given
    up meanwhile, and Ctrl-C ends the work. Raises RequestError, InputError, MemoryLimitError.
    """
    options = arguments(locals(), "model", "view", "quality", "progress", *VIEW_OPTIONS, *_OF_SURFACES)
    options.update(seen_from(view, {name: value for name, value in locals().items() if name in VIEW_OPTIONS}))
    of_surfaces: Dict[str, Any] = dict(x=x, y=y, samples=samples, every=every, z_scale=z_scale, z_range=z_range, u=u, v=v)
    of_surfaces["parametric"] = [tuple(str(formula) for formula in three) for three in parametric]
    surfaces = _surfaces(surface, grid, of_surfaces)
    scene = _scene_for(model, quality, options)
    return Drawing.of_scene(scene, surfaces, options, progress)


_OF_READING = ("only", "hide", "move", "weld", "merge_coplanar", "subdivide", "assume", "pose")
_OF_SURFACES = ("surface", "grid", "parametric", "x", "y", "u", "v", "samples", "every", "z_scale", "z_range")


def _several(value: Any) -> List[Any]:
    return [] if value is None else list(value) if isinstance(value, (list, tuple)) else [value]


def _surfaces(surface: Any, grid: Any, options: Dict[str, Any]) -> Dict[str, Any]:
    return height_sources([*_several(surface), *(pathlib.Path(file) for file in _several(grid))], options)


def _scene_for(model: Any, quality: Optional[str], options: Dict[str, Any]) -> Scene:
    """The model as a scene whose parts are told apart where the options do."""
    parts = options.get("group", "none") != "none" or bool(options.get("color")) or "object:" in str(options.get("pen"))
    reading = {name: options.pop(name) for name in _OF_READING if name in options}
    return as_scene(model, quality, options.get("threads", 0), groups=parts, reading=reading)


def draw_frames(
    model: Any,
    file: Path,
    view: Union[str, View, None] = "iso",
    *,
    frames: int,
    turn: float = 360,
    quality: Optional[str] = None,
    progress: Progress = None,
    **options: Any,
) -> List[str]:
    """Draws successive views of the turning model, at one scale and about an axis that stands still, and writes them.

    file: with a place for the number, "turn%03d.svg"; a PDF without one holds them all as pages.
    frames: how many; turn: degrees in all, counter-clockwise as seen from above.
    All others are those of draw(), but for surfaces. Gives the names of the files.
    """
    chosen = {name: options.pop(name) for name in VIEW_OPTIONS if name in options}
    scene = _scene_for(model, quality, options)
    given = dict(options, **seen_from(view, chosen))
    return _core.draw_frames(scene._core, os.fspath(file), frames, float(turn), given, progress)
