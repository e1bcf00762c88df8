#pragma once
/// The shapes of an SVG, and the frames in which they lie. Private to plotting.

#include <string_view>

#include <pugixml.hpp>

#include "plotting/svg/outline.hpp"

namespace ligne::svg {

/// What percentages are of, user units.
struct Viewport {
  double width = 0, height = 0;
};

/// An attribute as a length in user units. Throws std::invalid_argument.
double length(const pugi::xml_node& node, const char* attribute, double otherwise = 0, double whole = 0);

/// From the units inside an element with `viewBox` and `preserveAspectRatio` to those of a frame of this size at (0, 0).
/// Without a viewBox they are the same.
Matrix view_box_to(const pugi::xml_node& node, double width, double height, Viewport& inside);

/// Adds a shape to the outline. False when the element is none.
bool outline_shape(std::string_view name, const pugi::xml_node& node, const Viewport& port, Outline& outline);

}  // namespace ligne::svg
