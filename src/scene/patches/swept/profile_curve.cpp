#include "scene/patches/swept/profile_curve.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ligne {
namespace {

/// Number of steps of Newton's method towards the foot of a point: it doubles the digits at each.
constexpr int kFootSteps = 4;
/// Largest bend at a pole, by the bend at the next point, at which the curve counts as smooth. Bends of a sphere are equal.
constexpr double kLargestPoleBend = 1.6;
/// Largest curvature at an open end, by that at the next point.
constexpr double kLargestEndCurvature = 2;

/// Angle by which v is turned to the left of u.
double turn(const Point2& u, const Point2& v) { return std::atan2(cross(u, v), glm::dot(u, v)); }

Point2 turned(const Point2& v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x - s * v.y, s * v.x + c * v.y};
}

double square_distance(const Rect& box, const Point2& p) {
  const double x = std::max({box.min.x - p.x, 0.0, p.x - box.max.x}), y = std::max({box.min.y - p.y, 0.0, p.y - box.max.y});
  return x * x + y * y;
}

}  // namespace

ProfileCurve::ProfileCurve(std::vector<Point2> points, bool is_closed, bool is_mirrored)
    : points_(std::move(points)), joints_(points_.size()), is_closed_(is_closed), is_mirrored_(is_mirrored) {
  set_inner_joints();
  if (!is_closed_) {
    const std::size_t last = points_.size() - 1;
    set_end(0, 1, std::min<std::size_t>(2, last));
    set_end(last, last - 1, last < 2 ? 0 : last - 2);
  }
  build_boxes(0, 0, segment_count());
}

void ProfileCurve::set_inner_joints() {
  const std::size_t n = points_.size();
  for (std::size_t i = is_closed_ ? 0 : 1; i < (is_closed_ ? n : n - 1); ++i) {
    const Point2 before = chord(i > 0 ? i - 1 : n - 1), after = chord(i);
    const double l = glm::length(before), m = glm::length(after);
    Joint& joint = joints_[i];
    joint.bend = turn(before, after);
    joint.curvature = 2 * joint.bend / (l + m);
    joint.tangent = turned(before / l, joint.bend * l / (l + m));
  }
}

/// Sets the tangent and the curvature at an open end from those at the next two points.
void ProfileCurve::set_end(std::size_t end, std::size_t next, std::size_t after) {
  const double sign = next > end ? 1 : -1;  // the direction of the curve, seen from the end
  const Point2 way = points_[next] - points_[end];
  const double length = glm::length(way);
  Joint& joint = joints_[end];
  const bool has_next = after != next && after != end;
  const double here = has_next ? joints_[next].curvature : 0;
  if (is_mirrored_ && points_[end].x == 0) {
    // Across the pole the curve goes on with the mirror image of its first segment.
    const double bend = sign * turn(Point2(way.x, -way.y), way);
    if (has_next && bend * here > 0 && std::abs(bend) <= kLargestPoleBend * std::abs(joints_[next].bend)) {
      joint.curvature = bend / length;
      joint.tangent = Point2(sign * (way.x > 0 ? 1 : -1), 0);
      return;
    }
  }
  const bool is_inner = has_next && after != 0 && after != points_.size() - 1;
  double change = 0;
  if (is_inner) change = (here - joints_[after].curvature) * length / glm::length(points_[after] - points_[next]);
  const double most = kLargestEndCurvature * here;
  joint.curvature = std::clamp(here + change, std::min(0.0, most), std::max(0.0, most));
  // Where the curvature changes evenly from k to m along a chord, the tangent deviates from this by k/3 + m/6 of its length.
  joint.tangent = turned(sign * way / length, -sign * (joint.curvature / 3 + here / 6) * length);
}

void ProfileCurve::build_boxes(std::size_t node, std::size_t begin, std::size_t end) {
  if (boxes_.size() <= node) boxes_.resize(node + 1);
  for (std::size_t i = begin; i <= end; ++i) boxes_[node].extend(at(i));
  if (end - begin <= kLeaf) return;
  const std::size_t middle = (begin + end) / 2;
  build_boxes(2 * node + 1, begin, middle);
  build_boxes(2 * node + 2, middle, end);
}

void ProfileCurve::find_nearest(const Point2& p, std::size_t node, std::size_t begin, std::size_t end, Nearest& best) const {
  if (square_distance(boxes_[node], p) >= best.square) return;
  if (end - begin > kLeaf) {
    const std::size_t middle = (begin + end) / 2, left = 2 * node + 1, right = left + 1;
    if (square_distance(boxes_[left], p) <= square_distance(boxes_[right], p)) {
      find_nearest(p, left, begin, middle, best);
      find_nearest(p, right, middle, end, best);
    } else {
      find_nearest(p, right, middle, end, best);
      find_nearest(p, left, begin, middle, best);
    }
    return;
  }
  for (std::size_t i = begin; i < end; ++i) {
    const Point2 way = chord(i), from = p - at(i);
    const Point2 off = from - std::clamp(glm::dot(from, way) / glm::dot(way, way), 0.0, 1.0) * way;
    const double square = glm::dot(off, off);
    if (square < best.square) best = {i, square};
  }
}

ProfileCurve::Foot ProfileCurve::foot(const Point2& p) const {
  Nearest best;
  find_nearest(p, 0, 0, segment_count(), best);
  return foot_on(p, best.segment);
}

/// The foot on the cubic of a segment. Its arms are those of the cubic that stands for an arc of a circle.
ProfileCurve::Foot ProfileCurve::foot_on(const Point2& p, std::size_t segment) const {
  const Joint &from = joint(segment), &to = joint(segment + 1);
  const Point2 way = chord(segment), start = at(segment), end = at(segment + 1);
  const auto straight = [&](const Joint& joint, const Point2& at) {
    const Point2 normal(joint.tangent.y, -joint.tangent.x);
    return Foot{normal, glm::dot(p - at, normal), joint.curvature};
  };
  if (!is_closed_ && segment == 0 && glm::dot(p - start, from.tangent) <= 0) return straight(from, start);
  if (!is_closed_ && segment + 1 == segment_count() && glm::dot(p - end, to.tangent) >= 0) return straight(to, end);
  const double half = (std::abs(turn(from.tangent, way)) + std::abs(turn(way, to.tangent))) / 4;
  const double arm = glm::length(way) / std::pow(std::cos(half), 2);  // three times the length of an arm
  const Point2 a = arm * from.tangent, c = a + arm * to.tangent - 2.0 * way, b = way - a - c;
  double t = std::clamp(glm::dot(p - start, way) / glm::dot(way, way), 0.0, 1.0);
  for (int step = 0; step < kFootSteps; ++step) {
    const Point2 off = start + t * (a + t * (b + t * c)) - p, first = a + t * (2.0 * b + 3 * t * c),
                 second = 2.0 * b + 6 * t * c;
    const double slope = glm::dot(first, first) + glm::dot(off, second);
    if (slope > 0) t = std::clamp(t - glm::dot(off, first) / slope, 0.0, 1.0);
  }
  const Point2 tangent = glm::normalize(a + t * (2.0 * b + 3 * t * c)), normal(tangent.y, -tangent.x);
  const Point2 foot = start + t * (a + t * (b + t * c));
  return {normal, glm::dot(p - foot, normal), from.curvature + t * (to.curvature - from.curvature)};
}

ProfileCurve ProfileCurve::scaled(double factor) const {
  std::vector<Point2> points = points_;
  for (Point2& p : points) p *= factor;
  return {std::move(points), is_closed_, is_mirrored_};
}

}  // namespace ligne
