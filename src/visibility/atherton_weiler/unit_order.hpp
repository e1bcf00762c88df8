#pragma once
/// Which of two units is in front, found when it is asked for and remembered.

#include <unordered_map>

#include "visibility/atherton_weiler/clip_units.hpp"
#include "visibility/polygons/facet_order.hpp"

namespace ligne::atherton_weiler {

/// For one task.
class UnitOrders {
 public:
  /// Facets that touch others are marked in `touches`; see VisibleFaces::facet_touches.
  UnitOrders(const ProjectedScene& scene, const std::vector<Facet>& facets, const std::vector<ClipUnit>& units,
             std::vector<std::uint8_t>& touches)
      : scene_(scene), facets_(facets), units_(units), touches_(touches) {}

  /// The order of two units that have a place of the page in common.
  DepthOrder order(std::uint32_t a, std::uint32_t b);

  /// Where they have mixed order, because they pass through each other or one is no plane: the parts of b that are in front
  /// of a, those that meet the rectangle.
  std::vector<ContourFace> front_parts(std::uint32_t a, std::uint32_t b, const PageBox& within) const;

 private:
  template <class Visit>
  void for_each_pair(std::uint32_t a, std::uint32_t b, const PageBox& within, Visit visit) const;

  const ProjectedScene& scene_;
  const std::vector<Facet>& facets_;
  const std::vector<ClipUnit>& units_;
  std::vector<std::uint8_t>& touches_;
  std::unordered_map<std::uint64_t, DepthOrder> known_;  ///< by the numbers of two units, the lower first
};

}  // namespace ligne::atherton_weiler
