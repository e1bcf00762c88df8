"""Exact hidden-line drawings of 3D meshes and surfaces.

    >>> import ligne
    >>> drawing = ligne.draw(ligne.read("gearbox.stl"), "iso", hidden="dashed")
    >>> drawing.save("gearbox.svg")

Options have the names and the defaults of the command's (an underscore for a dash); lengths are in mm, or texts with a
unit ("1.5cm"); angles are in degrees. docs/python.md has recipes.
"""

from ._core import (
    DtypeError,
    Error,
    FileError,
    InputError,
    MemoryLimitError,
    MissingFileError,
    MissingFolderError,
    OutputError,
    RequestError,
    __version__,
)
from ._compare import compare, study
from ._drawing import Drawing, draw, draw_frames
from ._found import FittedSurface, Region
from ._lists import devices, experiments, methods
from ._models import compile, info
from ._plot import Plotted, plot
from ._scene import Mesh, Scene, read
from ._surface import surface
from ._view import View

__all__ = [
    "Drawing",
    "DtypeError",
    "Error",
    "FileError",
    "FittedSurface",
    "InputError",
    "MemoryLimitError",
    "Mesh",
    "MissingFileError",
    "MissingFolderError",
    "OutputError",
    "Plotted",
    "Region",
    "RequestError",
    "Scene",
    "View",
    "__version__",
    "compare",
    "compile",
    "devices",
    "draw",
    "draw_frames",
    "experiments",
    "info",
    "methods",
    "plot",
    "read",
    "study",
    "surface",
]
