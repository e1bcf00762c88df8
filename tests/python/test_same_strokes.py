"""The module draws what the command draws, to the last bit."""

import base64
import json

import numpy as np
import pytest
from conftest import CUBE_FACES, CUBE_VERTICES, MODELS, SOURCE, chosen

import ligne

EXAMPLES = ["five-cubes.obj", "gear-pair.json", "pipe-tee.json", "stair-tower.obj"]
CORPUS = ["cyclic_4.json", "book_three.json", "concave_plate_with_hole.json", "grazing_penetration.json"]
OTHERS = ["cornell_box.obj", "no_indices_3storybuilding.glb", "octagonal_pocket.ply", "featuretype.stl", "TESTI.ASC"]
FILES = (
    [SOURCE / "examples" / "models" / name for name in EXAMPLES]
    + [SOURCE / "tests" / "corpus" / name for name in CORPUS]
    + [MODELS / name for name in OTHERS if (MODELS / name).exists()]
)
METHODS = ["auto"] + [method["name"] for method in ligne.methods()]
WAYS = [({}, []), ({"quality": "exact", "hidden": "dashed"}, ["--quality", "exact", "--hidden", "dashed"])]


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.name)
def test_strokes_of_all_methods(file, command, tmp_path, strokes_of):
    for method in chosen(METHODS, file.name, 4):
        for options, given in chosen(WAYS, file.name + method, 2):
            expected = command("draw", file, "--method", method, *given)
            drawing = ligne.draw(file, method=method, **options)
            assert drawing.to_bytes("json") == expected, (file.name, method)
            check_arrays(drawing, strokes_of(expected))


def check_arrays(drawing, strokes):
    assert len(drawing) == len(strokes)
    assert drawing.kind.tolist() == [stroke["class"] for stroke in strokes]
    assert drawing.visible.tolist() == [stroke["visible"] for stroke in strokes]
    if not strokes:
        return
    points = np.array([stroke["points"] for stroke in strokes]).reshape(-1, 2)
    np.testing.assert_allclose(drawing.points, points, rtol=0, atol=1e-6)  # as many digits as JSON has
    np.testing.assert_allclose(drawing.parameter, [stroke["interval"] for stroke in strokes], rtol=1e-6, atol=1e-9)


@pytest.mark.parametrize("suffix", [".svg", ".pdf", ".png", ".hpgl", ".gcode"])
def test_files(suffix, command, tmp_path):
    file = FILES[0]
    expected = command("draw", file, "--hidden", "dashed", "--title", "five", suffix=suffix)
    drawing = ligne.draw(file, hidden="dashed", title="five")
    drawing.save(tmp_path / ("by_module" + suffix))
    assert (tmp_path / ("by_module" + suffix)).read_bytes() == expected


@pytest.mark.parametrize(
    "options, given",
    [
        ({"view": "trimetric", "edges": "all"}, ["--view", "trimetric", "--edges", "all"]),
        ({"direction": (1, 2, -3), "up": (0, 0, 1), "page": "A3"}, ["--direction", "1,2,-3", "--up", "0,0,1", "--page", "A3"]),
        ({"eye": (9, 6, 14), "fov": 40, "scale": "fit"}, ["--eye", "9,6,14", "--fov", "40", "--scale", "fit"]),
        ({"scale": "5:1", "unit": "cm", "margin": "1cm"}, ["--scale", "5:1", "--unit", "cm", "--margin", "1cm"]),
        ({"hatch": "shade", "light": (1, 2, -3), "hatch_angle": "face"}, ["--hatch", "shade", "--light", "1,2,-3", "--hatch-angle", "face"]),
        ({"fill": "shade", "width": {"profile": 0.7, "crease": 0.25}}, ["--fill", "shade", "--width", "profile=0.7,crease=0.25"]),
        ({"edges": "outline,suggestive,ridge,valley"}, ["--edges", "outline,suggestive,ridge,valley"]),
        ({"profile": "parts", "min_length": 0.2}, ["--profile", "parts", "--min-length", "0.2"]),
        ({"method": "warnock", "resolution": 64}, ["--method", "warnock", "--set", "resolution=64"]),
        ({"pen": {"outline": "1,black,0.5", "rest": "2,blue"}}, ["--pen", "outline=1,black,0.5", "--pen", "rest=2,blue"]),
        ({"group": "object", "color": {"*": "red"}}, ["--group", "object", "--color", "*=red"]),
    ],
    ids=lambda value: "-".join(value) if isinstance(value, dict) else "",
)
def test_options(options, given, command):
    file = FILES[0]
    options = dict(options)
    scene = ligne.read(file, groups="group" in options, unit=options.get("unit"))
    expected = command("draw", file, *given, suffix=".svg")
    assert ligne.draw(scene, **options).to_bytes("svg") == expected


def test_gray_faces(command):
    expected = command("draw", FILES[0], "--shade", "--method", "watkins", "--dpi", "40", suffix=".png")
    assert ligne.draw(FILES[0], method="watkins", dpi=40).to_bytes("png", shade=True) == expected


def test_views_of_one_scene_are_those_of_single_runs(command):
    scene = ligne.read(FILES[1])
    for view in ["front", "top", "right", "iso"]:
        assert ligne.draw(scene, view).to_bytes("json") == command("draw", FILES[1], "--view", view)


def test_a_mesh_of_arrays_is_the_mesh_of_a_file(command, tmp_path):
    file = tmp_path / "cube.ply"
    head = "ply\nformat ascii 1.0\nelement vertex 8\nproperty double x\nproperty double y\nproperty double z\n"
    head += "element face 6\nproperty list uchar int vertex_indices\nend_header\n"
    lines = [f"{x:g} {y:g} {z:g}" for x, y, z in CUBE_VERTICES] + ["4 " + " ".join(map(str, face)) for face in CUBE_FACES]
    file.write_text(head + "\n".join(lines) + "\n")
    drawing = ligne.draw(ligne.Mesh(CUBE_VERTICES, CUBE_FACES))
    assert drawing.to_bytes("json") == command("draw", file)


def test_a_camera_of_the_file(command, tmp_path):
    file = tmp_path / "triangle.gltf"
    points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], np.float32).tobytes()
    uri = "data:application/octet-stream;base64," + base64.b64encode(points).decode()
    gltf = {
        "asset": {"version": "2.0"},
        "scenes": [{"nodes": [0, 1]}],
        "scene": 0,
        "nodes": [{"mesh": 0}, {"camera": 0, "name": "near", "translation": [0.3, 0.3, 4]}],
        "cameras": [{"type": "perspective", "name": "near", "perspective": {"yfov": 0.7, "znear": 0.1}}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}],
        "bufferViews": [{"buffer": 0, "byteLength": len(points)}],
        "buffers": [{"byteLength": len(points), "uri": uri}],
    }
    file.write_text(json.dumps(gltf))
    for view in ("camera", "camera:near"):
        assert ligne.draw(file, view).to_bytes("json") == command("draw", file, "--view", view)
    with pytest.raises(ligne.RequestError, match="camera"):
        ligne.draw(file, "camera:far")


@pytest.mark.parametrize("threads", [1, 2])
def test_threads_change_nothing(threads, command):
    assert ligne.draw(FILES[1], threads=threads).to_bytes("json") == command("draw", FILES[1])
