"""What the other commands do: plots of drawings, facts, compiled models, frames, surfaces among models and as meshes."""

import json
import os
import subprocess

import numpy as np
import pytest
from conftest import SOURCE

import ligne

CUBES = SOURCE / "examples" / "models" / "five-cubes.obj"
SVG = b"""<svg xmlns="http://www.w3.org/2000/svg" width="80mm" height="60mm" viewBox="0 0 80 60">
<g id="a" stroke="red" stroke-width="0.5" fill="none"><path d="M10 10h50M60 40H10"/></g>
<rect x="20" y="20" width="30" height="30" fill="#404040"/><circle cx="60" cy="30" r="9" fill="blue"/></svg>"""


@pytest.fixture
def drawings(tmp_path):
    """An SVG of somebody else, and a stored study with regions."""
    (tmp_path / "foreign.svg").write_bytes(SVG)
    ligne.draw(CUBES, regions=True, hidden="dashed").save(tmp_path / "stored.json")
    return tmp_path


@pytest.mark.parametrize("name", ["foreign.svg", "stored.json"])
@pytest.mark.parametrize(
    "options, given, suffix",
    [
        ({}, [], ".svg"),
        ({"device": "hp7475a", "scale": "fit"}, ["--device", "hp7475a", "--scale", "fit"], ".hpgl"),
        ({"page": (200, 150), "margin": "2cm", "scale": "fit"}, ["--page", "200x150", "--margin", "2cm", "--scale", "fit"], ".pdf"),
        ({"hatch": "shade", "hatch_angle": {"hatch": 10, "#0000ff": 70}, "hatch_cross": ["#404040"]},
         ["--hatch", "shade", "--hatch-angle", "hatch=10", "--hatch-angle", "#0000ff=70", "--hatch-cross=#404040"], ".gcode"),
        ({"hatch_spacing": 1.5, "hatch_cross": True, "min_length": 0.5},
         ["--hatch-spacing", "1.5", "--min-length", "0.5", "--hatch-cross"], ".svg"),
        ({"pen": {"rest": "2,blue,0.3"}, "optimize": "order", "landscape": True},
         ["--pen", "rest=2,blue,0.3", "--optimize", "order", "--landscape"], ".svg"),
        ({"occlude": "layer"}, ["--occlude=layer"], ".svg"),
        ({"occlude": True, "fill": "outline", "pen_width": 0.2, "width": {"#f00": 0.9}, "scale": "1:2"},
         ["--occlude", "--fill", "outline", "--pen-width", "0.2", "--width", "#f00=0.9", "--scale", "1:2"], ".png"),
    ],
    ids=lambda value: "",
)  # fmt: skip
def test_plot(name, options, given, suffix, drawings, command):
    expected = command("plot", drawings / name, *given, suffix=suffix)
    file = drawings / ("by_module" + suffix)
    plotted = ligne.plot(drawings / name, file, **options)
    assert file.read_bytes() == expected and plotted.data == b""
    assert ligne.plot((drawings / name).read_bytes(), format=suffix[1:], **options).data == expected


def test_plot_of_a_drawing_and_what_it_tells(drawings):
    drawing = ligne.draw(CUBES)
    assert ligne.plot(drawing).data == ligne.plot(drawing.to_bytes("json")).data
    plotted = ligne.plot(SVG, drawings / "a.hpgl", report=True, preview=drawings / "way.svg", device="hp7475a", scale="fit")
    assert "min" in str(plotted) and "strokes" in plotted.report and (drawings / "way.svg").stat().st_size > 500
    assert any("filled areas are drawn by the outline" in line for line in plotted.warnings)
    assert "write" in plotted.statistics["stages"]


@pytest.mark.parametrize(
    "options, given, name",
    [
        ({"split": "lifts=2"}, ["--split", "lifts=2"], "part%02d.gcode"),
        ({"split": "distance=0.1m", "every": "9cm", "do": "dip"},
         ["--split", "distance=0.1m", "--every", "9cm", "--do", "dip"], "part.gcode"),
        ({"from_stroke": 2, "pen": {"#0000ff": 2, "rest": 1}, "park": "home"},
         ["--from-stroke", "2", "--pen", "#0000ff=2", "--pen", "rest=1", "--park", "home"], "pen%p.gcode"),
        ({"from_time": "3s"}, ["--from-time", "3s"], "rest.gcode"),
        ({"scale": "4:1", "tile": "A4", "overlap": 8}, ["--scale", "4:1", "--tile", "A4", "--overlap", "8"], "sheet%d.svg"),
        ({"scale": "4:1", "tile": (150, 200)}, ["--scale", "4:1", "--tile", "150x200"], "sheets.pdf"),
    ],
    ids=lambda value: "",
)  # fmt: skip
def test_long_plots(options, given, name, drawings):
    by_module, by_command = drawings / "by_module", drawings / "by_command"
    by_module.mkdir()
    by_command.mkdir()
    line = ["plot", drawings / "foreign.svg", *given, "-q", "-o", by_command / name]
    subprocess.run([os.environ["LIGNE_PROGRAM"], *line], check=True)
    plotted = ligne.plot(drawings / "foreign.svg", by_module / name, **options)
    names = sorted(file.name for file in by_command.iterdir())
    assert sorted(os.path.basename(file) for file in plotted.files) == names and (len(names) > 1) == ("%" in name)
    for file in names:
        assert (by_module / file).read_bytes() == (by_command / file).read_bytes()


