#pragma once
/// Which faces bound convex bodies: [Boulle1980] parts the faces of a convex object into those that look at the viewer and
/// those that do not.
///
/// Let all of a body lie on one side of the plane of each of its faces. Two faces with the viewer on their outer sides do
/// not hide each other: each is behind the plane of the other. Of two with the viewer on their inner sides each is before
/// the plane of the other, and neither hides either. One of the latter never hides one of the former. The body need not be
/// closed, nor wound in any way.

#include <cstdint>
#include <vector>

#include "base/no_index.hpp"
#include "visibility/order/model_pieces.hpp"

namespace ligne::newell {

class ConvexBodies {
 public:
  /// Bodies are sets of faces that hang together by vertices. `pieces` are those of the scene. Where the scene states that
  /// all its objects are convex bodies, one height for each triangle is enough.
  ConvexBodies(const Scene& scene, const ModelPieces& pieces, const Viewpoint& viewpoint);

  /// That the first of two faces does not hide the second is known without a comparison.
  bool never_hides(std::uint32_t face, std::uint32_t other) const {
    return body_[face] == body_[other] && body_[face] != kNone && !(is_front_[face] && !is_front_[other]);
  }
  /// The body of a face, or kNone.
  std::uint32_t body(std::uint32_t face) const { return body_[face]; }
  bool is_front(std::uint32_t face) const { return is_front_[face] != 0; }  ///< of a face of a body
  std::uint32_t count() const { return count_; }                            ///< of bodies
  std::uint64_t faces() const { return faces_; }                            ///< in them
  /// Heights of vertices over planes that were computed to find them.
  std::uint64_t heights() const { return heights_; }

 private:
  void find_fronts(const std::vector<std::uint32_t>& shell, const ModelPieces& pieces, const Viewpoint& viewpoint);
  void collect_vertices(const std::vector<std::uint32_t>& shell, const ModelPieces& pieces);
  bool lies_on_one_side(const std::vector<std::uint32_t>& shell, const ModelPieces& pieces, const Viewpoint& viewpoint);

  std::vector<std::uint32_t> body_;  ///< of every face, or kNone
  std::vector<std::uint8_t> is_front_;
  std::uint32_t count_ = 0;
  std::uint64_t faces_ = 0, heights_ = 0;
  std::vector<std::uint32_t> vertices_;  ///< while a body is looked at
};

}  // namespace ligne::newell
