#pragma once
/// The depth order of two touching faces: decided once per pair, from their whole overlap on the page, and cached.
///
/// Depths of touching faces differ only by rounding, and differently on every scan line. Compared line by line, the two
/// would change order from line to line and seem to penetrate each time. So where their depths on a line agree within the
/// depth tolerance (docs/numerics.md), this order decides. If the two touch everywhere, the face with the lower number is in
/// front everywhere. If one is in front somewhere and behind nowhere, it is in front also where they touch. Only faces that
/// penetrate by more than the tolerance are compared by their depths.

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "visibility/common/facet.hpp"
#include "visibility/watkins/skew_faces.hpp"
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
  /// `skew`: faces that have no plane, or null. Depths decide between them and others.
  FaceOrders(const std::vector<ProjectedVertex>& vertices, const std::vector<Facet>& facets, const FacetsOfFaces& of_faces,
             const SkewFaces* skew = nullptr)
      : vertices_(vertices), facets_(facets), of_faces_(of_faces), skew_(skew) {}

  /// The result depends only on the two faces: of(b, a) is of(a, b) with exchanged roles.
  DepthOrder of(std::uint32_t a, std::uint32_t b);

  std::size_t pairs() const { return known_.size(); }  ///< number of pairs decided

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
  const SkewFaces* skew_;
  std::unordered_map<std::uint64_t, DepthOrder> known_;  ///< by the lower, then the higher number; only looked up
  std::vector<Extent> extents_a_, extents_b_, open_;     ///< scratch of decide()
};

}  // namespace ligne::watkins
