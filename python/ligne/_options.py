"""What functions with many options have in common."""

from __future__ import annotations

import os
from typing import Any, Callable, Dict, Optional, Sequence, Union

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


def file_name(file: Optional[Path]) -> str:
    """Empty for none."""
    return "" if file is None else os.fspath(file)
