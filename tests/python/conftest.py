"""What the tests of the Python module have in common."""

import json
import os
import pathlib
import subprocess
import zlib

import numpy as np
import pytest

SOURCE = pathlib.Path(os.environ["LIGNE_SOURCE_DIR"])
MODELS = SOURCE.parent / "shared" / "models"
CUBE_VERTICES = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
CUBE_FACES = np.array([[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]])


WHOLE_TIER = os.environ.get("LIGNE_TEST_TIER") == "all"


def chosen(items, key, one_in):
    """All items, or in the first tier every `one_in`-th one, beginning where the seed and the key say."""
    if WHOLE_TIER:
        return items
    return items[zlib.crc32((os.environ.get("LIGNE_TEST_SEED", "0") + key).encode()) % one_in :: one_in]


def grid_mesh(n):
    """A wavy sheet of 2 (n - 1)^2 triangles."""
    x, y = np.meshgrid(np.linspace(-3, 3, n), np.linspace(-3, 3, n))
    vertices = np.column_stack([x.ravel(), y.ravel(), np.sin(x * y).ravel()])
    corner = (np.arange(n - 1)[:, None] * n + np.arange(n - 1)).ravel()
    lower = np.column_stack([corner, corner + 1, corner + n])
    upper = np.column_stack([corner + 1, corner + n + 1, corner + n])
    return vertices, np.concatenate([lower, upper])


@pytest.fixture
def cube():
    import ligne

    return ligne.Mesh(CUBE_VERTICES, CUBE_FACES)


@pytest.fixture
def command(tmp_path):
    """Runs the command; gives the bytes of the file that it writes."""

    def run(*arguments, suffix=".json"):
        file = tmp_path / ("by_command" + suffix)
        line = [os.environ["LIGNE_PROGRAM"], *map(str, arguments), "-q", "-o", str(file)]
        done = subprocess.run(line, capture_output=True, text=True, check=False)
        assert done.returncode == 0, f"{' '.join(line)}: {done.stderr}"
        return file.read_bytes()

    return run


@pytest.fixture
def strokes_of():
    """The strokes of a JSON drawing."""
    return lambda text: json.loads(text)["strokes"]
