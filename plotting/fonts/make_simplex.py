#!/usr/bin/env python3
"""Makes simplex_glyphs.cpp, the single-stroke font, from the Hershey fonts (Debian: hershey-fonts-data).

    make_simplex.py /usr/share/hershey-fonts /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf > simplex_glyphs.cpp

ASCII comes from futural, Greek from greeks; accented letters are put together from a letter and a mark, raised and lowered
digits are made smaller. Beside each glyph stands the width that a sans serif typeface gives the character, to lay out text
that is written in a typeface. Lengths: strokes in tenths of a Hershey unit (capitals are 210 high), y upwards from the base
line; widths of the typeface in thousandths of its capitals' height.
"""
import struct
import sys
import unicodedata

CAPITAL, SMALL = 21, 14  # heights of letters, Hershey units
TYPEFACE_CAPITAL = 1493  # of DejaVu Sans, in its units: the height of its H, which the file does not tell
BASE = 9                 # y of the base line in the files, which count downwards


def read_hershey(path):
    """Glyphs of a .jhf file in order: (width, strokes), the strokes as lists of (x, y) from the left edge and the base line."""
    glyphs = []
    for line in open(path, encoding="ascii"):
        line = line.rstrip("\n")
        pairs = [(ord(a) - ord("R"), ord(b) - ord("R")) for a, b in zip(line[8::2], line[9::2])]
        (left, right), strokes = pairs[0], [[]]
        for x, y in pairs[1:]:
            if (x, y) == (ord(" ") - ord("R"), 0):
                strokes.append([])
            else:
                strokes[-1].append((x - left, BASE - y))
        glyphs.append((right - left, [s for s in strokes if s]))
    return glyphs


def typeface_widths(path):
    """code -> advance in thousandths of the height of capitals, from a TrueType file with a cmap of format 4."""
    data = open(path, "rb").read()
    tables = {}
    for i in range(struct.unpack_from(">H", data, 4)[0]):
        tag, _, offset, _ = struct.unpack_from(">4sIII", data, 12 + 16 * i)
        tables[tag] = offset
    measures = struct.unpack_from(">H", data, tables[b"hhea"] + 34)[0]
    cmap = tables[b"cmap"]
    for i in range(struct.unpack_from(">H", data, cmap + 2)[0]):
        offset = cmap + struct.unpack_from(">HHI", data, cmap + 4 + 8 * i)[2]
        if struct.unpack_from(">H", data, offset)[0] == 4:
            break
    n = struct.unpack_from(">H", data, offset + 6)[0] // 2
    column = lambda k: struct.unpack_from(f">{n}H", data, offset + 14 + 2 * n * k + (2 if k else 0))
    ends, starts, deltas, ranges = (column(k) for k in range(4))
    widths = {}
    for s in range(n):
        for code in range(starts[s], ends[s] + 1):
            glyph = code
            if ranges[s]:
                glyph = struct.unpack_from(">H", data, offset + 16 + 6 * n + 2 * s + ranges[s] + 2 * (code - starts[s]))[0]
            glyph = (glyph + deltas[s]) & 0xFFFF
            at = tables[b"hmtx"] + 4 * min(glyph, measures - 1)
            widths[code] = round(1000 * struct.unpack_from(">H", data, at)[0] / TYPEFACE_CAPITAL)
    return widths


def moved(strokes, dx=0.0, dy=0.0, scale=1.0):
    return [[(x * scale + dx, y * scale + dy) for x, y in s] for s in strokes]


def bounds(strokes):
    xs, ys = zip(*(p for s in strokes for p in s))
    return min(xs), min(ys), max(xs), max(ys)


def ring(r, n=12):
    import math
    return [(r * math.cos(2 * math.pi * i / n), r * math.sin(2 * math.pi * i / n)) for i in range(n)] + [(r, 0)]


