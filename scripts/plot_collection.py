#!/usr/bin/env python3
"""Run `ligne plot` over a folder of SVG files and say how many are accepted, whether what comes out is what went in, and
whether the plot takes less time than in the order of the file.

    scripts/plot_collection.py FOLDER [--ligne build/release/src/cli/ligne] [--keep DIR] [--device NAME]

To be run by hand, with public collections of drawings; docs/notes/plotting.md has the figures. Needs rsvg-convert, numpy and
Pillow.

What is compared: a picture of the lines that should be drawn, black, with round ends, of the widths in the file, made from
the file by this script without any code of ours, against a picture of the result. Where they
differ, finer ones are compared, in which the narrowest stroke is some pixels wide. Filled areas without a line of their own
are outlined with 0.35 mm. White areas are painted white, in the order of the file, and so hide what lies under them; those
that are translucent have no line and hide nothing. A pen cannot be half hidden, and its ends are round: where a white area
covers a line, ink within half a pen of the area's rim, on both sides of it, does not count in either picture. Texts are left out on both sides,
since a typeface is no stroke font. `ink` is the difference of the two amounts of ink; `stray` is ink of either that lies
farther than a pixel, and than 0.02 mm, from all ink of the other.
"""

import argparse
import io
import itertools
import math
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

import numpy
from PIL import Image

Image.MAX_IMAGE_PIXELS = None  # the pictures are our own

SVG = "http://www.w3.org/2000/svg"
SHAPES = {"path", "line", "polyline", "polygon", "rect", "circle", "ellipse"}
KEYS = ("fill", "stroke", "stroke-width", "fill-opacity", "stroke-opacity", "opacity", "display", "visibility",
        "stroke-dasharray", "stroke-linecap")
INHERITED = {"fill", "stroke", "stroke-width", "fill-opacity", "stroke-opacity", "visibility", "stroke-dasharray",
             "stroke-linecap"}
UNSEEN = {"text", "style", "flowRoot", "image", "metadata", "title", "desc", "defs", "symbol", "clipPath", "mask", "marker",
          "linearGradient", "radialGradient", "filter", "pattern", "script"}
# Share of the longer side. A stroke of one pixel is darkest where it lies on a row of them, so the narrowest one should be wider.
PIXELS, MOST_PIXELS, PIXELS_OF_STROKE = 3200, 9600, 3
LEAST_STEPS = 32  # of a curve: half a circle in so many chords is 0.04 % too short
PEN_MM = 0.35
PATIENCE_S = 300  # scribbles of many thousand crossings take a renderer hours
NEAR_MM = 0.02  # what lines may move by default: nobody sees it
ACCEPTED, AGREES = 0.98, 0.002


def local(tag):
    return tag.rsplit("}", 1)[-1] if isinstance(tag, str) else ""


def declarations(text):
    pairs = (part.split(":", 1) for part in text.split(";") if ":" in part)
    return {name.strip(): value.replace("!important", "").strip() for name, value in pairs}


def rules_of(root):
    """Rules of one element, class or id; others are not of this collection."""
    rules = []
    for style in root.iter(f"{{{SVG}}}style"):
        css = re.sub(r"/\*.*?\*/", "", "".join(style.itertext()), flags=re.S)
        for selectors, body in re.findall(r"([^{}]+){([^{}]*)}", css):
            rules += [(s.strip(), declarations(body)) for s in selectors.split(",")]
    return rules


def style_of(node, inherited, rules):
    style = {k: v for k, v in inherited.items() if k in INHERITED}
    own = {k: node.get(k) for k in KEYS if node.get(k)}
    classes, name, number = (node.get("class") or "").split(), local(node.tag), node.get("id")
    for selector, said in rules:
        if selector in ("*", name, f"#{number}") or any(selector in (f".{c}", f"{name}.{c}") for c in classes):
            own.update(said)
    own.update(declarations(node.get("style") or ""))
    style.update({k: v for k, v in own.items() if k in KEYS and v != "inherit"})
    return style


def opacity(text):
    try:
        return float(text.rstrip("%"))
    except ValueError:
        return 1


