#pragma once
/// Lines inside smooth surfaces, which are neither edges nor outlines: suggestive contours, ridges and valleys.
/// Explained in docs/shape-lines.md.

#include <array>
#include <cstdint>
#include <vector>

#include "contours/contour_curves.hpp"
#include "contours/contour_lines.hpp"

namespace ligne {

/// A polyline on the mesh. Segment i runs from point i to point i + 1. A closed line repeats its first point.
struct ShapeLine {
  LineClass line_class = LineClass::suggestive;
  std::vector<Point3> points{};        ///< model coordinates
  std::vector<std::uint32_t> faces{};  ///< per segment: the face of the scene on which it lies
  bool closed = false;

  /// Number of segments.
  std::size_t size() const { return faces.size(); }
};

/// The shape lines of a scene, and the numbers of their segments as sources of strokes.
struct ShapeLines {
  std::vector<ShapeLine> lines;
  std::vector<std::uint32_t> first_source;  ///< per line: source of its first segment; the others follow
};

/// The line classes that find_shape_lines() can find.
inline constexpr std::array kShapeClasses{LineClass::suggestive, LineClass::ridge, LineClass::valley};
bool has_shape_lines(LineClasses classes);

/// Finds the lines of the given classes.
std::vector<ShapeLine> find_shape_lines(const Scene& scene, const Topology& topology, const View& view, LineClasses classes,
                                        const ContourOptions& options);

/// Adds the segments of the lines to the lines whose visibility the method computes. Their sources start at the former
/// `source_count` of the scene.
ShapeLines add_shape_lines(ProjectedScene& projected, std::vector<ShapeLine> lines);

/// Replaces the strokes that a method returned for those segments by strokes of smooth curves. Each gets a new source
/// in StrokeModel::intersections. Visible parts of a few pen widths are treated as hidden (3 for tangent lines, else
/// 14): such short dashes only clutter the drawing. The zigzag of the mesh is smoothed out, except in tangent lines,
/// which must stay where they are. `hidden_too`: whether the method returned hidden strokes; hidden parts are then
/// drawn, too.
void draw_shape_lines(StrokeModel& model, const View& view, const ShapeLines& lines, bool hidden_too,
                      const ContourOptions& options);

}  // namespace ligne
