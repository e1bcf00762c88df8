#pragma once
/// Texts of a drawing: their position and the space that they take.

#include <array>
#include <string>

#include "geometry/point.hpp"

namespace ligne {

enum class TextAcross { left, center, right };
enum class TextUp { base, middle, top };

/// One line of text. The anchors `across` and `up` select the point of the text that lies at `at`. Middle and top refer
/// to capital letters.
struct TextItem {
  std::string text{};      ///< UTF-8; malformed bytes are shown as U+FFFD, control characters as blanks
  Point2 at{0, 0};         ///< page mm
  double height_mm = 2.5;  ///< height of capital letters
  TextAcross across = TextAcross::left;
  TextUp up = TextUp::base;
  double rotation_degrees = 0;  ///< about `at`, counter-clockwise as seen
  double halo_mm = 0;           ///< width of the rim of paper colour around and below its letters; 0: none
};

/// Size of a line of text, in mm.
struct TextExtent {
  double width = 0;
  double ascent = 0, descent = 0;  ///< above and below the base line
};

/// The point on the base line at the horizontal anchor of the text.
Point2 base_point(const TextItem& item);

/// A rectangle on the page, rotated counter-clockwise as seen.
struct TextBox {
  Point2 center{0, 0};
  Point2 half{0, 0};  ///< half its width and half its height, before rotation
  double rotation_degrees = 0;

  /// Unit vectors along its width and its height, page mm.
  std::array<Point2, 2> axes() const;
  std::array<Point2, 4> corners() const;
  /// Largest distance of its points from its center, measured along a unit vector.
  double reach(Point2 direction) const;
};

/// Returns the box of a text of the given size.
TextBox text_box(const TextItem& item, const TextExtent& extent);

/// Whether the boxes overlap after each is enlarged by half of `gap_mm` on all sides. Boxes that only touch do not
/// overlap.
bool overlap(const TextBox& a, const TextBox& b, double gap_mm = 0);

}  // namespace ligne
