#pragma once
/// The visible parts of one line between two crossings with other edges.
///
/// Between crossings the facets over the two sides of the line do not change. A small scan line across the middle therefore
/// determines, by a span method, which facet is in front. The exact operation of all methods (common/hidden_interval.hpp)
/// then computes the part of the whole line that this facet hides, so its ends are bitwise equal wherever the line is
/// studied. Other facets are tested only for what the proposed facets leave open. The span method thus affects the cost,
/// never the result.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/add_counts.hpp"
#include "base/no_index.hpp"
#include "visibility/common/open_parts.hpp"
#include "visibility/watkins/exact/sweep_scene.hpp"
#include "visibility/watkins/exact/sweep_status.hpp"
#include "visibility/watkins/spans/span_method.hpp"

namespace ligne::watkins {

/// The state of knowledge about a line.
struct LineState {
  std::vector<std::uint32_t> tested;   ///< facets compared with the line
  std::vector<HiddenInterval> hidden;  ///< parts of the line that they hide
  bool near_side = false;              ///< a side of a facet, or a neighbour in the active list, lies along the line

  void clear() {
    tested.clear();
    hidden.clear();
    near_side = false;
  }
};

struct StretchCounts {
  std::uint64_t stretches = 0;    ///< stretches between two crossings
  std::uint64_t carried = 0;      ///< of these, hidden by known intervals
  std::uint64_t in_front = 0;     ///< of these, with no candidate in front of the line
  std::uint64_t studied = 0;      ///< of these, studied on a small scan line by the span method
  std::uint64_t facet_tests = 0;  ///< tests of a line against a facet
  void operator+=(const StretchCounts& o) { add_counts(*this, o); }
};

class StretchStudy {
 public:
  StretchStudy(const std::vector<ProjectedVertex>& vertices, const std::vector<Facet>& facets,
               std::span<const SweepLine> lines, double coincidence_steps, SpanMethodKind kind, ScanEffort& effort);

  /// Studies the stretch between two points of the line, in lattice steps. `left` and `right` are the facets over its sides.
  void study(std::uint32_t line, LineState& state, Point2 from, Point2 to, const Cover& left, const Cover& right);

  const StretchCounts& counts() const { return counts_; }
  const SpanCounts& span_counts() const { return spans_->counts(); }

 private:
  /// A facet that may hide the stretch.
  struct Candidate {
    std::uint32_t facet;
    bool left, right;  ///< sides of the line that it covers
  };

  /// State of a facet in study number `study`: its index among the candidates, or kNone if it was tested earlier.
  struct Mark {
    std::uint32_t study = 0, candidate = kNone;
  };

  void mark_tested(const LineState& state);
  void add_candidates(const PageLine& line, double z_far, const Cover& cover, bool left);
  void propose(const PageLine& line, double t);
  void test(const PageLine& line, std::uint32_t facet, LineState& state);
  double depth(const Facet& facet, double x, double y) const;

  const std::vector<ProjectedVertex>& vertices_;
  const std::vector<Facet>& facets_;
  std::span<const SweepLine> lines_;
  double coincidence_steps_;
  std::unique_ptr<SpanMethod<double>> spans_;
  ScanEffort& effort_;
  std::vector<Candidate> candidates_;
  std::vector<Mark> marks_;  ///< by facet
  std::uint32_t study_ = 0;
  std::vector<std::uint32_t> proposed_;  ///< indices of candidates
  std::vector<ScanSegment<double>> segments_;
  std::vector<VisibleSpan> found_;
  StretchCounts counts_;
};

}  // namespace ligne::watkins
