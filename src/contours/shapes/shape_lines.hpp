#pragma once
/// Lines of the shape that are no edges and no outlines: suggestive contours, ridges and valleys. docs/shape-lines.md.

#include <array>
#include <cstdint>
#include <vector>

#include "contours/contour_curves.hpp"
#include "contours/contour_lines.hpp"

namespace ligne {

/// Segment i runs from point i to point i + 1 over a face of the scene. A closed line repeats its first point.
struct ShapeLine {
  LineClass line_class = LineClass::suggestive;
  std::vector<Point3> points;  ///< on the mesh
  std::vector<std::uint32_t> faces;
  bool closed = false;

  std::size_t size() const { return faces.size(); }
};

/// The lines of a scene, and where they are in its study.
struct ShapeLines {
  std::vector<ShapeLine> lines;
  std::vector<std::uint32_t> first_source;  ///< per line: source of its first segment; the others follow
};

/// The classes that are lines of the shape.
inline constexpr std::array kShapeClasses{LineClass::suggestive, LineClass::ridge, LineClass::valley};
bool has_shape_lines(LineClasses classes);

/// Finds the lines of these classes.
std::vector<ShapeLine> find_shape_lines(const Scene& scene, const Topology& topology, const View& view, LineClasses classes,
                                        const ContourOptions& options);

/// Adds candidates at which the visibility of lines is studied, with sources from `source_count` on.
ShapeLines add_shape_lines(ProjectedScene& projected, std::vector<ShapeLine> lines);

/// Replaces the strokes of those candidates by strokes of the lines as smooth curves, with sources of their own behind the
/// intersections. What is seen of a line in pieces too short to tell anything is left out. Tangent lines are not evened.
/// `hidden_too`: as in the study.
void draw_shape_lines(StrokeModel& model, const View& view, const ShapeLines& lines, bool hidden_too,
                      const ContourOptions& options);

}  // namespace ligne
