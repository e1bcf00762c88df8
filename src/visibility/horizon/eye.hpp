#pragma once
/// Finds the places of points of the surface on the drawing plane and on the page, and the part of a segment in front
/// of the eye and inside the window.

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "view/clip.hpp"
#include "visibility/horizon/envelope.hpp"
#include "visibility/horizon/plane_projection.hpp"

namespace ligne::horizon {

/// Least distance in perspective of drawn points from the eye, along the normal of the drawing plane, as a part of the
/// target distance.
inline constexpr double kNearestPart = 0x1p-30;

/// A sample of the surface, with its places on the drawing plane and on the page.
struct Sample {
  Point3 p;
  PlanePoint seen;
  HomogeneousPoint page{};
  bool hole = true;
  bool placed = false;  ///< `page` and `inside` are computed
  bool inside = false;  ///< it is inside the window
};

/// The part of a segment that is in front of the eye: its ends, and their fractions of the segment in space.
struct FrontPart {
  PlanePoint a, b;
  double from, to;
};

class Eye {
 public:
  Eye(const View& view, const PlaneProjection& projection)
      : view_(view),
        projection_(projection),
        volume_{view.window, view.near_distance},
        nearest_(kNearestPart * view.camera.target_distance) {}

  /// A sample without a place on the page.
  Sample sample(const Point3& p) const { return {p, projection_(p), {}, false}; }
  Sample placed(Sample s) const {
    s.page = to_homogeneous(view_, s.p);
    s.inside = volume_.contains(s.page);
    s.placed = true;
    return s;
  }

  bool perspective() const { return projection_.perspective(); }

  std::optional<FrontPart> part_in_front(const Sample& a, const Sample& b, double from = 0, double to = 1) const {
    if (!perspective()) return FrontPart{a.seen, b.seen, 0, 1};
    FrontPart part{from == 0 ? a.seen : between(a.seen, b.seen, from), to == 1 ? b.seen : between(a.seen, b.seen, to), from,
                   to};
    const bool a_near = too_near(part.a), b_near = too_near(part.b);
    if (a_near && b_near) return std::nullopt;
    if (a_near || b_near) {
      const double t = (nearest_ - part.a.w) / (part.b.w - part.a.w);
      const PlanePoint cut = between(part.a, part.b, t);
      (a_near ? part.from : part.to) = from + t * (to - from);
      (a_near ? part.a : part.b) = cut;
    }
    return part;
  }

  /// The corners, in order, of the part of a triangle that is in front of the eye; empty if there is none.
  std::vector<PlanePoint> contour_in_front(const std::array<const PlanePoint*, 3>& corners) const {
    std::vector<PlanePoint> contour;
    for (std::size_t i = 0; i < 3; ++i) {
      const PlanePoint &s = *corners[i], &e = *corners[(i + 1) % 3];
      if (!too_near(s)) contour.push_back(s);
      if (too_near(s) != too_near(e)) contour.push_back(between(s, e, (nearest_ - s.w) / (e.w - s.w)));
    }
    return contour;
  }

  /// Calls sink(t0, t1) for the visible parts of the segment inside the window. `seen` holds fractions of the part from
  /// `from` to `to`.
  template <class Sink>
  void emit(const Sample& a, const Sample& b, double from, double to, const std::vector<Span>& seen, Sink sink) const {
    if (seen.empty()) return;
    std::array<double, 2> inside{0, 1};
    if (!a.inside || !b.inside) {
      const auto clipped = clip_segment(a.page, b.page, volume_);
      if (!clipped) return;
      inside = clipped->range;
    }
    const double extent = to - from;
    for (const Span& s : seen) {
      const double t0 = std::max(from + s.from * extent, inside[0]);
      const double t1 = std::min(s.to == 1 ? to : from + s.to * extent, inside[1]);
      if (t0 < t1) sink(t0, t1);
    }
  }

 private:
  bool too_near(const PlanePoint& p) const { return perspective() && p.w < nearest_; }

  /// The point at the fraction t in space.
  static PlanePoint between(const PlanePoint& a, const PlanePoint& b, double t) {
    return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.w + t * (b.w - a.w)};
  }

  const View& view_;
  PlaneProjection projection_;
  ClipVolume volume_;
  double nearest_;
};

}  // namespace ligne::horizon
