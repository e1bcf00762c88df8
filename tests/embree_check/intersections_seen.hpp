#pragma once
/// Finds visible intersections of penetrating faces by looking, with no intersection computed: rays on a grid of page
/// points; between neighbours that see different faces the place of the change is found by bisection; where both faces go on
/// beyond that place, one can have come before the other only by passing through it.

#include "check.hpp"
#include "sight.hpp"

namespace ligne::check {

struct SeenCrossing {
  Point2 at{0, 0};        ///< page mm
  Point3 point{0, 0, 0};  ///< unit box
  std::array<std::uint32_t, 2> faces{};
  double length_mm = 0;  ///< of the intersection, by this crossing's share of the grid
};

std::vector<SeenCrossing> find_intersections_seen(const CheckedScene& scene, const PageMap& map, const Sight& sight,
                                                  const CheckOptions& options);

}  // namespace ligne::check
