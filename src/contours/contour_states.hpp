#pragma once
/// The visible and hidden runs of a contour.

#include <vector>

#include "contours/contour_curves.hpp"
#include "linework/stroke.hpp"

namespace ligne {

/// State of a run: the number of transparent faces in front of it, if it is visible, or one of these.
inline constexpr int kHiddenState = -1;
inline constexpr int kOutsideState = -2;  ///< outside the window of the view

/// A part of a curve with one state, between two values of CurvePoint::at.
struct ContourRun {
  double from = 0, to = 0;
  int state = kHiddenState;
};

/// Makes the runs of a chain of `segments` segments from their strokes, sorted by source; segment i has the source
/// `first_source` + i. With `hidden_too` hidden parts have strokes, so parts without a stroke are outside; otherwise
/// parts without a stroke are hidden.
std::vector<ContourRun> runs_of(const std::vector<Stroke>& strokes, std::uint32_t first_source, std::size_t segments,
                                bool hidden_too);

/// Overwrites the states of `runs` within the intervals of `changed`, which must be ascending.
void put_in(std::vector<ContourRun>& runs, const std::vector<ContourRun>& changed);

/// Gives runs shorter than `shortest_mm` on the page the state of their longer neighbour.
void drop_short_runs(std::vector<ContourRun>& runs, const ContourCurve& curve, double shortest_mm);

}  // namespace ligne
