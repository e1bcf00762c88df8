"""Arrays in and out: shapes, types, errors that name the argument, and who owns what."""

import numpy as np
import pytest
from conftest import CUBE_FACES, CUBE_VERTICES, grid_mesh

import ligne

V, F = CUBE_VERTICES, CUBE_FACES


@pytest.mark.parametrize(
    "vertices, faces, options, error, names",
    [
        (V[:, :2], F, {}, ligne.InputError, "vertices"),
        (V.ravel(), F, {}, ligne.InputError, "vertices"),
        (V.astype(complex), F, {}, ligne.DtypeError, "vertices"),
        (V.astype(bool), F, {}, ligne.DtypeError, "vertices"),
        (V.astype(str), F, {}, ligne.DtypeError, "vertices"),
        ([["a", "b", "c"]], F, {}, ligne.DtypeError, "vertices"),
        (None, F, {}, ligne.InputError, "vertices"),
        ([[1, 2, 3], [1, 2]], F, {}, ligne.InputError, "vertices"),
        (np.where(V == 1, np.nan, V), F, {}, ligne.InputError, "vertices: row 1"),
        (np.where(V == 1, -np.inf, V), F, {}, ligne.InputError, "vertices: row 1"),
        (V * 1e200, F, {}, ligne.InputError, "vertices: row 1"),
        (V, F.astype(float), {}, ligne.DtypeError, "faces"),
        (V, F.astype(bool), {}, ligne.DtypeError, "faces"),
        (V, F[:, :2], {}, ligne.InputError, "faces"),
        (V, F.ravel(), {}, ligne.InputError, "faces"),
        (V, np.zeros((0, 3), int), {}, ligne.InputError, "faces"),
        (V, [], {}, ligne.InputError, "faces"),
        (V, [[0, 1, 8]], {}, ligne.InputError, "faces: index 8 of face 0"),
        (V, [[0, 1, 2], [0, 1, -1]], {}, ligne.InputError, "faces: index -1 of face 1"),
        (V, [[0, 1, 2], [0, 1, 3, 2**40]], {}, ligne.InputError, "faces: index 1099511627776 of face 1"),
        (V, np.array([[0, 1, 2**64 - 1]], np.uint64), {}, ligne.InputError, "faces: index 18446744073709551615"),
        (V, [[0, 1, 2], [0, 1]], {}, ligne.InputError, "faces: a contour of face 1"),
        (V, [[0, 1, 2], [0.0, 1.0, 2.0, 3.0]], {}, ligne.DtypeError, "faces"),
        (V, [[0, 1, 2], None], {}, ligne.InputError, "faces"),
        (np.zeros((0, 3)), F, {}, ligne.InputError, "faces"),
        (V, F, {"objects": ["a"]}, ligne.InputError, "objects"),
        (V, F, {"objects": "abcdef"}, ligne.InputError, "objects"),
        (V, F, {"materials": range(5)}, ligne.InputError, "materials"),
        (V, F, {"materials": range(6), "colors": {0: (1, 2, 3)}}, ligne.InputError, "colors"),
        (V, F, {"materials": range(6), "colors": {9: (1, 1, 1)}}, ligne.InputError, "colors"),
        (V, F, {"precision": -1}, ligne.InputError, "precision"),
        (V, F, {"up_axis": "w"}, ligne.RequestError, "up_axis"),
        (V, F, {"quality": "best"}, ligne.RequestError, "quality"),
        (V, F, {"weld": -1}, ligne.RequestError, "weld"),
    ],
)
def test_wrong_arrays_are_named(vertices, faces, options, error, names):
    with pytest.raises(error, match=f"^{names}"):
        ligne.Mesh(vertices, faces, **options)


