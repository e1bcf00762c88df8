#!/usr/bin/env python3
"""Times of `ligne surface` against the number of samples, as a table and as the plot docs/images/surface-times.svg.

bench/surface_times.py LIGNE [SVG]: processor time in user mode of whole runs with one thread, each the median of five, so that other work on the
machine changes little. The surface is sin(r)/r with 61 curves each way and n x n samples.
"""
import math
import os
import statistics
import subprocess
import sys

RUNS = 5
SIDES = [100, 200, 300, 500, 700, 1000, 1400, 2000, 3000]
MOST_MESH_SAMPLES = 2_000_000  # a mesh takes about half a kilobyte for each
SERIES = [("horizon", []), ("mesh (appel)", ["--method", "appel"])]


def user_seconds(ligne, side, options):
    arguments = [ligne, "surface", "sin(r)/r", "-x", "-12:12:61", "-y", "-12:12:61", "--samples", str(side + 1), "--threads", "1", "-q", "-o", "/dev/null"]
    arguments += ["--format", "svg"] + options
    process = subprocess.Popen(arguments)
    _, status, usage = os.wait4(process.pid, 0)
    if status != 0:
        sys.exit("failed: " + " ".join(arguments))
    return usage.ru_utime


def samples(side):
    """Of n x n as the program makes them: the same number between any two of the 61 curves."""
    return (60 * math.ceil(side / 60) + 1) ** 2


def measure(ligne):
    series = []
    for name, options in SERIES:
        points = []
        for side in SIDES:
            n = samples(side)
            if options and n > MOST_MESH_SAMPLES:
                continue
            points.append((n, statistics.median(user_seconds(ligne, side, options) for _ in range(RUNS))))
            print(f"{name:14} {n:10} samples {points[-1][1]:8.3f} s {points[-1][1] / n * 1e6:7.3f} us a sample", flush=True)
        series.append((name, points))
    return series


WIDTH, HEIGHT, LEFT, TOP, RIGHT, BOTTOM = 640, 420, 70, 20, 150, 50


class Scale:
    """Decades of a quantity along a stretch of the picture."""

    def __init__(self, low, high, begin, end):
        self.low, self.high, self.begin, self.end = math.floor(math.log10(low)), math.ceil(math.log10(high)), begin, end

    def __call__(self, value):
        return self.begin + (math.log10(value) - self.low) / (self.high - self.low) * (self.end - self.begin)


def plot(series):
    every = [p for _, points in series for p in points]
    x = Scale(min(n for n, _ in every), max(n for n, _ in every), LEFT, WIDTH - RIGHT)
    y = Scale(min(t for _, t in every), max(t for _, t in every), HEIGHT - BOTTOM, TOP)
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" viewBox="0 0 {WIDTH} {HEIGHT}" font-family="DejaVu Sans, sans-serif" font-size="12">',
           '<rect width="100%" height="100%" fill="#fff"/>']
    raised = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
    for decade in range(x.low, x.high + 1):
        at = x(10**decade)
        out.append(f'<path d="M{at:.1f} {TOP}V{HEIGHT - BOTTOM}" stroke="#ccc"/><text x="{at:.1f}" y="{HEIGHT - BOTTOM + 18}" text-anchor="middle">10{str(decade).translate(raised)}</text>')
    for decade in range(y.low, y.high + 1):
        at = y(10.0**decade)
        out.append(f'<path d="M{LEFT} {at:.1f}H{WIDTH - RIGHT}" stroke="#ccc"/><text x="{LEFT - 6}" y="{at + 4:.1f}" text-anchor="end">{10.0**decade:g} s</text>')
    out.append(f'<text x="{(LEFT + WIDTH - RIGHT) / 2}" y="{HEIGHT - 10}" text-anchor="middle">samples n</text>')
    # n log n through the last point of the first series.
    n1, t1 = series[0][1][-1]
    factor = t1 / (n1 * math.log(n1))
    line = [(n, factor * n * math.log(n)) for n, _ in series[0][1]]
    line = [(n, t) for n, t in line if t >= 10.0**y.low]
    curves = [("n log n", line, 'stroke="#888" stroke-dasharray="6 4"')] + [
        (name, points, f'stroke="{color}"') for (name, points), color in zip(series, ("#000", "#c40"))]
    for name, points, style in curves:
        data = "L".join(f"{x(n):.1f} {y(t):.1f}" for n, t in points)
        out.append(f'<path d="M{data}" fill="none" stroke-width="1.5" {style}/>')
        end_x, end_y = x(points[-1][0]), y(points[-1][1]) + (14 if name == "n log n" else 4)
        out.append(f'<text x="{end_x + 8:.1f}" y="{end_y:.1f}">{name}</text>')
        if name != "n log n":
            out += [f'<circle cx="{x(n):.1f}" cy="{y(t):.1f}" r="3" fill="{style[8:12]}"/>' for n, t in points]
    return "\n".join(out + ["</svg>"]) + "\n"


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    root = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    file = sys.argv[2] if len(sys.argv) == 3 else os.path.join(root, "docs/images/surface-times.svg")
    series = measure(sys.argv[1])
    with open(file, "w", encoding="utf-8") as out:
        out.write(plot(series))


main()
