#pragma once
/// A tree over segments of similar direction, or over short ones. Each segment is in exactly one leaf.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/no_index.hpp"
#include "linework/overlaps/segment_run.hpp"
#include "linework/overlaps/stroke_directions.hpp"

namespace ligne {

/// A segment in the coordinates of a frame, u0 <= u1.
struct FrameSegment {
  double u0, v0, u1, v1;
  double slope;  ///< 0 for a vertical segment

  FrameSegment(const DirectionFrame& frame, LatticePoint from, LatticePoint to);
  double v_at(double u) const { return v0 + (u - u0) * slope; }
};

/// Least length of a segment that is filed by direction, in tolerances.
inline constexpr double kDirectedLength = 12;

/// A range of numbers; empty at first.
struct NumberRange {
  double low = std::numeric_limits<double>::infinity(), high = -low;

  void add(double value) { low = std::min(low, value), high = std::max(high, value); }
  double extent() const { return high - low; }
  double farthest(double value) const { return std::max(std::abs(low - value), std::abs(high - value)); }
};

/// A segment is four numbers: u of its two ends, its slope, and its v in the middle. The tree divides by slope, by v
/// across the mean slope of a node, or by u. It takes the quantity that separates the segments most, measured in steps
/// of the page. So the slope separates segments that cross each other everywhere, and the offset separates parallel
/// ones. Memory is linear.
///
/// Invariants: a node's bounds contain all segments below it (they shrink only when the node is rebuilt), and `count`
/// is the number of segments below. A node is rebuilt when one child has become too large and the node has grown by
/// half since it was built. A node whose segments form one run, and were inserted with their order, stores this run.
class SegmentTree {
 public:
  /// Relations between the line of a query and the segments of the tree.
  enum class Question : std::uint8_t {
    along,   ///< the common interval has both ends within the tolerance of line and segment
    beside,  ///< the line is short, and the segment passes near it
    box,     ///< the segments of the tree are short, and any part of one is near the line
  };

  /// `is_directed`: the segments have slopes of at most 1/2. Otherwise they are short.
  SegmentTree(const DirectionFrame& frame, bool is_directed, double tolerance)
      : frame_(frame), is_directed_(is_directed), tolerance_(tolerance) {}

  const DirectionFrame& frame() const { return frame_; }
  /// Returns the place of the segment, for erase(). Segments with an order may become parts of runs.
  std::uint32_t insert(const FrameSegment& segment, std::uint32_t number, const std::optional<StrokeOrder>& order = {});
  void erase(std::uint32_t place);

  /// Fills an empty tree with segments and their numbers.
  void fill(const std::vector<std::pair<FrameSegment, std::uint32_t>>& segments);

  /// Calls found(number) for each segment that may satisfy the question, until it returns true. Returns whether it did.
  template <class Found>
  bool query(const FrameSegment& line, Question question, const Found& found) const {
    return query(
        line, question, [](const SegmentRun&) { return false; }, found);
  }
  /// As above, but first calls takes_run(run) for each run that lies on the line and inside it. Where that returns
  /// true, found() is not called for the segments of the run.
  template <class TakesRun, class Found>
  bool query(const FrameSegment& line, Question question, const TakesRun& takes_run, const Found& found) const {
    return !nodes_.empty() && visit(0, line, question, takes_run, found);
  }

  /// Number of nodes that such a query visits.
  std::size_t visited_nodes(const FrameSegment& line, Question question) const {
    return nodes_.empty() ? 0 : visited_nodes(0, line, question);
  }

 private:
  static constexpr std::uint32_t kLeafSize = 8;  ///< adjustable

  struct Item {
    FrameSegment segment;
    std::uint32_t number, next, leaf;
    bool erased;
  };
  /// Ranges over the segments of a node: coordinates of their ends, slopes, and v at the places first_u and last_u.
  struct Bounds {
    NumberRange low_u, low_v, high_u, high_v, slope, at_first, at_last;
  };
  struct Node {
    Bounds bounds;
    double first_u = 0, last_u = 0;           ///< where at_first and at_last are measured
    double of_u = 0, of_v = 0, of_slope = 0;  ///< a node divides by the key of_u * u + of_v * v + of_slope * slope
    double divide = 0;                        ///< keys below go to the first child
    std::uint32_t parent = kNone;
    std::uint32_t children = kNone;  ///< the first of two adjacent nodes; kNone for a leaf
    std::uint32_t first_item = kNone;
    std::uint32_t count = 0, count_when_built = 0;
    std::uint32_t listed = 0;  ///< for a leaf: its items, including those erased since it was built

    double key(const FrameSegment& s) const {
      return of_u * (s.u0 + s.u1) / 2 + of_v * (s.v0 + s.v1) / 2 + of_slope * s.slope;
    }
    void add(const FrameSegment& s);
    NumberRange v_at(double u) const;
    bool is_near(const FrameSegment& line, double u_low, double u_high, double margin) const;
  };

  double margin_along(const FrameSegment& line, double slopes_apart) const;
  bool may_be_along(const Node& node, const FrameSegment& line) const;
  bool may_be(const Node& node, const FrameSegment& line, Question question) const;
  bool may_be(const FrameSegment& segment, const FrameSegment& line, Question question) const;
  std::size_t visited_nodes(std::uint32_t number, const FrameSegment& line, Question question) const;
  bool is_on(const FrameSegment& line, const SegmentRun& run) const;
  const std::optional<SegmentRun>& run_below(std::uint32_t node) const { return runs_[has_runs_ ? node : 0]; }
  std::optional<SegmentRun> run_of_leaf(const Node& node) const;
  void find_run(std::uint32_t node);
  void find_runs_up_from(std::uint32_t node);
  bool choose_division(Node& node, std::span<const std::uint32_t> items, std::vector<double>& keys) const;
  void build(std::uint32_t node, std::span<std::uint32_t> items);
  void build_anew(std::uint32_t node);
  void collect(std::uint32_t node, std::vector<std::uint32_t>& items);
  std::uint32_t new_children();

  template <class TakesRun, class Found>
  bool visit(std::uint32_t number, const FrameSegment& line, Question question, const TakesRun& takes_run,
             const Found& found) const {
    const Node& node = nodes_[number];
    if (node.count == 0 || !may_be(node, line, question)) return false;
    if (const auto& run = run_below(number); run && is_on(line, *run) && takes_run(*run)) return false;
    if (node.children != kNone) {
      return visit(node.children, line, question, takes_run, found) ||
             visit(node.children + 1, line, question, takes_run, found);
    }
    for (std::uint32_t i = node.first_item; i != kNone; i = items_[i].next) {
      const Item& item = items_[i];
      if (!item.erased && may_be(item.segment, line, question) && found(item.number)) return true;
    }
    return false;
  }

  DirectionFrame frame_;
  bool is_directed_;
  double tolerance_;
  std::vector<Item> items_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> free_;  ///< pairs of nodes
  /// Whether a segment was inserted with its order. Only then the next two have an entry for each item and each node.
  bool has_runs_ = false;
  std::vector<std::optional<StrokeOrder>> orders_;   ///< by item
  std::vector<std::optional<SegmentRun>> runs_{{}};  ///< by node
};

}  // namespace ligne
