#pragma once
/// Which of two faces is in front where they touch: decided once for a pair, from all of its overlap on the page, and
/// remembered.
///
/// Depths of faces that touch are equal but for roundings, and on every scan line for other ones. Were they compared line by
/// line, the two would change places from line to line, and each time look as if they penetrated. So where the depths on a
/// line are within the depth tolerance (docs/numerics.md) the pair is asked instead: if the two touch all over, the face
/// of the lower number is in front everywhere; if one is in front somewhere and behind nowhere, it is in front also where
/// they touch. Only faces that pass through each other by more than the tolerance are left to their depths.

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "visibility/common/facet.hpp"
#include "visibility/watkins/spans/span_method.hpp"

namespace ligne::watkins {

/// The facets of every face.
struct FacetsOfFaces {
  FacetsOfFaces() = default;
  FacetsOfFaces(const std::vector<Facet>& facets, std::uint32_t face_count);
  std::span<const std::uint32_t> of(std::uint32_t face) const {
    return {list.data() + first[face], list.data() + first[face + 1]};
  }
  std::vector<std::uint32_t> first, list;
};

class FaceOrders {
 public:
  FaceOrders(const std::vector<ProjectedVertex>& vertices, const std::vector<Facet>& facets, const FacetsOfFaces& of_faces)
      : vertices_(vertices), facets_(facets), of_faces_(of_faces) {}

  /// The answer depends on the two faces alone: of(b, a) is of(a, b) with the roles exchanged.
  DepthOrder of(std::uint32_t a, std::uint32_t b);

  std::size_t pairs() const { return known_.size(); }  ///< that were asked for

 private:
  struct Extent {
    std::int32_t x0, x1, y0, y1;
    std::uint32_t facet;
  };

  DepthOrder decide(std::uint32_t a, std::uint32_t b);
  void extents_of(std::uint32_t face, std::vector<Extent>& extents) const;

  const std::vector<ProjectedVertex>& vertices_;
  const std::vector<Facet>& facets_;
  const FacetsOfFaces& of_faces_;
  std::unordered_map<std::uint64_t, DepthOrder> known_;  ///< by the lower number and the higher one; looked up only
  std::vector<Extent> extents_a_, extents_b_, open_;     ///< working memory of decide()
};

}  // namespace ligne::watkins
