#pragma once
/// Words of the options of ligne plot. As the functions of parse.hpp, these throw std::invalid_argument.

#include <set>
#include <string>

#include "plotting/drawing_reader.hpp"

namespace ligne {

/// "refuse", "outline" or "hatch".
FillReading::How parse_fill_reading(const std::string& text);

/// A comma list of what of an SVG may be left out, see kSkippable.
std::set<std::string> parse_skip(const std::string& text);

/// "plain", or "shade" (true).
bool parse_fill_tone(const std::string& text);

/// "LEN" for all fills, "NAME=LEN" for those of a layer or a colour.
void add_hatch_spacing(FillHatches& hatches, const std::string& text);
/// The same in degrees.
void add_hatch_angle(FillHatches& hatches, const std::string& text);
/// A layer or a colour; empty: all.
void add_hatch_cross(FillHatches& hatches, const std::string& name);

}  // namespace ligne
