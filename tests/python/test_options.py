"""Everything that the command can do: each option of each command is a keyword with its default, or there is a reason."""

import inspect
import json
import os
import re
import subprocess

import pytest

import ligne

# The functions that a command's options are the keywords of.
FUNCTIONS = {
    "draw": [ligne.draw, ligne.draw_frames, ligne.read, ligne.Drawing.save],
    "surface": [ligne.surface, ligne.draw, ligne.Drawing.save],
    "plot": [ligne.plot],
    "info": [ligne.info, ligne.read],
    "compile": [ligne.compile, ligne.read],
    "compare": [ligne.compare, ligne.read],
    "study": [ligne.study],
    "methods": [ligne.methods],
    "devices": [ligne.devices],
}
# Options of a command that the module does not have under that name.
REASONS = {
    "help": "help(ligne.draw)",
    "output": "the argument `file` of save(), plot(), compile() and draw_frames(), or to_bytes(); a dictionary of others",
    "quiet": "nothing is written to a terminal: Drawing.warnings, Scene.warnings, Plotted.warnings",
    "set": "each setting of a method is a keyword of its own: draw(..., method='warnock', understanding='two')",
    "zbuffer-save": "files between runs of the command, for which the library has `ZBuffer` (C++)",
    "zbuffer-add": "files between runs of the command, for which the library has `ZBuffer` (C++)",
    "stream": "the file of the command is read in parts; a Scene of the module is in memory",
    "stats": "Drawing.statistics, Plotted.statistics; compare() and study() give their times",
    "stats-json": "Drawing.statistics, Plotted.statistics; compare() and study() give their times",
    ("progress", "plot", "info", "compile"): "short work; the others call back",
    ("max-memory", "compile", "study"): "the command bounds its process; the module bounds stages whose counts tell it before",
    ("json", "info", "compare", "study", "methods", "devices"): "these give dictionaries and lists",
    ("to", "draw"): "a loop over draw() with an eye for each view; draw_frames() is for models that turn",
    ("path", "draw"): "a loop over draw() with an eye for each view; draw_frames() is for models that turn",
    ("plates", "study"): "a document of the command; study() gives the figures",
    ("csv", "compare"): "the same figures as in the dictionary",
    ("list", "study"): "experiments()",
    ("format", "info"): "info() gives a dictionary",
    ("grid", "surface"): "a pathlib.Path among the surfaces",
}
OF_METHODS = {option["name"] for method in ligne.methods() for option in method["options"]}


def reason_for(option, command):
    return REASONS.get(option) or next(
        (reason for names, reason in REASONS.items() if names[0] == option and command in names[1:]), None
    )


def options_of_help(command):
    """Name and default of each option, as the help names them."""
    text = subprocess.run([os.environ["LIGNE_PROGRAM"], "help", command, "all"], capture_output=True, text=True, check=True).stdout
    options = {}
    for line in text.splitlines():
        found = re.match(r"^  (?:-\w,)?--?([a-z][a-z-]*)(.*)", line)
        if found:
            default = re.search(r"\[([^\]|]*)\](?:\s|$)", found.group(2))
            options[found.group(1)] = default.group(1) if default else None
    assert len(options) == text.count("\n  -"), "an option that this does not read"
    return options


def keywords(functions):
    """Their parameters; of equal names those of the first."""
    return {name: p for f in reversed(functions) for name, p in inspect.signature(f).parameters.items()}


def is_default(default, written):
    """The help's default, as a keyword has it."""
    if isinstance(default, (int, float)) and not isinstance(default, bool):
        return float(re.match(r"-?[0-9.]+", written).group()) == float(default)
    return str(default) == written


@pytest.mark.parametrize("command", FUNCTIONS)
def test_every_option_is_a_keyword(command):
    given = keywords(FUNCTIONS[command])
    takes_parameters = inspect.Parameter.VAR_KEYWORD in (p.kind for p in given.values())
    for name, written in options_of_help(command).items():
        if reason_for(name, command) or (takes_parameters and name in OF_METHODS):
            continue
        keyword = name.replace("-", "_")
        assert keyword in given, name
        default = given[keyword].default
        # None and False: what holds is told in words, or decided by something else; a frame has to be asked for.
        if written and default is not None and default is not False and default is not inspect.Parameter.empty:
            if callable(default) or keyword == "progress":
                continue
            assert is_default(default, written), (name, default, written)


def test_there_are_no_other_commands():
    text = subprocess.run([os.environ["LIGNE_PROGRAM"], "--help"], capture_output=True, text=True, check=True).stdout
    commands = re.findall(r"^  ([a-z]+) ", text[text.index("Subcommands:"):], re.M)
    assert set(commands) - {"ligne"} == set(FUNCTIONS)


def test_reasons_are_of_options():
    there = {command: options_of_help(command) for command in FUNCTIONS}
    for names in REASONS:
        for command in FUNCTIONS if isinstance(names, str) else names[1:]:
            assert (names if isinstance(names, str) else names[0]) in there[command] or isinstance(names, str), names


@pytest.mark.parametrize("command, own", [
    ("draw", {"model", "regions", "parameters"}),
    ("plot", {"drawing", "file"}),
    ("info", {"model", "parameters"}),
    ("compile", {"model", "file", "parameters"}),
    ("compare", {"model", "parameters"}),
    ("study", {"name", "models"}),
])
def test_no_other_keywords(command, own):
    known = {name.replace("-", "_") for name in options_of_help(command)}
    assert set(keywords(FUNCTIONS[command][:1])) - own <= known


@pytest.mark.parametrize("command, listed", [("methods", ligne.methods), ("devices", ligne.devices)])
def test_lists_are_those_of_the_command(command, listed):
    line = [os.environ["LIGNE_PROGRAM"], command, "--json"]
    assert json.loads(subprocess.run(line, capture_output=True, check=True).stdout)[command] == listed()


def test_experiments_are_those_of_the_command():
    line = [os.environ["LIGNE_PROGRAM"], "study", "--list"]
    text = subprocess.run(line, capture_output=True, text=True, check=True).stdout
    listed = [f"{one['name']} {one['section']}: {one['title']}" for one in ligne.experiments()]
    assert [" ".join(line.split()) for line in text.splitlines()] == listed


def test_stubs_name_what_there_is():
    from ligne import _core

    stubs = open(os.path.join(os.path.dirname(ligne.__file__), "_core.pyi")).read()
    named = set(re.findall(r"^(?:class|def) (\w+)|^(\w+):", stubs, re.M))
    named = {a or b for a, b in named}
    there = {name for name in dir(_core) if not name.startswith("__")} | {"__version__"}
    assert named == there