@pytest.mark.parametrize(
    "options, option",
    [
        ({"view": "above"}, ""),
        ({"method": "best"}, "method"),
        ({"crease": 200}, "crease"),
        ({"crease": float("nan")}, "crease"),
        ({"crease": "wide"}, "crease"),
        ({"crease": object()}, "crease"),
        ({"hidden": "dotted"}, "hidden"),
        ({"cull": 1}, "cull"),
        ({"page": "A9"}, "page"),
        ({"margin": 200}, "margin"),
        ({"direction": (0, 0, 0)}, "direction"),
        ({"direction": (1, 2)}, "direction"),
        ({"direction": (1, 0, 0), "eye": (1, 2, 3)}, "view"),
        ({"threads": -1}, "threads"),
        ({"max_memory": "much"}, "max_memory"),
        ({"page": (100,)}, "page"),
        ({"x": (0, 1)}, ""),
        ({"resolution": 512}, "resolution"),
        ({"nothing": 1}, "nothing"),
        ({"quality": "exact"}, ""),
    ],
)
def test_wrong_options_are_named(options, option, cube):
    with pytest.raises(ligne.RequestError) as raised:
        ligne.draw(cube, **options)
    assert getattr(raised.value, "option", "") == option
    assert (option or next(iter(options))) in str(raised.value)


def test_errors_are_of_the_usual_kinds_too():
    assert issubclass(ligne.InputError, (ligne.Error, ValueError))
    assert issubclass(ligne.DtypeError, TypeError)
    assert issubclass(ligne.MemoryLimitError, MemoryError)
    with pytest.raises(ligne.MemoryLimitError):
        ligne.draw(ligne.Mesh(*grid_mesh(100)), max_memory="10k")


@pytest.mark.parametrize("dtype", [np.int8, np.uint16, np.int32, np.uint32, np.int64, np.uint64, ">i4"])
def test_kinds_of_indices(dtype, cube):
    assert ligne.draw(ligne.Mesh(V, F.astype(dtype))).to_bytes() == ligne.draw(cube).to_bytes()


@pytest.mark.parametrize("vertices", [V.astype(np.float32), V.astype(int), V.astype(">f8"), np.asfortranarray(V), V.tolist(),
                                      np.column_stack([V, V])[:, :3], V[::-1][::-1]])
def test_kinds_of_vertices(vertices, cube):
    assert ligne.draw(ligne.Mesh(vertices, F)).to_bytes() == ligne.draw(cube).to_bytes()


def test_float32_is_less_precise():
    apart = V + [1 + 2e-8, 0, 0]
    both, faces = np.concatenate([V, apart]), np.concatenate([F, F + 8])
    objects = [0] * 6 + [1] * 6
    fine = ligne.Mesh(both, faces, objects)
    coarse = ligne.Mesh(both, faces, objects, precision=1e-6)
    assert len(fine.object_names) == len(coarse.object_names) == 2


def test_polygons_with_holes():
    outer = [[0, 0, 0], [9, 0, 0], [9, 9, 0], [0, 9, 0]]
    hole = [[3, 3, 0], [3, 6, 0], [6, 6, 0], [6, 3, 0]]
    mesh = ligne.Mesh(outer + hole, [[[0, 1, 2, 3], [4, 5, 6, 7]]])
    drawing = ligne.draw(mesh, "top", scale="1:1", regions=True)
    assert drawing.regions[0].area == pytest.approx(72)
    assert len(drawing.regions[0].contours) == 2


def test_out_arrays(cube):
    drawing = ligne.draw(cube, hidden="solid")
    n = len(drawing)
    assert drawing.points.shape == drawing.points3d()[:, :2].shape == (2 * n, 2)
    assert drawing.offsets.tolist() == list(range(0, 2 * n + 1, 2))
    for array in (drawing.kind, drawing.visible, drawing.level):
        assert array.shape == (n,)
    for array in (drawing.edge, drawing.faces, drawing.parameter):
        assert array.shape == (n, 2)
    assert drawing.visible.dtype == bool and drawing.visible.sum() == 9 and n == 12
    # The matrix leads from where strokes are in space to where they are on the page.
    space = np.column_stack([drawing.points3d(), np.ones(2 * n)]) @ drawing.matrix.T
    np.testing.assert_allclose(space[:, :2] / space[:, 3:], drawing.points, atol=1e-6)
    # Whole edges: their ends are those of the vertices.
    np.testing.assert_array_equal(drawing.points3d().reshape(n, 2, 3), cube.vertices[drawing.edge])


