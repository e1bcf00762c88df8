"""What the other commands do: plots of drawings, facts, comparisons, experiments, compiled models, frames, surfaces among
models and as meshes."""

import json
import os
import re
import signal
import subprocess

import numpy as np
import pytest
from conftest import SOURCE, WHOLE_TIER, chosen, grid_mesh

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
    for device in chosen(ligne.devices(), "devices", 4):
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
     ["--quality", "exact", "--method", "bsp", "--set", "candidates=3"]),
], ids=lambda value: "")  # fmt: skip
def test_info(options, given, command):
    assert ligne.info(CUBES, **options) == json.loads(command("info", CUBES, "--json", *given))


def test_info_of_arrays(cube):
    facts = ligne.info(cube)
    assert facts["scene"]["faces"] == 6 and facts["scene"]["edges"] == 12 and facts["view"]["edges"]["outline"] == 6
    with pytest.raises(ligne.RequestError, match="nothing"):
        ligne.info(cube, nothing=1)


def without_measures(comparison):
    """A comparison without what no two runs have in common: times and memory."""
    for method in comparison["methods"]:
        assert method["seconds"] >= 0 and method["stages"].keys() >= {"study", "join"} or not method["drawn"]
        for measured in ("stages", "processor_seconds", "phases"):
            method[measured] = sorted(method[measured])
        del method["seconds"], method["peak_bytes"]
    return comparison


@pytest.mark.parametrize("options, given", [
    ({}, []),
    ({"view": "top", "methods": ["appel", "painter", "watkins"], "lines": 256, "hidden": "dashed", "cull": True},
     ["--view", "top", "--methods", "appel,painter,watkins", "--lines", "256", "--hidden", "dashed", "--cull"]),
    ({"eye": (9, 6, 14), "methods": "bsp,zbuffer,convex-tree", "candidates": 3, "edges": "all", "quality": "exact",
      "page": "A5", "margin": "2cm", "width": {"crease": 0.2}, "time_limit": 20},
     ["--eye", "9,6,14", "--methods", "bsp,zbuffer,convex-tree", "--set", "candidates=3", "--edges", "all", "--quality",
      "exact", "--page", "A5", "--margin", "2cm", "--width", "crease=0.2", "--time-limit", "20"]),
], ids=["all", "some", "parameters"])  # fmt: skip
def test_compare(options, given, command):
    expected = without_measures(json.loads(command("compare", CUBES, "--json", *given)))
    assert without_measures(ligne.compare(CUBES, **options)) == expected


def test_compare_of_a_compiled_model(command, tmp_path):
    """Which every method prepares by itself, also the one that it was compiled for."""
    tree = tmp_path / "a.tree"
    ligne.compile(CUBES, tree)
    options = {"methods": "appel,bsp", "candidates": 2}
    expected = json.loads(command("compare", tree, "--json", "--methods", "appel,bsp", "--set", "candidates=2"))
    assert without_measures(ligne.compare(tree, **options)) == without_measures(expected)


def test_pages_of_comparisons(command, tmp_path, cube):
    by_command, by_module = tmp_path / "by_command.html", tmp_path / "by_module.html"
    command("compare", CUBES, "--methods", "appel,painter", "--html", by_command)
    told = []
    ligne.compare(CUBES, methods="appel,painter", html=by_module, progress=told.append)
    pages = [re.sub(r"<h2>Lines, time.*?</table>|<figcaption>.*?</figcaption>", "", file.read_text(), flags=re.S)
             for file in (by_command, by_module)]  # fmt: skip
    assert pages[0] == pages[1] and "<svg" in pages[0] and told[-1] == 1
    assert ligne.compare(cube, methods="appel,bsp")["differences_mm"] == [[0, 0], [0, 0]]


@pytest.mark.parametrize("options, option", [
    ({"methods": "appel,nothing"}, "methods"),
    ({"methods": "auto"}, "methods"),
    ({"methods": ["bsp", "bsp"]}, "methods"),
    ({"methods": "appel", "resolution": 64}, "resolution"),
    ({"resolution": "nothing"}, "resolution"),
    ({"hatch": "shade"}, "hatch"),
    ({"time_limit": -1}, "time_limit"),
    ({"html": ""}, "html"),
    ({"margin": 200}, "margin"),
], ids=lambda value: "")  # fmt: skip
def test_wrong_comparisons(options, option, cube):
    with pytest.raises(ligne.RequestError, match=f"^{option}") as raised:
        ligne.compare(cube, **options)
    assert raised.value.option == option


