"""Scenes: files and arrays, read and mended."""

from __future__ import annotations

import os
from typing import Any, Dict, List, Optional, Sequence, Tuple, Type, Union

import numpy as np

from . import _core
from ._arrays import Faces, flat_faces, labels, material_list, vertex_array
from ._options import Array, Path, arguments


class Scene:
    """What is drawn: faces of objects, welded and, for clear lines, healed. It never changes, and threads may share it."""

    def __init__(self, core: _core.Scene) -> None:
        self._core = core

    def __reduce__(self) -> Tuple[Any, ...]:
        return _scene_again, (type(self), self._core)

    def __copy__(self) -> Scene:
        return self

    def __deepcopy__(self, memo: Any) -> Scene:
        return self

    @property
    def vertices(self) -> Array:
        """(n, 3) float64, read-only, no copy: the vertices after mending, in model units."""
        return self._core.vertices

    @property
    def faces(self) -> Union[Array, List[Any]]:
        """Rows of `vertices`: (m, 3) uint32, read-only, no copy, while all are triangles; otherwise a list of outer
        contours, or of lists of an outer contour and its holes."""
        faces: Union[Array, List[Any]] = self._core.faces
        return faces

    @property
    def face_source(self) -> Optional[Array]:
        """(m,) uint32: of each face, the row of the faces that were given. None for files."""
        return self._core.face_source

    @property
    def object_names(self) -> List[str]:
        """Names of the objects, or their numbers."""
        return self._core.object_names

    @property
    def up_axis(self) -> str:
        """ "x", "y" or "z"."""
        return self._core.up_axis

    @property
    def unit_mm(self) -> float:
        """True length of a model unit, mm."""
        return self._core.unit_mm

    @property
    def quality(self) -> str:
        """ "clear" or "exact", for which lines it was mended."""
        return self._core.quality

    @property
    def warnings(self) -> List[str]:
        """What was mended, a line each."""
        return self._core.warnings

    def __repr__(self) -> str:
        core = self._core
        return f"<ligne.{type(self).__name__}: {core.face_count} faces, {core.edge_count} edges>"


def _scene_again(kind: Type[Scene], core: _core.Scene) -> Scene:
    scene = kind.__new__(kind)
    scene._core = core
    return scene


def read(
    *files: Path,
    quality: str = "clear",
    weld: Union[str, float] = "auto",
    merge_coplanar: bool = False,
    subdivide: Optional[str] = None,
    assume: Optional[str] = None,
    only: Union[str, Sequence[str], None] = None,
    hide: Union[str, Sequence[str], None] = None,
    move: Union[Dict[str, Sequence[float]], Sequence[str], None] = None,
    unit: Union[str, float, None] = None,
    groups: bool = False,
    pose: Optional[str] = None,
    threads: int = 0,
) -> Scene:
    """Reads glTF, OBJ, STL, PLY, OFF, 3MF, 3D Studio or ligne-scene files; several make one scene.

    `subdivide`: "catmull-clark" or "loop", with ":N" for N levels: the polygons are control meshes.
    `assume`: facts that spare tests, "no-penetration", "convex" and "adjacency", separated by commas.
    `groups`: the groups of an OBJ without objects are objects, which draw(group=..., color=...) tell apart. The others are
    the command's. Raises InputError.
    """
    options = arguments(locals(), "files", "threads")
    if not files:
        raise _core.RequestError("files: no file is given")
    return Scene(_core.read([os.fspath(f) for f in files], options, threads))


