#pragma once
/// The visible parts of lines by the exact scan, band by band in parallel.

#include <functional>
#include <span>
#include <vector>

#include "visibility/common/open_parts.hpp"
#include "visibility/watkins/exact_sweep.hpp"

namespace ligne::watkins {

struct ExactOptions {
  SpanMethodKind kind = SpanMethodKind::stack;
  double coincidence_steps = 0;
  bool penetrations = false;                ///< look for pairs of facets that penetrate
  std::function<void(double)> progress{};
};

struct ExactCounts {
  SweepCounts sweep;
  StretchCounts stretches;
  SpanCounts spans;
  std::uint64_t bands = 0;
  void operator+=(const ExactCounts& o);
};

struct ExactResult {
  /// What facets hide of line i: intervals [first[i], first[i + 1]).
  std::vector<std::uint32_t> first;
  std::vector<HiddenInterval> intervals;
  std::vector<std::uint8_t> near;             ///< by line: another one may lie on it
  std::vector<PenetrationSearch> penetrations; ///< one by band, when asked for
  ExactCounts counts;
};

ExactResult study_exactly(const std::vector<ProjectedVertex>& vertices, const std::vector<Facet>& facets, std::span<const SweepLine> lines,
                          const ExactOptions& options);

/// What is left of a line when its intervals are taken from it.
const std::vector<LinePart>& visible_parts(const ExactResult& result, std::size_t line, OpenParts& open);

}  // namespace ligne::watkins