DOT = [(0, 2), (-1, 1), (0, 0), (1, 1), (0, 2)]
# Marks over a letter, their lowest point at y = 0, centred on x = 0.
OVER = {
    0x300: [[(-3, 4), (2, 0)]],
    0x301: [[(3, 4), (-2, 0)]],
    0x302: [[(-4, 0), (0, 4), (4, 0)]],
    0x303: [[(-5, 0), (-4, 2), (-2, 3), (2, 1), (4, 1), (5, 3)]],
    0x304: [[(-4, 1), (4, 1)]],
    0x306: [[(-4, 4), (-3, 1), (-1, 0), (1, 0), (3, 1), (4, 4)]],
    0x307: [DOT],
    0x308: moved([DOT], -4) + moved([DOT], 4),
    0x30A: moved([ring(2.5)], 0, 2.5),
    0x30B: [[(0, 4), (-4, 0)], [(5, 4), (1, 0)]],
    0x30C: [[(-4, 4), (0, 0), (4, 4)]],
}
# Marks under a letter, hung at the base line.
UNDER = {
    0x327: [[(0, 0), (-1, -2), (1, -2), (2, -3), (2, -5), (1, -6), (-2, -6)]],
    0x328: [[(0, 0), (-2, -2), (-2, -4), (-1, -5), (2, -5)]],
}


def with_mark(base, mark):
    width, strokes = base
    left, _, right, top = bounds(strokes)
    if mark in OVER:
        return width, strokes + moved(OVER[mark], (left + right) / 2, top + 3)
    return width, strokes + moved(UNDER[mark], (left + right) / 2)


