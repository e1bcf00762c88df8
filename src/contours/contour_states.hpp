#pragma once
/// Where along a contour it is seen.

#include <vector>

#include "contours/contour_curves.hpp"
#include "drawing/stroke.hpp"

namespace ligne {

/// Seen through so many transparent faces, or:
inline constexpr int kHiddenState = -1;
inline constexpr int kOutsideState = -2;  ///< of the window

/// A part of a curve, by CurvePoint::at.
struct ContourRun {
  double from = 0, to = 0;
  int state = kHiddenState;
};

/// The runs of a chain of `segments` from the strokes of its segments, which are numbered from `first_source` on and come in
/// order. `hidden_too`: the strokes say what is hidden; otherwise it is what is not seen.
std::vector<ContourRun> runs_of(const std::vector<Stroke>& strokes, std::uint32_t first_source, std::size_t segments,
                                bool hidden_too);

/// Gives the parts of runs that lie in `changed`, ascending, the state of these.
void put_in(std::vector<ContourRun>& runs, const std::vector<ContourRun>& changed);

/// Takes out runs that are shorter than `shortest_mm` on the page: they get the state of what is beside them.
void drop_short_runs(std::vector<ContourRun>& runs, const ContourCurve& curve, double shortest_mm);

/// Moves the ends of visible runs that are still where they were `found` and lie within `reach_mm` of a cusp there: up to it
/// the contour is seen, and behind it the surface hides it. `cusps`: nodes of the chain, ascending.
void end_runs_at_cusps(std::vector<ContourRun>& runs, const std::vector<ContourRun>& found, const ContourCurve& curve,
                       const std::vector<std::uint32_t>& cusps, double reach_mm);

}  // namespace ligne
