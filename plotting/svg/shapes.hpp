#pragma once
/// The shapes of an SVG, and the frames in which they lie. Private to plotting.

#include <array>
#include <optional>
#include <string_view>

#include <pugixml.hpp>

#include "plotting/svg/diagnostics.hpp"
#include "plotting/svg/outline.hpp"

namespace ligne::svg {

/// Reads attributes of elements. An invalid one is reported and ignored.
class Attributes {
 public:
  Attributes(const Viewport& port, const Diagnostics& diagnostics) : port_(port), diagnostics_(diagnostics) {}

  /// Lengths in user units. Percentages refer to the width, the height or the diagonal of the viewport.
  double x(const pugi::xml_node& node, const char* name, double otherwise = 0) const {
    return length(node, name, port_.width, otherwise);
  }
  double y(const pugi::xml_node& node, const char* name, double otherwise = 0) const {
    return length(node, name, port_.height, otherwise);
  }
  double along(const pugi::xml_node& node, const char* name, double otherwise = 0) const {
    return length(node, name, port_.diagonal(), otherwise);
  }
  /// Whether the attribute exists and is not "auto".
  static bool has(const pugi::xml_node& node, const char* name);

  /// The viewBox, "x y width height"; nothing if there is none.
  std::optional<std::array<double, 4>> view_box(const pugi::xml_node& node) const;

  const Diagnostics& diagnostics() const { return diagnostics_; }

 private:
  double length(const pugi::xml_node& node, const char* name, double whole, double otherwise) const;

  const Viewport& port_;
  const Diagnostics& diagnostics_;
};

/// Matrix from the units inside an element with `viewBox` and `preserveAspectRatio` to those of a frame of this size at
/// (0, 0). Without a viewBox they are the same. `inside` receives the size of the frame in the units inside.
Matrix view_box_to(const pugi::xml_node& node, const Attributes& attributes, double width, double height, Viewport& inside);

/// Adds a shape to the outline, up to the first error in its data. False if the element is not a shape.
bool outline_shape(std::string_view name, const pugi::xml_node& node, const Attributes& attributes, Outline& outline);

}  // namespace ligne::svg
