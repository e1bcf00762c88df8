#pragma once
/// Texts of the options of ligne plot. The functions throw std::invalid_argument, as in parse.hpp.

#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <string>

#include "picture/pages/plot_drawing.hpp"
#include "plotting/plot_parts.hpp"
#include "plotting/readers/drawing_reader.hpp"

namespace ligne {

/// --fill of plot: how to draw the areas of an SVG, or how to paint the pieces of a stored drawing.
void parse_plot_fill(const std::string& text, std::optional<FillReading::How>& reading, StoredPaint& paint);

/// NAME=COLOUR, a material and its colour.
void parse_material(const std::string& text, StoredPaint& paint);

/// Which lines areas hide: those of "all" layers, or only of their own "layer" (true).
bool parse_own_layer(const std::string& text);

/// A comma-separated list of parts of an SVG to leave out, see kSkippable.
std::set<std::string> parse_skip(const std::string& text);

/// "plain", or "shade" (true).
bool parse_fill_tone(const std::string& text);

/// "LEN" for all fills, "NAME=LEN" for the fills of a layer or a colour.
void add_hatch_spacing(FillHatches& hatches, const std::string& text);
/// Adds an angle in degrees, in the same form.
void add_hatch_angle(FillHatches& hatches, const std::string& text);
/// Adds a layer or a colour; empty: all.
void add_hatch_cross(FillHatches& hatches, const std::string& name);

/// A length above 0 in mm, cm, m, in or pt; mm without a unit.
double parse_drawn_length_mm(const std::string& text);
/// "90s", "30min", "2h", "MIN:S" or "H:MIN:S", in seconds.
double parse_duration_s(const std::string& text);
/// "time=30min", "distance=3m" or "lifts=200".
PlotSplit parse_split(const std::string& text);
/// A number of a stroke, from 1.
std::size_t parse_stroke_number(const std::string& text);
/// "CxR", columns and rows.
std::array<unsigned, 2> parse_grid(const std::string& text);

}  // namespace ligne
