#pragma once
/// Converts regions to faces of lattice contours and back, for further cutting.

#include <vector>

#include "drawing/result_models.hpp"
#include "geometry/polygons/contour_face.hpp"

namespace ligne {

inline ContourFace on_lattice(const Region& region, const Lattice& lattice) {
  std::vector<std::vector<LatticePoint>> contours;
  for (const std::vector<Point2>& contour : region.contours) {
    auto& points = contours.emplace_back();
    for (const Point2& p : contour) points.push_back(lattice.snap(p));
  }
  return make_contour_face(contours);
}

/// A region with these contours and otherwise the members of `like`.
inline Region region_of(const ContourFace& face, const Lattice& lattice, const Region& like) {
  Region region{like.face, {}, like.level, like.lights, like.light_shares, like.material};
  for (const EdgeLoop& loop : face.contours) {
    auto& contour = region.contours.emplace_back();
    for (const ContourEdge& e : loop) contour.push_back(to_mm(lattice, e.begin()));
  }
  return region;
}

}  // namespace ligne
