#pragma once
/// The visible pieces of curves in a scan plane, some of them transparent, by a sweep along x ([Boulle1980] 3.2.1.2).
///
/// [Boulle1980] takes the sweep of [BentleyOttmann1979] for a method of visibility, since it has at each stop the order of
/// all curves by depth, and says that it extends to arcs of circles of one curvature.

#include <cstdint>
#include <span>
#include <vector>

#include "studies/operations/plane_curves.hpp"

namespace ligne::studies {

/// A longest part of a curve in front of which the same number of transparent curves, and no opaque one, passes.
struct VisiblePiece {
  std::uint32_t curve = 0;
  std::uint32_t level = 0;  ///< transparent curves in front
  OneRoot from, to;         ///< range in x
  friend bool operator==(const VisiblePiece&, const VisiblePiece&) = default;
};

struct VisibleWork {
  std::uint64_t stops = 0;        ///< different abscissas at which something begins, ends, or crosses
  std::uint64_t comparisons = 0;  ///< comparisons of two curves in the tree
  std::uint64_t pairs = 0;        ///< neighbours whose next crossing was looked for
};

/// The pieces, by curve and from the left. Curves parallel to the view are seen as points: they hide nothing and have no
/// piece. A curve with a lower number is in front of one that coincides with it. Curves may touch, begin and end on each
/// other, and cross in one point.
///
/// Invariant: behind each stop, the tree holds the runs over the sweep line by depth just behind the stop, where a run is a
/// range of one line or half circle that curves cover, and each curve knows its level or that it is hidden.
/// O((n + k + p) log n) for n curves, k crossings and p pieces.
std::vector<VisiblePiece> visible_by_sweep(std::span<const PlaneCurve> curves, VisibleWork& work);

/// Finds the same pieces by ordering all curves between each two neighbouring stops of all pairs. O((n^2 + k) n log n).
std::vector<VisiblePiece> visible_by_pairs(std::span<const PlaneCurve> curves);

}  // namespace ligne::studies
