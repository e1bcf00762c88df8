#pragma once
/// Fits lines and arcs of ellipses to polylines: circles become circles again that tessellation made polygons.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "drawing/drawing.hpp"
#include "geometry/elliptic_arc.hpp"
#include "geometry/lattice.hpp"
#include "geometry/point.hpp"
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

/// Largest distance of the points of a line from the curve written for them, mm. A deviation of a tenth of a pen is
/// visible; this is a fiftieth of a pen of 0.25 mm. Adjustable.
inline constexpr double kCurveToleranceMm = 0.005;

struct CurveLimits {
  double tolerance_mm = kCurveToleranceMm;
  /// Largest rise of a circle with the arc's longer radius over a step of the line, mm. Lines that the shape hides end
  /// on its chords: up to the width of the pen their ink still meets the ink of the arc.
  double most_rise_mm = 0.35;
  bool start_stays = false;              ///< closed lines keep their starting point: the pen arrives there
  const KnownEllipses* known = nullptr;  ///< ellipses on which lines are known to lie; null: none
};

/// One straight line, or one arc of at most a whole turn.
struct PathPiece {
  Point2 to;
  std::optional<EllipticArc> arc{};  ///< its ends lie within the tolerance of those of the piece
};

/// A path of pieces, each from the end of the one before.
struct CurvedPath {
  Point2 start{0, 0};
  std::vector<PathPiece> pieces{};
  bool closed = false;  ///< the last piece ends at the start
};

/// The line as straight pieces and arcs from corner to corner. A closed line begins where that saves pieces, unless
/// `start_stays`. Rules: docs/curves.md. Time O(n log n).
CurvedPath fit_curves(std::span<const Point2> line, const CurveLimits& limits);

/// Whether the lines of the layer may become arcs: letters, hatching and debug lines may not.
bool may_be_curved(const Layer& layer);

}  // namespace ligne
