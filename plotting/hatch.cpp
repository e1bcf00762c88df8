/// Hatching, in the frame of the strokes (u along them, v across):
///
/// 1. Rows lie at v = k x spacing, counted from the origin, so that regions side by side share them.
/// 2. A row keeps what lies inside and at least half a pen from every border. What a segment forbids on a row is the part of the row within half a pen of it: a segment's
///    neighbourhood is convex, so that part is one interval. Inside is decided between the forbidden intervals by the crossings of the row (even-odd); no crossing
///    lies in an open one, since a crossing is forbidden.
/// 3. Spans of neighbouring rows are tied into strokes while the way from the end of one to the beginning of the next stays clear of the borders.

#include "plotting/hatch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <glm/geometric.hpp>

namespace ligne {
namespace {

struct Segment {
  Point2 a, b;
};

struct Span {
  double from, to;
};

/// Distance between two segments.
double distance(Point2 p, const Segment& s) {
  const Point2 along = s.b - s.a;
  const double squared = glm::dot(along, along);
  const double t = squared > 0 ? std::clamp(glm::dot(p - s.a, along) / squared, 0.0, 1.0) : 0;
  return glm::distance(p, s.a + along * t);
}

double cross(Point2 u, Point2 v) { return u.x * v.y - u.y * v.x; }

double distance(const Segment& s, const Segment& t) {
  const double a = cross(s.b - s.a, t.a - s.a), b = cross(s.b - s.a, t.b - s.a), c = cross(t.b - t.a, s.a - t.a), d = cross(t.b - t.a, s.b - t.a);
  if (((a > 0 && b < 0) || (a < 0 && b > 0)) && ((c > 0 && d < 0) || (c < 0 && d > 0))) return 0;
  return std::min({distance(s.a, t), distance(s.b, t), distance(t.a, s), distance(t.b, s)});
}

/// The part of the row v that lies nearer than r to the segment; empty (from > to) when none does.
Span forbidden(const Segment& s, double v, double r) {
  Span span{1e300, -1e300};
  const auto add = [&](double u) {
    span.from = std::min(span.from, u);
    span.to = std::max(span.to, u);
  };
  for (const Point2 end : {s.a, s.b}) {
    const double dv = v - end.y;
    if (std::abs(dv) > r) continue;
    const double half = std::sqrt(r * r - dv * dv);
    add(end.x - half);
    add(end.x + half);
  }
  // The two long sides of the segment's neighbourhood.
  const Point2 along = s.b - s.a;
  const double length = glm::length(along);
  if (length == 0) return span;
  const Point2 across = Point2{-along.y, along.x} * (r / length);
  for (const double side : {-1.0, 1.0}) {
    const Point2 p = s.a + across * side, q = s.b + across * side;
    if ((p.y <= v) == (q.y <= v)) continue;
    add(p.x + (q.x - p.x) * (v - p.y) / (q.y - p.y));
  }
  return span;
}

class Hatcher {
 public:
  Hatcher(std::span<const std::vector<Point2>> contours, const HatchOptions& options, double angle_degrees)
      : spacing_(options.spacing_mm), radius_(options.pen_width_mm / 2), origin_(options.origin) {
    const double angle = angle_degrees * std::numbers::pi / 180;
    // Page y points down: counter-clockwise as seen.
    along_ = {std::cos(angle), -std::sin(angle)};
    across_ = {-along_.y, along_.x};
    for (const std::vector<Point2>& contour : contours) {
      for (std::size_t i = 0; i < contour.size(); ++i) {
        const Segment s{to_frame(contour[i]), to_frame(contour[(i + 1) % contour.size()])};
        if (s.a != s.b || contour.size() == 1) segments_.push_back(s);
      }
    }
  }

  void run(Polylines& out);

 private:
  /// A stroke that may go on: its last point, and the row in which that lies.
  struct Open {
    std::vector<Point2> points;
  };

  Point2 to_frame(Point2 p) const { return {glm::dot(p - origin_, along_), glm::dot(p - origin_, across_)}; }
  Point2 to_page(Point2 q) const { return origin_ + along_ * q.x + across_ * q.y; }
  std::vector<Span> row(double v, std::span<const std::uint32_t> near) const;
  bool clear(Point2 a, Point2 b, std::span<const std::uint32_t> near) const;
  void finish(Open& open, Polylines& out) const;