def make_font(folder):
    font = {32 + i: glyph for i, glyph in enumerate(read_hershey(folder + "/futural.jhf")[:95])}
    greek = read_hershey(folder + "/greeks.jhf")
    letters = "ΑΒΓΔΕΖΗΘΙΚΛΜΝΞΟΠΡΣΤΥΦΧΨΩ"
    for i, letter in enumerate(letters):
        font[ord(letter)] = greek[ord("A") - 32 + i]
        font[ord(letter.lower())] = greek[ord("a") - 32 + i]
    font[0xB5] = font[ord("μ")]
    font[0x3C2] = font[ord("σ")]

    # Signs.
    minus, plus, dot = font[ord("-")], font[ord("+")], font[ord(".")]
    font[0x2212] = font[0x2013] = minus
    font[0x2010] = font[0x2011] = minus
    font[0x2014] = (minus[0] + 6, [[(4, 9), (minus[0] + 2, 9)]])
    font[0xA0] = font[0x202F] = font[0x2009] = font[32]
    font[0xB7] = font[0x22C5] = (8, moved([DOT], 4, 8))
    font[0xD7] = (22, [[(4, 2), (18, 16)], [(4, 16), (18, 2)]])
    font[0xF7] = (minus[0], minus[1] + moved([DOT], minus[0] / 2, 13) + moved([DOT], minus[0] / 2, 3))
    font[0xB1] = (plus[0], moved(plus[1], 0, 2) + [[(4, 0), (plus[0] - 4, 0)]])
    font[0xB0] = (12, moved([ring(3.5)], 6, 17.5))
    for code, sign in ((0x2264, "<"), (0x2265, ">")):
        width, strokes = font[ord(sign)]
        left, low, right, _ = bounds(strokes)
        font[code] = (width, moved(strokes, 0, 2) + [[(left, low - 1), (right, low - 1)]])
    width, strokes = font[ord("=")]
    font[0x2260] = (width, strokes + [[(width / 2 - 5, 1), (width / 2 + 5, 17)]])
    font[0x221E] = (28, moved([ring(5)], 9, 9) + moved([ring(5)], 19, 9))
    arrow = [[(2, 9), (22, 9)], [(15, 14), (22, 9), (15, 4)]]
    for code, sign in ((0x2190, -1), (0x2192, 1)):
        font[code] = (24, [[(12 + sign * (x - 12), y) for x, y in s] for s in arrow])
    for code, sign in ((0x2191, 1), (0x2193, -1)):
        font[code] = (16, [[(y - 1, 9 + sign * (x - 12)) for x, y in s] for s in arrow])
    font[0x2022] = (14, moved([ring(2.5)], 7, 9))
    font[0x200B] = (0, [])  # a blank of no width
    font[0x2019] = font[0x2018] = font[ord("'")]
    font[0x201C] = font[0x201D] = font[ord('"')]
    font[0x2026] = (30, [s for i in range(3) for s in moved(dot[1], 10 * i)])

    # Letters that are not a letter with a mark.
    for code, letter in ((0xF8, "o"), (0xD8, "O")):
        width, strokes = font[ord(letter)]
        left, low, right, high = bounds(strokes)
        font[code] = (width, strokes + [[(left, low - 2), (right, high + 2)]])
    for code, letter, height in ((0x142, "l", 11), (0x141, "L", 11)):
        width, strokes = font[ord(letter)]
        left = bounds(strokes)[0]
        font[code] = (width, strokes + [[(left - 3, height - 3), (left + 5, height + 3)]])
    for code, first, second in ((0xE6, "a", "e"), (0xC6, "A", "E"), (0x153, "o", "e"), (0x152, "O", "E")):
        (w, a), (v, b) = font[ord(first)], font[ord(second)]
        overlap = w - bounds(a)[2] + bounds(b)[0] + (-2 if first in "AO" else 0)
        font[code] = (w + v - overlap, a + moved(b, w - overlap))
    font[0xDF] = font[ord("β")]
    dotless = {ord("i"): (font[ord("i")][0], [s for s in font[ord("i")][1] if bounds([s])[3] <= SMALL]),
               ord("j"): (font[ord("j")][0], [s for s in font[ord("j")][1] if bounds([s])[3] <= SMALL])}
    font[0x131] = dotless[ord("i")]

    for code in [*range(0xC0, 0x180), *range(0x386, 0x3CF)]:
        parts = unicodedata.normalize("NFD", chr(code))
        if len(parts) != 2 or ord(parts[0]) not in font:
            continue
        base, mark = ord(parts[0]), ord(parts[1])
        if mark in OVER or mark in UNDER:
            font[code] = with_mark(dotless.get(base, font[base]) if mark in OVER else font[base], mark)

    # Raised and lowered digits and signs, three fifths as large.
    scale = 0.6
    for signs, rise in (("⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻ⁿ", 23 - scale * CAPITAL), ("₀₁₂₃₄₅₆₇₈₉₊₋", -5.0)):
        for sign in signs:
            plain = ord(unicodedata.normalize("NFKD", sign))
            width, strokes = font[plain]
            font[ord(sign)] = (width * scale, moved(strokes, 0, rise, scale))
    return font


HEAD = """\
// Made by make_simplex.py from the Hershey fonts; do not edit. See LICENCE beside this file:
// The Hershey Fonts were originally created by Dr. A. V. Hershey while working at the U. S. National Bureau of Standards.

#include "plotting/fonts/simplex_glyphs.hpp"

namespace ligne {
namespace {

// clang-format off
constexpr SimplexGlyph kGlyphs[] = {"""

TAIL = """\
};
// clang-format on

}  // namespace

std::span<const SimplexGlyph> simplex_glyphs() { return kGlyphs; }

}  // namespace ligne"""


def main():
    font = make_font(sys.argv[1])
    widths = typeface_widths(sys.argv[2])
    print(HEAD)
    rows = ["   "]
    for code in sorted(font):
        width, strokes = font[code]
        text = ";".join(" ".join(f"{round(10 * x)} {round(10 * y)}" for x, y in s) for s in strokes)
        glyph = f'{{0x{code:x}, {round(10 * width)}, {widths.get(code, 1372)}, "{text}"}},'
        if len(rows[-1]) + len(glyph) > 115:
            rows.append("   ")
        rows[-1] += " " + glyph
    print("\n".join([*rows, TAIL]))


main()