def test_comparisons_that_end(cube):
    """By their own limit, which is told; and from outside, which ends them as a whole, before any limit."""
    ended = ligne.compare(ligne.Mesh(*grid_mesh(100)), methods="newell", time_limit=0)["methods"][0]
    assert not ended["drawn"] and ended["failure"] == "ended after 0 s"

    class Enough(Exception):
        pass

    def enough(_):
        raise Enough

    with pytest.raises(Enough):
        ligne.compare(ligne.Mesh(*grid_mesh(100)), progress=enough)
    scene = ligne.Mesh(*grid_mesh(200))
    signal.setitimer(signal.ITIMER_REAL, 0.3)
    before = signal.signal(signal.SIGALRM, lambda *_: enough(0))
    try:
        with pytest.raises(Enough):
            ligne.compare(scene)
    finally:
        signal.signal(signal.SIGALRM, before)


def counted(study):
    """The tables of a study without what is measured by a clock, and the sentences that are made of it."""
    for experiment in study["experiments"]:
        del experiment["finding"], experiment["sentence"]
        for table in experiment["tables"]:
            timed = {i for i, column in enumerate(table["columns"]) if column["kind"] == "time"}
            table["rows"] = [[cell for i, cell in enumerate(row) if i not in timed] for row in table["rows"]]
    return study


ALL = [["all"]] if WHOLE_TIER else [[name] for name in chosen([one["name"] for one in ligne.experiments()], "study", 8)]


@pytest.mark.parametrize("words", [["squares"], ["coherence", CUBES], *ALL], ids=lambda words: "-".join(map(str, words[:1])))
def test_study(words, tmp_path):
    line = [os.environ["LIGNE_PROGRAM"], "study", *words, "--size", "small", "-q", "--json", "-"]
    expected = json.loads(subprocess.run(line, capture_output=True, check=True).stdout)
    told = []
    study = ligne.study(*words, size="small", progress=told.append)
    assert told[-1] == 1 and len(study["experiments"]) == (1 if words[0] != "all" else len(ligne.experiments()))
    assert counted(study) == counted(expected)


def test_files_of_studies(tmp_path):
    line = ["study", "translation", "--size", "small", "-q", "--csv", tmp_path / "a.csv", "--svg", tmp_path / "a.svg"]
    subprocess.run([os.environ["LIGNE_PROGRAM"], *line], capture_output=True, check=True)
    ligne.study("translation", size="small", csv=tmp_path / "b.csv", svg=tmp_path / "b.svg")
    for suffix in (".csv", ".svg"):
        assert (tmp_path / f"a{suffix}").read_bytes() == (tmp_path / f"b{suffix}").read_bytes()


@pytest.mark.parametrize("words, options, option", [
    (["nothing"], {}, "name"),
    (["squares"], {"size": "huge"}, "size"),
    (["squares"], {"svg": ""}, "svg"),
    (["windows"], {"size": "small", "svg": "none.svg", "csv": "none.csv"}, "svg"),
], ids=lambda value: "")  # fmt: skip
def test_wrong_studies(words, options, option, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(ligne.RequestError, match=f"^{option}"):
        ligne.study(*words, **options)
    with pytest.raises(ligne.InputError, match="none.obj"):
        ligne.study("coherence", "none.obj", size="small")
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("method", ["bsp", "convex-tree"])
def test_compile(method, command, tmp_path, cube):
    tree = tmp_path / "by_module.tree"
    ligne.compile(CUBES, tree, method=method, candidates=4)
    assert tree.read_bytes() == command("compile", CUBES, "--method", method, "--set", "candidates=4", suffix=".tree")
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
    ({"parametric": [("60*u", "60*v", "u*v+1")], "u": (0, 1, 9), "v": "0:1:9"},
     ["--parametric", "60*u", "60*v", "u*v+1", "-u", "0:1:9", "-v", "0:1:9"]),
], ids=["one", "two", "parametric"])  # fmt: skip
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


def test_no_input_is_overwritten(tmp_path):
    """What was read is never written over, by whatever name."""
    model, tree = tmp_path / "cubes.obj", tmp_path / "link.tree"
    model.write_bytes(CUBES.read_bytes())
    tree.symlink_to(model)
    page, link = tmp_path / "page.html", tmp_path / "link.svg"
    page.symlink_to(model)
    link.symlink_to(model)
    foreign = tmp_path / "foreign.svg"
    foreign.write_bytes(SVG)
    for write in (
        lambda: ligne.compare(model, methods="appel,newell", html=page),
        lambda: ligne.compile(model, tree),
        lambda: ligne.draw(model).save(link),
        lambda: ligne.draw(model).save(model, format="svg"),
        lambda: ligne.draw(model, optimize="full").save(tmp_path / "a.svg", preview=link),
        lambda: ligne.draw_frames(model, tmp_path / "cubes.obj", frames=2, format="pdf"),
        lambda: ligne.plot(foreign, foreign),
    ):
        with pytest.raises(ligne.RequestError, match="is also an input file"):
            write()
    assert model.read_bytes() == CUBES.read_bytes() and foreign.read_bytes() == SVG
