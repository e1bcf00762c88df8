#pragma once
/// Ellipses on which lines of a drawing are known to lie, such as the circles at which recognised surfaces end.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/elliptic_arc.hpp"
#include "geometry/lattice.hpp"
#include "geometry/search/line_cells.hpp"

namespace ligne {

/// Finds ellipses near points of the page.
class KnownEllipses {
 public:
  /// Ellipses outside the page are never found.
  KnownEllipses(std::vector<Ellipse> ellipses, const Rect& page);

  std::size_t size() const { return ellipses_.size(); }
  const Ellipse& operator[](std::size_t i) const { return ellipses_[i]; }
  /// The ellipses within kNearMm of a point of the page, and some that are farther away, ascending.
  std::vector<std::uint32_t> near(Point2 p) const;
  static constexpr double kNearMm = 0.01;

 private:
  void file(std::uint32_t ellipse, const Rect& page);

  std::vector<Ellipse> ellipses_;
  Lattice lattice_;
  LineCells cells_;     ///< of chords of the ellipses
  double rise_mm_ = 0;  ///< largest distance of an ellipse from its chords
};

}  // namespace ligne
