"""What there is to choose from."""

from __future__ import annotations

from typing import Any, Dict, List

from . import _core


def methods() -> List[Dict[str, Any]]:
    """The visibility methods: name, summary, products, exact, penetration, paper, parameters."""
    return _core.methods()


def devices() -> List[Dict[str, Any]]:
    """The plotters known: name, title, language, number of pens."""
    return _core.devices()
