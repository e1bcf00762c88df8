"""The interpreter's lock, progress, Ctrl-C, threads and memory."""

import gc
import os
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest
from conftest import WHOLE_TIER, grid_mesh

import ligne

SHEET = None


def sheet():
    """A mesh that takes a good part of a second; in the first tier a fourth of that."""
    global SHEET
    if SHEET is None:
        SHEET = ligne.Mesh(*grid_mesh(300 if WHOLE_TIER else 150), quality="exact")
    return SHEET


def test_progress_ascends_to_one():
    told = []
    # A slow method, since progress is told twenty times a second.
    ligne.draw(sheet(), edges="all", method="warnock", progress=told.append)
    assert told == sorted(told) and told[-1] == 1 and len(told) > 1


def test_what_progress_raises_ends_the_work():
    class Enough(Exception):
        pass

    def stop(fraction):
        raise Enough(fraction)

    with pytest.raises(Enough):
        ligne.draw(sheet(), edges="all", method="warnock", progress=stop)
    assert len(ligne.draw(sheet())) > 0  # all is well afterwards


@pytest.mark.parametrize("method", ["auto", "warnock", "newell", "bsp"])
def test_ctrl_c_ends_the_work(method):
    mesh = sheet()
    timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
    with pytest.raises(KeyboardInterrupt):
        timer.start()
        for _ in range(1000):
            ligne.draw(mesh, edges="all", method=method)


LONG_DRAWING = """
import sys
import numpy as np
import ligne
sys.path.insert(0, sys.argv[1])
from conftest import grid_mesh
mesh = ligne.Mesh(*grid_mesh(300), quality="exact")
print("begins", flush=True)
while True:
    ligne.draw(mesh, edges="all", method="newell")
"""
KILLED_AFTER_S = 120  # a process that nothing stops must not hold up the tests


def test_ctrl_c_ends_a_process_that_draws():
    """A script that never ends by itself is ended by one interrupt, with Python's own traceback."""
    line = [sys.executable, "-c", LONG_DRAWING, os.path.dirname(__file__)]
    with subprocess.Popen(line, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        try:
            assert process.stdout.readline() == "begins\n"
            time.sleep(0.5)  # it is somewhere in a drawing
            process.send_signal(signal.SIGINT)
            _, errors = process.communicate(timeout=KILLED_AFTER_S)
        finally:
            process.kill()
    assert process.returncode == -signal.SIGINT
    assert errors.rstrip().endswith("KeyboardInterrupt")


def test_the_lock_is_given_up():
    """Another thread counts while one draws."""
    counted, done = [0], threading.Event()

    def count():
        while not done.is_set():
            counted[0] += 1
            time.sleep(0.001)

    mesh = sheet()
    other = threading.Thread(target=count)
    other.start()
    before = counted[0]
    ligne.draw(mesh, edges="all")
    counts = counted[0] - before
    done.set()
    other.join()
    assert counts > 3  # one or none where the lock is kept


def test_threads_draw_at_once():
    mesh = sheet()
    expected = [ligne.draw(mesh, view).to_bytes() for view in ("iso", "front")]
    found = {}

    def work(number, view):
        found[number] = [ligne.draw(mesh, view).to_bytes() for _ in range(3)]

    threads = [threading.Thread(target=work, args=(i, ("iso", "front")[i % 2])) for i in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for number, files in found.items():
        assert all(file == expected[number % 2] for file in files)
    assert len(found) == 4


def test_threads_share_one_drawing():
    drawing = ligne.draw(sheet())
    expected = {format: drawing.to_bytes(format) for format in ("svg", "json", "hpgl")}
    wrong = []

    def work(format):
        for _ in range(3):
            if drawing.to_bytes(format) != expected[format] or drawing.points.shape != (2 * len(drawing), 2):
                wrong.append(format)

    threads = [threading.Thread(target=work, args=(format,)) for format in expected]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not wrong


def resident():
    with open("/proc/self/statm") as statm:
        return int(statm.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def test_memory_stays_flat():
    vertices, faces = grid_mesh(12)

    def once():
        mesh = ligne.Mesh(vertices, faces)
        drawing = ligne.draw(mesh, regions=True)
        drawing.points, drawing.regions, drawing.layers, drawing.to_bytes()
        with pytest.raises(ligne.InputError):
            ligne.Mesh(vertices * np.nan, faces)

    for _ in range(100):
        once()
    gc.collect()
    before = resident()
    for _ in range(300):
        once()
    gc.collect()
    # A leak of one array of strokes a draw would be 300 times some tens of kilobytes.
    assert resident() - before < 3_000_000
