#pragma once
/// Text in a drawing: where it stands, and the room that it takes.

#include <array>
#include <string>

#include "geometry/point.hpp"

namespace ligne {

enum class TextAcross { left, center, right };
enum class TextUp { base, middle, top };

/// One line of text. `at` is the point of the text that the two anchors name; the middle and the top are those of capitals.
struct TextItem {
  std::string text;        ///< UTF-8; what is malformed is shown as U+FFFD, control characters as blanks
  Point2 at{0, 0};         ///< page mm
  double height_mm = 2.5;  ///< of capitals
  TextAcross across = TextAcross::left;
  TextUp up = TextUp::base;
  double rotation_degrees = 0;  ///< about `at`, counter-clockwise as seen
};

/// Room that a line of text takes, in mm.
struct TextExtent {
  double width = 0;
  double ascent = 0, descent = 0;  ///< above and below the base line
};

/// The point of the base line at the text's anchor across.
Point2 base_point(const TextItem& item);

/// A rectangle on the page, turned counter-clockwise as seen.
struct TextBox {
  Point2 center{0, 0};
  Point2 half{0, 0};  ///< half its width and its height, before it is turned
  double rotation_degrees = 0;

  /// Unit vectors along its width and its height, page mm.
  std::array<Point2, 2> axes() const;
  std::array<Point2, 4> corners() const;
  /// How far it reaches from its center in the direction of a unit vector.
  double reach(Point2 direction) const;
};

TextBox text_box(const TextItem& item, const TextExtent& extent);

/// The boxes have a point in common when each is widened by half of `gap_mm` on all sides. Boxes that only touch do not
/// overlap.
bool overlap(const TextBox& a, const TextBox& b, double gap_mm = 0);

}  // namespace ligne
