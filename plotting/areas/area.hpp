#pragma once
/// Areas of an SVG on the lattice, and their windings on the two sides of a stroke. Private to plotting.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "areas/steps.hpp"
#include "areas/winding_rows.hpp"
#include "drawing/drawing.hpp"

namespace ligne::svg {

enum class FillRule { nonzero, even_odd };

/// Number of boxes and edges that all areas of a drawing have tested. It is limited, so that a small file cannot ask
/// for endless work.
using ClipWork = std::shared_ptr<std::size_t>;

/// Winding numbers of the points just beside a stroke, on its plus side and on its minus side.
struct Windings {
  std::int32_t plus = 0, minus = 0;
};

/// A place within a stroke where the windings of an area change.
struct WindingChange {
  Along at;
  std::uint32_t area = 0;  ///< the number that the caller of wind_along() gave
  Windings by{};
};

/// The area inside contours. Open contours are closed.
///
/// Edges are segments between lattice points. Edges with the same two ends become one, with the sum of their windings.
/// A vertex that lies on the line of a stroke up to rounding is on neither side of the stroke, so an edge along the
/// stroke separates its two sides and crosses nothing. Every function throws WorkLimitError when all areas together
/// have tested too many edges.
class Area {
 public:
  Area(const Polylines& contours, FillRule rule, ClipWork work);

  /// Returns the windings just after the stroke's begin, and appends the changes within the stroke, unsorted. Time:
  /// proportional to the edges whose boxes the stroke, or its line before the begin, may meet. With many edges the
  /// search goes back only to an anchor.
  Windings wind_along(const StepSegment& stroke, std::uint32_t number, std::vector<WindingChange>& changes) const;
  bool is_inside(std::int32_t winding) const { return rule_ == FillRule::nonzero ? winding != 0 : winding % 2 != 0; }
  /// The parts of the closed contours whose edges have boxes that meet `box`, page mm.
  Polylines contours_near(const Rect& box) const;

  const Rect& box() const { return box_; }  ///< page mm
  bool empty() const { return steps_.empty(); }
  /// Whether the lattice edges, their windings and the rule are the same.
  bool is_same(const Area& other) const;
  /// Hash value, equal for areas that are the same.
  std::size_t hash() const;

 private:
  struct Edge {
    Point2 a, b;           ///< page mm, in the direction of the contour
    std::int32_t winding;  ///< sum over the contours along this lattice edge
  };
  void add_changes(std::size_t i, const StepSegment& stroke, double from, std::uint32_t number, Windings& at_begin,
                   std::vector<WindingChange>& changes) const;
  std::optional<Anchor> anchor_before(const StepSegment& stroke) const;
  void count(std::size_t looked_at) const;

  std::vector<Edge> edges_;         ///< in the order of the contours
  std::vector<StepSegment> steps_;  ///< the lattice segments of edges_, each from its lower end
  EdgeTree tree_;
  mutable std::shared_ptr<const WindingRows> rows_;  ///< made on first use
  Rect box_;
  FillRule rule_;
  ClipWork work_;
};

}  // namespace ligne::svg
