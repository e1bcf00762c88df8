#pragma once
/// The results that a method may return besides strokes: regions, painting order, spans, pixels.

#include <array>
#include <cstdint>
#include <vector>

#include "drawing/transparent_layers.hpp"
#include "geometry/point.hpp"

namespace ligne {

/// A visible part of a face on the page.
struct Region {
  std::uint32_t face = 0;                       ///< face of the scene
  std::vector<std::vector<Point2>> contours{};  ///< page mm; the first is outer, the others holes
  std::uint32_t level = 0;                      ///< number of transparent faces in front of it
  /// Bit i: light i reaches the region. All bits are set if no light was requested.
  std::uint32_t lights = 0xffffffffu;
  /// Per light: the fraction, 0 to 1, that transparent faces between the light and the region let through. Empty: 1 for
  /// all lights in `lights`.
  std::vector<double> light_shares{};
  std::uint32_t material = 0xffffffffu;  ///< material, if it is a part of a detail; 0xffffffff: that of the face
  std::uint32_t in_front = TransparentLayers::kEmptyList;  ///< of an area of spans: Span::in_front
};

/// A whole face or a piece of one, to be painted over all earlier pieces.
struct PaintPiece {
  std::uint32_t face = 0;                     ///< face of the scene
  std::vector<std::vector<Point2>> contours;  ///< page mm; the first is outer, the others holes
  /// Depth at the page point (x, y) mm: plane[0] x + plane[1] y + plane[2], in mm as in View::model_to_page.
  std::array<double, 3> plane{0, 0, 0};
};

/// Pieces of faces in painting order, farthest first: no piece is hidden by an earlier one.
struct PaintOrder {
  std::vector<PaintPiece> pieces;
};

/// A number to be written on the page, centred on a point.
struct PageNumber {
  Point2 middle{0, 0};  ///< page mm
  std::uint32_t number = 0;
};

/// Equidistant horizontal scan lines on the page, from top to bottom.
struct SpanLines {
  double first_mm = 0;    ///< y coordinate of the first line
  double spacing_mm = 1;  ///< distance of adjacent lines
  std::uint32_t count = 0;

  double y_mm(std::uint32_t line) const { return first_mm + line * spacing_mm; }
};

/// An interval of a scan line on which one face is visible, directly or through the same transparent faces.
struct Span {
  std::uint32_t line = 0;
  double x_from = 0, x_to = 0;                             ///< page mm
  std::uint32_t face = 0;                                  ///< kNone behind transparent faces: paper
  std::uint32_t in_front = TransparentLayers::kEmptyList;  ///< list of SpanModel::layers in front of it
};

/// Disjoint spans, sorted by line from the top and on each line from left to right.
struct SpanModel {
  SpanLines lines{};
  std::vector<Span> spans{};
  TransparentLayers layers{};  ///< empty unless VisibilityOptions::with_transparent_faces
};

/// The plane through a scan line and the line of sight: it shows how faces lie behind each other ([Boulle1980], figures
/// 2.39 to 2.50). Lengths are in page mm; depths as in View::model_to_page, smaller is nearer.
struct ScanPlane {
  struct Segment {
    double x0, z0, x1, z1;  ///< x0 <= x1
    std::uint32_t face;     ///< face of the scene
  };
  struct Run {
    double x0, x1;
    unsigned row;           ///< of a bar: number of the step of the span method
    std::uint32_t segment;  ///< index into `segments`; 0xffffffff: a part that was divided
  };
  double y_mm = 0;
  std::uint8_t kind = 0;          ///< index of the span method in watkins::kSpanMethodNames
  std::vector<Segment> segments;  ///< as given to the span method
  std::vector<Run> runs;          ///< the visible runs, left to right
  std::vector<Run> bars;          ///< steps of the span method
};

/// The visible face of each pixel. Pixels are square, and stored row by row from the top.
struct PixelModel {
  std::uint32_t width = 0, height = 0;
  Point2 corner_mm{0, 0};                 ///< position of the upper left corner of the first pixel on the page
  double pixel_mm = 1;                    ///< side of a pixel
  std::vector<std::uint32_t> face;        ///< per pixel: face of the scene, 0xffffffff for none
  std::vector<float> depth;               ///< per pixel
  TransparentLayers layers{};             ///< empty unless VisibilityOptions::with_transparent_faces
  std::vector<std::uint32_t> in_front{};  ///< per pixel: list of `layers` in front of the face; empty if there is none
};

}  // namespace ligne
