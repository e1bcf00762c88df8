#!/usr/bin/env python3
"""clear_differences.py LIGNE SCENE... [--views NAME,...] [--within MM] [--where] [-- OPTIONS of ligne draw]

Draws each scene in each view (iso, front, right, top) by `--quality exact` and `--quality clear` and compares the two: the
length of the exact drawing's visible lines that no line of the clear one follows within a distance (0.175 mm, half of the
pen), and of the clear drawing's lines that follow no exact one; both by class. Prints a Markdown row for each drawing in
which either is longer than one millimetre, with what --stats says of the clear one, and a last row for all. --where lists
the runs from half a millimetre on: class, begin and end on the page."""

import collections
import json
import math
import os
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from short_strokes import argument_parser, distance, parse_arguments  # noqa: E402

STEP_MM = 0.1
CELL_MM = 1
LEAST_MM = 1  # of a difference that has a row
LISTED_MM = 0.5  # least length of a run that --where lists


def placement(ligne, scene, view):
    """Options that place both qualities alike. Without a scale, clear drawings of coarse round parts are fitted by their finer mesh."""
    run = subprocess.run([ligne, "info", scene, "--json", "--view", view], capture_output=True, text=True)
    return ["--unit", "mm", "--scale", f"{json.loads(run.stdout)['view']['mm_per_unit']}:1"] if run.returncode == 0 else []


def draw(ligne, scene, view, quality, options, folder):
    """({class: [polyline]}, what was said of clear lines)."""
    path = os.path.join(folder, "drawing.json")
    run = subprocess.run([ligne, "draw", scene, "-o", path, "--view", view, "--quality", quality, "--curves", "off",
                          "--stats", *placement(ligne, scene, view), *options], capture_output=True, text=True)
    if run.returncode != 0:
        return None, run.stderr.strip()
    lines = collections.defaultdict(list)
    with open(path, encoding="utf-8") as file:
        for stroke in json.load(file)["strokes"]:
            if stroke["visible"]:
                lines[stroke["class"]].append(stroke["points"])
    said = re.search(r"^clear lines\n((?:  .*\n)+)", run.stderr, re.M)
    return lines, re.sub(r" {2,}", " ", said[1].strip().replace("\n", ",")) if said else ""


class Lines:
    """The segments of a drawing, by cells of the page."""

    def __init__(self, lines, within):
        self.within = within
        self.cells = collections.defaultdict(list)
        for line in (line for of_class in lines.values() for line in of_class):
            for a, b in zip(line, line[1:]):
                low = [math.floor((min(u, v) - within) / CELL_MM) for u, v in zip(a, b)]
                high = [math.floor((max(u, v) + within) / CELL_MM) for u, v in zip(a, b)]
                for x in range(low[0], high[0] + 1):
                    for y in range(low[1], high[1] + 1):
                        self.cells[x, y].append((a, b))

    def follow(self, p):
        cell = math.floor(p[0] / CELL_MM), math.floor(p[1] / CELL_MM)
        return any(distance(p, a, b) <= self.within for a, b in self.cells.get(cell, ()))


def runs_without(lines, others):
    """(class, length, begin, end) of each run of the lines that no other follows, to STEP_MM."""
    for name, of_class in lines.items():
        for line in of_class:
            run = None
            for a, b in zip(line, line[1:]):
                mm = math.dist(a, b)
                count = max(1, math.ceil(mm / STEP_MM))
                for k in range(count):
                    p = [u + (v - u) * (k + 0.5) / count for u, v in zip(a, b)]
                    if others.follow(p):
                        if run:
                            yield run
                        run = None
                    else:
                        run = (name, mm / count, p, p) if not run else (name, run[1] + mm / count, run[2], p)
            if run:
                yield run


def by_class(runs):
    total = collections.Counter()
    for name, mm, _, _ in runs:
        total[name] += mm
    return total


def text(total):
    return ", ".join(f"{name} {mm:.1f}" for name, mm in total.most_common() if mm >= 0.05) or "0"


def main():
    parser = argument_parser(__doc__)
    parser.add_argument("--within", type=float, default=0.175)
    args, options = parse_arguments(parser)
    print("| scene | view | exact, mm | lost, mm | added, mm | what clear lines did |\n|---|---|---:|---|---|---|")
    drawings, sums = 0, [0, collections.Counter(), collections.Counter()]
    with tempfile.TemporaryDirectory() as folder:
        for scene in args.models:
            for view in args.views.split(","):
                exact, message = draw(args.ligne, scene, view, "exact", options, folder)
                clear, said = draw(args.ligne, scene, view, "clear", options, folder)
                if exact is None or clear is None:
                    print(f"{scene}: {message}", file=sys.stderr)
                    continue
                lost = list(runs_without(exact, Lines(clear, args.within)))
                added = list(runs_without(clear, Lines(exact, args.within)))
                mm = sum(math.dist(a, b) for of in exact.values() for line in of for a, b in zip(line, line[1:]))
                drawings += 1
                sums = [sums[0] + mm, sums[1] + by_class(lost), sums[2] + by_class(added)]
                if max(sum(r[1] for r in lost), sum(r[1] for r in added)) < LEAST_MM:
                    continue
                print(f"| `{os.path.basename(scene)}` | {view} | {mm:.0f} | {text(by_class(lost))} | {text(by_class(added))} | {said} |")
                for what, runs in (("lost", lost), ("added", added)):
                    for name, length, a, b in runs:
                        if args.where and length >= LISTED_MM:
                            print(f"    {what} {name}, {length:.2f} mm: {a[0]:.2f} {a[1]:.2f} to {b[0]:.2f} {b[1]:.2f}")
    print(f"| all {drawings} | | {sums[0]:.0f} | {text(sums[1])} | {text(sums[2])} | |")


if __name__ == "__main__":
    main()
