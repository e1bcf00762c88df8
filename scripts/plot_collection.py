#!/usr/bin/env python3
"""Run `ligne plot` over a folder of SVG files and say how many are accepted, whether what comes out is what went in, and
whether the plot takes less time than in the order of the file.

    scripts/plot_collection.py FOLDER [--ligne build/release/src/cli/ligne] [--keep DIR] [--device NAME]

To be run by hand, with public collections of drawings; docs/plotting.md has the figures. Needs rsvg-convert, numpy and
Pillow.

What is compared: a picture of the lines that should be drawn, black, with round ends, of the widths in the file, made from
the file by this script without any code of ours, against a picture of the result. Filled areas without a line of their own
are outlined with 0.35 mm. Texts are left out on both sides, since a typeface is no stroke font. `ink` is the difference of
the two amounts of ink; `stray` is ink of either that lies farther than a pixel from all ink of the other.
"""

import argparse
import io
import math
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

import numpy
from PIL import Image

SVG = "http://www.w3.org/2000/svg"
SHAPES = {"path", "line", "polyline", "polygon", "rect", "circle", "ellipse"}
KEYS = ("fill", "stroke", "stroke-width", "fill-opacity", "stroke-opacity", "opacity", "display", "visibility",
        "stroke-dasharray", "stroke-linecap")
INHERITED = {"fill", "stroke", "stroke-width", "fill-opacity", "stroke-opacity", "visibility", "stroke-dasharray",
             "stroke-linecap"}
PIXELS = 3200  # fewer, and the rounding of strokes two pixels wide is above what is looked for
PEN_MM = 0.35
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


