#pragma once
/// Events of the sweep: edges tested against the horizons, and edges and triangles that raise them.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "drawing/drawing.hpp"
#include "view/clip.hpp"
#include "view/tolerances.hpp"
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

/// Joins the visible pieces of a curve to polylines, one for each stretch that is visible without a break.
class CurveTracker {
 public:
  /// Adds the visible part from t0 to t1 of the segment a, b in space; it goes to `lines`. Parts must come in order
  /// along the curve.
  void add(const HomogeneousPoint& a, const HomogeneousPoint& b, double t0, double t1, Polylines& lines) {
    if (!(continues_ && t0 == 0 && lines_ == &lines)) {
      end();
      lines_ = &lines;
      points_.push_back(at(a, b, t0));
    }
    points_.push_back(at(a, b, t1));
    continues_ = false;
    reached_end_ = t1 == 1;
  }

  /// Ends a segment: the next parts belong to the following segment.
  void next_segment() {
    continues_ = reached_end_;
    reached_end_ = false;
  }

  /// Ends a segment of which nothing is visible.
  void interrupt() { continues_ = reached_end_ = false; }

  /// Ends the stretch, and puts it into its polylines.
  void end() {
    double length = 0;
    for (std::size_t i = 1; i < points_.size(); ++i)
      length += std::hypot(points_[i].x - points_[i - 1].x, points_[i].y - points_[i - 1].y);
    if (length > kLeastPartMm) {
      lines_->points.insert(lines_->points.end(), points_.begin(), points_.end());
      lines_->begin.push_back(static_cast<std::uint32_t>(lines_->points.size()));
    }
    points_.clear();
  }

  static Point2 at(const HomogeneousPoint& a, const HomogeneousPoint& b, double t) {
    const HomogeneousPoint p = t == 0 ? a : t == 1 ? b : interpolate(a, b, t);
    return {p.x / p.w, p.y / p.w};
  }

 private:
  Polylines* lines_ = nullptr;
  std::vector<Point2> points_;
  bool continues_ = false, reached_end_ = false;
};

/// Greatest horizontal distance between the ends of an upright segment, as a part of the picture's width.
inline constexpr double kUprightPart = 0x1p-42;

/// The horizons against which a segment is tested: it can be visible above everything nearer, below it, or either. A
/// surface that rises in the picture with distance is visible only above its nearer parts.
enum class HorizonSide : std::uint8_t { upper, lower, both };

/// The sides of an upright line that are tested. The line is hidden where all of them are covered; curves that hide
/// have no sides.
enum class LineSides : std::uint8_t { left, right, both, none };

/// The use of the visible parts of an edge; `nothing`: the edge is not tested. An interruption is not an edge; it ends
/// a stretch of a curve.
enum class VisibleUse : std::uint8_t {
  nothing,
  curve,
  underside,
  outline,
  border,
  contour,
  base_contour,
  back_line,
  interruption
};

struct HorizonEdge {
  PlaneSegment line;
  double from = 0, to = 1;                  ///< part of the segment from a to b that the line is
  const Sample *a = nullptr, *b = nullptr;  ///< samples with a place on the page; only for tested edges
  CurveTracker* curve = nullptr;            ///< the curve that the edge belongs to, or null
  std::uint32_t number = 0;                 ///< number of the contour's height, or of the back line
  std::uint16_t first_band = 0, last_band = 0;
  VisibleUse use = VisibleUse::nothing;
  HorizonSide against = HorizonSide::both;
  LineSides sides = LineSides::both;
  bool upper = false, lower = false;  ///< it then raises the upper, the lower horizon
  bool open = true;                   ///< result of find_seen() for an upright line

  bool is_tested() const { return use != VisibleUse::nothing && use != VisibleUse::interruption; }
};

using PlaneTriangle = std::array<PlanePoint, 3>;

/// A part of an edge that is visible in a band.
struct SeenSpan {
  std::uint32_t edge;
  bool below;  ///< below the lower horizon, for edges tested against both
  Span span;
};

/// The edges and triangles of a strip of the grid.
struct EdgeList {
  static constexpr std::uint32_t kTriangle = std::uint32_t{1} << 31;

  std::vector<HorizonEdge> edges;
  std::vector<PlaneTriangle> triangles;
  std::deque<Sample> samples;     ///< ends of edges that are not samples of rows, or copies of samples with a place on
                                  ///< the page
  CurveTracker nearest_row, row;  ///< curves of the part's first row, and of the row behind the strip
  std::vector<std::vector<std::uint32_t>> of_band;  ///< per band: numbers of its edges, and of its triangles plus
                                                    ///< kTriangle
  std::vector<std::vector<SeenSpan>> seen;          ///< per band: visible parts, in the order of the edges
  std::size_t tested = 0;                           ///< number of tested edges of the surface

  void clear() {
    edges.clear();
    triangles.clear();
    samples.clear();
    for (auto& numbers : of_band) numbers.clear();
    for (auto& spans : seen) spans.clear();
    nearest_row = row = CurveTracker();
    tested = 0;
  }
};

}  // namespace ligne::horizon
