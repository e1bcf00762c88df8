#pragma once
/// Clipping to the view volume in homogeneous coordinates, before the division by w (Sutherland and Hodgman 1974).

#include <array>
#include <optional>
#include <vector>

#include "geometry/lattice.hpp"
#include "geometry/point.hpp"
#include "view/view.hpp"

namespace ligne {

/// A view volume: the points with w >= near_distance whose page point lies in the window.
struct ClipVolume {
  Rect window;
  double near_distance = 0;

  static constexpr int kPlanes = 5;
  /// Signed distance to plane i, scaled by a positive factor: >= 0 inside.
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

/// The volume in which lines are drawn: the window widened by half a lattice step, with all points that the lattice
/// rounds onto its border. So a line along the border, or a vertex on it, is in view however it is rounded.
ClipVolume line_volume(const View& view, const Lattice& lattice);

/// The volume to which faces are clipped: the window widened by kWindowMarginSteps lattice steps, so that the faces on
/// both sides of a line along its border are known.
ClipVolume face_volume(const View& view, const Lattice& lattice);

/// Clips a convex contour in place. The result is empty if nothing lies inside.
void clip_contour(std::vector<HomogeneousPoint>& contour, const ClipVolume& volume);

/// The part of a segment a, b that lies inside a volume.
struct SegmentPart {
  /// First and last parameter t of a + t (b - a), 0 <= t <= 1. Since the coordinates are homogeneous, t is also the
  /// parameter on the edge in model space.
  std::array<double, 2> range{0, 1};
  /// Per end: whether the end of the segment lies outside, so that the part ends on the border of the volume. `range`
  /// does not show this: if the end is outside by a rounding error only, the parameter of the cut may round to 0 or 1.
  std::array<bool, 2> cut{false, false};

  bool whole() const { return !cut[0] && !cut[1]; }
};

/// The part inside, or nothing. An end is cut if and only if the volume does not contain it.
std::optional<SegmentPart> clip_segment(const HomogeneousPoint& a, const HomogeneousPoint& b, const ClipVolume& volume);

/// The point a + t (b - a).
HomogeneousPoint interpolate(const HomogeneousPoint& a, const HomogeneousPoint& b, double t);

}  // namespace ligne
