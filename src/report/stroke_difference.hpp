#pragma once
/// Compares the visible strokes of two drawings.

#include <vector>

#include "geometry/page_segments.hpp"
#include "linework/stroke.hpp"

namespace ligne {

/// Lines of two drawings that are closer than this, in page mm, count as the same line. Coincident lines are merged
/// within one micrometre, and which of them stays may depend on other lines.
inline constexpr double kSameLineMm = 0.002;

/// The parts of visible strokes of `of` along which no visible stroke of `in` lies within the tolerance, page mm. Parts
/// shorter than the tolerance are ignored. With `same_level`, only strokes behind equally many transparent faces are
/// compared.
std::vector<paper::Segment> parts_missing(const StrokeModel& of, const StrokeModel& in, double tolerance_mm = kSameLineMm,
                                          bool same_level = false);

/// The differences of two drawings of one scene, page mm.
struct StrokeDifference {
  std::vector<paper::Segment> only_first, only_second;
  double length_mm = 0;   ///< total length of both lists
  double longest_mm = 0;  ///< length of the longest part
};

/// Compares two drawings in both directions.
StrokeDifference difference_of(const StrokeModel& first, const StrokeModel& second, double tolerance_mm = kSameLineMm);

}  // namespace ligne
