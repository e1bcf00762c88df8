#pragma once
/// Polylines written as lines and arcs of ellipses: what a tessellated circle was before it became a mesh.

#include <optional>
#include <span>
#include <vector>

#include "drawing/drawing.hpp"
#include "geometry/point.hpp"
#include "plotting/paths/elliptic_arc.hpp"

namespace ligne {

/// Adjustable: the points of a line may lie so far from the curve that is written for them. A tenth of the width of the
/// thinnest pen is seen; this is a twenty-fifth of that.
inline constexpr double kCurveToleranceMm = 0.005;

struct CurveLimits {
  double tolerance_mm = kCurveToleranceMm;
  /// Most that a circle of the arc's longer radius rises over a step of the line. What the shape hides ends on its chords:
  /// with the width of the pen, its ink still meets that of the arc.
  double most_rise_mm = 0.35;
  bool start_stays = false;  ///< closed lines begin where they did: the pen arrives there
};

/// One straight line, or one arc of less than half a turn.
struct PathPiece {
  Point2 to;
  std::optional<EllipticArc> arc{};
};

/// A path of pieces, each from the end of the one before.
struct CurvedPath {
  Point2 start{0, 0};
  std::vector<PathPiece> pieces{};
  bool closed = false;  ///< the last piece ends at the start
};

/// The line as straight pieces and arcs that begin and end exactly at points of it, corners among them. A closed line begins
/// where it is best for that, or where it did. Sizes and directions of the arcs are whole numbers of kArcDecimals decimals
/// (mm and degrees), so that a file that says them so holds what was checked. Rules: docs/curves.md. Time O(n log n).
CurvedPath fit_curves(std::span<const Point2> line, const CurveLimits& limits);
inline constexpr int kArcDecimals = 4;

/// Whether lines of the layer are those of shapes; letters and strokes of hatching are not.
bool may_be_curved(const Layer& layer);

}  // namespace ligne
