#!/usr/bin/env python3
"""short_strokes.py LIGNE MODEL... [--views NAME,...] [--limit MM] [--where] [-- OPTIONS of ligne draw]

Draws each model in each view (iso, front, right, top) and prints a Markdown table: the strokes of the drawing, its chains
(strokes of one layer of which one ends where the other does), and how many of both are shorter than the limit (0.5 mm).
--where lists those strokes: layer, place on the page, length, and what each end does there: `free`; `end` where a stroke of
any layer ends; `side` where it lies on one, within the pen's half width."""

import argparse
import collections
import math
import os
import re
import subprocess
import sys
import tempfile

HALF_PEN_MM = 0.175
SAME_POINT_MM = 2e-3  # the writers round to 1 micrometre in x and y


def polylines(d):
    """The polylines of a path of the commands M, m, L, l, Z and z."""
    lines, at, command = [], (0, 0), ""
    tokens = iter(re.findall(r"[A-Za-z]|-?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:e-?[0-9]+)?", d))
    for token in tokens:
        if token.isalpha():
            command = token
            if command in "Zz":
                lines[-1].append(lines[-1][0])
            elif command not in "MmLl":
                raise ValueError(f"path command {command}")
            continue
        x, y = float(token), float(next(tokens))
        at = (at[0] + x, at[1] + y) if command.islower() else (x, y)
        if command in "Mm":
            lines.append([])
            command = "l" if command == "m" else "L"
        lines[-1].append(at)
    return lines


def layers(svg):
    """(name, [polyline]) of each layer of strokes."""
    for name, body in re.findall(r'<g [^>]*id="([^"]+)"[^>]*>(.*?)</g>', svg, re.S):
        yield name, [line for d in re.findall(r'<path [^>]*?d="([^"]+)"', body) for line in polylines(d)]


def length(line):
    return sum(math.dist(p, q) for p, q in zip(line, line[1:]))


def distance(p, a, b):
    dx, dy = b[0] - a[0], b[1] - a[1]
    square = dx * dx + dy * dy
    t = max(0, min(1, ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / square)) if square > 0 else 0
    return math.dist(p, (a[0] + t * dx, a[1] + t * dy))


class Picture:
    def __init__(self, svg):
        self.strokes = [(name, line, length(line)) for name, lines in layers(svg) for line in lines]
        self.ends = collections.defaultdict(list)  # by cell: (point, stroke)
        for i, (_, line, _) in enumerate(self.strokes):
            for p in (line[0], line[-1]):
                self.ends[self.cell(p)].append((p, i))

    @staticmethod
    def cell(p):
        return round(p[0] / SAME_POINT_MM), round(p[1] / SAME_POINT_MM)

    def ending_at(self, p):
        x, y = self.cell(p)
        return [i for u in (x - 1, x, x + 1) for v in (y - 1, y, y + 1) for q, i in self.ends.get((u, v), [])
                if math.dist(p, q) <= SAME_POINT_MM]

    def chains(self):
        """The lengths of all chains."""
        root = list(range(len(self.strokes)))

        def find(i):
            while root[i] != i:
                root[i] = i = root[root[i]]
            return i
        for i, (name, line, _) in enumerate(self.strokes):
            for p in (line[0], line[-1]):
                for k in self.ending_at(p):
                    if self.strokes[k][0] == name:
                        root[find(k)] = find(i)
        total = collections.Counter()
        for i, (_, _, mm) in enumerate(self.strokes):
            total[find(i)] += mm
        return list(total.values())

    def end_text(self, i, p):
        others = [k for k in self.ending_at(p) if k != i]
        if others:
            return "end(" + "+".join(sorted(self.strokes[k][0] for k in others)) + ")"
        for k, (name, line, _) in enumerate(self.strokes):
            if k != i and any(distance(p, a, b) <= HALF_PEN_MM for a, b in zip(line, line[1:])):
                return f"side({name})"
        return "free"


def draw(ligne, model, view, options, folder):
    path = os.path.join(folder, "drawing.svg")
    run = subprocess.run([ligne, "draw", "-q", model, "-o", path, "--view", view, "--curves", "off", *options],
                         capture_output=True, text=True)
    if run.returncode != 0:
        print(f"{model}: {run.stderr.strip()}", file=sys.stderr)
        return None
    with open(path, encoding="utf-8") as file:
        return Picture(file.read())


def argument_parser(description):
    """Of a program that draws models in views and prints a table."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("ligne")
    parser.add_argument("models", nargs="+")
    parser.add_argument("--views", default="iso,front,right,top")
    parser.add_argument("--where", action="store_true")
    return parser


def parse_arguments(parser):
    """The program's own arguments, and the options of ligne draw behind them."""
    own, options = sys.argv[1:], []
    if "--" in own:
        own, options = own[:own.index("--")], own[own.index("--") + 1:]
    return parser.parse_args(own), options


def pictures(args, options):
    """(beginning of a row of the table, picture) of each model in each view."""
    with tempfile.TemporaryDirectory() as folder:
        for model in args.models:
            for view in args.views.split(","):
                picture = draw(args.ligne, model, view, options, folder)
                if picture is not None:
                    yield f"| `{os.path.basename(model)}` | {view} | ", picture


def main():
    parser = argument_parser(__doc__)
    parser.add_argument("--limit", type=float, default=0.5)
    args, options = parse_arguments(parser)
    print("| model | view | strokes | short | chains | short |\n|---|---|---:|---:|---:|---:|")
    sums = [0, 0, 0, 0]
    for title, picture in pictures(args, options):
        chains = picture.chains()
        short = [i for i, s in enumerate(picture.strokes) if s[2] < args.limit]
        row = [len(picture.strokes), len(short), len(chains), sum(mm < args.limit for mm in chains)]
        sums = [a + b for a, b in zip(sums, row)]
        print(title + " | ".join(map(str, row)) + " |")
        if args.where:
            for i in short:
                name, line, mm = picture.strokes[i]
                ends = " ".join(picture.end_text(i, p) for p in (line[0], line[-1]))
                print(f"    {name} at {line[0][0]:.2f} {line[0][1]:.2f}, {mm:.3f} mm: {ends}")
    print("| all | | " + " | ".join(map(str, sums)) + " |")


if __name__ == "__main__":
    main()
