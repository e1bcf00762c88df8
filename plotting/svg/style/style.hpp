#pragma once
/// Properties that elements of an SVG inherit. Private to plotting.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <pugixml.hpp>

#include "plotting/svg/diagnostics.hpp"
#include "plotting/svg/style/sheet.hpp"
#include "plotting/svg/values.hpp"
#include "plotting/svg/xml.hpp"

namespace ligne::svg {

/// A colour, or the id of a gradient or pattern with a fallback colour.
struct Paint {
  std::string color;
  std::string server;  ///< id of a gradient or pattern; empty: the colour alone
  double opacity = 1;  ///< opacity of the colour
};

/// The parts of a shape that are painted one after the other.
enum class PaintPart : unsigned char { fill, stroke, markers };

/// Widths of the letters of a typeface.
struct TypefaceWidth {
  double of_sans = 0.88;  ///< as a fraction of those of DejaVu Sans; here of Arial and Helvetica
  double fixed_em = 0;    ///< width of every letter; 0: each has its own
};

struct Style {
  std::optional<Paint> stroke;  ///< nothing: no stroke
  std::optional<Paint> fill = Paint{"#000000", {}};
  std::string color = "#000000";              ///< value of currentColor
  bool stroke_seen = true, fill_seen = true;  ///< opacity above zero
  double fill_opacity = 1;
  bool visible = true;
  double stroke_width = 1;
  std::vector<double> dashes;  ///< in the element's units
  double dash_offset = 0;
  double font_size = 16;
  double line_em = 1.2;  ///< distance of lines, em
  TypefaceWidth typeface;
  double letter_spacing = 0, word_spacing = 0;
  double baseline_em = 0;    ///< distance of the base line below the given point, em
  bool keep_blanks = false;  ///< blanks of a text are kept
  std::string anchor = "start";
  bool round_caps = false;  ///< round or square caps: lines of no length are visible
  bool fill_even_odd = false, clip_even_odd = false;
  std::array<std::string, 3> markers{};  ///< ids of the markers at the start, in the middle, at the end
  std::array<PaintPart, 3> paint_order{PaintPart::fill, PaintPart::stroke, PaintPart::markers};
  std::optional<Paint> context_fill, context_stroke;  ///< paints of the <use>, or of the shape that a marker marks
  bool alpha_mask = false;                            ///< a mask shows what lies under its shapes, dark ones too
  VariablesPointer variables;
  // Not inherited.
  std::optional<Matrix> placing;  ///< transform of the element
  std::string origin;             ///< origin of the transform, as it is written
  bool origin_of_box = false;     ///< the origin refers to the element's own box
  bool displayed = true;          ///< false for display: none
  double opacity = 1;
  std::optional<std::string> stop_color;  ///< colour of a gradient's stop
  double stop_opacity = 1;
  bool blended = false;          ///< mixed with what lies under it
  double baseline_shift = 0;     ///< upwards, in the element's units
  bool non_scaling = false;      ///< transforms do not change the width of the stroke
  std::string clip;              ///< id of a clip path
  std::string mask;              ///< id of a mask
  std::string text_box;          ///< id of the shape into which a text flows
  std::optional<bool> overflow;  ///< parts outside a viewport are visible; nothing: not given
};

/// The style of an element: its inherited style, changed by its attributes, the style sheets, and its style attribute.
/// `displayed` becomes false for display: none. Reports invalid values, and properties that change the picture in ways
/// that are not drawn. The font sizes of `port` are the ones around the element.
Style style_of(const pugi::xml_node& node, const Style& inherited, const StyleSheet& sheet, const Viewport& port,
               bool& displayed, const Diagnostics& diagnostics);

}  // namespace ligne::svg
