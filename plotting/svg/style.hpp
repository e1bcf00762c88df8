#pragma once
/// What elements of an SVG inherit. Private to plotting.

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <pugixml.hpp>

#include "plotting/svg/sheet.hpp"
#include "plotting/svg/values.hpp"

namespace ligne::svg {

/// A colour, or the id of a gradient or pattern with the colour that stands in for it.
struct Paint {
  std::string color;
  std::string server;  ///< empty: the colour as it is
};

struct Style {
  std::optional<Paint> stroke;  ///< nothing: none
  std::optional<Paint> fill = Paint{"#000000", {}};
  std::string color = "#000000";              ///< what currentColor means
  bool stroke_seen = true, fill_seen = true;  ///< opacity above zero
  double fill_opacity = 1;
  bool visible = true;
  double stroke_width = 1;
  std::vector<double> dashes;  ///< of the element's units
  double dash_offset = 0;
  double font_size = 16;
  double letter_spacing = 0, word_spacing = 0;
  double baseline_em = 0;    ///< how far below the given point the base line lies
  bool keep_blanks = false;  ///< of a text
  std::string anchor = "start";
  bool round_caps = false;  ///< or square ones: dots show
  bool fill_even_odd = false, clip_even_odd = false;
  std::array<std::string, 3> markers{};               ///< ids of those at the start, in the middle, at the end
  std::optional<Paint> context_fill, context_stroke;  ///< in a marker: of what it marks
  // Not inherited.
  double opacity = 1;
  std::optional<std::string> stop_color;  ///< of a gradient
  double baseline_shift = 0;              ///< upwards, of the element's units
  bool non_scaling = false;               ///< the stroke is as wide whatever the transforms
  std::string clip;                       ///< id of a clip path
  std::string mask;                       ///< id of a mask
  bool overflow = false;                  ///< what lies outside a viewport is seen
};

/// Something of SVG that can not be drawn as strokes, by its name in drawing_reader.hpp.
using Refuse = std::function<void(std::string_view name, const pugi::xml_node& node)>;

/// The style of an element: what it inherits, changed by its attributes, the style sheets, and its style attribute.
/// `displayed` becomes false for display: none. Throws std::invalid_argument for values without a meaning; calls `refuse`
/// for properties that change what is seen in other ways.
Style style_of(const pugi::xml_node& node, const Style& inherited, const StyleSheet& sheet, bool& displayed,
               const Refuse& refuse);

/// The name behind the prefix: "path" of "svg:path".
std::string_view local_name(const pugi::xml_node& node);

}  // namespace ligne::svg