def test_scene_arrays_are_views(cube):
    vertices = cube.vertices
    assert not vertices.flags.writeable and not vertices.flags.owndata
    with pytest.raises(ValueError):
        vertices[0, 0] = 1
    del cube
    assert vertices.sum() == V.sum()  # kept alive by the array


def test_faces_are_numbered_as_given():
    # A face that is dropped, one that is cut, and objects whose faces are mixed.
    vertices = np.concatenate([V, V + [3, 0, 0]])
    faces = [[0, 0, 1]] + [list(f) for pair in zip(F, F + 8) for f in pair]
    objects = ["a"] + ["a", "b"] * 6
    mesh = ligne.Mesh(vertices, faces, objects)
    assert mesh.object_names == ["a", "b"]
    assert sorted(mesh.face_source.tolist()) == list(range(1, 13))
    drawing = ligne.draw(mesh, "front", regions=True)
    seen = {region.face for region in drawing.regions}
    assert seen == {1 + 2 * 2, 2 + 2 * 2}  # the third face of each cube looks to the front
    assert set(drawing.faces[drawing.faces >= 0].ravel()) <= set(range(1, 13))


def test_merged_faces_name_one_of_theirs():
    triangles = np.concatenate([F[:, [0, 1, 2]], F[:, [0, 2, 3]]])
    mesh = ligne.Mesh(V, triangles, merge_coplanar=True)
    assert len(mesh.faces) == 6
    assert sorted(f % 6 for f in mesh.face_source) == list(range(6))


def test_materials_fill(cube):
    mesh = ligne.Mesh(V, F, materials=["red"] * 6, colors={"red": (1, 0, 0)})
    assert b"#f00" in ligne.draw(mesh, fill="material").to_bytes()


def test_other_meshes(cube):
    class Trimesh:
        vertices, faces = V, F

    class PolyData:
        points, faces = V, np.column_stack([np.full(6, 4), F]).ravel()

    class Block:
        type, data = "quad", F

    class Meshio:
        points, cells = V, [Block]

    class Graph:
        nodes_geometry = ["one", "two"]

        def __getitem__(self, node):
            moved = np.eye(4)
            moved[0, 3] = 3 if node == "two" else 0
            return moved, "cube"

    class TrimeshScene:
        geometry, graph = {"cube": Trimesh}, Graph()

    expected = ligne.draw(cube).to_bytes()
    for mesh in (ligne.Mesh.from_trimesh(Trimesh), ligne.Mesh.from_pyvista(PolyData), ligne.Mesh.from_meshio(Meshio)):
        assert ligne.draw(mesh).to_bytes() == expected
    for other in (Trimesh, PolyData, Meshio):
        assert ligne.draw(other).to_bytes() == expected
    assert ligne.Mesh.from_trimesh(TrimeshScene).object_names == ["one", "two"]
    with pytest.raises(ligne.RequestError, match="^model"):
        ligne.draw(3)


def test_views():
    assert np.allclose(ligne.View.named("front").matrix, [[1, 0, 0], [0, 0, 1], [0, -1, 0]])
    assert np.allclose(np.linalg.det(ligne.View.parallel((1, 2, -3)).matrix), 1)
    assert np.allclose(
        ligne.View.perspective((5, 5, 5), (0, 0, 0)).matrix, ligne.View.parallel((-1, -1, -1)).matrix
    )
    with pytest.raises(ligne.RequestError, match="^target"):
        ligne.View.perspective((5, 5, 5)).matrix
