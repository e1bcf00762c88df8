"""Front, top and side view of a model on one page each, with the hidden lines dashed.  three_views.py MODEL"""

import pathlib
import sys

import ligne


def main(model):
    scene = ligne.read(model)
    for view in ("front", "top", "left"):
        file = pathlib.Path(model).stem + f"-{view}.svg"
        drawing = ligne.draw(scene, view, hidden="dashed")
        drawing.save(file)
        print(f"{file}: {drawing.visible.sum()} visible strokes, {(~drawing.visible).sum()} hidden ones")


if __name__ == "__main__":
    main(*sys.argv[1:])
