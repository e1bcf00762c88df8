#pragma once
/// Lengths and areas of things on the page, mm and mm^2.

#include "drawing/drawing.hpp"
#include "drawing/result_models.hpp"
#include "support/page_lines.hpp"

namespace ligne::test {

/// Calls visit(from, to) for every segment of the lines.
template <class Visit>
void for_segments(const Polylines& lines, const Visit& visit) {
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (std::size_t k = 1; k < lines[i].size(); ++k) visit(lines[i][k - 1], lines[i][k]);
}

inline double length_of(const Polylines& lines) {
  double sum = 0;
  for_segments(lines, [&](Point2 a, Point2 b) { sum += glm::distance(a, b); });
  return sum;
}

/// With the sign of the contour's turn: holes count as negative.
inline double area_of(const std::vector<Point2>& contour) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < contour.size(); ++i) {
    const Point2 a = contour[i] - contour[0], b = contour[i + 1] - contour[0];
    sum += (a.x * b.y - a.y * b.x) / 2;
  }
  return sum;
}

/// The area of a shape whose first contour is the outer one, whatever their turns.
inline double area_within(const std::vector<std::vector<Point2>>& contours) {
  double sum = 2 * std::abs(area_of(contours.front()));
  for (const auto& contour : contours) sum -= std::abs(area_of(contour));
  return sum;
}

inline double area_of(const Region& region) {
  double sum = 0;
  for (const auto& contour : region.contours) sum += area_of(contour);
  return sum;
}

/// The contours hold the point, by the rule of even and odd over all of them; so does a region or a piece of a face.
inline bool holds(const std::vector<std::vector<Point2>>& contours, Point2 p) {
  bool inside = false;
  for (const auto& contour : contours)
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const Point2 a = contour[i], b = contour[(i + 1) % contour.size()];
      if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
    }
  return inside;
}
template <class Shape>
bool holds(const Shape& shape, Point2 p) {
  return holds(shape.contours, p);
}

/// The distance of a point from the nearest line, which may be a dot.
inline double distance_to_lines(Point2 p, const Polylines& lines) {
  double least = 1e300;
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (std::size_t k = 0; k < lines[i].size(); ++k)
      least = std::min(least, distance_to_segment(p, lines[i][k], lines[i][std::min(k + 1, lines[i].size() - 1)]));
  return least;
}

/// A contour of it passes within the distance of the point.
template <class Shape>
bool is_near_side(const Shape& shape, Point2 p, double distance) {
  for (const auto& contour : shape.contours)
    for (std::size_t i = 0; i < contour.size(); ++i)
      if (distance_to_segment(p, contour[i], contour[(i + 1) % contour.size()]) < distance) return true;
  return false;
}

}  // namespace ligne::test