  double spacing_, radius_;
  Point2 origin_, along_, across_;
  std::vector<Segment> segments_;
};

/// Free spans of a row, ascending.
std::vector<Span> Hatcher::row(double v, std::span<const std::uint32_t> near) const {
  std::vector<Span> closed;
  std::vector<double> crossings;
  for (const std::uint32_t i : near) {
    const Segment& s = segments_[i];
    const Span span = forbidden(s, v, radius_);
    if (span.from <= span.to) closed.push_back(span);
    if ((s.a.y <= v) != (s.b.y <= v)) crossings.push_back(s.a.x + (s.b.x - s.a.x) * (v - s.a.y) / (s.b.y - s.a.y));
  }
  std::sort(crossings.begin(), crossings.end());
  std::sort(closed.begin(), closed.end(), [](const Span& l, const Span& r) { return l.from < r.from; });
  std::vector<Span> free;
  double reached = closed.empty() ? 0 : closed[0].to;
  for (const Span& span : closed) {
    if (span.from > reached) {
      const double middle = (reached + span.from) / 2;
      const auto before = std::lower_bound(crossings.begin(), crossings.end(), middle) - crossings.begin();
      if (before % 2 == 1) free.push_back({reached, span.from});
    }
    reached = std::max(reached, span.to);
  }
  return free;
}

/// Whether the pen can go from a to b without touching a border.
bool Hatcher::clear(Point2 a, Point2 b, std::span<const std::uint32_t> near) const {
  // The ends themselves lie exactly half a pen from a border; rounding is far below this share.
  constexpr double kShare = 1 - 1e-9;
  return std::all_of(near.begin(), near.end(), [&](std::uint32_t i) { return distance(Segment{a, b}, segments_[i]) >= radius_ * kShare; });
}

void Hatcher::finish(Open& open, Polylines& out) const {
  if (open.points.empty()) return;
  for (const Point2 p : open.points) out.points.push_back(to_page(p));
  out.begin.push_back(static_cast<std::uint32_t>(out.points.size()));
  open.points.clear();
}

void Hatcher::run(Polylines& out) {
  if (segments_.empty()) return;
  double low = 1e300, high = -1e300;
  for (const Segment& s : segments_) {
    low = std::min({low, s.a.y, s.b.y});
    high = std::max({high, s.a.y, s.b.y});
  }
  const double first = std::ceil((low + radius_) / spacing_), last = std::floor((high - radius_) / spacing_);
  if (!(last >= first)) return;
  if (last - first >= kMostHatchRows) throw std::invalid_argument("a hatch has more than a million rows");

  // Segments by the first row that they can touch, and those that the rows at hand can touch.
  const auto reach_low = [&](std::uint32_t i) { return std::min(segments_[i].a.y, segments_[i].b.y) - radius_ - spacing_; };
  const auto reach_high = [&](std::uint32_t i) { return std::max(segments_[i].a.y, segments_[i].b.y) + radius_ + spacing_; };
  std::vector<std::uint32_t> order(segments_.size()), near;
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::uint32_t l, std::uint32_t r) { return reach_low(l) < reach_low(r); });

  std::vector<Open> open;
  std::size_t next = 0;
  for (double k = first; k <= last; ++k) {
    const double v = k * spacing_;
    std::erase_if(near, [&](std::uint32_t i) { return reach_high(i) < v; });
    for (; next < order.size() && reach_low(order[next]) <= v; ++next) near.push_back(order[next]);
    const bool forward = std::fmod(k, 2) == 0;
    std::vector<Open> now;
    for (Span span : row(v, near)) {
      Point2 from{span.from, v}, to{span.to, v};
      if (!forward) std::swap(from, to);
      Open stroke;
      for (Open& before : open) {
        if (before.points.empty() || !clear(before.points.back(), from, near)) continue;
        stroke.points = std::move(before.points);
        before.points.clear();
        break;
      }
      stroke.points.push_back(from);
      stroke.points.push_back(to);
      now.push_back(std::move(stroke));
    }
    for (Open& before : open) finish(before, out);
    open = std::move(now);
  }
  for (Open& stroke : open) finish(stroke, out);
}

}  // namespace

Polylines hatch(std::span<const std::vector<Point2>> contours, const HatchOptions& options) {
  if (!(options.spacing_mm > 0) || !(options.pen_width_mm > 0)) throw std::invalid_argument("spacing and pen width of a hatch are above zero");
  Polylines out;
  Hatcher(contours, options, options.angle_degrees).run(out);
  if (options.cross) Hatcher(contours, options, options.angle_degrees + 90).run(out);
  return out;
}

}  // namespace ligne
