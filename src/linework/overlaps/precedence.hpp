#pragma once
/// The order of precedence of strokes that lie on each other.

#include <cmath>
#include <tuple>
#include <utility>

#include "linework/overlaps/stroke_overlap.hpp"
#include "linework/stroke.hpp"

namespace ligne {

/// Visible before seen through transparent faces before hidden; then by class. The lowest rank stays.
inline std::size_t rank(const Stroke& s) {
  const std::size_t group = !s.visible ? 2 : s.level > 0 ? 1 : 0;
  return group * kLineClassCount + static_cast<std::size_t>(s.line_class);
}

/// Depth at a fraction of the stroke's length.
inline double depth(const Stroke& s, double fraction) { return (1 - fraction) * s.z_from + fraction * s.z_to; }

/// Depth in tolerances, rounded down, so that depths that are equal but for rounding mostly compare equal.
inline double rounded_depth(double depth, double tolerance_mm) {
  const double rounded = std::floor(depth / tolerance_mm);
  return std::isfinite(rounded) ? rounded : 0;
}

/// The first key by which strokes on one line are sorted: their rank, and their depth at a fraction of their length.
using PrecedenceKey = std::pair<std::size_t, double>;
inline PrecedenceKey precedence_key(const Stroke& s, double fraction, double tolerance_mm) {
  return {rank(s), rounded_depth(depth(s, fraction), tolerance_mm)};
}

/// The order of strokes of one rank and depth.
inline bool goes_before_by_source(const Stroke& a, const Stroke& b) {
  return std::tie(a.source, a.t_from, a.t_to) < std::tie(b.source, b.t_from, b.t_to);
}

/// Whether stroke a stays where it lies on stroke b: by rank, then by depth in the middle of the common interval, then by
/// source.
inline bool precedes(const Stroke& a, const Stroke& b, const StrokeOverlap& common, double tolerance_mm) {
  if (rank(a) != rank(b)) return rank(a) < rank(b);
  const double z_a = depth(a, (common.a_from + common.a_to) / 2), z_b = depth(b, (common.b_from + common.b_to) / 2);
  if (std::abs(z_a - z_b) > tolerance_mm) return z_a < z_b;
  return goes_before_by_source(a, b);
}

}  // namespace ligne
