"""What Python's own habits make people expect: positions behind z, copies, errors of the system, files that are open."""

import copy
import io
import os
import pathlib
import pickle
import shutil
import struct
import subprocess
import sys
import zlib

import ligne
import numpy as np
import pytest
from conftest import CUBE_FACES, CUBE_VERTICES, WHOLE_TIER

X, Y = np.meshgrid(np.linspace(-5, 5, 30), np.linspace(-4, 4, 20))
Z = np.sin(np.hypot(X, Y))


@pytest.mark.parametrize("x, y", [(X, Y), (X[0], Y[:, 0]), (list(X[0]), tuple(Y[:, 0]))])
def test_positions_behind_z(x, y):
    expected = ligne.surface(Z, x=X[0], y=Y[:, 0]).to_bytes()
    assert ligne.surface(Z, x, y).to_bytes() == expected
    assert ligne.surface(Z, x=x, y=y).to_bytes() == expected
    assert ligne.surface(Z, x, y=y).to_bytes() == expected


def test_ranges_behind_z():
    expected = ligne.surface("x*y", x=(-2, 2, 30), y=(-1, 1, 30)).to_bytes()
    assert ligne.surface("x*y", (-2, 2, 30), (-1, 1, 30)).to_bytes() == expected
    assert ligne.surface(lambda x, y: x * y, (-2, 2), (-1, 1)).page[0] > 0


def test_surfaces_behind_a_surface_stay_surfaces():
    three = ligne.surface(Z, Z + 3, Z + 6)
    assert three.to_bytes() != ligne.surface(Z).to_bytes()
    with pytest.raises(ligne.RequestError, match="x, y: are given both after z"):
        ligne.surface(Z, X, Y, x=X)


def test_meshgrids_of_the_other_order_are_refused():
    x, y = np.meshgrid(X[0], Y[:, 0], indexing="ij")
    with pytest.raises(ligne.InputError, match=r'x: comes from meshgrid\(indexing="ij"\)'):
        ligne.surface(Z.T, x, y)
    with pytest.raises(ligne.InputError, match="x: the shape is"):
        ligne.surface(Z, x=np.zeros((3, 4)), y=Y)


def test_a_name_of_a_file_is_no_formula():
    with pytest.raises(ligne.RequestError, match=r"z: 'volcano.csv' is the name of a file.*pathlib.Path\('volcano.csv'\)"):
        ligne.surface("volcano.csv")


def scenes(tmp_path):
    colors = {"red": (1, 0, 0), "glass": (0, 0, 1, 0.5)}
    materials = ["red", "red", "glass", "glass", "red", "glass"]
    yield ligne.Mesh(CUBE_VERTICES, CUBE_FACES, list("abcabc"), materials, colors=colors, up_axis="y", unit="cm")
    yield ligne.Mesh(CUBE_VERTICES.astype(np.float32), [[[0, 1, 3, 2]], *CUBE_FACES[1:].tolist()], quality="exact")
    file = tmp_path / "cube.stl"
    corners = CUBE_VERTICES[CUBE_FACES][:, [0, 1, 2, 0, 2, 3]].reshape(-1, 3, 3)
    file.write_text("solid\n" + "".join(
        "facet normal 0 0 0\nouter loop\n" + "".join("vertex %g %g %g\n" % tuple(p) for p in t) + "endloop\nendfacet\n"
        for t in corners) + "endsolid\n")
    yield ligne.read(file)


def test_scenes_are_pickled_and_copied(tmp_path):
    for scene in scenes(tmp_path):
        expected = ligne.draw(scene, hidden="dashed", scale="10:1").to_bytes("json")
        assert copy.copy(scene) is scene and copy.deepcopy([scene])[0] is scene
        again = pickle.loads(pickle.dumps(scene))
        assert type(again) is type(scene) and repr(again) == repr(scene)
        assert again.object_names == scene.object_names and again.quality == scene.quality
        assert ligne.draw(again, hidden="dashed", scale="10:1").to_bytes("json") == expected
        drawing = ligne.draw(again, regions=True)
        assert {r.face for r in drawing.regions} == {r.face for r in ligne.draw(scene, regions=True).regions}


def test_drawings_are_pickled_and_copied(cube):
    for drawing in (ligne.draw(cube, "front", hidden="solid", title="cube"), ligne.surface("sin(r)/r", x=(-9, 9)),
                    ligne.surface(Z, X, Y, method="appel"), ligne.surface(lambda x, y: x * y)):
        assert copy.copy(drawing) is drawing and copy.deepcopy(drawing) is drawing
        assert pickle.loads(pickle.dumps(drawing)).to_bytes() == drawing.to_bytes()
    for other in (ligne.View.perspective((1, 2, 3), (0, 0, 0)), ligne.draw(cube, regions=True).regions[0],
                  ligne.plot(ligne.draw(cube))):
        assert repr(pickle.loads(pickle.dumps(other))) == repr(other)


