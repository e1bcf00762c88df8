"""Keywords are the command's options, with its defaults."""

import inspect
import os
import re
import subprocess

import ligne

# Options of the command line itself: files, what goes to a terminal, several files at once.
OF_THE_COMMAND = {"help", "output", "stats", "stats-json", "quiet", "frames", "turn"}
# Surfaces among models, which draw() does not take (docs/python.md).
OF_MIXED_SCENES = {"surface", "grid", "x", "y", "samples", "every", "z-scale", "z-range"}
OF_METHODS = {name for method in ligne.methods() for name in method["parameters"]}


def options_of_help(command):
    """Name and default of each option, as the help names them."""
    text = subprocess.run([os.environ["LIGNE_PROGRAM"], command, "--help"], capture_output=True, text=True, check=True).stdout
    options = {}
    for line in text.splitlines():
        found = re.match(r"^  (?:-\w,)?--?([a-z][a-z-]*)(.*)", line)
        if found:
            default = re.search(r"\[([^\]|]*)\](?:\s|$)", found.group(2))
            options[found.group(1)] = default.group(1) if default else None
    return options


def keywords(*functions):
    return {name: p.default for f in functions for name, p in inspect.signature(f).parameters.items()}


def is_default(default, written):
    """The help's default, as a keyword has it."""
    if isinstance(default, (int, float)) and not isinstance(default, bool):
        return float(re.match(r"-?[0-9.]+", written).group()) == float(default)
    return str(default) == written


def test_draw_has_all_options():
    given = keywords(ligne.draw, ligne.read, ligne.Drawing.save)
    for name, written in options_of_help("draw").items():
        if name in OF_THE_COMMAND or name in OF_MIXED_SCENES or name in OF_METHODS:
            continue
        keyword = name.replace("-", "_")
        assert keyword in given, name
        if written and given[keyword] is not None and given[keyword] is not False and keyword != "progress":
            assert is_default(given[keyword], written), (name, given[keyword], written)


def test_surface_has_all_options():
    given = keywords(ligne.surface, ligne.draw, ligne.Drawing.save)
    given["grid"] = None  # a path among the surfaces
    for name in options_of_help("surface"):
        if name in OF_THE_COMMAND or name == "as-mesh":
            continue
        assert name.replace("-", "_") in given, name


def test_draw_has_no_other_options():
    known = {name.replace("-", "_") for name in options_of_help("draw")}
    own = {"model", "regions", "parameters"}
    assert set(keywords(ligne.draw)) - own <= known


def test_stubs_name_what_there_is():
    from ligne import _core

    stubs = open(os.path.join(os.path.dirname(ligne.__file__), "_core.pyi")).read()
    named = set(re.findall(r"^(?:class|def) (\w+)|^(\w+):", stubs, re.M))
    named = {a or b for a, b in named}
    there = {name for name in dir(_core) if not name.startswith("__")} | {"__version__"}
    assert named == there
