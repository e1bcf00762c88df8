#pragma once
/// Takes an SVG document of Cairo apart: its paths and images, without its groups, definitions and transforms. Private to
/// plotting.
///
/// The forms of Cairo 1.16 and 1.18 are known. Any other is a std::runtime_error "cairo: ...", and never a wrong picture.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/parallel.hpp"
#include "plotting/svg/values.hpp"

namespace ligne {

/// A path or an image of a document, in the text of which `data` and `image` lie.
struct CairoSvgPart {
  svg::Matrix to_document{};                    ///< from the numbers of the part to the unit of the document
  std::string_view data{};                      ///< of a path: its commands
  std::optional<std::string> fill{}, stroke{};  ///< of a path: "#rrggbb", or nothing
  double fill_opacity = 1;
  std::string_view image{};  ///< of an image: its address; it covers (0, 0) to `pixels`
  Point2 pixels{0, 0};
};

/// The parts in the order in which they are painted. The text, of a document of `size` by `size` units, is written into.
std::vector<CairoSvgPart> cairo_svg_parts(std::string& document, double size);

/// Calls `take` with each command of a path and its points in the unit of the document: M and L have one, C has three, Z
/// has none. Cairo moves to the start behind every Z, so an M may follow another, or be the last.
void for_each_command(const CairoSvgPart& part, FunctionRef<void(char, const Point2*)> take);

}  // namespace ligne