def test_several_drawings(drawings):
    files = [drawings / "foreign.svg"] * 3
    line = ["plot", *files, "--grid", "2x2", "--page", "A3", "-q", "-o", drawings / "all.svg"]
    subprocess.run([os.environ["LIGNE_PROGRAM"], *line], check=True)
    assert ligne.plot(files, grid=(2, 2), page="A3").data == (drawings / "all.svg").read_bytes()
    done = subprocess.run([os.environ["LIGNE_PROGRAM"], "plot", "-", "-o", "-", "--format", "svg", "-q"], input=SVG, capture_output=True)
    assert done.stdout == ligne.plot(SVG).data
    assert len(ligne.plot(SVG, device="grbl-servo", format="gcode", split="lifts=1").parts) > 2


@pytest.mark.parametrize(
    "drawing, options, error, text",
    [
        (3, {}, ligne.RequestError, "drawing"),
        (b"nothing", {}, ligne.Error, "drawing: is neither"),
        ("missing.svg", {}, ligne.InputError, "missing.svg"),
        (SVG, {"format": "json"}, ligne.RequestError, "format"),
        (SVG, {"fill": "red"}, ligne.RequestError, "fill"),
        (SVG, {"skip": "lines"}, ligne.RequestError, "skip"),
        (SVG, {"hatch_spacing": {"red": -1}}, ligne.RequestError, "hatch_spacing"),
        (SVG, {"hatch_cross": object()}, ligne.RequestError, "hatch_cross"),
        (SVG, {"margin": 90, "scale": "fit"}, ligne.RequestError, "margin"),
        (SVG, {"device": "nothing"}, ligne.RequestError, "device"),
        ([SVG, SVG], {}, ligne.RequestError, "several drawings"),
        ([], {}, ligne.RequestError, "drawing"),
        (SVG, {"split": "lots"}, ligne.RequestError, "split"),
        (SVG, {"every": "3m"}, ligne.RequestError, "every"),
    ],
    ids=lambda value: "",
)
def test_wrong_plots(drawing, options, error, text):
    with pytest.raises(error, match=text):
        ligne.plot(drawing, **options)


def test_every_device(command, tmp_path):
    """With the default page, whatever the limits: a drawing that fits does so by itself."""
    drawing = ligne.draw(CUBES)
    for device in ligne.devices():
        suffix = "." + device["language"]
        if suffix != ".svg":
            expected = command("draw", CUBES, "--device", device["name"], suffix=suffix)
            drawing.save(tmp_path / ("a" + suffix), device=device["name"])
            assert (tmp_path / ("a" + suffix)).read_bytes() == expected, device["name"]


@pytest.mark.parametrize("options, given", [
    ({}, []),
    ({"view": "top", "cull": True}, ["--view", "top", "--cull"]),
    ({"eye": (9, 6, 14), "scale": "1:2", "unit": "cm", "page": "A3"},
     ["--eye", "9,6,14", "--scale", "1:2", "--unit", "cm", "--page", "A3"]),
    ({"quality": "exact", "method": "bsp", "candidates": 3},
     ["--quality", "exact", "--method", "bsp", "--candidates", "3"]),
], ids=lambda value: "")  # fmt: skip
def test_info(options, given, command):
    assert ligne.info(CUBES, **options) == json.loads(command("info", CUBES, "--json", *given))


def test_info_of_arrays(cube):
    facts = ligne.info(cube)
    assert facts["scene"]["faces"] == 6 and facts["scene"]["edges"] == 12 and facts["view"]["edges"]["outline"] == 6
    with pytest.raises(ligne.RequestError, match="nothing"):
        ligne.info(cube, nothing=1)


