"""Surfaces from formulas, files, arrays and functions."""

import numpy as np
import pytest

import ligne


@pytest.mark.parametrize(
    "arguments, options, given",
    [
        (["sin(r)/r"], {"x": (-8, 8, 50), "y": (-8, 8, 50)}, ["sin(r)/r", "-x", "-8:8:50", "-y", "-8:8:50"]),
        (["sin(x)*y"], {"hidden": "dashed"}, ["sin(x)*y", "--hidden", "dashed"]),
        (["x^2+y^2", "8-x^2-y^2"], {"z_range": (0, 8)}, ["x^2+y^2", "8-x^2-y^2", "--z-range", "0:8"]),
        (["sin(r)/r"], {"axes": True, "title": "t", "contours": 7}, ["sin(r)/r", "--axes", "--title", "t", "--contours", "7"]),
        (["cos(x)+cos(y)"], {"ridgeline": True}, ["cos(x)+cos(y)", "--ridgeline"]),
        (["x*y"], {"horizon": "pixels", "resolution": 500}, ["x*y", "--horizon", "pixels", "--resolution", "500"]),
        (["x*y"], {"skirt": -30, "azimuth": 20, "elevation": 50}, ["x*y", "--skirt=-30", "--azimuth", "20", "--elevation", "50"]),
        ([], {"parametric": [("(3+cos(v))*cos(u)", "(3+cos(v))*sin(u)", "sin(v)")]},
         ["--parametric", "(3+cos(v))*cos(u)", "(3+cos(v))*sin(u)", "sin(v)"]),
        (["x*y"], {"method": "newell", "underside": "same"}, ["x*y", "--method", "newell"]),
    ],
    ids=lambda value: "",
)
def test_same_as_the_command(arguments, options, given, command):
    drawing = ligne.surface(*arguments, **options)
    assert drawing.to_bytes("svg") == command("surface", *given, suffix=".svg")


def test_arrays_functions_and_files(tmp_path, command):
    x, y = np.linspace(-2, 2, 30), np.linspace(-1, 1, 20)
    z = np.sin(x * y[:, None])
    file = tmp_path / "z.csv"
    np.savetxt(file, z, delimiter=",")
    expected = command("surface", "--grid", file, "--every", "2", suffix=".svg")
    assert ligne.surface(file, every=2).to_bytes() == expected
    assert ligne.surface(np.loadtxt(file, delimiter=","), every=2).to_bytes() == expected
    wave = ligne.surface(lambda x, y: np.sin(x * y), x=(-2, 2, 30), y=(-1, 1, 30))
    assert len(wave.layers["horizon"]) > 30


def test_holes_and_layers():
    z = np.add.outer(np.arange(20.0), np.arange(30.0) ** 2)
    z[5:9, 5:9] = np.nan
    drawing = ligne.surface(z, x=(0, 3), y=np.linspace(0, 2, 20))
    assert list(drawing.layers) == ["horizon"] and len(drawing.polylines("horizon")) > 50
    assert len(drawing) == 0 and drawing.page == (297, 210)
    with pytest.raises(ligne.RequestError, match="^method"):
        drawing.points
    assert len(ligne.surface(z, method="appel")) > 100


@pytest.mark.parametrize(
    "z, options, error, names",
    [
        (np.zeros(5), {}, ligne.InputError, "z"),
        (np.zeros((1, 5)), {}, ligne.InputError, "z"),
        (np.zeros((5, 5), complex), {}, ligne.DtypeError, "z"),
        (np.full((5, 5), np.inf), {}, ligne.InputError, "z"),
        (np.full((5, 5), np.nan), {}, ligne.InputError, "z"),
        (np.zeros((5, 6)), {"x": range(5)}, ligne.InputError, "x"),
        (np.zeros((5, 6)), {"y": ["a"] * 5}, ligne.DtypeError, "y"),
        (np.zeros((5, 6)), {"x": [5, 4, 3, 2, 1, 0]}, ligne.InputError, "z"),
        ("sin(", {}, ligne.InputError, ""),
        ("x", {"x": (5, -5)}, ligne.RequestError, "x"),
        ("x", {"samples": 1}, ligne.RequestError, "samples"),
        ("x", {"nothing": 1}, ligne.RequestError, "nothing"),
        ("x", {"contours": 5, "contour_step": 1}, ligne.RequestError, ""),
        ("x", {"ridgeline": True, "hidden": "dashed"}, ligne.RequestError, "method"),
        (lambda x, y: x + "a", {}, Exception, ""),
        (lambda x, y: x * 1j, {}, ligne.DtypeError, "z"),
    ],
    ids=lambda value: "",
)
def test_wrong_surfaces(z, options, error, names):
    with pytest.raises(error, match=f"^{names}"):
        ligne.surface(z, **options)
