#pragma once
/// Line segments and arcs of circles in a scan plane, [Boulle1980] 3.2.1.2, and where two of them meet. All is exact.
///
/// The plane has x along the scan line and the depth z; the viewer looks along +z. A curve has one depth for each x of its
/// range: a segment that is not parallel to the view, or an arc of the near or the far half of a circle, whose curvature has
/// one sign.

#include <array>
#include <cstdint>
#include <vector>

#include "studies/operations/one_root.hpp"

namespace ligne::studies {

/// Largest coordinate, and largest radius, for which all decisions are exact.
inline constexpr std::int32_t kCurveLimit = 1 << 12;

struct PlaneCurve {
  enum class Kind : std::uint8_t { segment, near_arc, far_arc };
  Kind kind = Kind::segment;
  bool is_transparent = false;              ///< it hides nothing
  std::int32_t left = 0, right = 0;         ///< range in x; a segment with left == right is parallel to the view
  std::int32_t z_left = 0, z_right = 0;     ///< depths of the ends; segments only
  std::int32_t x_middle = 0, z_middle = 0;  ///< centre; arcs only
  std::int32_t radius_square = 0;           ///< arcs only; left and right are at most the radius from the centre

  static PlaneCurve segment(LatticePoint a, LatticePoint b, bool is_transparent = false);
  /// `radius` is the radius; the range is cut to that of the circle.
  static PlaneCurve arc(Kind half, LatticePoint centre, std::int32_t radius, LatticePoint range,
                        bool is_transparent = false);

  bool is_arc() const { return kind != Kind::segment; }
  bool is_seen_edge_on() const { return left == right; }
  double depth(double x) const;  ///< rounded
};

/// The line or the half circle that a curve is part of: equal for two curves that coincide where their ranges overlap.
std::array<std::int64_t, 4> carrier_of(const PlaneCurve& curve);

/// The near and the far half of a circle.
std::vector<PlaneCurve> circle(LatticePoint centre, std::int32_t radius, bool is_transparent = false);

/// Where two curves meet within their common range; nowhere if that is a point or empty.
struct CurveMeeting {
  bool coincide = false;   ///< they are equal over the whole common range
  int order_at_begin = 0;  ///< -1 if the first is nearer just behind the begin of the common range, +1 if the second is
  int count = 0;           ///< common points, unless they coincide
  OneRoot points[2];       ///< rising
  bool crosses[2] = {};    ///< they change sides there; otherwise they touch, or one ends
};
CurveMeeting meeting_of(const PlaneCurve& a, const PlaneCurve& b);

/// Sign of the depth of `a` less that of `b` at numerator / 2, which lies in both ranges.
int depth_order(const PlaneCurve& a, const PlaneCurve& b, std::int64_t numerator);

}  // namespace ligne::studies
