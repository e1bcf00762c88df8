#!/usr/bin/env python3
"""Hold `ligne plot` against reference pictures: folders in which each FILE.svg has a FILE.png beside it, such as the test
suite of resvg.

    scripts/plot_reference.py FOLDER [--ligne build/release/src/cli/ligne] [--sheet DIR]

To be run by hand; docs/notes/plotting.md has the figures. Needs numpy, scipy and Pillow.

Fills are plotted as outlines, strokes as lines of their width, and --occlude hides what lies under opaque areas, as in the
picture. So two things are measured, both in pixels of the reference, with a tolerance of TOLERANCE_PX:

- stray: the part of the plotted length that the picture does not explain. A line that stands for a fill must lie on an edge of
  the picture, a stroke on an edge or on ink.
- lacking: the part of the picture's edges that the plot does not explain. An edge must lie on the line of a fill, or on the
  border of a stroke: half its width from its middle line, farther at mitred corners, nearer at ends, which pens make round.

A file agrees when both are at most AGREES. Files with images, filters, texts and foreignObject are left out. Inside a gradient
or a pattern the picture has edges that no outline stands for: of files with such paints only `stray` counts.
"""

import argparse
import math
import pathlib
import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

import numpy
from PIL import Image, ImageDraw
from scipy import ndimage

SVG = "{http://www.w3.org/2000/svg}"
NOT_COMPARED = re.compile(r"<(\w+:)?(image|feImage|text|foreignObject|filter)\b|\bfilter\s*[:=]")
PAINTS = re.compile(r"radient|<(\w+:)?(pattern|hatch|mesh)")
FINE = 4  # cells of the distance maps along a side of a pixel
TOLERANCE_PX = 1.75  # antialiasing spreads an edge over two pixels, and both beside it count
AGREES = 0.02
FAINT, CLEAR = 0.02, 0.12  # differences of neighbours, of 1: that may be an edge, and that is one
MITRE_LIMIT = 4.0  # where a file tells none
PEN_MM = 0.35


def plotted(ligne, file):
    """The page in mm, and lists of lines by (width in mm, colour); None when the file is refused. A file that draws nothing
    gives no lines."""
    options = ["--occlude", "--fill", "outline", "--optimize", "off", "--format", "svg", "-o", "-"]
    command = [ligne, "plot", file, *options]
    run = subprocess.run(command, capture_output=True, text=True, timeout=60)
    if not run.stdout:
        return None, run.stderr
    root = ElementTree.fromstring(run.stdout)
    page = tuple(float(root.get(side)[:-2]) for side in ("width", "height"))
    groups = {}

    def walk(node, look):
        look = tuple(node.get(key, of_outer) for key, of_outer in zip(("stroke-width", "stroke"), look))
        if node.tag == SVG + "path":
            groups.setdefault(look, []).extend(lines_of(node.get("d")))
        for child in node:
            walk(child, look)

    walk(root, ("1", "#000"))
    return (page, [(float(width), color, lines) for (width, color), lines in groups.items()]), run.stderr


def lines_of(data):
    """Lines of a path of M, m, l, L, z and numbers as our writer makes it."""
    lines, at, start, command, values = [], (0.0, 0.0), (0.0, 0.0), "", []
    for token in re.findall(r"[A-Za-z]|-?[\d.]+(?:e-?\d+)?", data):
        if token in "Zz":
            lines[-1].append(lines[-1][0])
            at = start
        elif token.isalpha():
            command = token
        else:
            values.append(float(token))
            if len(values) < 2:
                continue
            x, y = values
            values = []
            at = (at[0] + x, at[1] + y) if command.islower() else (x, y)
            if command in "Mm":
                lines.append([at])
                start = at
                command = "l" if command == "m" else "L"
            else:
                lines[-1].append(at)
    return lines


def edges_of(picture):
    """Largest difference of the pixels beside each pixel, of 1."""
    step = numpy.zeros(picture.shape[:2])
    for axis in (0, 1):
        far = numpy.abs(numpy.diff(picture, axis=axis)).max(2)
        grown = [(0, 0), (0, 0)]
        grown[axis] = (1, 0)
        step = numpy.maximum(step, numpy.pad(far, grown))
        grown[axis] = (0, 1)
        step = numpy.maximum(step, numpy.pad(far, grown))
    return step


