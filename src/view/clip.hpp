#pragma once
/// Clipping to the view volume, before the division by w (Sutherland and Hodgman 1974 in homogeneous coordinates).

#include <array>
#include <optional>
#include <vector>

#include "geometry/point.hpp"
#include "view/view.hpp"

namespace ligne {

/// w >= near and the page point inside the window.
struct ClipVolume {
  Rect window;
  double near_distance = 0;

  static constexpr int kPlanes = 5;
  /// Signed distance to plane i, in no particular unit: >= 0 inside.
  double distance(int plane, const HomogeneousPoint& p) const {
    switch (plane) {
      case 0:
        return p.w - near_distance;
      case 1:
        return p.x - window.min.x * p.w;
      case 2:
        return window.max.x * p.w - p.x;
      case 3:
        return p.y - window.min.y * p.w;
      default:
        return window.max.y * p.w - p.y;
    }
  }
  bool contains(const HomogeneousPoint& p) const {
    for (int i = 0; i < kPlanes; ++i) {
      if (distance(i, p) < 0) return false;
    }
    return true;
  }
};

/// Clips a convex contour in place; what is left has no corner when nothing is inside.
void clip_contour(std::vector<HomogeneousPoint>& contour, const ClipVolume& volume);

/// The part of the segment a, b inside, as parameters of a + t (b - a), 0 <= t <= 1, or nothing. Since the coordinates are
/// homogeneous, t is also the parameter on the edge in model space.
std::optional<std::array<double, 2>> clip_segment(const HomogeneousPoint& a, const HomogeneousPoint& b,
                                                  const ClipVolume& volume);

/// a + t (b - a).
HomogeneousPoint interpolate(const HomogeneousPoint& a, const HomogeneousPoint& b, double t);

}  // namespace ligne
