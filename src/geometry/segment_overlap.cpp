#include "geometry/segment_overlap.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace ligne {
namespace {

/// A place on both segments, as fractions of the base and of the other segment.
struct Place {
  double base, other;
};

}  // namespace

std::optional<SegmentOverlap> overlap(LatticePoint a0, LatticePoint a1, LatticePoint b0, LatticePoint b1, double tolerance) {
  const double a_length = length(a0, a1), b_length = length(b0, b1);
  // The base of two equally long segments does not depend on their order.
  const bool swapped = b_length > a_length || (b_length == a_length && std::tie(b0, b1) < std::tie(a0, a1));
  if (swapped) {
    std::swap(a0, b0);
    std::swap(a1, b1);
  }
  const double base_length = std::max(a_length, b_length);
  if (std::min(a_length, b_length) <= tolerance) return std::nullopt;

  // Positions along the base and offsets across it of the other segment's ends.
  const double dx = (double(a1.x) - a0.x) / base_length, dy = (double(a1.y) - a0.y) / base_length;
  const auto along = [&](LatticePoint p) { return (double(p.x) - a0.x) * dx + (double(p.y) - a0.y) * dy; };
  const auto across = [&](LatticePoint p) { return (double(p.y) - a0.y) * dx - (double(p.x) - a0.x) * dy; };
  const double y0 = across(b0), y1 = across(b1);
  if (std::min(y0, y1) > tolerance || std::max(y0, y1) < -tolerance) return std::nullopt;
  const double x0 = along(b0), x1 = along(b1);
  const double from = std::max(0.0, std::min(x0, x1)), to = std::min(base_length, std::max(x0, x1));
  if (to - from <= tolerance) return std::nullopt;

  const auto place = [&](double x) {
    const double other = x == x0 ? 0 : x == x1 ? 1 : std::clamp((x - x0) / (x1 - x0), 0.0, 1.0);
    return Place{x == base_length ? 1 : x / base_length, other};
  };
  Place first = place(from), last = place(to);
  const auto deviation = [&](const Place& p) { return std::abs(y0 + p.other * (y1 - y0)); };
  if (deviation(first) > tolerance || deviation(last) > tolerance) return std::nullopt;
  if (std::min(a_length, b_length) > kLongInTolerances * tolerance) {
    using namespace line_directions;
    if (std::abs(difference(direction(a0, a1), direction(b0, b1))) > kDirectionReach) return std::nullopt;
  }

  if (!swapped) return SegmentOverlap{first.base, last.base, first.other, last.other};
  if (first.other > last.other) std::swap(first, last);
  return SegmentOverlap{first.other, last.other, first.base, last.base};
}

}  // namespace ligne