def distance_to(lines, size, scale):
    """Distance in pixels of each pixel's middle to the lines, whose points are in mm."""
    image = Image.new("1", (size[0] * FINE, size[1] * FINE), 1)
    draw = ImageDraw.Draw(image)
    for line in lines:
        points = [((x * scale[0]) * FINE - 0.5, (y * scale[1]) * FINE - 0.5) for x, y in line]
        draw.line([p for point in points for p in point] if len(points) > 1 else [*points[0], *points[0]], fill=0)
    cells = numpy.asarray(image, bool)
    if cells.all():
        return numpy.full((size[1], size[0]), 1e9)
    far = ndimage.distance_transform_edt(cells) / FINE
    return far.reshape(size[1], FINE, size[0], FINE).mean((1, 3))


def corners_of(lines, half, limit):
    """Places of ends and corners, and how far from them ink of a line of half that width may reach, in the unit of both."""
    for line in lines:
        closed = len(line) > 2 and line[0] == line[-1]
        for i, at in enumerate(line):
            before = line[i - 1] if i > 0 else line[-2] if closed else None
            behind = line[i + 1] if i + 1 < len(line) else line[1] if closed else None
            if before is None or behind is None or before == at or behind == at:
                yield at, half * math.sqrt(2)
                continue
            ways = [math.atan2(q[1] - p[1], q[0] - p[0]) for p, q in ((before, at), (at, behind))]
            turn = abs(math.remainder(ways[1] - ways[0], 2 * math.pi))
            if turn > math.pi / 12:
                reach = 1 / max(math.cos(turn / 2), 1e-9)
                yield at, half * (reach if reach <= limit else 1)


def near_corners(lines, half_mm, size, scale, limit):
    image = Image.new("1", size, 0)
    draw = ImageDraw.Draw(image)
    for (x, y), reach in corners_of(lines, half_mm, limit):
        rx, ry = reach * scale[0] + TOLERANCE_PX, reach * scale[1] + TOLERANCE_PX
        draw.ellipse([x * scale[0] - rx, y * scale[1] - ry, x * scale[0] + rx, y * scale[1] + ry], fill=1)
    return numpy.asarray(image, bool)


def samples_of(lines, size, scale):
    """Pixels along the lines, one per pixel of length, inside the picture."""
    out = []
    for line in lines:
        pixels = [(x * scale[0], y * scale[1]) for x, y in line]
        for p, q in zip(pixels, pixels[1:] or pixels):
            count = max(1, round(math.dist(p, q)))
            for k in range(count):
                t = (k + 0.5) / count
                out.append((p[0] + (q[0] - p[0]) * t, p[1] + (q[1] - p[1]) * t, math.dist(p, q) / count))
    out = [(int(y), int(x), length) for x, y, length in out if 0 <= x < size[0] and 0 <= y < size[1]]
    return out


class Comparison:
    """Of one file: `stray` and `lacking` as parts of 1, and where they lie, as pixels."""

    def __init__(self, page, groups, picture, mitre_limit):
        size = picture.shape[1], picture.shape[0]
        scale = size[0] / page[0], size[1] / page[1]
        step = edges_of(picture)
        to_faint = ndimage.distance_transform_edt(step < FAINT) if (step >= FAINT).any() else numpy.full(step.shape, 1e9)
        inked = (picture < 1 - FAINT).any(2)
        # An edge is where the difference is as large as beside it: antialiasing leaves smaller ones.
        clear = step >= CLEAR
        explained = numpy.zeros(step.shape, bool)
        self.stray_at, self.length, stray = [], 0.0, 0.0
        for width, _, lines in groups:
            is_outline = width == PEN_MM
            half = 0 if is_outline else width / 2
            half_px = half * (scale[0] + scale[1]) / 2
            far = distance_to(lines, size, scale)
            explained |= numpy.abs(far - half_px) <= TOLERANCE_PX
            if not is_outline:
                explained |= near_corners(lines, half, size, scale, mitre_limit)
            for y, x, length in samples_of(lines, size, scale):
                self.length += length
                if to_faint[y, x] <= TOLERANCE_PX or (not is_outline and inked[y, x]):
                    continue
                stray += length
                self.stray_at.append((y, x))
        self.lacking_at = numpy.argwhere(clear & ~explained)
        self.stray = stray / self.length if self.length else 0.0
        self.lacking = len(self.lacking_at) / max(1, clear.sum())


