#pragma once
/// Skew faces by the slopes of their sides ([Boulle1980] 2.3.2.1): faces whose corners are not in a plane, and that are
/// not cut into triangles. On every scan line the segment of such a face runs straight from its depth on one side to its
/// depth on the next. So between two sides the face is a ruled surface with horizontal rulings. The surface depends on
/// the direction of the scan lines; only its sides are the same in each view.
///
/// Reading a model cuts skew faces into triangles and marks the new edges (kCornerInner). Here they are joined again.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "view/projected_scene.hpp"
#include "visibility/common/facet.hpp"
#include "visibility/watkins/ruled_parts.hpp"

namespace ligne::watkins {

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
