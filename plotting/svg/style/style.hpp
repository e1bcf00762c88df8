#pragma once
/// Properties that elements of an SVG inherit. Private to plotting.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <pugixml.hpp>

#include "plotting/svg/complaints.hpp"
#include "plotting/svg/namespaces.hpp"
#include "plotting/svg/style/sheet.hpp"
#include "plotting/svg/style/variables.hpp"
#include "plotting/svg/values.hpp"

namespace ligne::svg {

/// A colour, or the id of a gradient or pattern with the colour that stands in for it.
struct Paint {
  std::string color;
  std::string server;  ///< empty: the colour as it is
  double opacity = 1;  ///< of the colour
};

/// The parts of a shape that are painted one after the other.
enum class PaintPart : unsigned char { fill, stroke, markers };

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
  std::array<std::string, 3> markers{};  ///< ids of those at the start, in the middle, at the end
  std::array<PaintPart, 3> paint_order{PaintPart::fill, PaintPart::stroke, PaintPart::markers};
  std::optional<Paint> context_fill, context_stroke;  ///< of the <use>, or of what a marker marks
  VariablesPointer variables;
  // Not inherited.
  std::optional<Matrix> placing;  ///< its transform
  std::string origin;             ///< of the transform, as it is written
  bool origin_of_box = false;     ///< of the element's own box
  bool displayed = true;          ///< no display: none
  double opacity = 1;
  std::optional<std::string> stop_color;  ///< of a gradient
  double stop_opacity = 1;
  bool blended = false;          ///< mixed with what lies under it
  double baseline_shift = 0;     ///< upwards, of the element's units
  bool non_scaling = false;      ///< the stroke is as wide whatever the transforms
  std::string clip;              ///< id of a clip path
  std::string mask;              ///< id of a mask
  std::optional<bool> overflow;  ///< what lies outside a viewport is seen; nothing: it is not said
};

/// The style of an element: what it inherits, changed by its attributes, the style sheets, and its style attribute.
/// `displayed` becomes false for display: none. Complains of values without a meaning, and of properties that change what
/// is seen in other ways. The font sizes of `port` are those around the element.
Style style_of(const pugi::xml_node& node, const Style& inherited, const StyleSheet& sheet, const Viewport& port,
               bool& displayed, const Complaints& complaints);

}  // namespace ligne::svg
