#pragma once
/// The strokes that one drawing shows and another does not.

#include <vector>

#include "drawing/overlaps/page_segments.hpp"
#include "drawing/stroke.hpp"

namespace ligne {

/// Lines nearer to each other than this are the same line in two drawings: lines that coincide are merged within a
/// micrometre, and which of two stays may change with what else is there.
inline constexpr double kSameLineMm = 0.002;

/// The parts of visible strokes of `of` along which no visible stroke of `in` runs within the tolerance, which is as long as
/// a part must be to count: page mm. `same_level`: a stroke seen through transparent faces is only found among those seen
/// through as many.
std::vector<paper::Segment> parts_missing(const StrokeModel& of, const StrokeModel& in, double tolerance_mm = kSameLineMm,
                                          bool same_level = false);

/// By what two drawings of one scene differ.
struct StrokeDifference {
  std::vector<paper::Segment> only_first, only_second;
  double length_mm = 0;   ///< of both
  double longest_mm = 0;  ///< the longest part
};

StrokeDifference difference_of(const StrokeModel& first, const StrokeModel& second, double tolerance_mm = kSameLineMm);

}  // namespace ligne
