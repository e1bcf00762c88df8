#pragma once
/// Takes an SVG document of Cairo apart: its paths and images, without its groups, definitions and transforms. Private to
/// plotting.
///
/// Knows the forms of Cairo 1.16 and 1.18. Any other throws std::runtime_error "cairo: ...", and never gives a wrong
/// picture.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/parallel.hpp"
#include "plotting/svg/values.hpp"

namespace ligne {

/// A path or an image of a document. `data` and `image` point into the text of the document.
struct CairoSvgPart {
  svg::Matrix to_document{};                    ///< from the numbers of the part to the unit of the document
  std::string_view data{};                      ///< commands of a path
  std::optional<std::string> fill{}, stroke{};  ///< path: "#rrggbb", or nothing
  double fill_opacity = 1;
  std::string_view image{};  ///< address of an image, which covers (0, 0) to `pixels`
  Point2 pixels{0, 0};
};

/// Returns the parts in the order in which they are painted. The document has `size` by `size` units. Its text is
/// overwritten.
std::vector<CairoSvgPart> cairo_svg_parts(std::string& document, double size);

/// Calls `take` with each command of a path and its points in the unit of the document: M and L have one, C has three, Z
/// has none. Cairo moves to the start behind every Z, so an M may follow another, or be the last.
void for_each_command(const CairoSvgPart& part, FunctionRef<void(char, const Point2*)> take);

}  // namespace ligne
