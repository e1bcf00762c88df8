#pragma once
/// Strokes: what a visibility method says of the edges.

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "geometry/lattice.hpp"

namespace ligne {

/// Class of a line, decided on the 3D edge; in order of precedence where lines coincide on the page.
enum class LineClass : std::uint8_t {
  outline,       ///< one of its two faces looks at the viewer, the other away
  border,        ///< one face
  intersection,  ///< of two penetrating faces
  crease,        ///< normals differ by more than the crease angle, or more than two faces
  tangent,       ///< surfaces that the mesh stands for run into each other (scene/patches); in clear lines only
  mesh,          ///< all others
  curve,         ///< curve in space, of no face (add_lines in view/projected_scene.hpp)
  contour,       ///< contour line of a surface, whatever its faces (kCornerContour in scene/scene.hpp)
  horizon,       ///< iso-curve of a surface, whatever its faces (kCornerCurve)
  axes,          ///< line of the axes, of no face (add_lines in view/projected_scene.hpp)
  shadow,        ///< border of a shadow on a face; no edge of the scene
  suggestive,  ///< where the surface turns as towards an outline and back (contours/shapes/shape_lines.hpp); no edge of the
               ///< scene
  ridge,       ///< where a surface is bent most, outwards; no edge either
  valley,      ///< where a surface is bent most, inwards; no edge either
  detail,      ///< contour of a detail on a face; no edge of the scene
  profile,     ///< part of a line of one of the first classes behind which an object ends; decided when all else is
};
inline constexpr std::size_t kLineClassCount = 16;
/// The first classes are those of the scene's edges.
inline constexpr std::size_t kEdgeClassCount = 6;
inline constexpr std::array<std::string_view, kLineClassCount> kLineClassNames{
    "outline", "border", "intersection", "crease",     "tangent", "mesh",   "curve",  "contour",
    "horizon", "axes",   "shadow",       "suggestive", "ridge",   "valley", "detail", "profile"};

/// A set of classes.
struct LineClasses {
  std::uint16_t bits = 0;
  bool has(LineClass c) const { return (bits >> static_cast<unsigned>(c)) & 1u; }
  void add(LineClass c) { bits = static_cast<std::uint16_t>(bits | (1u << static_cast<unsigned>(c))); }

  /// The classes that are drawn by default: outlines, borders, intersections, creases and tangent lines.
  static LineClasses features() { return {0b11111}; }
};

/// A straight piece of one source edge, visible or hidden as a whole.
struct Stroke {
  double t_from = 0, t_to = 1;  ///< parameters on the source edge in model space, t_from < t_to
  LatticePoint from, to;
  float z_from = 0, z_to = 0;  ///< depths at the two ends; smaller is nearer
  float w_from = 1,
        w_to = 1;            ///< distances along the line of sight at the two ends (to one factor); 1 in parallel projection
  std::uint32_t source = 0;  ///< source edge, as numbered by StrokeModel
  LineClass line_class = LineClass::mesh;
  bool visible = true;
  bool needs_overlap_check = true;  ///< false only where the method knows that no other stroke lies on this one
  std::uint8_t level = 0;           ///< how many transparent faces are in front of it, 255 for more; 0 is seen directly
};

/// Parameter on the source edge at the fraction `s` of the stroke's length on the page. Perspective foreshortens: with the
/// homogeneous weights w the page point at the model fraction u is ((1-u) w0 p0 + u w1 p1) / ((1-u) w0 + u w1), hence
/// s = u w1 / ((1-u) w0 + u w1) and u = s w0 / ((1-s) w1 + s w0). Depth is linear on the page, w is linear in u.
inline double source_parameter(const Stroke& stroke, double s) {
  const double numerator = s * stroke.w_from;
  const double u = numerator / ((1 - s) * stroke.w_to + numerator);
  return stroke.t_from + u * (stroke.t_to - stroke.t_from);
}

/// Where a stroke comes from: an edge of the scene, the common segment of two penetrating faces, or a line on a face.
struct SourceEdge {
  std::array<Point3, 2> ends{};  ///< model coordinates; a stroke's parameter runs from the first to the second
  std::array<std::uint32_t, 2> faces{0xffffffffu,
                                     0xffffffffu};  ///< the faces that meet here, 0xffffffff where there is none
  bool intersection = false;
};

/// All strokes of one study. Sources below `edge_count` are edges of the scene, by index; the others are the
/// intersections and, behind them, borders of shadows, in order.
struct StrokeModel {
  Lattice lattice;
  std::vector<Stroke> strokes;
  std::uint32_t edge_count = 0;
  std::vector<SourceEdge> intersections;
};

}  // namespace ligne