def reference(file):
    """The picture on white paper, of values from 0 to 1."""
    image = Image.open(file).convert("RGBA")
    paper = Image.new("RGBA", image.size, "white")
    return numpy.asarray(Image.alpha_composite(paper, image).convert("RGB"), float) / 255


def shown(picture, groups, page, comparison):
    """The reference, the plot, and on top of a pale reference: stray lines red, lacking edges blue."""
    size = picture.shape[1], picture.shape[0]
    first = Image.fromarray((picture * 255).astype(numpy.uint8))
    second = Image.new("RGB", size, "white")
    draw = ImageDraw.Draw(second)
    for width, color, lines in groups:
        for line in lines:
            points = [(x * size[0] / page[0], y * size[1] / page[1]) for x, y in line]
            wide = 1 if width == PEN_MM else max(1, round(width * size[0] / page[0]))
            draw.line(points if len(points) > 1 else points * 2, fill=color, width=wide)
    third = Image.fromarray((255 - (1 - picture) * 80).astype(numpy.uint8))
    if comparison:
        for y, x in comparison.stray_at:
            third.putpixel((int(x), int(y)), (255, 0, 0))
        for y, x in comparison.lacking_at:
            third.putpixel((int(x), int(y)), (0, 0, 255))
    sheet = Image.new("RGB", (size[0] * 3 + 20, size[1]), "gray")
    for i, one in enumerate((first, second, third)):
        sheet.paste(one, (i * (size[0] + 10), 0))
    return sheet


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--ligne", default="build/release/src/cli/ligne")
    parser.add_argument("--sheet", type=pathlib.Path, help="a folder for pictures of the files that do not agree")
    parser.add_argument("--only", default="", help="files whose path contains this")
    given = parser.parse_args()
    counts = {}
    for file in sorted(given.folder.rglob("*.svg")):
        name, picture_file = str(file.relative_to(given.folder)), file.with_suffix(".png")
        text = file.read_text(errors="replace")
        if given.only not in name or not picture_file.exists() or NOT_COMPARED.search(text):
            continue
        kind = "with gradients or patterns" if PAINTS.search(text) else "plain"
        picture = reference(picture_file)
        plot, message = plotted(given.ligne, file)
        page, groups = plot or (None, [])
        if page is None:  # a file that draws nothing may be refused
            page = picture.shape[1], picture.shape[0]
        limits = re.findall(r"stroke-miterlimit\s*[:=]\s*[\"']?([\d.]+)", text)
        mitre_limit = max([MITRE_LIMIT, *map(float, limits)])
        found = Comparison(page, groups, picture, mitre_limit)
        agrees = found.stray <= AGREES and (found.lacking <= AGREES or kind != "plain")
        counts.setdefault(kind, [0, 0])[0 if agrees else 1] += 1
        if not agrees:
            said = message.strip().split("warning: ")[-1].split("error: ")[-1].replace("\n", " ")
            print(f"differs  {name}: stray {100 * found.stray:.1f} %, lacking {100 * found.lacking:.1f} %  [{said[:100]}]")
            if given.sheet:
                given.sheet.mkdir(parents=True, exist_ok=True)
                shown(picture, groups, page, found).save(given.sheet / (name.replace("/", "__")[:-4] + ".png"))
    for kind, (agreeing, differing) in sorted(counts.items()):
        print(f"{kind}: {agreeing} agree, {differing} do not")
    return 0


if __name__ == "__main__":
    sys.exit(main())
