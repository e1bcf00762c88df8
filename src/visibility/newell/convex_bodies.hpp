#pragma once
/// Faces that bound convex bodies. [Boulle1980] divides the faces of a convex object into front and back faces.
///
/// Let a body lie on one side of the plane of each of its faces. Two front faces do not hide each other: each lies behind
/// the plane of the other. Two back faces do not hide each other: each lies in front of the plane of the other. A back face
/// never hides a front face. The body need be neither closed nor consistently oriented.

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/no_index.hpp"
#include "geometry/point.hpp"
#include "visibility/order/model_pieces.hpp"

namespace ligne::newell {

/// Extents on the page and in depth: [low, high] along x, y, z.
struct Extents {
  std::array<double, 3> low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};

  void extend(const Extents& o);
  double longest_side() const { return std::max(high[0] - low[0], high[1] - low[1]); }  ///< on the page
  /// True if they overlap along the axis by more than a border.
  bool overlap(const Extents& o, int axis) const { return low[axis] < o.high[axis] && o.low[axis] < high[axis]; }
};

/// An element of the priority list: a connected part of a face, or a convex body. `parts` are convex pieces of triangles.
struct Element {
  std::uint32_t face = 0;            ///< for a body: one of its faces
  std::uint32_t body = kNone;        ///< body number, or kNone
  std::vector<std::uint32_t> parts;  ///< numbers of pieces
  Extents extents;
  ModelPlane plane;                              ///< its normal points to the viewer's side; unset for a body
  std::array<double, 3> page_plane{};            ///< see PagePlanes
  std::size_t corner_begin = 0, corner_end = 0;  ///< range of corners of its parts in the model, see PaintElements
};

class ConvexBodies {
 public:
  /// Bodies are sets of faces connected by vertices. `pieces` are the pieces of the scene. If the scene states that all its
  /// objects are convex bodies, one height per triangle is computed.
  ConvexBodies(const Scene& scene, const ModelPieces& pieces, const Viewpoint& viewpoint);

  /// True if it is known without comparison that `face` does not hide `other`.
  bool never_hides(std::uint32_t face, std::uint32_t other) const {
    return body_[face] == body_[other] && body_[face] != kNone && !(is_front_[face] && !is_front_[other]);
  }
  /// The body of a face, or kNone.
  std::uint32_t body(std::uint32_t face) const { return body_[face]; }
  bool is_front(std::uint32_t face) const { return is_front_[face] != 0; }  ///< for a face of a body
  std::uint32_t count() const { return count_; }                            ///< number of bodies
  std::uint64_t faces() const { return faces_; }                            ///< number of faces in bodies
  /// Number of computed heights of vertices over planes.
  std::uint64_t heights() const { return heights_; }

 private:
  void find_fronts(std::span<const std::uint32_t> shell, const ModelPieces& pieces, const Viewpoint& viewpoint);
  void collect_vertices(std::span<const std::uint32_t> shell, const ModelPieces& pieces);
  bool lies_on_one_side(std::span<const std::uint32_t> shell, const ModelPieces& pieces, const Viewpoint& viewpoint);

  std::vector<std::uint32_t> body_;  ///< per face, or kNone
  std::vector<std::uint8_t> is_front_;
  std::uint32_t count_ = 0;
  std::uint64_t faces_ = 0, heights_ = 0;
  std::vector<std::uint32_t> vertices_;  ///< scratch: vertices of the body under test
};

/// Convex bodies as list elements: one silhouette replaces many faces.
///
/// [Boulle1980] 1.2.2.3 c consolidates a convex object into its silhouette, and 2.5.2.7 puts its faces back into the list,
/// back faces before front faces. A body that can not be ordered as a whole is opened: its faces replace it.
struct BodyElement {
  std::vector<Element> members;  ///< one element per face, back faces first
  std::size_t back_count = 0;
  std::vector<Point2> silhouette;  ///< convex hull on the page, mm, in positive orientation
};

}  // namespace ligne::newell