def linear(text):
    """The linear part of a list of transforms: a, b, c, d."""
    result = (1.0, 0.0, 0.0, 1.0)
    for name, said in re.findall(r"(\w+)\s*\(([^)]*)\)", text or ""):
        v = [float(x) for x in re.findall(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?", said)]
        m = (1.0, 0.0, 0.0, 1.0)
        if name == "matrix":
            m = tuple(v[:4])
        elif name == "scale":
            m = (v[0], 0.0, 0.0, v[-1])
        elif name == "rotate":
            turn = math.radians(v[0])
            m = (math.cos(turn), math.sin(turn), -math.sin(turn), math.cos(turn))
        elif name == "skewX":
            m = (1.0, 0.0, math.tan(math.radians(v[0])), 1.0)
        elif name == "skewY":
            m = (1.0, math.tan(math.radians(v[0])), 0.0, 1.0)
        result = product(result, m)
    return result


def product(m, n):
    return (m[0] * n[0] + m[2] * n[1], m[1] * n[0] + m[3] * n[1], m[0] * n[2] + m[2] * n[3], m[1] * n[2] + m[3] * n[3])


def stretches(m):
    """A stroke would be wider in one direction than in another; a pen is not."""
    size = math.sqrt(abs(m[0] * m[3] - m[1] * m[2]))
    return abs(abs(m[0]) - abs(m[3])) + abs(abs(m[1]) - abs(m[2])) > 1e-4 * size, size


def lines_only(node, inherited, rules, matrix):
    """Turns the tree into one of black lines. `matrix` leads to px."""
    for child in list(node):
        name = local(child.tag)
        known = isinstance(child.tag, str) and child.tag.startswith(f"{{{SVG}}}")
        if name in ("text", "style", "flowRoot", "image", "metadata", "title", "desc") or not known:
            node.remove(child)
            continue
        if name in ("clipPath", "mask", "linearGradient", "radialGradient", "filter", "pattern", "marker"):
            continue
        style = style_of(child, inherited, rules)
        if style.get("display") == "none" or opacity(style.get("opacity", "1")) == 0:
            node.remove(child)
            continue
        placing = declarations(child.get("style") or "")
        kept = [f"{k}:{placing[k]}" for k in ("clip-path", "clip-rule", "fill-rule", "stroke-dashoffset") if k in placing]
        inside = product(matrix, linear(child.get("transform")))
        if name in SHAPES:
            rewrite(child, style, kept, inside)
        elif known:
            for key in KEYS + ("filter", "mask"):
                child.attrib.pop(key, None)
            child.set("style", ";".join(kept))
            lines_only(child, style, rules, inside)


def rewrite(shape, style, kept, matrix):
    stroked = shows(style, "stroke") and not re.match(r"0+(\.0*)?[a-z]*$", style.get("stroke-width", "1"))
    filled = shows(style, "fill") and local(shape.tag) != "line"
    white = filled and is_white(style.get("fill", "black")) and opacity(style.get("fill-opacity", "1")) == 1
    for key in KEYS + ("filter", "mask"):
        shape.attrib.pop(key, None)
    shape.attrib.pop("vector-effect", None)
    said = kept + ["fill:#fff" if white else "fill:none", "stroke-linejoin:round", "stroke-linecap:round"]
    if style.get("visibility") == "hidden":
        said += ["visibility:hidden"]
    if stroked:
        width, (uneven, size) = style.get("stroke-width", "1"), stretches(matrix)
        if uneven and re.match(r"[\d.]+(px)?$", width):
            width = f"{float(width.rstrip('px')) * size};vector-effect:non-scaling-stroke"
        said += ["stroke:#000", "stroke-width:" + width]
        if style.get("stroke-dasharray", "none") not in ("none", "null"):
            said += ["stroke-dasharray:" + style["stroke-dasharray"]]
    elif filled and not white:
        if local(shape.tag) in ("polyline", "path"):  # a fill closes what is open
            key = "points" if local(shape.tag) == "polyline" else "d"
            if key == "points":
                shape.tag = f"{{{SVG}}}polygon"
            else:
                parts = re.split(r"(?<=[^\s])\s*(?=[Mm])", shape.get("d") or "")
                shape.set("d", close_all(parts))
        said += ["stroke:#000", f"stroke-width:{PEN_MM * 96 / 25.4}", "vector-effect:non-scaling-stroke"]
    shape.set("style", ";".join(said))


def close_all(parts):
    closed = [p if p.rstrip()[-1:] in ("z", "Z", "") else p + "z" for p in parts]
    # A relative move behind a close is one from the start of what was closed: only where all moves are absolute is it safe.
    return "".join(closed) if all(p.lstrip()[:1] in ("M", "") for p in parts[1:]) else "".join(parts)


def pixels(svg, width, height, sheet=None):
    """Darkness from 0 to 1."""
    command = ["rsvg-convert", "--unlimited", "-w", str(width), "-h", str(height), "-b", "white"]
    if sheet:
        command += ["--stylesheet", sheet]
    run = subprocess.run(command, input=svg, capture_output=True, check=True, timeout=300)
    return 1 - numpy.asarray(Image.open(io.BytesIO(run.stdout)).convert("L"), numpy.float32) / 255


def grown(ink):
    best = ink.copy()
    for dy in (-1, 0, 1):
        for dx in (-1, 0, 1):
            best = numpy.maximum(best, numpy.roll(ink, (dy, dx), (0, 1)))
    return best


def compare(source, result, page):
    root = ElementTree.fromstring(source)
    if any(True for _ in root.iter(f"{{{SVG}}}use")) or root.find(f".//{{{SVG}}}mask") is not None:
        return None
    style = style_of(root, {}, rules_of(root))
    rules = rules_of(root)
    box = [float(v) for v in re.split(r"[ ,]+", root.get("viewBox", "").strip()) if v]
    unit = page[0] / 25.4 * 96 / box[2] if len(box) == 4 else 1.0
    lines_only(root, style, rules, (unit, 0.0, 0.0, unit))
    for key in KEYS:
        root.attrib.pop(key, None)
    root.attrib.pop("style", None)
    width = PIXELS if page[0] >= page[1] else max(1, round(PIXELS * page[0] / page[1]))
    height = PIXELS if page[1] > page[0] else max(1, round(PIXELS * page[1] / page[0]))
    with tempfile.NamedTemporaryFile("w", suffix=".css") as sheet:
        sheet.write("* { stroke: #000 !important }")
        sheet.flush()
        before, after = pixels(ElementTree.tostring(root), width, height), pixels(result, width, height, sheet.name)
    ink = before.sum()
    if ink == 0:
        return (0.0 if after.sum() == 0 else 1.0), 0.0
    stray = numpy.maximum(before - grown(after), 0).sum() + numpy.maximum(after - grown(before), 0).sum()
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
    parser.add_argument("--quick", action="store_true", help="accepted or not, nothing else")
    given = parser.parse_args()
    device = {"speed_down": 40.0, "speed_up": 80.0, "lift": 0.25}  # grbl-servo
    files = sorted(p for p in given.folder.rglob("*") if p.suffix.lower() == ".svg")
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
