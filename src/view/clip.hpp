#pragma once
/// Clipping to the view volume, before the division by w (Sutherland and Hodgman 1974 in homogeneous coordinates).

#include <array>
#include <optional>
#include <vector>

#include "geometry/lattice.hpp"
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

/// The volume in which lines are drawn: the window, and points that the lattice rounds onto its border. So a line along the
/// border, or a vertex on it, is in view whatever the last digits of its projection.
ClipVolume line_volume(const View& view, const Lattice& lattice);

/// The volume in which faces are studied: kWindowMarginSteps more than the window, so that a line along the window's border
/// has on both of its banks what covers it.
ClipVolume face_volume(const View& view, const Lattice& lattice);

/// Clips a convex contour in place; what is left has no corner when nothing is inside.
void clip_contour(std::vector<HomogeneousPoint>& contour, const ClipVolume& volume);

/// The part of a segment a, b that is inside.
struct SegmentPart {
  /// Parameters of a + t (b - a), 0 <= t <= 1. Since the coordinates are homogeneous, t is also the parameter on the edge in
  /// model space.
  std::array<double, 2> range{0, 1};
  /// Per end: it is a point of the volume's border, because the segment's own end lies outside. The parameter does not say:
  /// where an end is outside by a rounding only, the parameter of the cut may be rounded to 0 or 1.
  std::array<bool, 2> cut{false, false};

  bool whole() const { return !cut[0] && !cut[1]; }
};

/// The part inside, or nothing. An end is cut when and only when the volume does not contain it.
std::optional<SegmentPart> clip_segment(const HomogeneousPoint& a, const HomogeneousPoint& b, const ClipVolume& volume);

/// a + t (b - a).
HomogeneousPoint interpolate(const HomogeneousPoint& a, const HomogeneousPoint& b, double t);

}  // namespace ligne
