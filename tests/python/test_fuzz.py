"""Made-up arrays: they are drawn, or refused by an error of ours."""

import numpy as np
from conftest import WHOLE_TIER
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

import ligne

settings.register_profile("ligne", max_examples=400 if WHOLE_TIER else 100, deadline=None, derandomize=True, database=None)
settings.load_profile("ligne")

NUMBERS = st.one_of(
    st.sampled_from([0.0, 1.0, -1.0, 0.5, 1e-300, 1e300, np.nan, np.inf, 1 / 3]), st.floats(-2, 2, allow_nan=False)
)
DTYPES = st.one_of(arrays.floating_dtypes(), arrays.integer_dtypes(), arrays.complex_number_dtypes(), arrays.boolean_dtypes())
OPTIONS = st.fixed_dictionaries(
    {
        "method": st.sampled_from(["auto"] + [method["name"] for method in ligne.methods()]),
        "hidden": st.sampled_from(["none", "dashed"]),
        "edges": st.sampled_from(["all", "feature", "outline,profile"]),
        "view": st.sampled_from(["iso", "front", "top"]),
    }
)


def drawn_or_refused(make, **options):
    try:
        drawing = ligne.draw(make(), page="A6", **options)
        assert np.isfinite(drawing.points).all()
        drawing.to_bytes()
    except ligne.Error:
        pass


@given(
    arrays.arrays(np.float64, st.tuples(st.integers(0, 12), st.just(3)), elements=NUMBERS),
    arrays.arrays(np.int64, st.tuples(st.integers(0, 14), st.integers(3, 5)), elements=st.integers(-1, 12)),
    OPTIONS,
    st.sampled_from(["clear", "exact"]),
)
def test_values(vertices, faces, options, quality):
    drawn_or_refused(lambda: ligne.Mesh(vertices, faces, quality=quality), **options)


@given(
    arrays.arrays(np.float64, st.just((10, 3)), elements=st.floats(-1, 1)),
    st.lists(st.lists(st.integers(0, 9), min_size=3, max_size=6), min_size=1, max_size=10),
    st.data(),
)
def test_ragged_faces_and_labels(vertices, faces, data):
    count = len(faces)
    objects = data.draw(st.lists(st.integers(0, 3), min_size=count, max_size=count))
    materials = data.draw(st.one_of(st.none(), st.lists(st.sampled_from("ab"), min_size=count, max_size=count)))
    drawn_or_refused(lambda: ligne.Mesh(vertices, faces, objects, materials), fill=data.draw(st.sampled_from(["none", "shade"])))


@given(DTYPES, st.lists(st.integers(0, 6), max_size=3), DTYPES, st.lists(st.integers(0, 6), max_size=3))
def test_shapes_and_kinds(vertex_type, vertex_shape, face_type, face_shape):
    drawn_or_refused(lambda: ligne.Mesh(np.zeros(vertex_shape, vertex_type), np.zeros(face_shape, face_type)))


@given(arrays.arrays(np.float64, st.tuples(st.integers(0, 8), st.integers(0, 8)), elements=NUMBERS), st.booleans())
def test_heights(heights, mesh):
    try:
        ligne.surface(heights, page="A6", method="appel" if mesh else "auto").to_bytes()
    except ligne.Error:
        pass
