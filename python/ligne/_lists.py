"""What there is to choose from."""

from __future__ import annotations

import json
from typing import Any, Dict, List

from . import _core


def methods() -> List[Dict[str, Any]]:
    """The visibility methods, as `ligne methods --json` lists them: name, summary, produces, exact, penetration, paper,
    options and so on."""
    listed: List[Dict[str, Any]] = json.loads(_core.methods())["methods"]
    return listed


def devices() -> List[Dict[str, Any]]:
    """The plotters known, as `ligne devices --json` lists them: name, title, language, step_mm, pens, papers or limits_mm,
    speeds and so on."""
    listed: List[Dict[str, Any]] = json.loads(_core.devices())["devices"]
    return listed


def experiments() -> List[Dict[str, str]]:
    """The experiments that study() makes again, as `ligne study --list` lists them: name, section (of the source), title."""
    return [dict(zip(("name", "section", "title"), one)) for one in _core.experiments()]
