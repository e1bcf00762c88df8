#include "geometry/polygons/contour_face.hpp"

#include <cstddef>

namespace ligne {
namespace {

/// Twice the area of the loop about its first corner. Coordinates relative to it have a size below 2^43, so a product has 88
/// bits, and the sum of some thousand million products 120.
Int128 exact_twice_area(const EdgeLoop& loop) {
  if (loop.empty()) return 0;
  const FinePoint origin = loop.front().begin();
  Int128 sum = 0;
  FinePoint last = origin;
  for (const ContourEdge& e : loop) {
    const FinePoint next = e.end();
    sum += Int128{last.x - origin.x} * (next.y - origin.y) - Int128{last.y - origin.y} * (next.x - origin.x);
    last = next;
  }
  return sum;
}

double in_steps(Int128 twice_area) { return std::ldexp(static_cast<double>(twice_area), -2 * kFineBits); }

/// Adds the contribution of edge a-b to the winding about p, along a ray in +x; true if p lies on the edge.
bool count_winding(FinePoint a, FinePoint b, FinePoint p, int& winding) {
  const Int128 turn = Int128{b.x - a.x} * (p.y - a.y) - Int128{b.y - a.y} * (p.x - a.x);
  if (turn == 0 && (a.x < b.x ? a.x <= p.x && p.x <= b.x : b.x <= p.x && p.x <= a.x) &&
      (a.y < b.y ? a.y <= p.y && p.y <= b.y : b.y <= p.y && p.y <= a.y)) {
    return true;
  }
  if (a.y <= p.y && p.y < b.y && turn > 0) ++winding;
  if (b.y <= p.y && p.y < a.y && turn < 0) --winding;
  return false;
}

}  // namespace

ContourFace make_contour_face(std::span<const std::vector<LatticePoint>> contours, std::uint32_t first_source) {
  ContourFace face;
  for (std::size_t c = 0; c < contours.size(); ++c) {
    const std::vector<LatticePoint>& points = contours[c];
    double area = 0;  // only its sign is used; contours that turn equally both ways have no defined side
    EdgeLoop loop;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const LatticePoint a = points[i], b = points[i + 1 == points.size() ? 0 : i + 1];
      area += orientation(points[0], a, b);
      if (!(a == b)) loop.push_back({{a, b}, kSegmentBegin, kSegmentEnd, first_source, false});
      ++first_source;
    }
    if ((area > 0) != (c == 0)) {
      for (std::size_t i = 0, n = loop.size(); i < n / 2; ++i) std::swap(loop[i], loop[n - 1 - i]);
      for (ContourEdge& e : loop) e.reversed = true;
    }
    face.contours.push_back(std::move(loop));
  }
  return face;
}

double twice_area(const EdgeLoop& loop) { return in_steps(exact_twice_area(loop)); }

double twice_area(const ContourFace& face) {
  Int128 sum = 0;
  for (const EdgeLoop& loop : face.contours) sum += exact_twice_area(loop);
  return in_steps(sum);
}

double twice_area(std::span<const ContourFace> faces) {
  Int128 sum = 0;
  for (const ContourFace& face : faces) {
    for (const EdgeLoop& loop : face.contours) sum += exact_twice_area(loop);
  }
  return in_steps(sum);
}

int position_in_face(const ContourFace& face, FinePoint p) {
  int winding = 0;
  for (const EdgeLoop& loop : face.contours) {
    for (const ContourEdge& e : loop) {
      if (count_winding(e.begin(), e.end(), p, winding)) return 0;
    }
  }
  return winding > 0 ? 1 : -1;
}

}  // namespace ligne
