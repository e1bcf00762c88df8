#pragma once
/// Strokes: the visible and hidden pieces of lines that a visibility method returns.

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "geometry/lattice.hpp"

namespace ligne {

/// Class of a line, decided on the edge in space. Where lines of several classes coincide on the page, the first class
/// of this list is drawn.
enum class LineClass : std::uint8_t {
  outline,       ///< edge between a front face and a back face
  border,        ///< edge of one face
  intersection,  ///< line along which two faces penetrate each other
  crease,        ///< edge whose face normals differ by more than the crease angle, or edge of more than two faces
  tangent,       ///< line along which recognised surfaces join smoothly (scene/patches); in clear lines only
  mesh,          ///< any other edge of the scene
  curve,         ///< curve in space that is not an edge (add_lines in view/projected_scene.hpp)
  contour,       ///< contour line of a surface, regardless of its faces (kCornerContour in scene/model/scene.hpp)
  horizon,       ///< iso-curve of a surface, regardless of its faces (kCornerCurve)
  axes,          ///< line of the axes of a plot (add_lines in view/projected_scene.hpp)
  shadow,        ///< border of a shadow on a face; no edge of the scene
  suggestive,    ///< suggestive contour: where the surface almost turns into an outline
                 ///< (contours/shapes/shape_lines.hpp); no edge of the scene
  ridge,         ///< greatest outward curvature of a surface; no edge of the scene
  valley,        ///< greatest inward curvature of a surface; no edge of the scene
  detail,        ///< contour of a detail on a face; no edge of the scene
  profile,       ///< part of an outline, border or crease behind which an object ends; set after all other classes
};
inline constexpr std::size_t kLineClassCount = 16;
/// The first classes, outline to mesh, are those of edges of the scene and of intersections.
inline constexpr std::size_t kEdgeClassCount = 6;
inline constexpr std::array<std::string_view, kLineClassCount> kLineClassNames{
    "outline", "border", "intersection", "crease",     "tangent", "mesh",   "curve",  "contour",
    "horizon", "axes",   "shadow",       "suggestive", "ridge",   "valley", "detail", "profile"};

/// A set of line classes.
struct LineClasses {
  std::uint16_t bits = 0;  ///< bit i is LineClass i
  bool has(LineClass c) const { return (bits >> static_cast<unsigned>(c)) & 1u; }
  void add(LineClass c) { bits = static_cast<std::uint16_t>(bits | (1u << static_cast<unsigned>(c))); }

  /// The default classes: outlines, borders, intersections, creases and tangent lines.
  static LineClasses features() { return {0b11111}; }
};

/// A straight piece of one source edge that is visible as a whole or hidden as a whole.
struct Stroke {
  double t_from = 0, t_to = 1;  ///< parameters on the source edge in model space, from 0 to 1; t_from < t_to
  LatticePoint from{}, to{};    ///< its ends on the page lattice
  float z_from = 0, z_to = 0;   ///< depths at the two ends; smaller is nearer
  float w_from = 1,
        w_to = 1;            ///< homogeneous weights at the two ends: distance along the line of sight, up to a common
                             ///< factor; 1 in parallel projection
  std::uint32_t source = 0;  ///< number of the source edge, see StrokeModel
  LineClass line_class = LineClass::mesh;
  bool visible = true;
  bool needs_overlap_check : 1 = true;  ///< false if the method knows that no other stroke lies on this one
  bool is_joint : 1 = false;            ///< added to join lines or to extend one (linework/clean_lines.hpp)
  std::uint8_t level = 0;               ///< number of transparent faces in front, or of all faces where counted; at most 255
};

/// Parameter on the source edge at the fraction `s` of the stroke's length on the page, with perspective
/// foreshortening: with the homogeneous weights w, the page point at the model fraction u is ((1-u) w0 p0 + u w1 p1) /
/// ((1-u) w0 + u w1). Hence s = u w1 / ((1-u) w0 + u w1) and u = s w0 / ((1-s) w1 + s w0). Depth is linear in s, and w
/// is linear in u.
inline double source_parameter(const Stroke& stroke, double s) {
  const double numerator = s * stroke.w_from;
  const double u = numerator / ((1 - s) * stroke.w_to + numerator);
  return stroke.t_from + u * (stroke.t_to - stroke.t_from);
}

/// The line in space that a stroke is a part of: an edge of the scene, the common segment of two penetrating faces, or
/// a line on a face.
struct SourceEdge {
  std::array<Point3, 2> ends{};  ///< model coordinates; stroke parameters run from 0 at the first to 1 at the second
  std::array<std::uint32_t, 2> faces{0xffffffffu, 0xffffffffu};  ///< the faces that meet here; 0xffffffff is not a face
  bool intersection = false;
};

/// A hidden part of a line and the faces in front of it. The number of these faces is the quantitative invisibility of
/// its points [Appel1967]; the set of them is their nature [GalimbertiMontanari1969].
struct HiddenPart {
  std::uint32_t source = 0;
  double t_from = 0, t_to = 1;  ///< parameters on the source edge, as in Stroke
  std::uint32_t count = 0;
  std::vector<std::uint32_t> faces{};  ///< ascending; empty if only the number was requested
};

/// All strokes that one run of a method returns. Sources below `edge_count` are the sources of ProjectedScene: edges of
/// the topology and added lines. Source `edge_count` + i is intersections[i].
struct StrokeModel {
  Lattice lattice{};
  std::vector<Stroke> strokes{};
  std::uint32_t edge_count = 0;
  std::vector<SourceEdge> intersections{};  ///< intersections of faces; later phases append borders of shadows and curves
  std::vector<HiddenPart> hidden_parts{};   ///< by source and parameter; empty unless faces in front were counted
};

}  // namespace ligne
