#pragma once
/// The JSON drawing, as a stranger reads it: docs/drawing-format.md.

#include "checked_scene.hpp"

namespace ligne::check {

struct DrawnStroke {
  LineKind kind = kMesh;
  bool visible = true;
  std::array<Point3, 2> ends{};                         ///< ends of the source edge, model coordinates
  std::array<double, 2> interval{0, 1};                 ///< parameters on the source edge
  std::optional<std::uint32_t> edge;                    ///< number of the source edge; none for an intersection
  std::array<std::optional<std::uint32_t>, 2> faces{};  ///< that meet at the source edge
  std::array<Point2, 2> points{};                       ///< page mm
};

struct DrawingFile {
  Rows model_to_page{};
  Rect window;               ///< page mm
  double near_distance = 0;  ///< smallest W that is drawn; in a perspective
  std::vector<DrawnStroke> strokes;
};

/// Throws std::runtime_error with one line.
DrawingFile parse_drawing(std::string_view text);

/// "outline" and so on; throws std::runtime_error for another name.
LineKind kind_of(std::string_view name);
std::string_view name_of(LineKind kind);

}  // namespace ligne::check
