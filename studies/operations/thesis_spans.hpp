#pragma once
/// The span methods of [Boulle1980] 2.3.3 over counting numbers: merge from the head of the visible list, stack with its
/// pseudo-code, box with its three modules. Only the experiments use them: the program's own in visibility/watkins/ are
/// correct where these are not. The stack here is ordered by depth only as far as the sort goes, and neither it nor the
/// merge handles touching faces.

#include <algorithm>
#include <cstdint>
#include <vector>

#include "studies/counting.hpp"
#include "visibility/watkins/spans/span_method.hpp"

namespace ligne::studies {

using Real = Counted<double>;

/// A segment of the scan plane. Its slope is computed once per face and not counted.
struct PlaneSegment {
  Real x0, z0, x1, z1, slope;

  Real z(const Real& x) const { return z0 + slope * (x - x0); }
};

/// The actions of the stack with which [Boulle1980] 2.3.3.2 evaluates it; C1 to C5 are their costs.
struct StackActions {
  std::uint64_t searches = 0;          ///< C1: searches for the next end of a segment
  std::uint64_t shown = 0;             ///< C2: spans shown up to an end that differs from the preceding end
  std::uint64_t depths = 0;            ///< C3: depth tests at left ends
  std::uint64_t pushes = 0, pops = 0;  ///< C4 and C5
  std::uint64_t equal_ends = 0;        ///< ends equal to the preceding end
};

struct SpanRun {
  std::vector<watkins::VisibleSpan> spans;
  Operations operations;
  std::uint64_t boxes = 0;  ///< studied parts of the line (box)
  StackActions actions;     ///< of the stack
};

class ThesisSpans {
 public:
  explicit ThesisSpans(std::vector<watkins::ScanSegment<double>> segments) : source_(std::move(segments)) {}

  /// Merges the segments in the given order.
  SpanRun merge();

  /// Sorts the segments by the full key first.
  SpanRun stack();

  /// `at_ends`: a part is divided at an end of a segment if it contains one, else in the middle. The first part is the line
  /// from 0 to `length`, or from the first end to the last if `length` is 0.
  SpanRun box(bool at_ends, double length = 0);

 private:
  static constexpr std::uint32_t kBackground = 0xffffffffu;

  Real real(double value) { return {value, &run_.operations}; }
  std::vector<PlaneSegment> counted() {
    run_ = {};
    std::vector<PlaneSegment> out;
    for (const auto& s : source_) out.push_back({real(s.x0), real(s.z0), real(s.x1), real(s.z1), real(s.slope())});
    return out;
  }
  bool test(bool answer) {
    ++run_.operations.tests;
    return answer;
  }
  void show(double x0, double x1, std::uint32_t id) {
    if (!(x0 < x1)) return;
    if (!run_.spans.empty() && run_.spans.back().segment == id && run_.spans.back().x1 == x0) {
      run_.spans.back().x1 = x1;
      return;
    }
    run_.spans.push_back({x0, x1, id});
    ++run_.operations.assignments;
  }
  SpanRun take() { return std::move(run_); }

  struct End {
    std::uint32_t segment;
    bool left;
  };
  std::vector<End> sorted_ends() const;

  /// Pops ended segments off the pile and returns the newest one that continues, or kBackground.
  std::uint32_t next_of(std::vector<std::uint32_t>& pile, const std::vector<bool>& ended);
  /// The bounding box of the segments met in a part of the line, their number, and whether they are two that cross.
  struct Box {
    Real x0, x1, z0, z1;
    Real cut;  ///< place where the part may be divided
    bool have_cut = false, crossing = false;
    std::uint32_t count = 0, only = kBackground, other = kBackground;
    std::vector<std::uint32_t> inside;

    void fit(std::uint32_t id, const Real& a, const Real& b, const Real& za, const Real& zb);
  };
  Box analyse(const std::vector<PlaneSegment>& s, const std::vector<std::uint32_t>& list, const Real& from, const Real& to);
  void study_box(const std::vector<PlaneSegment>& s, const std::vector<std::uint32_t>& list, const Real& from,
                 const Real& to, bool at_ends);

  std::vector<watkins::ScanSegment<double>> source_;
  SpanRun run_;
};

/// Total length over which the two show different segments.
double difference_of(const std::vector<watkins::VisibleSpan>& a, const std::vector<watkins::VisibleSpan>& b);

}  // namespace ligne::studies
