#pragma once
/// The plane on which curves are compared with the horizon.

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "view/view.hpp"
#include "visibility/horizon/envelope.hpp"

namespace ligne::horizon {

/// A point projected to an upright drawing plane, on which verticals stay vertical for any tilt of the camera. Hiding
/// depends only on the lines of sight, so any plane serves, and on this one the horizon is a function of u.
struct PlanePoint {
  double x, y;  ///< to the right and upwards, before the division by w
  double w;     ///< distance from the viewer along the plane's normal; 1 in parallel projection
  double u() const { return x / w; }
  double v() const { return y / w; }
};

/// The projection of one part of the grid: in perspective, of all points with sign_x (x - eye_x) >= 0 and sign_y (y -
/// eye_y) >= 0.
class PlaneProjection {
 public:
  PlaneProjection(const Camera& camera, double sign_x, double sign_y);

  PlanePoint operator()(const Point3& p) const {
    const Point3 d = p - eye_;
    if (!perspective_) return {glm::dot(right_, d), glm::dot(up_, d), 1};
    return {glm::dot(right_, d), d.z, glm::dot(forward_, d)};
  }

  bool perspective() const { return perspective_; }

 private:
  bool perspective_;
  Point3 eye_, right_, up_, forward_;
};

/// Fraction of a segment in space at the fraction s on the drawing plane; see source_parameter in linework/stroke.hpp.
inline double fraction_in_space(double w0, double w1, double s) {
  const double numerator = s * w0;
  return numerator / ((1 - s) * w1 + numerator);
}

class PlaneSegment {
 public:
  PlaneSegment() = default;
  /// A segment no wider than `upright` is upright: it has no width that could hide.
  PlaneSegment(const PlanePoint& a, const PlanePoint& b, double upright)
      : w0_(a.w), w1_(b.w), line_{a.u(), a.v(), b.u(), b.v()} {
    upright_ = std::abs(line_.u1 - line_.u0) <= upright;
    turned_ = upright_ ? line_.v1 < line_.v0 : line_.u1 < line_.u0;
    if (turned_) line_ = {line_.u1, line_.v1, line_.u0, line_.v0};
  }

  bool upright() const { return upright_; }
  const Line& line() const { return line_; }  ///< u0 < u1; upright: v0 <= v1
  double height_of_start() const { return turned_ ? line_.v1 : line_.v0; }
  Line upside_down() const { return {line_.u0, -line_.v0, line_.u1, -line_.v1}; }

  /// Converts spans of u (for an upright segment, of v) to fractions of the segment in space, ascending.
  void to_space(std::vector<Span>& spans) const {
    const double from = upright_ ? line_.v0 : line_.u0, to = upright_ ? line_.v1 : line_.u1, extent = to - from;
    for (Span& s : spans) {
      if (s.from == from && s.to == to && from < to) {  // most lines are visible as a whole or not at all
        s = {0, 1};
        continue;
      }
      s = {(s.from - from) / extent, (s.to - from) / extent};
      if (turned_) s = {1 - s.to, 1 - s.from};
      s = {fraction_in_space(w0_, w1_, s.from), fraction_in_space(w0_, w1_, s.to)};
    }
    if (turned_) std::reverse(spans.begin(), spans.end());
  }

 private:
  double w0_ = 1, w1_ = 1;
  Line line_{};
  bool upright_ = false, turned_ = false;
};

}  // namespace ligne::horizon
