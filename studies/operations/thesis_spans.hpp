#pragma once
/// The span methods as [Boulle1980] 2.3.3 has them, over numbers that count: merge from the head of the visible list, stack
/// with its pseudo-code, box with its three modules. For the experiments alone: the program uses those of
/// visibility/watkins/, which are right where these are not. The stack here is ordered by depth only as far as the sort
/// goes, and neither it nor the merge is told of faces that touch.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "studies/counting.hpp"
#include "visibility/watkins/spans/span_method.hpp"

namespace ligne::studies {

using Real = Counted<double>;

/// A segment of the scan plane. Its slope is computed once for the face, and not counted.
struct PlaneSegment {
  Real x0, z0, x1, z1, slope;

  Real z(const Real& x) const { return z0 + slope * (x - x0); }
};

/// The actions of the stack by which [Boulle1980] 2.3.3.2 evaluates it: C1 to C5 are their costs.
struct StackActions {
  std::uint64_t searches = 0;          ///< C1: of the next end of a segment
  std::uint64_t shown = 0;             ///< C2: segments or background, up to an end that is not where the one before was
  std::uint64_t depths = 0;            ///< C3: depth tests at left ends
  std::uint64_t pushes = 0, pops = 0;  ///< C4 and C5
  std::uint64_t equal_ends = 0;        ///< ends where the one before was
};

struct SpanRun {
  std::vector<watkins::VisibleSpan> spans;
  Operations operations;
  std::uint64_t boxes = 0;  ///< parts of the line studied (box)
  StackActions actions;     ///< of the stack
};

class ThesisSpans {
 public:
  explicit ThesisSpans(std::vector<watkins::ScanSegment<double>> segments) : source_(std::move(segments)) {}

  /// In the order in which the segments were given.
  SpanRun merge();

  /// The segments sorted by the full key.
  SpanRun stack();

  /// `at_ends`: parts are divided at an end of a segment where there is one, else in the middle of the part. The first part
  /// is the line from 0 to `length`, or from the first end to the last where that is 0.
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

  /// The newest segment of the pile that goes on, none of them the background; those that ended leave the pile.
  std::uint32_t next_of(std::vector<std::uint32_t>& pile, const std::vector<bool>& ended);
  /// The box round what was met in a part of the line, how much that is, and whether it is two segments that cross.
  struct Box {
    Real x0, x1, z0, z1;
    Real cut;  ///< where the part may be divided
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

/// Length on which the two show different segments.
double difference_of(const std::vector<watkins::VisibleSpan>& a, const std::vector<watkins::VisibleSpan>& b);

}  // namespace ligne::studies
