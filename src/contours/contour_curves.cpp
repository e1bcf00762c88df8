#include "contours/contour_curves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include <glm/geometric.hpp>

#include "base/no_index.hpp"
#include "contours/contour_sights.hpp"
#include "geometry/nearest_on_segment.hpp"

namespace ligne {
namespace {

/// Least absolute cosine between a chord and the tangent at one of its ends (40 degrees). At a larger angle, as near a
/// cusp, the curve takes the direction of the chord.
constexpr double kLeastTangentCosine = 0.766;
/// Largest number of straight pieces between two nodes of a curve.
constexpr int kMostPieces = 16;

struct Place {
  Point2 mm;
  double depth, weight;
};

Place place_of(const View& view, const Point3& p) {
  const HomogeneousPoint h = to_homogeneous(view, p);
  return {{h.x / h.w, h.y / h.w}, h.z / h.w, h.w};
}

/// The tangent, directed like the chord; the chord itself if the angle between them is too large (kLeastTangentCosine).
Point2 direction(Point2 chord, Point2 tangent) {
  const double cosine = glm::dot(chord, tangent);
  if (std::abs(cosine) < kLeastTangentCosine) return chord;
  return cosine < 0 ? -tangent : tangent;
}

/// Upper bound of the distance between the cubic and its chord of length 1: t (1 - t)^2 is at most 4/27.
double rise(Point2 turn0, Point2 turn1) { return (glm::length(turn0) + glm::length(turn1)) * (4.0 / 27); }

CurvePoint between(const CurvePoint& a, const CurvePoint& b, double t) {
  return {a.at + t * (b.at - a.at), a.mm + t * (b.mm - a.mm), a.depth + t * (b.depth - a.depth),
          a.weight + t * (b.weight - a.weight), a.length + t * (b.length - a.length)};
}

template <class Key>
CurvePoint find_point(const std::vector<CurvePoint>& points, double value, Key key) {
  const auto after =
      std::lower_bound(points.begin(), points.end(), value, [&](const CurvePoint& p, double v) { return key(p) < v; });
  if (after == points.begin()) return points.front();
  if (after == points.end()) return points.back();
  const double from = key(after[-1]), to = key(*after);
  return between(after[-1], *after, to > from ? (value - from) / (to - from) : 1);
}

}  // namespace

CurvePoint ContourCurve::point_at(double at) const {
  return find_point(points, at, [](const CurvePoint& p) { return p.at; });
}

CurvePoint ContourCurve::point_at_length(double value) const {
  return find_point(points, value, [](const CurvePoint& p) { return p.length; });
}

std::vector<CurvePoint> ContourCurve::part(double from, double to) const {
  std::vector<CurvePoint> line{point_at(from)};
  auto p = std::upper_bound(points.begin(), points.end(), from, [](double at, const CurvePoint& q) { return at < q.at; });
  for (; p != points.end() && p->at < to; ++p) line.push_back(*p);
  line.push_back(point_at(to));
  return line;
}

void unfold(std::vector<CurvePoint>& line, double longest_mm) {
  std::size_t kept = 0;
  for (const CurvePoint& p : line) {
    const auto turns_back = [&] {
      const CurvePoint &a = line[kept - 2], &b = line[kept - 1];
      const double shorter = std::min(p.length - b.length, b.length - a.length);
      return shorter < longest_mm && glm::dot(b.mm - a.mm, p.mm - b.mm) < 0;
    };
    while (kept > 1 && turns_back()) --kept;
    line[kept++] = p;
  }
  line.resize(kept);
}

namespace {

/// Number of pieces of a Bezier curve that each deviate from a straight line on the page by at most `flatness_mm`.
int pieces_of(const View& view, const ContourCubic& cubic, double flatness_mm) {
  std::array<Point2, 4> p;
  for (std::size_t i = 0; i < 4; ++i) p[i] = place_of(view, cubic.controls[i]).mm;
  const double bend = 6 * std::max(glm::length(p[0] - 2.0 * p[1] + p[2]), glm::length(p[1] - 2.0 * p[2] + p[3]));
  return std::clamp(static_cast<int>(std::ceil(std::sqrt(bend / (8 * flatness_mm)))), 1, kMostPieces);
}

/// Upper bound of the distance on the page between a Bezier curve and the chord of its ends.
double rise_of(const View& view, const ContourCubic& cubic) {
  std::array<Point2, 4> p;
  for (std::size_t i = 0; i < 4; ++i) p[i] = place_of(view, cubic.controls[i]).mm;
  const auto away = [&](Point2 control) {
    return glm::length(p[0] + nearest_on_segment(control, p[0], p[3]) * (p[3] - p[0]) - control);
  };
  return 0.75 * std::max(away(p[1]), away(p[2]));
}

/// The places that a curve passes, and its tangents there: unit vectors, or zero if unknown.
struct Waypoints {
  const std::vector<Place>& places;
  const std::vector<Point2>& tangents;
  bool closed;  ///< the last place is the first
};

/// Makes the curve through the places, as segments that deviate from it by at most `flatness_mm`. `cubic_of(i)`: the
/// curve in space from place i to the next, if it is known. `most_of(i)`: largest distance on the page that this part
/// of the curve may have from its chord, mm.
template <class CubicOf, class MostOf>
ContourCurve curve_through(const View& view, const Waypoints& along, double flatness_mm, CubicOf cubic_of, MostOf most_of) {
  const auto& [places, tangents, closed] = along;
  ContourCurve curve;
  curve.closed = closed;
  const auto add = [&](double at, Point2 mm, double depth, double weight) {
    const double length = curve.points.empty() ? 0 : curve.points.back().length + glm::length(mm - curve.points.back().mm);
    curve.points.push_back({at, mm, depth, weight, length});
  };
  add(0, places[0].mm, places[0].depth, places[0].weight);
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const Place &a = places[i], &b = places[i + 1];
    const std::optional<ContourCubic> cubic = cubic_of(i);
    if (cubic && rise_of(view, *cubic) <= most_of(i)) {
      const int pieces = pieces_of(view, *cubic, flatness_mm);
      for (int k = 1; k <= pieces; ++k) {
        const double t = double(k) / pieces;
        const Place place = k == pieces ? b : place_of(view, cubic->point(t));
        add(double(i) + t, place.mm, place.depth, place.weight);
      }
      continue;
    }
    const Point2 d = b.mm - a.mm;
    const double length = glm::length(d);
    int pieces = 1;
    Point2 turn0{0, 0}, turn1{0, 0};  // end directions minus the direction of the chord
    if (length > 0) {
      const Point2 chord = d / length;
      turn0 = direction(chord, tangents[i]) - chord;
      turn1 = direction(chord, tangents[i + 1]) - chord;
      const double high = length * rise(turn0, turn1), most = most_of(i);
      if (high > most) turn0 *= most / high, turn1 *= most / high;
      const double pieces_squared = length * rise(turn0, turn1) / flatness_mm;
      pieces = std::clamp(static_cast<int>(std::ceil(std::sqrt(pieces_squared))), 1, kMostPieces);
    }
    for (int k = 1; k <= pieces; ++k) {
      const double t = double(k) / pieces;
      const Point2 off = (1 - t) * t * length * ((1 - t) * turn0 - t * turn1);
      const Point2 mm = k == pieces ? b.mm : a.mm + t * d + off;
      add(double(i) + t, mm, a.depth + t * (b.depth - a.depth), a.weight + t * (b.weight - a.weight));
    }
  }
  return curve;
}

}  // namespace

