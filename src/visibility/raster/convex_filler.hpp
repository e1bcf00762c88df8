#pragma once
/// Filling of convex polygons in integers (Heulin, "Remplissage de polygones"). Every side is walked once, line by
/// line, by one addition to a fixed-point place. The first side that meets a line leaves its place in one table, the
/// second in another; the polygon's run lies between the two.
///
/// Heulin uses 8 binary places and rounds corners to whole pixels; here corners have kPlaces binary places, and places
/// on a side have 32. As in scan_conversion.hpp, a polygon meets the lines with top <= line < bottom and the columns
/// with left <= column < right.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace ligne {

/// A corner in units of 2^-kPlaces of a pixel; whole pixels are the centres of pixels. |u|, |v| < 2^31.
struct FixedCorner {
  static constexpr int kPlaces = 16;
  std::int64_t u = 0, v = 0;

  static FixedCorner at(double u, double v) { return {rounded(u), rounded(v)}; }

 private:
  static std::int64_t rounded(double w) { return static_cast<std::int64_t>(std::floor(w * (1 << kPlaces) + 0.5)); }
};

/// Fills polygons one after the other. It keeps its working memory.
class ConvexFiller {
 public:
  /// Calls row(line, from, to) with the columns [from, to) for each of the lines [first, end) that the polygon meets,
  /// from the top. If the polygon is not convex, a row lies between the first two sides that meet the line.
  template <class Row>
  void fill(std::span<const FixedCorner> corners, std::int64_t first, std::int64_t end, Row row);

 private:
  static constexpr std::int64_t kNone = INT64_MIN;

  struct Places {
    std::int64_t first = kNone, second = kNone;  ///< in units of 2^-32 of a pixel
  };

  /// The least integer not below a place in units of 2^-places.
  static std::int64_t ceiling(std::int64_t w, int places) { return (w + ((std::int64_t{1} << places) - 1)) >> places; }

  void walk(FixedCorner a, FixedCorner b, std::int64_t first, std::int64_t end);

  std::vector<Places> lines_;
};

template <class Row>
void ConvexFiller::fill(std::span<const FixedCorner> corners, std::int64_t first, std::int64_t end, Row row) {
  if (corners.empty()) return;
  std::int64_t low = corners[0].v, high = corners[0].v;
  for (const FixedCorner& c : corners) {
    low = std::min(low, c.v);
    high = std::max(high, c.v);
  }
  first = std::max(first, ceiling(low, FixedCorner::kPlaces));
  end = std::min(end, ceiling(high, FixedCorner::kPlaces));
  if (first >= end) return;
  lines_.assign(static_cast<std::size_t>(end - first), {});
  for (std::size_t i = 0; i < corners.size(); ++i)
    walk(corners[i], corners[i + 1 == corners.size() ? 0 : i + 1], first, end);
  for (std::int64_t line = first; line < end; ++line) {
    const Places& p = lines_[static_cast<std::size_t>(line - first)];
    if (p.second != kNone) row(line, ceiling(std::min(p.first, p.second), 32), ceiling(std::max(p.first, p.second), 32));
  }
}

}  // namespace ligne