class Mesh(Scene):
    """A scene of arrays.

    vertices: (n, 3) of floats or integers, model units, finite. float32 arrays are taken to be as precise as that.
    faces: (m, k) of integers, rows of `vertices`, k corners each; or a list of m sequences of any length; an item of
        sequences is an outer contour with its holes.
    objects: (m,) names or numbers; edges join faces of one object only. None: one object.
    materials: (m,) names or numbers. colors: for each of them (red, green, blue[, opacity]) in 0 to 1.
    precision: how far coordinates may be from what they mean, model units, where that is more than the dtype tells.

    The arrays are copied once, into the scene. Raises InputError, DtypeError.
    """

    def __init__(
        self,
        vertices: Any,
        faces: Faces,
        objects: Optional[Sequence[Any]] = None,
        materials: Optional[Sequence[Any]] = None,
        *,
        colors: Optional[Dict[Any, Sequence[float]]] = None,
        precision: Optional[float] = None,
        up_axis: str = "z",
        quality: str = "clear",
        weld: Union[str, float] = "auto",
        merge_coplanar: bool = False,
        subdivide: Optional[str] = None,
        assume: Optional[str] = None,
        unit: Union[str, float, None] = None,
        threads: int = 0,
    ) -> None:
        points = vertex_array(vertices)
        corners, contour_end, face_end, count = flat_faces(faces)
        object_of, object_names = labels("objects", objects, count)
        material_of, material_names = labels("materials", materials, count)
        options = dict(quality=quality, weld=weld, merge_coplanar=merge_coplanar, subdivide=subdivide, unit=unit)
        if assume is not None:
            options["assume"] = assume
        if precision is not None and not (np.isfinite(precision) and precision >= 0):
            raise _core.InputError("precision: is not a length of 0 or more")
        super().__init__(
            _core.mesh(
                points,
                corners,
                contour_end,
                face_end,
                object_of,
                [str(name) for name in object_names],
                material_of,
                material_list(material_names, colors),
                precision,
                up_axis,
                options,
                threads,
            )
        )

    @staticmethod
    def from_trimesh(mesh: Any, **options: Any) -> Mesh:
        """A trimesh.Trimesh, or a trimesh.Scene, whose geometries become objects."""
        if hasattr(mesh, "geometry") and hasattr(mesh, "graph"):
            parts: List[Tuple[str, Any, Any]] = []
            for node in mesh.graph.nodes_geometry:
                transform, name = mesh.graph[node]
                matrix, part = np.asarray(transform), mesh.geometry[name]
                parts.append((node, np.asarray(part.vertices) @ matrix[:3, :3].T + matrix[:3, 3], np.asarray(part.faces)))
            return Mesh._of_parts(parts, options)
        return Mesh(mesh.vertices, mesh.faces, **options)

    @staticmethod
    def from_pyvista(mesh: Any, **options: Any) -> Mesh:
        """A pyvista.PolyData, or another data set of pyvista's, of which the surface is taken."""
        if not hasattr(mesh, "faces"):
            mesh = mesh.extract_surface()
        flat = np.asarray(mesh.faces)
        if len(flat) and len(flat) % (int(flat[0]) + 1) == 0 and np.all(flat.reshape(-1, int(flat[0]) + 1)[:, 0] == flat[0]):
            return Mesh(mesh.points, flat.reshape(-1, int(flat[0]) + 1)[:, 1:], **options)
        rows, at = [], 0
        while at < len(flat):
            rows.append(flat[at + 1 : at + 1 + int(flat[at])])
            at += int(flat[at]) + 1
        return Mesh(mesh.points, rows, **options)

    @staticmethod
    def from_meshio(mesh: Any, **options: Any) -> Mesh:
        """The faces (triangle, quad, polygon) of a meshio.Mesh."""
        rows: List[Array] = []
        for block in mesh.cells:
            if block.type in ("triangle", "quad") or block.type.startswith("polygon"):
                rows.extend(np.asarray(block.data))
        if rows and all(len(row) == len(rows[0]) for row in rows):
            return Mesh(mesh.points, np.array(rows), **options)
        return Mesh(mesh.points, rows, **options)

    @staticmethod
    def _of_parts(parts: Sequence[Tuple[str, Any, Any]], options: Dict[str, Any]) -> Mesh:
        first = np.cumsum([0] + [len(points) for _, points, _ in parts])
        names = [name for name, _, faces in parts for _ in range(len(faces))]
        return Mesh(
            np.concatenate([points for _, points, _ in parts]),
            np.concatenate([faces + start for (_, _, faces), start in zip(parts, first)]),
            objects=names,
            **options,
        )


def as_scene(
    model: Any,
    quality: Optional[str],
    threads: int,
    groups: bool = False,
    reading: Optional[Dict[str, Any]] = None,
) -> Scene:
    """A scene, a file, or what has vertices and faces. `reading`: options of read()."""
    if reading and not isinstance(model, (str, os.PathLike)):
        name = next(iter(reading))
        raise _core.RequestError(f"{name}: is an option of read() and needs a file here; the model has been read already")
    if isinstance(model, Scene):
        if quality is not None and quality != model.quality:
            raise _core.RequestError(
                f"quality: the scene was read for {model.quality} lines; read(quality=...) and Mesh(quality=...) choose"
            )
        return model
    kept: Dict[str, Any] = {"quality": quality or "clear", "threads": threads}
    if isinstance(model, (str, os.PathLike)):
        return read(model, groups=groups, **kept, **(reading or {}))
    if hasattr(model, "points") and hasattr(model, "faces"):
        return Mesh.from_pyvista(model, **kept)
    if hasattr(model, "points") and hasattr(model, "cells"):
        return Mesh.from_meshio(model, **kept)
    if (hasattr(model, "vertices") and hasattr(model, "faces")) or hasattr(model, "geometry"):
        return Mesh.from_trimesh(model, **kept)
    raise _core.RequestError(f"model: {type(model).__name__} is neither a scene, a file nor a mesh")