def test_a_broken_pickle_is_an_error(cube):
    state = list(cube._core.__getstate__())
    state[0] = state[0][:-9]
    other = cube._core.__class__.__new__(cube._core.__class__)
    with pytest.raises(ligne.InputError):
        other.__setstate__(tuple(state))


def test_arrays_are_read_only(cube):
    drawing = ligne.draw(cube, regions=True)
    arrays = [drawing.points, drawing.offsets, drawing.kind, drawing.visible, drawing.edge, drawing.faces, drawing.parameter,
              drawing.level, drawing.points3d(), drawing.matrix, drawing.regions[0].contours[0], cube.vertices]
    for array in arrays:
        with pytest.raises(ValueError, match="read-only"):
            array[...] = array
    line = drawing.polylines()[0]
    line *= 2  # a list of its own


def test_errors_of_the_system(cube, tmp_path):
    with pytest.raises(FileNotFoundError) as missing:
        ligne.draw(tmp_path / "none.stl")
    assert isinstance(missing.value, ligne.InputError) and isinstance(missing.value, ValueError)
    assert missing.value.filename == str(tmp_path / "none.stl") and missing.value.errno == 2
    assert str(missing.value) == f"{tmp_path}/none.stl: there is no such file"
    with pytest.raises(FileNotFoundError, match="none/a.svg: No such file or directory") as folder:
        ligne.draw(cube).save(tmp_path / "none" / "a.svg")
    assert isinstance(folder.value, ligne.OutputError)
    with pytest.raises(OSError) as directory:
        ligne.draw(tmp_path)
    assert isinstance(directory.value, ligne.FileError) and not isinstance(directory.value, FileNotFoundError)
    with pytest.raises(OSError):
        ligne.draw(cube).save(tmp_path, format="svg")
    with pytest.raises(FileNotFoundError):
        ligne.surface(pathlib.Path("none.csv"))
    with pytest.raises(FileNotFoundError):
        ligne.plot("none.svg")


def test_files_that_are_open(cube, tmp_path):
    drawing = ligne.draw(cube)
    binary, text = io.BytesIO(), io.StringIO()
    drawing.save(binary, format="svg")
    drawing.save(text, format="svg")
    assert binary.getvalue() == drawing.to_bytes() == text.getvalue().encode()
    with open(tmp_path / "a.hpgl", "w") as file:
        assert "strokes" in drawing.plot(file)
    assert (tmp_path / "a.hpgl").read_bytes() == drawing.to_bytes("hpgl", optimize="full")
    with open(tmp_path / "a.pdf", "wb") as file:
        drawing.save(file)
    assert (tmp_path / "a.pdf").read_bytes().startswith(b"%PDF")
    with pytest.raises(ligne.RequestError, match="file: png writes bytes"):
        drawing.save(io.StringIO(), format="png")
    with pytest.raises(ligne.RequestError, match="format: a file object without a name needs one"):
        drawing.save(io.BytesIO())
    with pytest.raises(ligne.RequestError, match="file: int is neither a path nor"):
        drawing.save(3)
    mesh = io.StringIO()
    ligne.surface("x*y").save(mesh, format="obj", as_mesh=True)
    assert mesh.getvalue().count("\nv ") > 100
    out = io.StringIO()
    assert ligne.plot(drawing, out, format="gcode").data == b"" and "G1" in out.getvalue()


@pytest.mark.parametrize("call, meant", [
    (lambda cube: ligne.draw(cube, hiden="dashed"), r"hiden: there is no such option \(hidden\?\)"),
    (lambda cube: ligne.draw(cube, pen_witdh=1), r"\(pen_width\?\)"),
    (lambda cube: ligne.surface("x", conturs=3), r"conturs: there is no such option \(contours\?\)"),
    (lambda cube: ligne.draw(cube, resolutoin=3), r"\(resolution\?\)"),
    (lambda cube: ligne.draw(cube, "isometric"), r"\(iso\?\)"),
    (lambda cube: ligne.draw(cube, device="axidraw"), r"axidraw-v3"),
    (lambda cube: ligne.draw(cube).to_bytes("svg", tilte="x"), r"\(title\?\)"),
])
def test_options_that_are_mistyped(cube, call, meant):
    with pytest.raises(ligne.RequestError, match=meant):
        call(cube)


