#pragma once
/// The visible parts of lines by the exact scan, band by band in parallel.

#include <functional>
#include <span>
#include <vector>

#include "visibility/common/open_parts.hpp"
#include "visibility/watkins/exact/exact_sweep.hpp"

namespace ligne::watkins {

struct ExactOptions {
  SpanMethodKind kind = SpanMethodKind::stack;
  double coincidence_steps = 0;
  bool penetrations = false;             ///< look for pairs of facets that penetrate
  const OccluderGrid* covers = nullptr;  ///< of what lies behind them, no penetrations
  std::function<void(double)> progress{};
};

struct ExactCounts {
  SweepCounts sweep;
  StretchCounts stretches;
  SpanCounts spans;
  std::uint64_t bands = 0;
  void operator+=(const ExactCounts& o);
};

/// The hidden intervals of every line, from the findings of several bands. A line that runs through several bands has those
/// of all; what bands have in common is the same interval to the last bit, so a seam leaves no trace.
class FoundIntervals {
 public:
  FoundIntervals() = default;
  FoundIntervals(const std::vector<std::vector<Finding>>& findings, std::size_t line_count);

  /// The parts of the line outside its intervals.
  const std::vector<LinePart>& visible_parts(std::size_t line, OpenParts& open) const;

 private:
  std::vector<std::uint32_t> first_;  ///< intervals [first_[i], first_[i + 1]) are of line i
  std::vector<HiddenInterval> intervals_;
};

struct ExactResult {
  bool gave_up = false;  ///< see ScanEffort; then nothing is found
  FoundIntervals found;
  std::vector<std::uint8_t> near;               ///< by line: another one may lie on it
  std::vector<PenetrationSearch> penetrations;  ///< one by band, when asked for
  ExactCounts counts;
};

/// The intersections that all bands have found together. Takes them out of the result.
std::vector<Intersection> take_intersections(ExactResult& result, const std::vector<ProjectedVertex>& vertices,
                                             const std::vector<Facet>& facets, double least_steps);

ExactResult study_exactly(const std::vector<ProjectedVertex>& vertices, const std::vector<Facet>& facets,
                          std::span<const SweepLine> lines, const ExactOptions& options);

}  // namespace ligne::watkins
