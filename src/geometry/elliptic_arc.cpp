#include "geometry/elliptic_arc.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace ligne {
namespace {

/// Most steps of Newton's method. It starts on a side where it is monotone, and stops when rounding ends its progress.
constexpr int kMostSteps = 100;

/// Largest determinant of a covariance, relative to the square of its trace, that counts as a straight line.
constexpr double kStraight = 1e-14;

Point2 direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// Rotations that take the x axis to `axis`, and back.
Point2 turned(Point2 p, Point2 axis) { return {axis.x * p.x - axis.y * p.y, axis.y * p.x + axis.x * p.y}; }
Point2 turned_back(Point2 p, Point2 axis) { return {axis.x * p.x + axis.y * p.y, axis.x * p.y - axis.y * p.x}; }

/// Mean and covariance of points.
struct Spread {
  Point2 mean{0, 0};
  double xx = 0, xy = 0, yy = 0;

  explicit Spread(std::span<const Point2> points) {
    const auto n = static_cast<double>(points.size());
    for (const Point2 p : points) mean += p;
    mean /= n;
    for (const Point2 p : points) {
      const Point2 d = p - mean;
      xx += d.x * d.x / n;
      xy += d.x * d.y / n;
      yy += d.y * d.y / n;
    }
  }
  double determinant() const { return xx * yy - xy * xy; }
  bool is_straight() const { return !(determinant() > kStraight * (xx + yy) * (xx + yy)); }
};

/// The largest root of x^3 - trace x^2 + minors x - determinant, whose roots are all real. Newton's method descends to
/// it from above.
double largest_root(double trace, double minors, double determinant) {
  double x = 1 + std::max({std::abs(trace), std::abs(minors), std::abs(determinant)});
  for (int i = 0; i < kMostSteps; ++i) {
    const double slope = (3 * x - 2 * trace) * x + minors;
    const double next = x - (((x - trace) * x + minors) * x - determinant) / slope;
    if (!(next < x)) break;
    x = next;
  }
  return x;
}

/// The vector that the matrix, of rank two, takes to zero.
Point3 null_vector(const glm::dmat3& matrix) {
  const glm::dmat3 rows = glm::transpose(matrix);
  Point3 best{0, 0, 0};
  for (int i = 0; i < 3; ++i) {
    const Point3 normal = glm::cross(rows[i], rows[(i + 1) % 3]);
    if (glm::dot(normal, normal) > glm::dot(best, best)) best = normal;
  }
  return best;
}

/// The ellipse (p - centre)^T q (p - centre) = 1; false if this is not an ellipse.
bool ellipse_of(Point2 centre, const glm::dmat2& q, Ellipse& ellipse) {
  const double a = q[0][0], b = q[0][1], c = q[1][1];
  const double mean = (a + c) / 2, apart = std::hypot((a - c) / 2, b);
  const double least = (a * c - b * b) / (mean + apart);
  if (!(least > 0) || !std::isfinite(mean + apart)) return false;
  ellipse = {centre, {1 / std::sqrt(least), 1 / std::sqrt(mean + apart)}, std::atan2(-2 * b, c - a) / 2};
  return std::isfinite(ellipse.radii.x) && std::isfinite(ellipse.radii.y);
}

}  // namespace

Point2 point_at(const Ellipse& ellipse, double t) { return EllipseFrame(ellipse).point_at(t); }

EllipseFrame::EllipseFrame(const Ellipse& ellipse) : ellipse_(ellipse), axis_(direction(ellipse.rotation)) {}

Point2 EllipseFrame::to_unit(Point2 p) const { return turned_back(p - ellipse_.centre, axis_) / ellipse_.radii; }

Point2 EllipseFrame::point_at(double t) const {
  return ellipse_.centre + turned({ellipse_.radii.x * std::cos(t), ellipse_.radii.y * std::sin(t)}, axis_);
}

Point2 EllipseFrame::tangent_at(double t) const {
  return turned({-ellipse_.radii.x * std::sin(t), ellipse_.radii.y * std::cos(t)}, axis_);
}

double EllipseFrame::distance(Point2 unit) const {
  const double r = glm::length(unit);
  return std::abs(r - 1) / (glm::length(unit / ellipse_.radii) / r);
}

double angle_of(Point2 unit) { return std::atan2(unit.y, unit.x); }

double EllipseFrame::nearest_angle(Point2 p) const {
  const double t = angle_of(to_unit(p));
  const Point2 tangent = tangent_at(t);
  return t + glm::dot(p - point_at(t), tangent) / glm::dot(tangent, tangent);
}

