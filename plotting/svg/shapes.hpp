#pragma once
/// The shapes of an SVG, and the frames in which they lie. Private to plotting.

#include <array>
#include <optional>
#include <string_view>

#include <pugixml.hpp>

#include "plotting/svg/complaints.hpp"
#include "plotting/svg/outline.hpp"

namespace ligne::svg {

/// Attributes of elements. One without a meaning is complained of, and is as if it were not there.
class Attributes {
 public:
  Attributes(const Viewport& port, const Complaints& complaints) : port_(port), complaints_(complaints) {}

  /// As lengths in user units; percentages are of the width, of the height, or of neither.
  double x(const pugi::xml_node& node, const char* name, double otherwise = 0) const {
    return length(node, name, port_.width, otherwise);
  }
  double y(const pugi::xml_node& node, const char* name, double otherwise = 0) const {
    return length(node, name, port_.height, otherwise);
  }
  double along(const pugi::xml_node& node, const char* name, double otherwise = 0) const {
    return length(node, name, port_.diagonal(), otherwise);
  }
  /// Whether it says something else than "auto".
  static bool has(const pugi::xml_node& node, const char* name);

  /// "x y width height"; nothing where there is none.
  std::optional<std::array<double, 4>> view_box(const pugi::xml_node& node) const;

  const Complaints& complaints() const { return complaints_; }

 private:
  double length(const pugi::xml_node& node, const char* name, double whole, double otherwise) const;

  const Viewport& port_;
  const Complaints& complaints_;
};

/// From the units inside an element with `viewBox` and `preserveAspectRatio` to those of a frame of this size at (0, 0).
/// Without a viewBox they are the same.
Matrix view_box_to(const pugi::xml_node& node, const Attributes& attributes, double width, double height, Viewport& inside);

/// Adds a shape to the outline, up to where its data is wrong. False when the element is none.
bool outline_shape(std::string_view name, const pugi::xml_node& node, const Attributes& attributes, Outline& outline);

}  // namespace ligne::svg
