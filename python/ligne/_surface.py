"""Surfaces z = f(x, y), and parametric ones."""

from __future__ import annotations

from typing import Any, List, Optional, Sequence, Tuple, Union

from . import _core
from ._drawing import Drawing
from ._heights import height_sources, split_positions
from ._options import Length, Progress, Range, arguments
from ._view import VIEW_OPTIONS, Vector, View, seen_from

def surface(
    *z: Any,
    x: Optional[Any] = None,
    y: Optional[Any] = None,
    parametric: Sequence[Tuple[str, str, str]] = (),
    u: Union[Range, List[Range], None] = None,
    v: Union[Range, List[Range], None] = None,
    samples: Optional[int] = None,
    every: Union[int, str] = "auto",
    gridded: Optional[int] = None,
    using: Optional[str] = None,
    index: Optional[int] = None,
    layout: Optional[str] = None,
    band: Optional[int] = None,
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
    contours: Union[int, str, Sequence[float], None] = None,
    contour_step: Optional[float] = None,
    contours_base: Union[bool, float] = False,
    outline: Union[str, bool, None] = None,
    underside: str = "same",
    hidden_by: str = "surface",
    ridgeline: Union[bool, float] = False,
    contour_labels: Union[bool, str] = False,
    index_contours: Optional[int] = None,
    water: Union[float, str, None] = None,
    water_fill: str = "blank",
    hachures: str = "none",
    hachure_spacing: Optional[Length] = None,
    sun: Union[float, str, Tuple[float, float], None] = None,
    scale_bar: Union[bool, str] = False,
    north_arrow: bool = False,
    curve: Sequence[Tuple[str, str, str]] = (),
    t: Union[Range, List[Range], None] = None,
    points: Sequence[Any] = (),
    path: Sequence[Any] = (),
    colors: Union[str, Sequence[str], None] = None,
    bands: Union[int, Sequence[float], None] = None,
    legend: bool = False,
    name: Sequence[str] = (),
    x_names: Optional[Sequence[str]] = None,
    y_names: Optional[Sequence[str]] = None,
    z_names: Optional[Sequence[str]] = None,
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

    surface(z, x, y) draws one surface, surface(z1, z2, ..., x=..., y=...) several.

    z: each a formula in x and y ("sin(r)/r"), a path of a grid file (a pathlib.Path), an array of heights (rows of y,
        columns of x; nan where there is none), or a function of two arrays.
    x, y: for formulas and functions (from, to) or (from, to, curves), by default (-5, 5, 40); for an array the positions of
        its columns and rows, or both of numpy.meshgrid(), or (from, to), by default 0, 1, 2, ...
    parametric: surfaces as three formulas in u and v.
    curve: curves as three formulas in t, that of z may be "surface"; points, path: paths of tables; name: names of the
        legend.

    All others are the options of `ligne surface` and, for the page, hatching and pens, of draw(). Raises RequestError,
    InputError, DtypeError.
    """
    sources, x, y = split_positions(z, x, y)
    given = arguments(locals(), "z", "sources", "options", "view", "progress", "method", "hidden", *VIEW_OPTIONS)
    seen = seen_from(view, dict(direction=direction, eye=eye, target=target, fov=fov, up=up))
    if (azimuth is not None or elevation is not None) and any(seen.get(n) is not None for n in ("view", "direction", "eye")):
        raise _core.RequestError("azimuth, elevation: can not be combined with view, direction or eye")
    given["parametric"] = [tuple(str(formula) for formula in three) for three in parametric]
    return Drawing.of_surface(height_sources(sources, given), dict(seen, **options, method=method, hidden=hidden), progress)