bool fit_circle(std::span<const Point2> points, Ellipse& circle) {
  const Spread spread(points);
  if (spread.is_straight()) return false;
  const auto& [mean, xx, xy, yy] = spread;
  Point2 pz{0, 0};  // mean products of the coordinates from the mean and of their squared distance
  for (const Point2 p : points) {
    const Point2 q = p - mean;
    pz += q * glm::dot(q, q) / static_cast<double>(points.size());
  }
  const Point2 centre = Point2{yy * pz.x - xy * pz.y, xx * pz.y - xy * pz.x} / (2 * spread.determinant());
  const double radius = std::sqrt(glm::dot(centre, centre) + xx + yy);
  circle = {mean + centre, {radius, radius}, 0};
  return std::isfinite(radius);
}

bool fit_ellipse(std::span<const Point2> points, Ellipse& ellipse) {
  const Spread spread(points);
  if (spread.is_straight()) return false;
  const Point2 mean = spread.mean;
  const auto n = static_cast<double>(points.size());
  // p = mean + lower q, where the covariance of q is the unit matrix.
  const double l00 = std::sqrt(spread.xx), l10 = spread.xy / l00, l11 = std::sqrt(spread.yy - l10 * l10);
  const auto white = [&](Point2 p) {
    const double x = (p.x - mean.x) / l00;
    return Point2{x, (p.y - mean.y - l10 * x) / l11};
  };

  // Removes from the squares what is a linear function of the coordinates. The outer products of (x, y, 1) add up to n
  // times the unit matrix here, so the regression of [HalirFlusser1998] (their T) is three means.
  glm::dmat3 linear{0};
  const auto squares = [](Point2 q) { return Point3{q.x * q.x, q.x * q.y, q.y * q.y}; };
  for (const Point2 p : points) {
    const Point2 q = white(p);
    const Point3 s = squares(q) / n;
    linear[0] += s * q.x;
    linear[1] += s * q.y;
    linear[2] += s;
  }
  glm::dmat3 m{0};
  for (const Point2 p : points) {
    const Point2 q = white(p);
    const Point3 rest = squares(q) - linear * Point3{q.x, q.y, 1};
    m += glm::outerProduct(rest, rest) / n;
  }

  // M a = lambda C a with the constraint a^T C a = 4ac - b^2. C has one positive eigenvalue, so exactly one lambda is
  // positive, and it gives the ellipse.
  glm::dmat3 reduced{0};
  for (int column = 0; column < 3; ++column) reduced[column] = {m[column][2] / 2, -m[column][1], m[column][0] / 2};
  const glm::dmat3& r = reduced;
  const double minors =
      r[0][0] * r[1][1] - r[1][0] * r[0][1] + r[0][0] * r[2][2] - r[2][0] * r[0][2] + r[1][1] * r[2][2] - r[2][1] * r[1][2];
  const double lambda = largest_root(r[0][0] + r[1][1] + r[2][2], minors, glm::determinant(r));
  const Point3 a = null_vector(reduced - glm::dmat3{lambda});
  const glm::dmat2 q{a.x, a.y / 2, a.y / 2, a.z};
  if (!(glm::determinant(q) > 0)) return false;
  const Point3 rest = -(glm::transpose(linear) * a);
  const Point2 centre = -0.5 * (glm::inverse(q) * Point2{rest.x, rest.y});
  const double constant = -(rest.z + 0.5 * (rest.x * centre.x + rest.y * centre.y));
  const glm::dmat2 inverse{1 / l00, -l10 / (l00 * l11), 0, 1 / l11};
  return ellipse_of(mean + Point2{l00 * centre.x, l10 * centre.x + l11 * centre.y},
                    glm::transpose(inverse) * (q / constant) * inverse, ellipse);
}

std::vector<Point2> bezier_points(const EllipticArc& arc, double tolerance) {
  // One curve for a quarter of the unit circle has an error of 2.7e-4, which grows with the sixth power of the angle.
  constexpr double kQuarterError = 2.8e-4;
  const double quarters = std::abs(arc.sweep) / (std::numbers::pi / 2);
  const double wanted = quarters * std::pow(kQuarterError * arc.ellipse.radii.x / tolerance, 1.0 / 6);
  const int count = std::max({1, static_cast<int>(std::ceil(wanted)), static_cast<int>(std::ceil(quarters))});
  const double step = arc.sweep / count, handle = 4.0 / 3 * std::tan(step / 4);
  const EllipseFrame frame(arc.ellipse);
  std::vector<Point2> points;
  points.reserve(3 * static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const double t0 = arc.from + i * step, t1 = arc.from + (i + 1) * step;
    const Point2 end = frame.point_at(t1);
    points.push_back(frame.point_at(t0) + handle * frame.tangent_at(t0));
    points.push_back(end - handle * frame.tangent_at(t1));
    points.push_back(end);
  }
  return points;
}

}  // namespace ligne
