#!/usr/bin/env python3
"""Writes the sample document of Cairo's SVG surface: make_sample.py FILE

cairo-1.16.svg is from Debian 12, cairo-1.18.svg from Debian 13 (python3-cairo of each)."""

import sys

import cairo

surface = cairo.SVGSurface(sys.argv[1], 2000, 2000)
pen = cairo.Context(surface)

pen.save()  # gray pixels
pen.translate(100, 200)
pen.scale(50, 25)
pen.set_source_surface(cairo.ImageSurface(cairo.FORMAT_RGB24, 3, 2), 0, 0)
pen.get_source().set_filter(cairo.FILTER_NEAREST)
pen.paint()
pen.restore()

pen.translate(1000, 1000)  # as the writer has it
pen.scale(1000, 1000)
pen.set_fill_rule(cairo.FILL_RULE_EVEN_ODD)
pen.set_line_join(cairo.LINE_JOIN_ROUND)
pen.set_line_width(0.015)
pen.set_source_rgb(0.5, 0.25, 0)  # an area with a hole and a rim
pen.rectangle(0.25, 0.25, 0.5, 0.5)
pen.rectangle(0.375, 0.375, 0.25, 0.25)
pen.fill_preserve()
pen.stroke()
pen.set_source_rgba(1, 0, 0, 0.3)  # one that shines through
pen.rectangle(-0.5, -0.5, 0.25, 0.25)
pen.fill()

pen.set_source_rgb(0, 0, 0)  # a line, a dot, a closed line and a curve
pen.set_line_cap(cairo.LINE_CAP_ROUND)
pen.move_to(0.125, 0.25)
pen.line_to(-0.25, 0.5)
pen.line_to(-0.3, 0.123456)
pen.move_to(0.5, 0.5)
pen.line_to(0.5, 0.5)
pen.move_to(0, 0)
pen.line_to(0.25, 0)
pen.line_to(0.25, 0.25)
pen.close_path()
pen.move_to(0.5, 0)
pen.curve_to(0.5, 0.25, 0.25, 0.5, 0, 0.5)
pen.stroke()
pen.set_line_cap(cairo.LINE_CAP_BUTT)  # dashes
pen.identity_matrix()
pen.set_line_width(2)
pen.set_dash([12, 3])
pen.move_to(10, 20)
pen.line_to(30.5, 40)
pen.stroke()
surface.finish()
