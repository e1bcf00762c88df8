"""The surfaces behind a mesh: Drawing.surfaces and Drawing.stroke_surfaces."""

import dataclasses
import json
import math
import pickle

import ligne
import numpy as np
import pytest


def tube(outer, inner, height, facets=36):
    """A tube about the z axis: outer and inner wall, two rings."""
    angle = 2 * np.pi * np.arange(facets) / facets
    circle = np.column_stack([np.cos(angle), np.sin(angle)])
    vertices = np.array([[*(radius * p), z] for radius in (outer, inner) for z in (0, height) for p in circle])
    at = np.arange(facets)
    after = (at + 1) % facets
    rings = [facets * k for k in range(4)]  # outer below, outer above, inner below, inner above

    def quads(first, second):
        return np.column_stack([first + at, first + after, second + after, second + at])

    return vertices, np.concatenate([
        quads(rings[0], rings[1]), quads(rings[3], rings[2]), quads(rings[1], rings[3]), quads(rings[2], rings[0])])


@pytest.fixture
def drawing():
    return ligne.draw(ligne.Mesh(*tube(10, 6, 15)))


def test_a_tube_has_a_boss_and_a_bore(drawing):
    boss, bore = sorted(drawing.surfaces, key=lambda surface: -surface.radius)
    assert (boss.kind, bore.kind) == ("cylinder", "cylinder")
    assert (boss.radius, bore.radius) == pytest.approx((10, 6))
    assert boss.outward and not bore.outward
    for surface in (boss, bore):
        assert surface.axis == pytest.approx((0, 0, 1)) and surface.at == pytest.approx((0, 0, 0))
        assert surface.along == pytest.approx((0, 15)) and surface.turn == 360
        assert surface.slope is None and surface.tube is None
        assert surface.faces == 36 and surface.object == 0
        assert surface.sag == pytest.approx(surface.radius * (1 - math.cos(math.pi / 36)))


def test_strokes_name_their_surfaces(drawing):
    number = drawing.stroke_surfaces
    assert number.shape == (len(drawing), 2) and number.dtype == np.int64
    assert not number.flags.writeable
    assert number.min() == -1 and number.max() == 1
    assert np.all(number[drawing.faces == -1] == -1)
    ends = drawing.points3d().reshape(-1, 2, 3)
    for index, surface in enumerate(drawing.surfaces):
        away = np.hypot(ends[..., 0], ends[..., 1])[(number == index).any(axis=1) & (drawing.kind == "crease")]
        assert len(away) > 0 and away == pytest.approx(np.full(away.shape, surface.radius), abs=1e-4)


def test_they_are_those_of_the_file(drawing):
    written = json.loads(drawing.to_bytes("json"))
    assert len(written["surfaces"]) == len(drawing.surfaces)
    for surface, entry in zip(drawing.surfaces, written["surfaces"]):
        members = {name: value for name, value in dataclasses.asdict(surface).items() if value is not None}
        for name in ("at", "axis", "along"):
            members[name] = list(members[name])
        assert members.pop("turn") == pytest.approx(entry.pop("turn"))
        assert members == entry
    numbers = [[-1 if n is None else n for n in stroke["source"]["surfaces"]] for stroke in written["strokes"]]
    assert np.array_equal(numbers, drawing.stroke_surfaces)


def test_other_kinds_have_other_members():
    up = np.linspace(-np.pi / 3, np.pi / 3, 9)
    around = 2 * np.pi * np.arange(24) / 24
    cap = np.array([[3 * np.cos(a) * np.cos(b), 3 * np.sin(a) * np.cos(b), 3 * np.sin(b)] for b in up for a in around])
    cone = np.array([[(4 - z) * np.cos(a), (4 - z) * np.sin(a), 2 * z + 10] for z in (0, 1, 2) for a in around])
    corners = np.array([[24 * v + u, 24 * v + (u + 1) % 24, 24 * v + 24 + (u + 1) % 24, 24 * v + 24 + u]
                        for v in range(8) for u in range(24)])
    mesh = ligne.Mesh(np.concatenate([cap, cone]), np.concatenate([corners, corners[:48] + len(cap)]),
                      objects=["ball"] * 192 + ["cone"] * 48)
    found = {surface.kind: surface for surface in ligne.draw(mesh).surfaces}
    assert set(found) == {"sphere", "cone"}
    ball, cone = found["sphere"], found["cone"]
    assert ball.axis is None and ball.along is None and ball.turn is None and ball.radius == pytest.approx(3)
    assert mesh.object_names[ball.object] == "ball" and mesh.object_names[cone.object] == "cone"
    assert cone.slope == pytest.approx(-0.5) and cone.radius == pytest.approx(4) and cone.at == pytest.approx((0, 0, 10))


def test_drawings_without_surfaces(cube):
    tubes = tube(10, 6, 15)
    for drawing in (ligne.draw(cube), ligne.draw(ligne.Mesh(*tubes, quality="exact")),
                    ligne.draw(ligne.Mesh(*tubes), edges="outline")):
        assert drawing.surfaces == ()
        assert drawing.stroke_surfaces.shape == (len(drawing), 2) and np.all(drawing.stroke_surfaces == -1)
    with pytest.raises(ligne.RequestError, match="the floating horizon gives only polylines"):
        ligne.surface("sin(r)/r").surfaces


def test_they_are_read_only_and_pickled(drawing):
    with pytest.raises(dataclasses.FrozenInstanceError):
        drawing.surfaces[0].radius = 1
    assert isinstance(drawing.surfaces, tuple) and drawing.surfaces is drawing.surfaces
    assert pickle.loads(pickle.dumps(drawing.surfaces)) == drawing.surfaces
    again = pickle.loads(pickle.dumps(drawing))
    assert again.surfaces == drawing.surfaces
    assert np.array_equal(again.stroke_surfaces, drawing.stroke_surfaces)
    assert hash(drawing.surfaces[0]) == hash(again.surfaces[0])
