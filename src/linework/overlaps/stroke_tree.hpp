#pragma once
/// Finds, among segments of the page that come and go, those that may coincide with a given one.

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

/// Segments numbered as they come in: those of about one direction in one tree, short ones, whose directions say little, in
/// another. A segment is held only against those of which both ends of a common interval may be within the tolerance, so
/// neither thousands that cross in one place nor thousands side by side are looked at one by one. Segments of very different
/// directions have but a short interval in common, between an end of each; they are found by their ends.
class StrokeTree {
 public:
  /// The distance within which segments count as one, in lattice steps.
  explicit StrokeTree(double tolerance)
      : tolerance_(tolerance),
        directed_(kDirectedLength * tolerance),
        trees_(make_trees(tolerance)),
        ends_(kAcross * tolerance + kRounding) {}

  /// With the strokes numbered in `of`, which are not to be erased; in parallel.
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

  /// Whether a query looks at few of the strokes: most lie side by side. A sample tells. Those that cross each other
  /// everywhere are better told apart by their ends.
  static bool suits(const std::vector<Stroke>& strokes, const std::vector<std::uint32_t>& of, double tolerance);

  /// Whether many of the strokes lie on each other, so that they make runs. A sample tells.
  static bool suits_runs(const std::vector<Stroke>& strokes, const std::vector<std::uint32_t>& of, double tolerance);

  /// Segments that come in with their order may become parts of runs.
  void insert(LatticePoint from, LatticePoint to, const std::optional<StrokeOrder>& order = {}) {
    const std::uint32_t number = add(from, to);
    SegmentTree& tree = trees_[segments_[number].group];
    const bool may_run = length(from, to) >= kLeastInRun * tolerance_;
    segments_[number].place = tree.insert({tree.frame(), from, to}, number, may_run ? order : std::nullopt);
  }

  /// Segment number `segment` is no longer to be found; it keeps its number.
  void erase(std::uint32_t segment) {
    Segment& s = segments_[segment];
    if (s.erased) return;
    s.erased = true;
    trees_[s.group].erase(s.place);
  }

  /// Calls found(segment) for every inserted segment that may coincide with from-to, until it returns true; true when it
  /// did.
  template <class Found>
  bool query(LatticePoint from, LatticePoint to, const Found& found) const {
    return query(
        from, to, [](const SegmentRun&, double, double) { return false; }, found);
  }
  /// As above, but runs within the tolerance of from-to are handed to takes_run(run, begin, end) first, with the fractions
  /// of from-to at the two ends of the run; where that returns true their segments are not told one by one.
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
  /// Behind the groups of the four quarters of directions: short ones nearer to the x axis, and to the y axis.
  static constexpr std::size_t kShort = 4, kGroups = 6;
  /// In a frame, where the segments have slopes of at most a half. A steeper line is at an angle of 11 degrees or more to
  /// them.
  static constexpr double kSteep = 1;
  /// Segments at such an angle share less than 10.2 tolerances; those that share an end share nothing.
  static constexpr double kAcross = kDirectedLength + 2;
  static constexpr double kRounding = 2;  ///< steps
  /// Tolerances. What such a segment has in common with a stroke along a run is longer than the tolerance, since it is at an
  /// angle of at most 30 degrees to it.
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
  /// The question for a group; nothing when its directions are so different that the ends tell.
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
