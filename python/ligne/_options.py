"""What functions with many options have in common."""

from __future__ import annotations

import io
import os
from typing import Any, Callable, Dict, Optional, Protocol, Sequence, Tuple, Union

from numpy.typing import NDArray

from ._core import RequestError

Array = NDArray[Any]
Path = Union[str, "os.PathLike[str]"]
Length = Union[str, float]
Range = Union[str, Sequence[float]]
Pens = Union[str, Sequence[str], Dict[str, str], None]
Progress = Optional[Callable[[float], Any]]


def arguments(given: Dict[str, Any], *but: str) -> Dict[str, Any]:
    """The arguments of a function, which are its locals() where it begins, without those named; what `**parameters` took
    stands beside the others."""
    options = {name: value for name, value in given.items() if name not in but}
    return {**options.pop("parameters", {}), **options}


class Writable(Protocol):
    """A file that is open for writing, text or binary."""

    def write(self, data: Any, /) -> Any: ...


Output = Union[Path, Writable]

_SUFFIXES = {"plt": "hpgl", "hpg": "hpgl", "nc": "gcode", "ngc": "gcode"}
_TEXTS = ("svg", "json", "hpgl", "gcode", "obj")


def open_output(file: Output) -> Optional[Writable]:
    """The file object that is meant, or None for a path."""
    if isinstance(file, (str, os.PathLike)):
        return None
    if callable(getattr(file, "write", None)):
        return file
    raise RequestError(f"file: {type(file).__name__} is neither a path nor a file that is open for writing")


def format_for(file: Writable, format: Optional[str]) -> str:
    """The format as given, or by the name of the file object."""
    if format is not None:
        return format
    name = getattr(file, "name", None)
    suffix = os.path.splitext(name)[1][1:].lower() if isinstance(name, str) else ""
    if not suffix:
        raise RequestError("format: a file object without a name needs one, such as format=\"svg\"")
    return _SUFFIXES.get(suffix, suffix)


def write_to(file: Writable, data: bytes, format: str) -> None:
    """Writes bytes, or to a file of text their text."""
    if not isinstance(file, io.TextIOBase):
        file.write(data)
    elif format in _TEXTS:
        file.write(data.decode())
    else:
        raise RequestError(f"file: {format} writes bytes, but the file is open for text; open it with \"wb\"")


def file_name(file: Optional[Path]) -> str:
    """Empty for none."""
    return "" if file is None else os.fspath(file)
