#pragma once
/// Skew faces by the slopes of their sides ([Boulle1980] 2.3.2.1): faces whose corners are not in a plane, and that are
/// not cut into triangles. On every scan line the segment of such a face runs straight from its depth on one side to its
/// depth on the next. So between two sides the face is a ruled surface with horizontal rulings. The surface depends on
/// the direction of the scan lines; only its sides are the same in each view.
///
/// Reading a model cuts skew faces into triangles and marks the new edges (kCornerInner). Here they are joined again.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "view/projected_scene.hpp"
#include "visibility/common/facet.hpp"
#include "visibility/common/hidden_interval.hpp"

namespace ligne::watkins {

/// A side of a skew face from top to bottom: top.p.y < bottom.p.y. x and y are in lattice steps, z in mm.
struct RuledSide {
  ProjectedVertex top, bottom;

  double x(double y) const { return at(y, top.p.x, bottom.p.x); }
  double z(double y) const { return at(y, top.z, bottom.z); }

 private:
  double at(double y, double first, double last) const {
    return first + (last - first) * ((y - top.p.y) / (double(bottom.p.y) - top.p.y));
  }
};

/// A part of a skew face: between two neighbouring sides, and between two heights between which no side of the face
/// begins, ends or crosses another. Its depth is linear along each side and along each horizontal ruling.
struct RuledPart {
  RuledSide left, right;
  double y_top, y_bottom;  ///< lattice steps
};

/// Faces with more sides than this stay triangles: their parts are found by comparing all pairs of sides.
inline constexpr std::size_t kMostSkewSides = 64;

/// Divides a face into parts. `sides`: its sides without horizontal ones, at most kMostSkewSides, in any order.
std::vector<RuledPart> ruled_parts(std::span<const RuledSide> sides);

/// The parts of a line that are farther than the ruled surface: at most two. The others have sides `none`. `tolerance`:
/// depth difference at which surfaces touch, mm. Ends are exact but for the rounding of doubles.
std::array<HiddenInterval, 2> behind_ruled_part(const PageLine& line, const RuledPart& part, double tolerance);

/// The skew faces of a scene. Faces are numbered as in the scene; a skew face has the lowest number of its triangles.
class SkewFaces {
 public:
  bool has(std::uint32_t face) const { return face < number_.size() && number_[face] != kNone; }
  std::size_t count() const { return faces_.size(); }
  std::span<const RuledPart> parts(std::uint32_t face) const { return faces_[number_[face]].parts; }
  double farthest(std::uint32_t face) const { return faces_[number_[face]].farthest; }  ///< its largest depth, mm
  /// Surfaces within this depth of the face touch it, mm.
  double depth_tolerance(std::uint32_t face) const { return faces_[number_[face]].depth_tolerance; }

  struct Face {
    std::vector<RuledPart> parts;
    double farthest = 0, depth_tolerance = 0;
  };
  void add(std::uint32_t face, Face surface);

 private:
  std::vector<std::uint32_t> number_;  ///< by face: its place in `faces_`, or kNone
  std::vector<Face> faces_;
};

/// A scene in which the triangles of each skew face have one number. Edges within these faces are no candidates, except
/// outlines: there the face folds over on the page, and the outline has no other edge.
struct SkewScene {
  ProjectedScene scene;
  SkewFaces faces;
  std::size_t left_as_triangles = 0;  ///< skew faces of more than kMostSkewSides sides
};

/// Joins the triangles of skew faces. Nothing if the scene has no such faces. `facets`: make_facets() of the scene.
/// O(n log n).
std::optional<SkewScene> join_skew_faces(const ProjectedScene& scene, const std::vector<Facet>& facets);

}  // namespace ligne::watkins
