#pragma once
/// The visible parts of lines by the exact scan, band by band in parallel.

#include <functional>
#include <span>
#include <vector>

#include "base/index_lists.hpp"
#include "drawing/statistics.hpp"
#include "visibility/common/open_parts.hpp"
#include "visibility/watkins/exact/exact_sweep.hpp"

namespace ligne::watkins {

struct ExactOptions {
  SpanMethodKind kind = SpanMethodKind::stack;
  double coincidence_steps = 0;
  bool penetrations = false;             ///< searches for penetrating pairs of facets
  const OccluderGrid* covers = nullptr;  ///< no penetrations are searched behind these
  std::function<void(double)> progress{};
};

struct ExactCounts {
  SweepCounts sweep;
  StretchCounts stretches;
  SpanCounts spans;
  std::uint64_t bands = 0;
  void operator+=(const ExactCounts& o);
};

/// The hidden intervals of every line, merged from the bands. The part of a line in several bands gets bitwise equal
/// intervals from each, so seams leave no trace.
class FoundIntervals {
 public:
  FoundIntervals() = default;
  FoundIntervals(const std::vector<std::vector<Finding>>& findings, std::size_t line_count);

  /// The parts of the line outside its intervals.
  const std::vector<LinePart>& visible_parts(std::size_t line, OpenParts& open) const;

 private:
  ListsOf<HiddenInterval> intervals_;  ///< by line
};

struct ExactResult {
  bool gave_up = false;  ///< see ScanEffort; the result is then empty
  FoundIntervals found;
  std::vector<std::uint8_t> near;               ///< by line: 1 if another line may coincide with it
  std::vector<PenetrationSearch> penetrations;  ///< one per band, if requested
  ExactCounts counts;
};

/// The intersections found by all bands. Moves them out of the result.
std::vector<Intersection> take_intersections(ExactResult& result, const std::vector<ProjectedVertex>& vertices,
                                             const std::vector<Facet>& facets, double least_steps);

ExactResult study_exactly(const std::vector<ProjectedVertex>& vertices, const std::vector<Facet>& facets,
                          std::span<const SweepLine> lines, const ExactOptions& options);

void report(const ExactCounts& counts, Statistics& statistics);

}  // namespace ligne::watkins
