#pragma once
/// Words of the options of ligne plot. As the functions of parse.hpp, these throw std::invalid_argument.

#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <string>

#include "picture/pages/plot_drawing.hpp"
#include "plotting/plot_parts.hpp"
#include "plotting/readers/drawing_reader.hpp"

namespace ligne {

/// --fill of plot: how the areas of an SVG are drawn, or how the order of a stored drawing is painted.
void parse_plot_fill(const std::string& text, std::optional<FillReading::How>& reading, StoredPaint& paint);

/// NAME=COLOUR, a material and its colour.
void parse_material(const std::string& text, StoredPaint& paint);

/// "all" layers, or only their own "layer" (true): what areas hide.
bool parse_own_layer(const std::string& text);

/// A comma list of what of an SVG may be left out, see kSkippable.
std::set<std::string> parse_skip(const std::string& text);

/// "plain", or "shade" (true).
bool parse_fill_tone(const std::string& text);

/// "LEN" for all fills, "NAME=LEN" for those of a layer or a colour.
void add_hatch_spacing(FillHatches& hatches, const std::string& text);
/// Adds an angle in degrees.
void add_hatch_angle(FillHatches& hatches, const std::string& text);
/// A layer or a colour; empty: all.
void add_hatch_cross(FillHatches& hatches, const std::string& name);

/// A length above 0 in mm, cm, m, in or pt; bare is mm.
double parse_way_mm(const std::string& text);
/// "90s", "30min", "2h", "MIN:S" or "H:MIN:S", in seconds.
double parse_duration_s(const std::string& text);
/// "time=30min", "distance=3m" or "lifts=200".
PlotSplit parse_split(const std::string& text);
/// A number of a stroke, from 1.
std::size_t parse_stroke_number(const std::string& text);
/// "CxR", columns and rows.
std::array<unsigned, 2> parse_grid(const std::string& text);

}  // namespace ligne