def shows(style, key):
    paint = style.get(key, "black" if key == "fill" else "none")
    return paint not in ("none", "transparent") and opacity(style.get(f"{key}-opacity", "1")) > 0


def is_white(text):
    return text.replace(" ", "").lower() in ("#fff", "#ffffff", "white", "rgb(255,255,255)", "rgb(100%,100%,100%)")


def matrix_of(text):
    """A list of transforms as a, b, c, d, e, f."""
    result = (1.0, 0.0, 0.0, 1.0, 0.0, 0.0)
    for name, said in re.findall(r"(\w+)\s*\(([^)]*)\)", text or ""):
        v = numbers(said)
        m = (1.0, 0.0, 0.0, 1.0, 0.0, 0.0)
        if name == "matrix":
            m = tuple(v[:6])
        elif name == "translate":
            m = (1.0, 0.0, 0.0, 1.0, v[0], v[1] if len(v) > 1 else 0.0)
        elif name == "scale":
            m = (v[0], 0.0, 0.0, v[-1], 0.0, 0.0)
        elif name == "rotate":
            turn, (x, y) = math.radians(v[0]), v[1:3] if len(v) > 2 else (0.0, 0.0)
            c, s = math.cos(turn), math.sin(turn)
            m = (c, s, -s, c, x - c * x + s * y, y - s * x - c * y)
        elif name == "skewX":
            m = (1.0, 0.0, math.tan(math.radians(v[0])), 1.0, 0.0, 0.0)
        elif name == "skewY":
            m = (1.0, math.tan(math.radians(v[0])), 0.0, 1.0, 0.0, 0.0)
        result = product(result, m)
    return result


def product(m, n):
    return (m[0] * n[0] + m[2] * n[1], m[1] * n[0] + m[3] * n[1], m[0] * n[2] + m[2] * n[3], m[1] * n[2] + m[3] * n[3],
            m[0] * n[4] + m[2] * n[5] + m[4], m[1] * n[4] + m[3] * n[5] + m[5])


