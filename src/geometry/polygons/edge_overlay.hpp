#pragma once
/// Sets of directed edges laid over each other: along an edge, how often each set winds round the page just left and just
/// right of it.
///
/// The line of an edge, moved to the left by less than anything that matters, meets no corner and runs along no edge. On it
/// the winding of a set changes where an edge of the set has one end on its left and the other on its right; an end exactly
/// on the unmoved line counts as right. The same to the right. So corners on edges, corners on corners, and edges on edges
/// need no case of their own: the sides of corners are exact, and order along the line is exact
/// (geometry/exact_segment.hpp).

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/polygons/contour_face.hpp"

namespace ligne {

/// Windings of the sets, up to three, on the two sides of a part of an edge, in the direction of its segment.
struct EdgeSides {
  std::array<std::int32_t, 3> left{}, right{};
};

class EdgeOverlay {
 public:
  void clear() { edges_.clear(); }
  void add(const ContourEdge& edge, unsigned set) {
    edges_.push_back({edge, set, edge.from.num >= 0 && edge.to.num <= edge.to.den});
  }
  void add(const ContourFace& face, unsigned set);
  std::size_t size() const { return edges_.size(); }
  const ContourEdge& edge(std::size_t i) const { return edges_[i].edge; }

  /// Calls visit(from, to, sides, corner) for the parts of edge i between `from` and `to` on its segment, in order, without
  /// gaps. Nothing changes within a part. `corner`: at `from` there may be a corner of a border that goes on along the edge:
  /// other edges end or meet there, or begin to run along it. A place where one edge passes through is no such corner.
  template <class Visit>
  void for_each_part(std::size_t i, SegmentParameter from, SegmentParameter to, Visit visit) {
    EdgeSides sides = start(i, from, to);
    bool corner = true;
    for (std::size_t k = 0; k < events_.size();) {
      const SegmentParameter t = events_[k].t;
      visit(from, t, sides, corner);
      const std::size_t first = k;
      corner = false;
      for (; k < events_.size() && compare(events_[k].t, t) == 0; ++k) {
        sides.left[events_[k].set] += events_[k].left;
        sides.right[events_[k].set] += events_[k].right;
        corner |= k > first || !events_[k].passes;
      }
      from = t;
    }
    visit(from, to, sides, corner);
  }

 private:
  struct Item {
    ContourEdge edge;
    unsigned set;
    bool within;  ///< the run does not leave its segment
  };
  struct Event {
    SegmentParameter t;
    unsigned set;
    std::int32_t left, right;
    bool passes;  ///< the edge has its ends on the two sides of the line
  };

  /// Fills events_ with what changes between from and to, in order; gives what holds at `from`.
  EdgeSides start(std::size_t i, SegmentParameter from, SegmentParameter to);

  void add_ends(const LatticeSegment& line, const ContourEdge& edge, SegmentParameter from, SegmentParameter to);

  std::vector<Item> edges_;
  std::vector<Event> events_;
};

}  // namespace ligne
