#pragma once
/// A segment to be compared with a horizon: from left to right, with conversion back to fractions in space.

#include <algorithm>
#include <cmath>
#include <vector>

#include "visibility/horizon/envelope.hpp"
#include "visibility/horizon/plane_projection.hpp"

namespace ligne::horizon {

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
