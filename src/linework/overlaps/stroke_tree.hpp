#pragma once
/// Finds the segments of the page that may coincide with a given segment, while segments are inserted and erased.

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "linework/overlaps/end_points.hpp"
#include "linework/overlaps/segment_tree.hpp"
#include "linework/overlaps/stroke_overlap.hpp"
#include "linework/stroke.hpp"

namespace ligne {

/// Segments, numbered in the order of insertion. Each tree holds the segments of similar direction; short segments,
/// whose directions are unreliable, have trees of their own. A query visits only segments that may have both ends of a
/// common interval within the tolerance. So it does not visit thousands of segments that cross in one place or run side
/// by side. Segments of very different directions share only a short interval near an end of each; these are found by
/// their ends.
class StrokeTree {
 public:
  /// `tolerance` is the distance within which segments coincide, in lattice steps.
  explicit StrokeTree(double tolerance)
      : tolerance_(tolerance),
        directed_(kDirectedLength * tolerance),
        trees_(make_trees(tolerance)),
        ends_(kAcross * tolerance + kRounding) {}

  /// Inserts the strokes numbered in `of`, in parallel. These can not be erased.
  StrokeTree(const std::vector<Stroke>& strokes, const std::vector<std::uint32_t>& of, double tolerance)
      : StrokeTree(tolerance) {
    std::array<std::vector<std::pair<FrameSegment, std::uint32_t>>, kGroups> segments;
    for (const std::uint32_t i : of) {
      const LatticePoint from = strokes[i].from, to = strokes[i].to;
      const std::uint32_t number = add(from, to);
      const std::size_t group = segments_[number].group;
      segments[group].push_back({{trees_[group].frame(), from, to}, number});
    }
    parallel_tasks(kGroups, [&](std::size_t group) { trees_[group].fill(std::exchange(segments[group], {})); });
  }

  /// Whether queries visit few nodes because most strokes lie side by side, judged by a sample. Strokes that cross each
  /// other everywhere are separated better by their ends.
  static bool suits(const std::vector<Stroke>& strokes, const std::vector<std::uint32_t>& of, double tolerance);

  /// Whether many strokes lie on each other and so form runs, judged by a sample.
  static bool suits_runs(const std::vector<Stroke>& strokes, const std::vector<std::uint32_t>& of, double tolerance);

  /// A segment that is inserted with its order may become part of a run.
  void insert(LatticePoint from, LatticePoint to, const std::optional<StrokeOrder>& order = {}) {
    const std::uint32_t number = add(from, to);
    SegmentTree& tree = trees_[segments_[number].group];
    const bool may_run = length(from, to) >= kLeastInRun * tolerance_;
    segments_[number].place = tree.insert({tree.frame(), from, to}, number, may_run ? order : std::nullopt);
  }

  /// Queries no longer find segment number `segment`. It keeps its number.
  void erase(std::uint32_t segment) {
    Segment& s = segments_[segment];
    if (s.erased) return;
    s.erased = true;
    trees_[s.group].erase(s.place);
  }

  /// Calls found(segment) for every segment that may coincide with from-to, until it returns true. Returns whether it
  /// did.
  template <class Found>
  bool query(LatticePoint from, LatticePoint to, const Found& found) const {
    return query(
        from, to, [](const SegmentRun&, double, double) { return false; }, found);
  }
  /// As above, but first calls takes_run(run, begin, end) for runs within the tolerance of from-to, with the fractions
  /// of from-to at the two ends of the run. Where that returns true, found() is not called for the segments of the run.
  template <class TakesRun, class Found>
  bool query(LatticePoint from, LatticePoint to, const TakesRun& takes_run, const Found& found) const {
    for (std::size_t group = 0; group < kGroups; ++group) {
      const DirectionFrame& frame = trees_[group].frame();
      const FrameSegment line(frame, from, to);
      const auto question = question_of(group, line, from, to);
      if (!question) continue;
      const double u = frame.u(from), extent = frame.u(to) - u;
      const auto takes = [&](const SegmentRun& run) { return takes_run(run, (run.u0 - u) / extent, (run.u1 - u) / extent); };
      if (trees_[group].query(line, *question, takes, found)) return true;
    }
    if (group_of(from, to) >= kShort) return false;
    const auto found_from = [&](std::uint32_t i) {
      const Segment& s = segments_[i];
      return !s.erased && !question_of(s.group, {trees_[s.group].frame(), from, to}, from, to) && found(i);
    };
    const auto found_to = [&](std::uint32_t i) {
      const bool is_known = ends_.is_near(from, segments_[i].from) || ends_.is_near(from, segments_[i].to);
      return !is_known && found_from(i);
    };
    return ends_.for_each_near(from, found_from) || ends_.for_each_near(to, found_to);
  }

 private:
  using Question = SegmentTree::Question;
  /// Trees 0 to 3 hold the quarters of directions, 4 and 5 the short segments nearer to the x axis and to the y axis.
  static constexpr std::size_t kShort = 4, kGroups = 6;
  /// Largest slope of a line, in a frame, that is compared with its segments, whose slopes are at most 1/2. A steeper
  /// line is at an angle of 11 degrees or more to them.
  static constexpr double kSteep = 1;
  /// Reach of the search by ends, in tolerances. Segments at such an angle share less than 10.2 tolerances, and nothing
  /// if they share an end.
  static constexpr double kAcross = kDirectedLength + 2;
  static constexpr double kRounding = 2;  ///< lattice steps
  /// Least length of a segment in a run, in tolerances. The interval that it shares with a stroke along the run is
  /// longer than the tolerance, since the angle between them is at most 30 degrees.
  static constexpr double kLeastInRun = 2;

  struct Segment {
    LatticePoint from, to;
    std::uint32_t place;
    std::uint8_t group;
    bool erased;
  };

  static std::array<SegmentTree, kGroups> make_trees(double tolerance) {
    return {SegmentTree({true, -0.5}, true, tolerance), SegmentTree({true, 0.5}, true, tolerance),
            SegmentTree({false, 0.5}, true, tolerance), SegmentTree({false, -0.5}, true, tolerance),
            SegmentTree({true, 0}, false, tolerance),   SegmentTree({false, 0}, false, tolerance)};
  }
  std::size_t group_of(LatticePoint from, LatticePoint to) const {
    if (length(from, to) < directed_) return kShort + (DirectionFrame::is_flat(from, to) ? 0 : 1);
    return std::min(kShort - 1, static_cast<std::size_t>(stroke_directions::direction(from, to)));
  }
  /// Returns the question for a group, or nothing if its directions are so different that the ends find the segments.
  std::optional<Question> question_of(std::size_t group, const FrameSegment& line, LatticePoint from,
                                      LatticePoint to) const {
    if (group >= kShort) return Question::box;
    if (group_of(from, to) >= kShort) return Question::beside;
    if (std::abs(line.v1 - line.v0) > kSteep * (line.u1 - line.u0)) return std::nullopt;
    return Question::along;
  }
  std::uint32_t add(LatticePoint from, LatticePoint to) {
    const auto number = static_cast<std::uint32_t>(segments_.size());
    const std::size_t group = group_of(from, to);
    segments_.push_back({from, to, 0, static_cast<std::uint8_t>(group), false});
    if (group < kShort) {
      ends_.add(from, number);
      ends_.add(to, number);
    }
    return number;
  }

  double tolerance_, directed_;
  std::array<SegmentTree, kGroups> trees_;
  EndPoints ends_;
  std::vector<Segment> segments_;
};

}  // namespace ligne