def numbers(text):
    return [float(x) for x in re.findall(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?", text or "")]


UNITS = {"": 1, "px": 1, "mm": 96 / 25.4, "cm": 96 / 2.54, "in": 96, "pt": 96 / 72, "pc": 16}


def length(text, otherwise=0.0):
    found = re.match(r"\s*([-+\d.eE]*\d\.?)\s*([a-z]*)\s*$", text or "")
    return float(found[1]) * UNITS[found[2]] if found and found[2] in UNITS else otherwise


def bezier(points, scale):
    """Points of a curve behind its first one; steps far below a pixel."""
    reach = sum(math.dist(p, q) for p, q in zip(points, points[1:])) * scale
    count = max(LEAST_STEPS, min(400, math.ceil(reach)))
    out = []
    for i in range(1, count + 1):
        row, t = list(points), i / count
        while len(row) > 1:
            row = [(p[0] + (q[0] - p[0]) * t, p[1] + (q[1] - p[1]) * t) for p, q in zip(row, row[1:])]
        out.append(row[0])
    return out


def arc(start, rx, ry, turn, large, sweep, end, scale):
    """SVG 1.1, F.6.5."""
    rx, ry = abs(rx), abs(ry)
    if rx == 0 or ry == 0 or start == end:
        return [end]
    c, s = math.cos(math.radians(turn)), math.sin(math.radians(turn))
    dx, dy = (start[0] - end[0]) / 2, (start[1] - end[1]) / 2
    x, y = c * dx + s * dy, -s * dx + c * dy
    grow = (x / rx) ** 2 + (y / ry) ** 2
    if grow > 1:
        rx, ry = rx * math.sqrt(grow), ry * math.sqrt(grow)
    below = (rx * y) ** 2 + (ry * x) ** 2
    root = math.sqrt(max(0.0, ((rx * ry) ** 2 - below) / below)) * (-1 if large == sweep else 1)
    cx, cy = root * rx * y / ry, -root * ry * x / rx
    first = math.atan2((y - cy) / ry, (x - cx) / rx)
    over = math.atan2((-y - cy) / ry, (-x - cx) / rx) - first
    if sweep and over < 0:
        over += 2 * math.pi
    if not sweep and over > 0:
        over -= 2 * math.pi
    mx, my = (start[0] + end[0]) / 2, (start[1] + end[1]) / 2
    count = max(LEAST_STEPS, min(2000, math.ceil(abs(over) * max(rx, ry) * scale)))
    out = []
    for i in range(1, count):
        u, v = cx + rx * math.cos(first + over * i / count), cy + ry * math.sin(first + over * i / count)
        out.append((c * u - s * v + mx, s * u + c * v + my))
    return out + [end]


def path_lines(data, scale):
    """Lines of a path: lists of points."""
    tokens = re.findall(r"[A-Za-z]|[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?", data or "")
    lines, line, at, start, i, command, control, last = [], [], (0.0, 0.0), (0.0, 0.0), 0, "", None, ""
    flags = re.compile(r"[01]")

    def take():
        nonlocal i
        i += 1
        return float(tokens[i - 1])

    def flag():
        """The flags of an arc need nothing between them."""
        nonlocal i
        text = tokens[i]
        if len(text) > 1 and flags.match(text):
            tokens[i] = text[1:]
            return text[0] == "1"
        i += 1
        return text == "1"

    while i < len(tokens):
        if tokens[i].isalpha():
            command = tokens[i]
            i += 1
        elif command in "Mm":
            command = "L" if command == "M" else "l"
        kind, origin = command.upper(), at if command.islower() else (0.0, 0.0)

        def point():
            x = take()
            return (origin[0] + x, origin[1] + take())

        mirrored = (2 * at[0] - control[0], 2 * at[1] - control[1]) if control else at
        if last not in last_of(kind):
            mirrored = at
        more, control = [], None
        if kind == "M":
            if len(line) > 1:
                lines.append(line)
            at = start = point()
            line, last = [at], kind
            continue
        if kind == "Z":
            if line and line[-1] != start:
                line.append(start)
            if len(line) > 1:
                lines.append(line)
            at, line, last = start, [start], kind
            continue
        if kind == "L":
            more = [point()]
        elif kind == "H":
            more = [(origin[0] + take(), at[1])]
        elif kind == "V":
            more = [(at[0], origin[1] + take())]
        elif kind in "CS":
            one = point() if kind == "C" else mirrored
            control = point()
            more = bezier([at, one, control, point()], scale)
        elif kind in "QT":
            control = point() if kind == "Q" else mirrored
            more = bezier([at, control, point()], scale)
        elif kind == "A":
            rx, ry, turn = take(), take(), take()
            large, sweep = flag(), flag()
            more = arc(at, rx, ry, turn, large, sweep, point(), scale)
        else:
            raise ValueError(f"path command {command}")
        line.extend(more)
        at, last = more[-1], kind
    if len(line) > 1:
        lines.append(line)
    return lines


def last_of(kind):
    """Which commands leave a control point for this one."""
    return ("C", "S") if kind == "S" else ("Q", "T") if kind == "T" else ()


def shape_lines(shape, scale):
    name, get = local(shape.tag), lambda key, otherwise=0.0: length(shape.get(key), otherwise)
    if name == "path":
        return path_lines(shape.get("d"), scale)
    if name == "line":
        return [[(get("x1"), get("y1")), (get("x2"), get("y2"))]]
    if name in ("polyline", "polygon"):
        v = numbers(shape.get("points"))
        line = list(zip(v[::2], v[1::2]))
        return [line + line[:1]] if name == "polygon" else [line]
    if name == "rect":
        x, y, w, h = get("x"), get("y"), get("width"), get("height")
        rx, ry = get("rx", get("ry")), get("ry", get("rx"))
        rx, ry = min(rx, w / 2), min(ry, h / 2)
        if not (w > 0 and h > 0):
            return []
        if rx <= 0 or ry <= 0:
            return path_lines(f"M{x} {y}h{w}v{h}h{-w}z", scale)
        a = f"a{rx} {ry} 0 0 1"
        return path_lines(f"M{x + rx} {y}h{w - 2 * rx}{a} {rx} {ry}v{h - 2 * ry}{a} {-rx} {ry}h{2 * rx - w}{a} {-rx} {-ry}"
                          f"v{2 * ry - h}{a} {rx} {-ry}z", scale)
    x, y, rx = get("cx"), get("cy"), get("r") if name == "circle" else get("rx")
    ry = rx if name == "circle" else get("ry")
    if not (rx > 0 and ry > 0):
        return []
    return path_lines(f"M{x + rx} {y}A{rx} {ry} 0 1 1 {x - rx} {y}A{rx} {ry} 0 1 1 {x + rx} {y}z", scale)


class NotCompared(Exception):
    """Something that this script does not draw."""


def reference(node, inherited, rules, matrix, out, seen=1.0):
    """The lines that should be drawn, in px of the page. `seen`: the opacity of what they are in."""
    for child in node:
        name = local(child.tag)
        if not (isinstance(child.tag, str) and child.tag.startswith(f"{{{SVG}}}")) or name in UNSEEN:
            continue
        style = style_of(child, inherited, rules)
        shown = seen * opacity(style.get("opacity", "1"))
        if style.get("display") == "none" or shown == 0:
            continue
        said = declarations(child.get("style") or "")
        if name in ("use", "svg", "switch") or any((child.get(k) or said.get(k, "none")) != "none" for k in ("clip-path", "mask")):
            raise NotCompared
        inside = product(matrix, matrix_of(child.get("transform") or said.get("transform")))
        if name in SHAPES:
            add_shape(child, style, inside, out, shown)
        else:
            reference(child, style, rules, inside, out, shown)


def add_shape(shape, style, m, out, seen):
    size = math.sqrt(abs(m[0] * m[3] - m[1] * m[2]))
    width = length(style.get("stroke-width", "1"), 1.0) * size
    stroked = shows(style, "stroke") and width > 0
    filled = shows(style, "fill") and local(shape.tag) != "line"
    white = filled and is_white(style.get("fill", "black"))
    if white and seen * opacity(style.get("fill-opacity", "1")) < 1:
        white = filled = False
    if style.get("visibility") in ("hidden", "collapse") or not (stroked or filled):
        return
    lines = [[(m[0] * x + m[2] * y + m[4], m[1] * x + m[3] * y + m[5]) for x, y in line]
             for line in shape_lines(shape, size * PIXELS / 1000)]
    said = "fill:#fff" if white else "fill:none"
    if filled and not white and not stroked:
        lines = [line + line[:1] if line and line[0] != line[-1] else line for line in lines]
        width = PEN_MM * 96 / 25.4
        stroked = True
    if stroked:
        said += f";stroke:#000;stroke-width:{width:.4f}"
        if re.match(r"[\d.]", style.get("stroke-dasharray", "none")) and any(numbers(style["stroke-dasharray"])):
            said += ";stroke-dasharray:" + ",".join(str(v * size) for v in numbers(style["stroke-dasharray"]))
    data = "".join("M" + "L".join(f"{x:.5g},{y:.5g}" if abs(x) < 1 else f"{x:.3f},{y:.3f}" for x, y in line)
                   for line in lines if len(line) > 1)
    if data:
        rule = ";fill-rule:evenodd" if "evenodd" in ((shape.get("style") or "") + (shape.get("fill-rule") or "")) else ""
        out.append((said + rule, data))


def pixels(svg, width, height):
    """Darkness from 0 to 1."""
    command = ["rsvg-convert", "--unlimited", "-w", str(width), "-h", str(height), "-b", "white"]
    run = subprocess.run(command, input=svg, capture_output=True, check=True, timeout=PATIENCE_S)
    return 1 - numpy.asarray(Image.open(io.BytesIO(run.stdout)).convert("L"), numpy.float32) / 255


def grown(ink, reach):
    return 1 - eroded(1 - ink, reach)


def root_matrix(root, page):
    """From the units of the file to px, where its viewBox says something of them."""
    box = numbers(root.get("viewBox"))
    if len(box) != 4:
        return (1.0, 0.0, 0.0, 1.0, 0.0, 0.0)
    if root.get("preserveAspectRatio", "xMidYMid") not in ("xMidYMid", "xMidYMid meet"):
        raise NotCompared
    width, height = page[0] * 96 / 25.4, page[1] * 96 / 25.4
    unit = min(width / box[2], height / box[3])
    return (unit, 0.0, 0.0, unit, (width - unit * box[2]) / 2 - unit * box[0], (height - unit * box[3]) / 2 - unit * box[1])


def shapes_of(source, page):
    """What is painted, in order: its style and its path."""
    root = ElementTree.fromstring(source)
    rules = rules_of(root)
    if any(set(selector) & set(" >[:+~") for selector, _ in rules):
        raise NotCompared
    shapes = []
    reference(root, style_of(root, {}, rules), rules, root_matrix(root, page), shapes)
    return shapes


def hides(shape):
    return "#fff" in shape[0]


def flat(shapes, page):
    """The shapes as one file. Between white areas the order does not show, so lines of one style are one path there: the rims
    of lines that are there twice are not painted twice."""
    text = (f'<svg xmlns="{SVG}" width="{page[0]}mm" height="{page[1]}mm" viewBox="0 0 {page[0] * 96 / 25.4} '
            f'{page[1] * 96 / 25.4}" stroke-linecap="round" stroke-linejoin="round">')
    for white, run in itertools.groupby(shapes, hides):
        if white:
            text += "".join(f'<path style="{style}" d="{data}"/>' for style, data in run)
            continue
        for style, group in itertools.groupby(sorted(run, key=lambda shape: shape[0]), lambda shape: shape[0]):
            text += f'<path style="{style}" d="{"".join(data for _, data in group)}"/>'
    return (text + "</svg>").encode()


def eroded(seen, reach):
    """The least value within a square of 2 reach + 1 pixels, by windows that double."""
    for axis in (0, 1):
        wide, least = 1, seen
        while wide < 2 * reach + 1:
            step = min(wide, 2 * reach + 1 - wide)
            least = numpy.minimum(least, numpy.roll(least, step, axis))
            wide += step
        seen = numpy.roll(least, -reach, axis)
    return seen


def stroke_widths(shapes):
    """In px of the page."""
    return [float(width) for style, _ in shapes for width in re.findall(r"stroke-width:([\d.]+)", style)]


def longer_side(shapes, page):
    """How many pixels it has."""
    narrowest = min((w for w in stroke_widths(shapes) if w > 0), default=PEN_MM * 96 / 25.4)
    return min(MOST_PIXELS, max(PIXELS, math.ceil(PIXELS_OF_STROKE * max(page) * 96 / 25.4 / narrowest)))


def white_rims(shapes, seen, page, width, height):
    """0 where a white area covers ink, within half a pen of its rim, and where a line may stick out that is so covered, 1
    elsewhere. `seen`: the picture of the shapes."""
    if not any(map(hides, shapes)):
        return 1
    bare = [(style.replace("fill:#fff", "fill:none"), data) for style, data in shapes if "stroke:#000" in style]
    covered = pixels(flat(bare, page), width, height) > seen
    everywhere = ("fill:#000", f"M0,0H{page[0] * 4}V{page[1] * 4}H0z")
    white = 1 - pixels(flat([everywhere, *shapes], page), width, height)
    widest = max(stroke_widths(shapes), default=0)
    reach = math.ceil(widest / 2 * width / (page[0] * 96 / 25.4)) + 1
    halved = covered & (white > 0) & (eroded(white, reach) < 1)
    return 1 - grown(halved, reach)


def compare(source, result, page):
    """Difference of the ink, and stray ink, as parts of it; None where the script can not draw the file."""
    try:
        drawn = shapes_of(source, page), shapes_of(result, page)
    except NotCompared:
        return None
    coarse = difference(drawn, page, PIXELS)
    fine = longer_side(drawn[0], page)
    return coarse if max(coarse) <= AGREES or fine == PIXELS else difference(drawn, page, fine)


def difference(drawn, page, pixels_of_side):
    pixel_mm = max(page) / pixels_of_side
    width, height = (max(1, round(side / pixel_mm)) for side in page)
    before, after = (pixels(flat(shapes, page), width, height) for shapes in drawn)
    counts = white_rims(drawn[0], before, page, width, height)
    before, after = before * counts, after * counts
    ink = before.sum()
    if ink == 0:
        return (0.0 if after.sum() == 0 else 1.0), 0.0
    reach = max(1, math.ceil(NEAR_MM / pixel_mm))
    stray = sum(float(numpy.maximum(one - grown(other, reach), 0).sum()) for one, other in ((before, after), (after, before)))
    return float(abs(after.sum() - ink) / ink), float(stray / ink)


def seconds(report, device):
    """Time before and after from the lengths of a report, finer than the whole seconds that it prints."""
    rows = {}
    for name in ("before", "after"):
        fields = re.search(rf"^{name} +(\d+) +([\d.]+) m +([\d.]+) m +(\d+)", report, re.M)
        if not fields:
            return None
        strokes, down, up = int(fields[1]), float(fields[2]) * 1000, float(fields[3]) * 1000
        rows[name] = (strokes, down / device["speed_down"] + up / device["speed_up"] + strokes * device["lift"])
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--ligne", default="build/release/src/cli/ligne")
    parser.add_argument("--keep", type=pathlib.Path, help="a folder for the results")
    parser.add_argument("--only", default="", help="files whose path contains this")
    parser.add_argument("--quick", action="store_true", help="accepted or not, nothing else")
    given = parser.parse_args()
    device = {"speed_down": 40.0, "speed_up": 80.0, "lift": 0.25}  # grbl-servo
    files = sorted(p for p in given.folder.rglob("*") if p.suffix.lower() == ".svg" and given.only in str(p))
    accepted, compared, agree, slower, timed = [], 0, 0, [], 0
    total = {"before": 0.0, "after": 0.0}
    for file in files:
        name = str(file.relative_to(given.folder))
        with tempfile.TemporaryDirectory() as folder:
            out, plot = pathlib.Path(folder, "out.svg"), pathlib.Path(folder, "out.gcode")
            run = subprocess.run([given.ligne, "plot", file, "--skip", "text", "-o", out], capture_output=True, text=True)
            if run.returncode != 0:
                print(f"refused   {name}: {run.stderr.strip().splitlines()[-1:]}")
                continue
            accepted.append(name)
            if given.quick:
                continue
            result = out.read_bytes()
            if given.keep:
                kept = given.keep / name.replace("/", "__")
                kept.parent.mkdir(parents=True, exist_ok=True)
                kept.write_bytes(result)
            size = re.search(rb'width="([\d.]+)mm" height="([\d.]+)mm"', result)
            try:
                found = compare(file.read_bytes(), result, (float(size[1]), float(size[2])))
            except (ElementTree.ParseError, subprocess.SubprocessError) as error:
                print(f"unread    {name}: {str(error)[:80]}")
                found = None
            if found:
                compared += 1
                agree += found[0] <= AGREES
                if found[0] > AGREES or found[1] > AGREES:
                    print(f"differs   {name}: ink {100 * found[0]:.3f} %, stray {100 * found[1]:.3f} %")
            run = subprocess.run([given.ligne, "plot", file, "--fit-device", "--report", "-o", plot],
                                 capture_output=True, text=True)
            rows = seconds(run.stderr, device)
            if rows is None:
                print(f"no time   {name}: {run.stderr.strip().splitlines()[-1:]}")
                continue
            timed += 1
            for row in total:
                total[row] += rows[row][1]
            # Lengths are printed to a millimetre.
            if rows["after"][1] > rows["before"][1] + 0.002 / device["speed_down"] + 0.002 / device["speed_up"]:
                slower.append(name)
                print(f"slower    {name}: {rows['before']} -> {rows['after']}")
    print(f"{len(files)} files, {len(accepted)} accepted ({100 * len(accepted) / max(1, len(files)):.1f} %)")
    if not given.quick:
        print(f"{compared} compared, {agree} within {100 * AGREES} % of their ink; "
              f"{timed} timed, {len(slower)} slower; {total['before'] / 3600:.1f} h before, {total['after'] / 3600:.1f} h after")
    good = len(accepted) >= ACCEPTED * len(files) and agree == compared and not slower
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
