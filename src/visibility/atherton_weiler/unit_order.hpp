#pragma once
/// The depth order of two units, computed on demand and cached.

#include <unordered_map>

#include "visibility/atherton_weiler/clip_units.hpp"
#include "visibility/atherton_weiler/polygon_clip.hpp"
#include "visibility/polygons/facet_order.hpp"

namespace ligne::atherton_weiler {

/// One per task: not thread-safe.
class UnitOrders {
 public:
  /// Marks facets that touch others in `touches`; see VisibleFaces::facet_touches.
  UnitOrders(const ProjectedScene& scene, const std::vector<Facet>& facets, const std::vector<ClipUnit>& units,
             std::vector<std::uint8_t>& touches, ClipKind clip, PolygonCounts& counts)
      : scene_(scene), facets_(facets), units_(units), touches_(touches), clip_(clip, counts) {}

  /// The order of two units that overlap on the page.
  DepthOrder order(std::uint32_t a, std::uint32_t b);

  /// For units of mixed order, which penetrate or are not planar: the parts of b in front of a that meet the rectangle.
  std::vector<ContourFace> front_parts(std::uint32_t a, std::uint32_t b, const PageBox& within);

 private:
  template <class Visit>
  void for_each_pair(std::uint32_t a, std::uint32_t b, const PageBox& within, Visit visit) const;

  const ProjectedScene& scene_;
  const std::vector<Facet>& facets_;
  const std::vector<ClipUnit>& units_;
  std::vector<std::uint8_t>& touches_;
  PolygonClip clip_;
  std::unordered_map<std::uint64_t, DepthOrder> known_;  ///< by the numbers of two units, lower first
};

}  // namespace ligne::atherton_weiler