@pytest.mark.parametrize("method", ["bsp", "convex-tree"])
def test_compile(method, command, tmp_path, cube):
    tree = tmp_path / "by_module.tree"
    ligne.compile(CUBES, tree, method=method, candidates=4)
    assert tree.read_bytes() == command("compile", CUBES, "--method", method, "--candidates", "4", suffix=".tree")
    assert ligne.draw(tree, "front").to_bytes("json") == command("draw", tree, "--view", "front")
    with pytest.raises(ligne.RequestError, match="^candidates"):
        ligne.draw(tree, candidates=3)
    with pytest.raises(ligne.RequestError, match="^model"):
        ligne.compile(ligne.read(tree), tmp_path / "again.tree")
    with pytest.raises(ligne.RequestError, match="^method"):
        ligne.compile(cube, tmp_path / "b.tree", method="appel")
    with pytest.raises(ligne.RequestError, match="^nothing"):
        ligne.compile(cube, tmp_path / "b.tree", nothing=1)


@pytest.mark.parametrize("name, options, given", [
    ("turn%02d.svg", {"turn": 90, "hidden": "dashed"}, ["--turn", "90", "--hidden", "dashed"]),
    ("turn.pdf", {"view": "front", "page": "A5"}, ["--view", "front", "--page", "A5"]),
], ids=["files", "pages"])  # fmt: skip
def test_frames(name, options, given, tmp_path, cube):
    told = []
    files = ligne.draw_frames(CUBES, tmp_path / name, frames=3, progress=told.append, **options)
    line = ["draw", CUBES, "--frames", "3", *given, "-q", "-o", tmp_path / name.replace("turn", "by_command")]
    subprocess.run([os.environ["LIGNE_PROGRAM"], *line], check=True)
    assert len(files) == (3 if "%" in name else 1)
    for file in files:
        expected = file.replace("turn", "by_command")
        assert open(file, "rb").read() == open(expected, "rb").read(), file
    for wrong, error in [(tmp_path / "one.svg", "output"), (tmp_path / "one.xyz", "format")]:
        with pytest.raises(ligne.RequestError, match=f"^{error}"):
            ligne.draw_frames(cube, wrong, frames=3)
    with pytest.raises(ligne.RequestError, match="^frames"):
        ligne.draw_frames(cube, tmp_path / name, frames=0)


@pytest.mark.parametrize("options, given", [
    ({"surface": "sin(x)+1"}, ["--surface", "sin(x)+1"]),
    ({"surface": ["x/9+1", "1-y/9"], "x": (-60, 60, 20), "y": "-60:60:30", "samples": 99, "z_scale": 2, "z_range": (-1, 9)},
     ["--surface", "x/9+1", "--surface", "1-y/9", "-x", "-60:60:20", "-y", "-60:60:30", "--samples", "99", "--z-scale", "2",
      "--z-range=-1:9"]),
], ids=["one", "two"])  # fmt: skip
def test_surfaces_among_models(options, given, command):
    drawing = ligne.draw(CUBES, **options)
    assert drawing.to_bytes("svg") == command("draw", CUBES, *given, suffix=".svg")
    assert "horizon" in set(drawing.kind)


def test_grids_and_arrays_among_models(command, tmp_path, cube):
    z = np.add.outer(np.linspace(0, 0.5, 12), np.linspace(0, 0.5, 15))
    file = tmp_path / "z.csv"
    np.savetxt(file, z, delimiter=",", fmt="%.17g")
    expected = command("draw", CUBES, "--grid", file, "--every", "2", suffix=".svg")
    assert ligne.draw(CUBES, grid=file, every=2).to_bytes() == expected
    assert ligne.draw(CUBES, surface=z, every=2).to_bytes() == expected
    with pytest.raises(ligne.RequestError, match="--surface"):
        ligne.draw(cube, samples=9)
    with pytest.raises(ligne.InputError, match="^z"):
        ligne.draw(cube, surface=np.zeros(3))


@pytest.mark.parametrize("suffix", [".obj", ".json"])
def test_surfaces_as_meshes(suffix, command, tmp_path, cube):
    expected = command("surface", "x*y", "-x", "-2:2:9", "-y", "-2:2:9", "--skirt", "--as-mesh", suffix=suffix)
    drawing = ligne.surface("x*y", x=(-2, 2, 9), y=(-2, 2, 9), skirt=True)
    drawing.save(tmp_path / ("a" + suffix), as_mesh=True)
    assert (tmp_path / ("a" + suffix)).read_bytes() == drawing.to_bytes(suffix[1:], as_mesh=True) == expected
    for wrong in (lambda: drawing.save(tmp_path / "a.stl", as_mesh=True), lambda: ligne.draw(cube).to_bytes("obj", as_mesh=True)):
        with pytest.raises(ligne.RequestError, match="^as_mesh"):
            wrong()


def test_names_that_are_not_there():
    with pytest.raises(ligne.RequestError, match="^pen: no material is called"):
        ligne.draw(CUBES, pen="material:nonsense=2")
    with pytest.raises(ligne.RequestError, match="^color: no object is called"):
        ligne.draw(CUBES, color={"nonsense": "red"})
