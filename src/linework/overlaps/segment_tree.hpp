#pragma once
/// Segments of about one direction, or short ones, in a tree: each stands in one leaf, whatever it crosses.

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
  double slope;  ///< 0 for one that is upright

  FrameSegment(const DirectionFrame& frame, LatticePoint from, LatticePoint to);
  double v_at(double u) const { return v0 + (u - u0) * slope; }
};

/// Segments from this many tolerances on are filed by direction.
inline constexpr double kDirectedLength = 12;

/// A range of numbers; empty at first.
struct NumberRange {
  double low = std::numeric_limits<double>::infinity(), high = -low;

  void add(double value) { low = std::min(low, value), high = std::max(high, value); }
  double extent() const { return high - low; }
  double farthest(double value) const { return std::max(std::abs(low - value), std::abs(high - value)); }
};

/// A segment is four numbers: the u of its two ends, its slope, and its v in the middle. The tree divides by slope, by v
/// across the common slope of a node, or by u, whichever sets the segments farther apart, in steps of the page: so segments
/// that cross each other everywhere are told apart by their slopes, parallel ones by their offset. Memory is linear.
///
/// Invariants: a node's bounds hold all that stands below it (they shrink only when it is built anew); `count` is what
/// stands below. A node of which one child has got too much is built anew, when it has grown by half since it was. Where
/// what stands below is one run of segments that came in with their order, the node knows that.
class SegmentTree {
 public:
  /// The questions to the segments here.
  enum class Question : std::uint8_t {
    along,   ///< both ends of what they have in common with the line near each other
    beside,  ///< the line is short: near it
    box,     ///< the segments here are short: any part near the line
  };

  /// `is_directed`: the segments have slopes of at most a half; otherwise they are short.
  SegmentTree(const DirectionFrame& frame, bool is_directed, double tolerance)
      : frame_(frame), is_directed_(is_directed), tolerance_(tolerance) {}

  const DirectionFrame& frame() const { return frame_; }
  /// Returns the place of the segment, for erase(). Those with an order may become parts of runs.
  std::uint32_t insert(const FrameSegment& segment, std::uint32_t number, const std::optional<StrokeOrder>& order = {});
  void erase(std::uint32_t place);

  /// Puts in many at once, into an empty tree: for each its number.
  void fill(const std::vector<std::pair<FrameSegment, std::uint32_t>>& segments);

  /// Calls found(number) for the segments of which the answer may be yes, until it returns true; true when it did.
  template <class Found>
  bool query(const FrameSegment& line, Question question, const Found& found) const {
    return query(
        line, question, [](const SegmentRun&) { return false; }, found);
  }
  /// As above, but runs that lie on the line and inside it are handed to takes_run(run) first; where that returns true their
  /// segments are not told one by one.
  template <class TakesRun, class Found>
  bool query(const FrameSegment& line, Question question, const TakesRun& takes_run, const Found& found) const {
    return !nodes_.empty() && visit(0, line, question, takes_run, found);
  }

  /// How many nodes such a query looks at.
  std::size_t nodes_asked(const FrameSegment& line, Question question) const {
    return nodes_.empty() ? 0 : nodes_asked(0, line, question);
  }

 private:
  static constexpr std::uint32_t kLeafSize = 8;  ///< adjustable

  struct Item {
    FrameSegment segment;
    std::uint32_t number, next, leaf;
    bool erased;
  };
  /// At two places along u, and for the ends.
  struct Bounds {
    NumberRange low_u, low_v, high_u, high_v, slope, at_first, at_last;
  };
  struct Node {
    Bounds bounds;
    double first_u = 0, last_u = 0;           ///< the places of at_first and at_last
    double of_u = 0, of_v = 0, of_slope = 0;  ///< the key by which a node divides is a sum of these
    double divide = 0;                        ///< keys below go to the first child
    std::uint32_t parent = kNone;
    std::uint32_t children = kNone;  ///< two of them; kNone: a leaf
    std::uint32_t first_item = kNone;
    std::uint32_t count = 0, count_when_built = 0;
    std::uint32_t listed = 0;  ///< of a leaf: items, and those erased since it was built

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
  std::size_t nodes_asked(std::uint32_t number, const FrameSegment& line, Question question) const;
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
  /// Some segment came in with its order: then there are as many of the next two as of items and nodes.
  bool has_runs_ = false;
  std::vector<std::optional<StrokeOrder>> orders_;   ///< by item
  std::vector<std::optional<SegmentRun>> runs_{{}};  ///< by node
};

}  // namespace ligne
