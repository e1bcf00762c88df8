#pragma once
/// Ellipses on which lines of a drawing are known to lie, such as the circles at which recognised surfaces end.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/point.hpp"
#include "plotting/paths/elliptic_arc.hpp"

namespace ligne {

/// Ellipses, by the squares of the page through which they run.
class KnownEllipses {
 public:
  /// Ellipses outside the page are left out.
  KnownEllipses(std::vector<Ellipse> ellipses, const Rect& page);

  std::size_t size() const { return ellipses_.size(); }
  const Ellipse& operator[](std::size_t i) const { return ellipses_[i]; }
  /// Whether a point lies within `tolerance` of an ellipse.
  bool is_on(std::size_t i, Point2 p, double tolerance) const;
  /// The ellipses that may run within kNearMm of a point.
  std::span<const std::uint32_t> near(Point2 p) const;
  static constexpr double kNearMm = 0.01;

 private:
  template <class Visit>
  void for_boxes(std::size_t i, const Visit& visit) const;
  std::size_t square_of(Point2 p) const;

  Rect page_;
  double squares_per_mm_;
  std::vector<Ellipse> ellipses_;
  std::vector<EllipseFrame> frames_;              ///< of the ellipses
  std::vector<std::uint32_t> begin_, in_square_;  ///< square i: in_square_[begin_[i], begin_[i + 1])
};

}  // namespace ligne
