#include "drawing/text_item.hpp"

#include <glm/geometric.hpp>

#include <cmath>

#include "geometry/degrees.hpp"

namespace ligne {
namespace {

/// Unit vectors of a turned frame on the page: to the right, and upwards. Quarter turns are exact.
std::array<Point2, 2> frame(double rotation_degrees) {
  const auto [s, c] = sine_cosine_degrees(rotation_degrees);
  return {Point2{c, -s}, Point2{-s, -c}};
}

}  // namespace

Point2 base_point(const TextItem& item) {
  const double above = item.up == TextUp::base ? 0 : item.up == TextUp::middle ? 0.5 : 1;
  return item.at - frame(item.rotation_degrees)[1] * (above * item.height_mm);
}

std::array<Point2, 2> TextBox::axes() const { return frame(rotation_degrees); }

std::array<Point2, 4> TextBox::corners() const {
  const auto [u, v] = axes();
  return {center - u * half.x - v * half.y, center + u * half.x - v * half.y, center + u * half.x + v * half.y,
          center - u * half.x + v * half.y};
}

double TextBox::reach(Point2 direction) const {
  const auto [u, v] = axes();
  return half.x * std::abs(glm::dot(u, direction)) + half.y * std::abs(glm::dot(v, direction));
}

TextBox text_box(const TextItem& item, const TextExtent& extent) {
  const auto [u, v] = frame(item.rotation_degrees);
  const double along = item.across == TextAcross::left ? 0.5 : item.across == TextAcross::center ? 0 : -0.5;
  return {.center = base_point(item) + u * (along * extent.width) + v * ((extent.ascent - extent.descent) / 2),
          .half = {extent.width / 2, (extent.ascent + extent.descent) / 2},
          .rotation_degrees = item.rotation_degrees};
}

bool overlap(const TextBox& a, const TextBox& b, double gap_mm) {
  // Two convex polygons are disjoint if a side's normal of one of them separates them.
  const Point2 between = b.center - a.center;
  for (const TextBox* box : {&a, &b}) {
    for (const Point2 n : box->axes()) {
      if (std::abs(glm::dot(between, n)) >= a.reach(n) + b.reach(n) + gap_mm) return false;
    }
  }
  return true;
}

}  // namespace ligne