def test_options_of_reading_go_with_files(cube, tmp_path):
    file = tmp_path / "two.obj"
    file.write_text("o a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\no b\nv 0 0 5\nv 9 0 5\nv 0 9 5\nf 4 5 6\n")
    assert ligne.draw(file, only="a").scene.object_names == ["a"]
    assert ligne.draw(file, hide=["a"]).scene.object_names == ["b"]
    with pytest.raises(ligne.RequestError, match=r"only: is an option of read\(\)"):
        ligne.draw(cube, only="a")


def test_truth_and_repr(cube):
    horizon = ligne.surface("sin(r)/r")
    assert horizon and len(horizon) == 0
    assert repr(horizon) == f"<ligne.Drawing: {len(horizon.polylines())} polylines on {horizon.page[0]:g} x {horizon.page[1]:g} mm>"
    assert repr(ligne.draw(cube)).startswith(f"<ligne.Drawing: {len(ligne.draw(cube))} strokes on ")


def test_what_has_no_meaning_is_refused_where_it_is_given(cube):
    for number in (np.nan, np.inf):
        vertices = CUBE_VERTICES.copy()
        vertices[3, 1] = number
        with pytest.raises(ligne.InputError, match="vertices: row 3 is not finite"):
            ligne.Mesh(vertices, CUBE_FACES)
        with pytest.raises(ligne.RequestError, match="eye: is not three finite numbers"):
            ligne.View.perspective((0, number, 0))
        with pytest.raises(ligne.RequestError, match="direction: is not three finite numbers"):
            ligne.draw(cube, direction=(0, number, 0))
    for call in (lambda: ligne.View.perspective((1, 2, 3), (1, 2, 3)), lambda: ligne.draw(cube, eye=(1, 2, 3), target=(1, 2, 3))):
        with pytest.raises(ligne.RequestError, match="target: is the position of the eye"):
            call()
    with pytest.raises(ligne.RequestError, match="fov: 200 is not between 0 and 180 degrees"):
        ligne.View.perspective((1, 2, 3), fov=200)


@pytest.mark.skipif(not shutil.which("mypy"), reason="mypy is not installed")
def test_types_are_strict(tmp_path):
    source = pathlib.Path(os.environ["LIGNE_SOURCE_DIR"]) / "python"
    user = tmp_path / "user.py"
    user.write_text("""
import io
from typing import List
import ligne
import numpy as np

drawing: ligne.Drawing = ligne.draw("a.stl", "iso", hidden="dashed")
lines: List[ligne.Region] = drawing.regions
drawing.save(io.StringIO(), format="svg")
with open("a.pdf", "wb") as file:
    drawing.save(file)
ligne.surface(np.zeros((3, 3)), (0, 1), (0, 1)).plot("a.hpgl")
reveal_type(drawing.points3d())
""")
    line = ["mypy", "--strict", "--python-executable", sys.executable, "--cache-dir", str(tmp_path / "cache"), "-p", "ligne"]
    environment = dict(os.environ, MYPYPATH=str(source))
    done = subprocess.run(line, cwd=source, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout
    line[-2:] = [str(user)]
    done = subprocess.run(line, cwd=tmp_path, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0 and "ndarray" in done.stdout, done.stdout + done.stderr


def png_of(picture):
    """A grey PNG of 8 bits."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    rows, columns = picture.shape
    lines = np.concatenate([np.zeros((rows, 1), np.uint8), picture], axis=1).tobytes()
    header = struct.pack(">IIBBBBB", columns, rows, 8, 0, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(lines, 1)) + chunk(b"IEND", b"")


@pytest.mark.skipif(not WHOLE_TIER, reason="ten seconds; the first tier has ThinnedHeights.PicturesAreThinnedWhileTheyAreRead")
def test_large_pictures_are_thinned(tmp_path):
    n = 4200
    at = np.arange(n)
    picture = (120 + 60 * np.sin(at / 400)[:, None] + 60 * np.cos(at / 300)).astype(np.uint8)
    (tmp_path / "a.png").write_bytes(png_of(picture))
    drawing = ligne.surface(tmp_path / "a.png")
    assert [line for line in drawing.warnings if "4200 x 4200 samples thinned: 1 of 2 rows" in line]
    kept = np.append(at[::2], n - 1)
    expected = ligne.surface(picture[::-1][np.ix_(kept, kept)], kept, kept)
    assert all(map(np.array_equal, drawing.polylines(), expected.polylines()))
    assert len(drawing.polylines()) == len(expected.polylines()) > 0
    part = ligne.surface(tmp_path / "a.png", x=(0, 50), y=(0, 50))
    assert not [line for line in part.warnings if "thinned" in line]
