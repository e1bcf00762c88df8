#pragma once
/// The visible parts of one line between two places where it meets other edges.
///
/// Between such places the facets over the two sides of the line are the same all along, so one small scan line across it,
/// in the middle, decides by a span method which of them is in front. What that facet hides of the line is then computed by
/// the exact operation that all methods share (common/hidden_interval.hpp), over the whole line at once: its ends are the
/// same to the last bit wherever and however often the line is studied. Only what the proposed facets leave open is asked of
/// the others. So a span method decides how much is computed, never what comes out.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/no_index.hpp"
#include "visibility/common/open_parts.hpp"
#include "visibility/watkins/exact/sweep_scene.hpp"
#include "visibility/watkins/exact/sweep_status.hpp"
#include "visibility/watkins/scan_effort.hpp"
#include "visibility/watkins/spans/span_method.hpp"

namespace ligne::watkins {

/// The facts known of a line so far.
struct LineState {
  std::vector<std::uint32_t> tested;   ///< facets compared with it
  std::vector<HiddenInterval> hidden;  ///< what they hide of it
  bool near_side = false;              ///< a side of one of them, or of a neighbour in the active list, lies along it

  void clear() {
    tested.clear();
    hidden.clear();
    near_side = false;
  }
};

struct StretchCounts {
  std::uint64_t stretches = 0;    ///< between two meetings with other edges
  std::uint64_t carried = 0;      ///< of them: hidden by what was known
  std::uint64_t in_front = 0;     ///< of them: nothing may be before the line
  std::uint64_t studied = 0;      ///< of them: scan lines studied by the span method
  std::uint64_t facet_tests = 0;  ///< lines against facets
  void operator+=(const StretchCounts& o);
};

class StretchStudy {
 public:
  StretchStudy(const std::vector<ProjectedVertex>& vertices, const std::vector<Facet>& facets,
               std::span<const SweepLine> lines, double coincidence_steps, SpanMethodKind kind, ScanEffort& effort);

  /// The stretch between two page positions in steps, both on the line; `left` and `right` are the facets over its sides.
  void study(std::uint32_t line, LineState& state, Point2 from, Point2 to, const Cover& left, const Cover& right);

  const StretchCounts& counts() const { return counts_; }
  const SpanCounts& span_counts() const { return spans_->counts(); }

 private:
  /// A facet that may hide the stretch.
  struct Candidate {
    std::uint32_t facet;
    bool left, right;  ///< sides that it is over
  };

  /// The facts known of a facet in the current study: its place among the candidates, or kNone, it was tested before.
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
  std::vector<std::uint32_t> proposed_;  ///< indices among the candidates
  std::vector<ScanSegment<double>> segments_;
  std::vector<VisibleSpan> found_;
  StretchCounts counts_;
};

}  // namespace ligne::watkins
