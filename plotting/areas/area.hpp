#pragma once
/// Areas of an SVG on the lattice, and what lies on the two sides of a stroke. Private to plotting.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "areas/edge_tree.hpp"
#include "areas/steps.hpp"
#include "areas/winding_rows.hpp"
#include "drawing/drawing.hpp"

namespace ligne::svg {

enum class FillRule { nonzero, even_odd };

/// Boxes and edges that were looked at, by all areas of a drawing together: a small file must not ask for endless work.
using ClipWork = std::shared_ptr<std::size_t>;

/// How often contours wind round the points just beside a stroke, on its plus side and on its minus side.
struct Windings {
  std::int32_t plus = 0, minus = 0;
};

/// A place within a stroke where the windings of an area change.
struct WindingChange {
  Along at;
  std::uint32_t area = 0;  ///< the caller's number
  Windings by{};
};

/// The inside of contours; open ones are closed.
///
/// The edges are whole segments of the lattice; those that lie on each other from end to end are one, with the sum of their
/// windings. Where a stroke is asked for, vertices that lie on its line up to rounding are on neither side of it, so that an
/// edge along the stroke separates its two sides and crosses nothing. Every function throws EndlessWork when the work of all
/// areas becomes endless.
class Area {
 public:
  Area(const Polylines& contours, FillRule rule, ClipWork work);

  /// The windings just behind the stroke's begin; appends the changes within the stroke, in no order. Time: the edges in
  /// whose boxes the stroke and its line backwards may lie, of many edges as far back as to an anchor.
  Windings wind_along(const StepSegment& stroke, std::uint32_t number, std::vector<WindingChange>& changes) const;
  bool is_inside(std::int32_t winding) const { return rule_ == FillRule::nonzero ? winding != 0 : winding % 2 != 0; }
  /// The parts of the closed contours whose edges reach into the box, page mm.
  Polylines contours_near(const Rect& box) const;

  const Rect& box() const { return box_; }  ///< page mm
  const StepBox& step_box() const { return tree_.box(); }
  bool empty() const { return steps_.empty(); }
  /// Whether the lattice edges, their windings and the rule are the same.
  bool is_same(const Area& other) const;
  /// Equal for areas that are the same.
  std::size_t hash() const;

 private:
  struct Edge {
    Point2 a, b;           ///< page mm, in the direction of the contour
    std::int32_t winding;  ///< of contours along the edge of the lattice
  };
  void add_changes(std::size_t i, const StepSegment& stroke, double from, std::uint32_t number, Windings& at_begin,
                   std::vector<WindingChange>& changes) const;
  std::optional<Anchor> anchor_before(const StepSegment& stroke) const;
  void count(std::size_t looked_at) const;

  std::vector<Edge> edges_;         ///< in the order of the contours
  std::vector<StepSegment> steps_;  ///< the same on the lattice, each from its lower end
  EdgeTree tree_;
  mutable std::shared_ptr<const WindingRows> rows_;  ///< made when they are needed first
  Rect box_;
  FillRule rule_;
  ClipWork work_;
};

}  // namespace ligne::svg
