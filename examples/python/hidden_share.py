"""How much of each class of lines of a model is hidden, in mm on the page.  hidden_share.py MODEL"""

import sys

import numpy as np

import ligne


def main(model):
    drawing = ligne.draw(model, hidden="solid")
    ends = drawing.points.reshape(-1, 2, 2)
    length = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    for kind in np.unique(drawing.kind):
        of_kind = drawing.kind == kind
        seen, hidden = length[of_kind & drawing.visible].sum(), length[of_kind & ~drawing.visible].sum()
        print(f"{kind:12} {seen:10.1f} mm seen {hidden:10.1f} mm hidden")


if __name__ == "__main__":
    main(*sys.argv[1:])
