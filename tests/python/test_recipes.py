"""The recipes of docs/python.md and the programs of examples/python run as they are written.

Where trimesh, pyvista or CadQuery are not installed, stand-ins with their names take their places.
"""

import ast
import pathlib
import re
import subprocess
import sys

import numpy as np
import pytest
from conftest import CUBE_FACES, CUBE_VERTICES, SOURCE

import ligne

sys.path.append(str(pathlib.Path(__file__).parent / "stand_ins"))

PAGE = (SOURCE / "docs" / "python.md").read_text()
RECIPES = re.findall(r"^### (\d+)\. ([^\n]*)\n.*?^```python\n(.*?)^```", PAGE, re.M | re.S)
MADE = {
    "1": ["bracket.svg"],
    "2": ["base.pdf"],
    "3": ["cone.svg"],
    "4": ["part.svg"],
    "5": [f"frame{n:02}.png" for n in range(12)] + ["turn.pdf"],
    "6": ["by_face.png"],
    "9": ["deflection.pdf"],
    "10": ["bracket.hpgl", "way.svg", "bracket.gcode"],
}


def write_bracket(file):
    """Two boxes that touch, as a binary STL."""
    boxes = [CUBE_VERTICES * (60, 30, 10), CUBE_VERTICES * (10, 30, 30) + (0, 0, 10)]
    corners = np.concatenate([CUBE_FACES[:, [0, 1, 2]], CUBE_FACES[:, [0, 2, 3]]])
    write_stl(file, np.concatenate([box[corners] for box in boxes]))


def bored_plate(radius, height, facets=24):
    """Triangles of a square plate of side 12 with a bore in its middle, about (10, 8)."""
    angle = 2 * np.pi * np.arange(facets) / facets
    way = np.column_stack([np.cos(angle), np.sin(angle)])
    square = 6 * way / np.abs(way).max(axis=1)[:, None]
    rings = [np.column_stack([ring + (10, 8), np.full(facets, z)]) for ring in (radius * way, square) for z in (0, height)]
    inner_low, inner_high, outer_low, outer_high = rings
    triangles = []
    for low, high in ((inner_high, inner_low), (outer_low, outer_high), (inner_low, outer_low), (outer_high, inner_high)):
        a, b, c, d = low, np.roll(low, -1, axis=0), np.roll(high, -1, axis=0), high
        triangles += [np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)]
    return np.concatenate(triangles)


def write_stl(file, triangles):
    """A binary STL of (n, 3, 3) corners."""
    record = np.zeros(len(triangles), dtype=[("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("rest", "<u2")])
    record["corners"] = triangles
    file.write_bytes(bytes(80) + np.uint32(len(triangles)).tobytes() + record.tobytes())


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    write_bracket(tmp_path / "bracket.stl")
    write_stl(tmp_path / "plate.stl", bored_plate(radius=2.5, height=5))
    return tmp_path


def test_there_are_eleven():
    assert [number for number, _, _ in RECIPES] == [str(n) for n in range(1, 12)]


@pytest.mark.parametrize("number, title, code", RECIPES, ids=[f"{n}-{t}" for n, t, _ in RECIPES])
def test_recipe(number, title, code, folder, capsys):
    names = {}
    exec(compile(code, f"docs/python.md, recipe {number}", "exec"), names)
    for file in MADE.get(number, []):
        assert (folder / file).stat().st_size > 500, file
    if number == "7":
        assert names["area"][2] == pytest.approx(200) and names["area"].sum() == pytest.approx(200)
    if number == "8":
        last = ast.parse(code).body[-1]
        shown = eval(compile(ast.Expression(last.value), "cell", "eval"), names)
        assert shown._repr_svg_().startswith("<?xml") and "<path" in shown._repr_svg_()
    if number == "10":
        assert "min" in capsys.readouterr().out
    if number == "11":
        assert capsys.readouterr().out == "diameter 5.00 at 10.00, 8.00, 0.00, depth 5.00\n"


def test_shapely(folder):
    lines = ligne.draw("bracket.stl").to_shapely()
    assert lines.length > 100 and len(lines.geoms) == len(ligne.draw("bracket.stl").polylines())


@pytest.mark.parametrize("program", sorted((SOURCE / "examples" / "python").glob("*.py")), ids=lambda p: p.name)
def test_example(program, folder):
    line = [sys.executable, str(program), "bracket.stl"]
    done = subprocess.run(line, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stdout or len(list(folder.iterdir())) > 1
