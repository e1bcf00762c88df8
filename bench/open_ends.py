#!/usr/bin/env python3
"""open_ends.py LIGNE MODEL... [--views NAME,...] [--from MM] [--to MM] [--where] [-- OPTIONS of ligne draw]

Draws each model in each view (iso, front, right, top), with hidden lines, and prints a Markdown table: the visible strokes
of the drawing, the ends of outlines and of other strokes that meet no line (none is nearer than 0.1 mm), and how many of
both would meet one if they went straight on by no more than 3 mm. These are told apart by what begins where they end:

  cut   a hidden line that goes on: something in front ends the line, and has no line of its own there
  ink   such a line, beside another one that is less than the width of the pen away
  cusp  a hidden line that turns back: a fold ends where it runs along the sight
  end   no hidden line: the crease, or the line of an open sheet, ends there

The first are faults of the drawing; the others lie in the shape, or are not seen. --where lists all of them: layer, place
on the page, the way to the line, and the kind."""

import collections
import math
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from short_strokes import argument_parser, distance, parse_arguments, pictures  # noqa: E402

DIRECTION_MM = 0.5  # of the stroke before its end, which tells its direction
CELL_MM = 2
PEN_MM = 0.35
SAME_END_MM = 0.2  # a visible line and the hidden one that continues it
KINDS = ("cut", "ink", "cusp", "end")


def before_end(line):
    """The point that is DIRECTION_MM before the end of the line, or its beginning."""
    left = DIRECTION_MM
    for p, q in zip(line[::-1], line[-2::-1]):
        mm = math.dist(p, q)
        if mm >= left:
            return (p[0] + (q[0] - p[0]) * left / mm, p[1] + (q[1] - p[1]) * left / mm)
        left -= mm
    return line[0]


def last_segments(line, at_end):
    """The numbers of the segments of the piece that tells the direction; what is left of the line may come back."""
    numbers = range(len(line) - 1)
    left, last = DIRECTION_MM, set()
    for k in reversed(numbers) if at_end else numbers:
        last.add(k)
        left -= math.dist(line[k], line[k + 1])
        if left <= 0:
            break
    return last


def hit(p, q, a, b):
    """The fraction of p-q at which a-b crosses it, or None."""
    dx, dy, ex, ey = q[0] - p[0], q[1] - p[1], b[0] - a[0], b[1] - a[1]
    area = dx * ey - dy * ex
    if area == 0:
        return None
    t = ((a[0] - p[0]) * ey - (a[1] - p[1]) * ex) / area
    s = ((a[0] - p[0]) * dy - (a[1] - p[1]) * dx) / area
    return t if 0 <= t <= 1 and 0 <= s <= 1 else None


class Segments:
    def __init__(self, strokes):
        self.cells = collections.defaultdict(set)
        self.list = []
        for i, (_, line, _) in enumerate(strokes):
            for k, (a, b) in enumerate(zip(line, line[1:])):
                for cell in self.box(a, b, 0):
                    self.cells[cell].add(len(self.list))
                self.list.append((i, k, a, b))

    @staticmethod
    def box(a, b, margin):
        low = [math.floor((min(u, v) - margin) / CELL_MM) for u, v in zip(a, b)]
        high = [math.floor((max(u, v) + margin) / CELL_MM) for u, v in zip(a, b)]
        return [(x, y) for x in range(low[0], high[0] + 1) for y in range(low[1], high[1] + 1)]

    def near(self, a, b, margin):
        return {s for cell in self.box(a, b, margin) for s in self.cells.get(cell, ())}


def kind_of(end, back, hidden, nearest):
    """What ends a line at that point, to which it comes from `back`."""
    best = None
    for line in hidden:
        for way in (line, line[::-1]):
            mm = math.dist(way[0], end)
            if mm < SAME_END_MM and (best is None or mm < best[0]):
                best = mm, way
    if best is None:
        return "end"
    way = best[1]
    ahead = before_end(way[::-1])
    cosine = (end[0] - back[0]) * (ahead[0] - way[0][0]) + (end[1] - back[1]) * (ahead[1] - way[0][1])
    if cosine < 0:
        return "cusp"
    return "ink" if nearest < PEN_MM else "cut"


def open_ends(picture, least, most):
    """(layer, point, way to the line ahead or None, kind) of each end that meets no line."""
    strokes = [s for s in picture.strokes if s[0] != "hidden"]
    hidden = [line for name, line, _ in picture.strokes if name == "hidden"]
    segments = Segments(strokes)
    for i, (name, line, _) in enumerate(strokes):
        if line[0] == line[-1]:
            continue
        for way in (line, line[::-1]):
            end, back = way[-1], before_end(way)
            last = last_segments(line, way is line)
            nearest = min((distance(end, *segments.list[s][2:]) for s in segments.near(end, end, max(least, PEN_MM))
                           if segments.list[s][0] != i or segments.list[s][1] not in last), default=math.inf)
            if nearest < least:
                continue
            unit = math.dist(back, end)
            if unit == 0:
                continue
            to = tuple(e + (e - b) * most / unit for b, e in zip(back, end))
            hits = []
            for s in segments.near(end, to, 0):
                k, _, a, b = segments.list[s]
                if k == i and min(math.dist(end, a), math.dist(end, b)) < 1e-9:
                    continue
                t = hit(end, to, a, b)
                if t is not None and t > 0:
                    hits.append(t * most)
            yield name, end, min(hits) if hits else None, kind_of(end, back, hidden, nearest)


def main():
    parser = argument_parser(__doc__)
    parser.add_argument("--from", dest="least", type=float, default=0.1)
    parser.add_argument("--to", dest="most", type=float, default=3)
    args, options = parse_arguments(parser)
    heads = [f"{what} {kind}" for what in ("outlines:", "others:") for kind in KINDS]
    print("| model | view | strokes | open ends | short of a line | " + " | ".join(heads) + " |")
    print("|---|---|" + "---:|" * (3 + len(heads)))
    sums = [0] * (3 + len(heads))
    for title, picture in pictures(args, [*options, "--hidden", "dashed"]):
        ends = list(open_ends(picture, args.least, args.most))
        short = [e for e in ends if e[2] is not None]
        row = [sum(name != "hidden" for name, _, _ in picture.strokes), len(ends), len(short)]
        for outline in (True, False):
            kinds = collections.Counter(kind for name, _, _, kind in short if (name in ("outline", "profile")) == outline)
            row += [kinds[kind] for kind in KINDS]
        sums = [a + b for a, b in zip(sums, row)]
        print(title + " | ".join(map(str, row)) + " |")
        if args.where:
            for name, p, way, kind in short:
                print(f"    {name} at {p[0]:.2f} {p[1]:.2f}: {way:.2f} mm, {kind}")
    print("| all | | " + " | ".join(map(str, sums)) + " |")


if __name__ == "__main__":
    main()
