#pragma once
/// The other visibility models that a method may produce beside strokes: regions, order, spans, pixels.

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/point.hpp"

namespace ligne {

/// A visible part of a face on the page.
struct Region {
  std::uint32_t face = 0;                     ///< face of the scene
  std::vector<std::vector<Point2>> contours;  ///< page mm; the first is outer, the others holes
  std::uint32_t level = 0;                    ///< how many transparent faces are in front of it: 0 is seen directly
  /// Bit i: light i reaches it. All bits where no light was asked for.
  std::uint32_t lights = 0xffffffffu;
  /// How much of each light comes here through the transparent faces in its way, 0 to 1, by light. Empty: all of those in
  /// `lights`.
  std::vector<double> light_shares{};
  std::uint32_t material = 0xffffffffu;  ///< of the detail of which it is a part; 0xffffffff for that of the face
};

/// A whole face, or a piece of one, to be painted over what comes before it.
struct PaintPiece {
  std::uint32_t face = 0;                     ///< face of the scene
  std::vector<std::vector<Point2>> contours;  ///< page mm; the first is outer, the others holes
  /// Depth at the page point (x, y) mm: plane[0] x + plane[1] y + plane[2], in mm as in View::model_to_page.
  std::array<double, 3> plane{0, 0, 0};
};

/// Pieces of faces in painting order, farthest first: none hides anything of one behind it in the list.
struct PaintOrder {
  std::vector<PaintPiece> pieces;
};

/// A number to be written round a point of the page.
struct PageNumber {
  Point2 middle{0, 0};  ///< page mm
  std::uint32_t number = 0;
};

/// Scan lines of the page, from the top downwards.
struct SpanLines {
  double first_mm = 0;    ///< height of the first on the page
  double spacing_mm = 1;  ///< from line to line
  std::uint32_t count = 0;

  double y_mm(std::uint32_t line) const { return first_mm + line * spacing_mm; }
};

/// A run of one scan line on which one face is seen.
struct Span {
  std::uint32_t line = 0;
  double x_from = 0, x_to = 0;  ///< page mm
  std::uint32_t face = 0;
};

/// Spans line by line from the top, on each line from left to right, disjoint.
struct SpanModel {
  SpanLines lines;
  std::vector<Span> spans;
};

/// One face per pixel, row by row from the top; 0xffffffff where nothing is seen. Pixels are square.
struct PixelModel {
  std::uint32_t width = 0, height = 0;
  Point2 corner_mm{0, 0};  ///< upper left corner of the first, on the page
  double pixel_mm = 1;
  std::vector<std::uint32_t> face;
  std::vector<float> depth;
};

}  // namespace ligne