ContourCurve contour_curve(const Scene& scene, const View& view, const ContourChain& chain, double flatness_mm) {
  const std::size_t n = chain.nodes.size();
  std::vector<Place> places(n);
  std::vector<Point2> tangents(n, {0, 0});
  for (std::size_t i = 0; i < n; ++i) {
    const ContourNode& node = chain.nodes[i];
    const bool at_border = node.meets != kNone;
    places[i] = place_of(view, at_border ? scene.vertices[node.meets] : node.on_surface);
    if (at_border) continue;
    const Point2 d = page_direction(view, node.on_surface, node.normal);
    const double size = glm::length(d);
    if (size > 0) tangents[i] = Point2{-d.y, d.x} / size;
  }
  return curve_through(
      view, {places, tangents, chain.closed}, flatness_mm,
      [&](std::size_t i) -> std::optional<ContourCubic> {
        const ContourNode &a = chain.nodes[i], &b = chain.nodes[i + 1];
        if (a.meets != kNone || b.meets != kNone) return std::nullopt;
        return ContourCubic::between(a, b);
      },
      [&](std::size_t i) { return chain.nodes[i].bulge_mm; });
}

ContourCurve smooth_curve(const View& view, const std::vector<Point3>& points, bool closed, double flatness_mm) {
  const std::size_t n = points.size();
  std::vector<Place> places(n);
  for (std::size_t i = 0; i < n; ++i) places[i] = place_of(view, points[i]);
  std::vector<Point2> tangents(n, {0, 0});
  for (std::size_t i = 0; i < n; ++i) {
    const bool at_end = i == 0 || i + 1 == n;
    if (at_end && !closed) continue;
    const Point2 d = places[at_end ? 1 : i + 1].mm - places[at_end ? n - 2 : i - 1].mm;
    const double size = glm::length(d);
    if (size > 0) tangents[i] = d / size;
  }
  return curve_through(
      view, {places, tangents, closed}, flatness_mm, [](std::size_t) { return std::optional<ContourCubic>(); },
      [](std::size_t) { return std::numeric_limits<double>::infinity(); });
}

}  // namespace ligne
