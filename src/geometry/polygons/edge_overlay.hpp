#pragma once
/// Overlays sets of directed edges: gives, along an edge, the winding number of each set just left and just right of
/// it.
///
/// The line of an edge, moved left by an infinitesimal distance, meets no corner and runs along no edge. On it the
/// winding of a set changes where an edge of the set has one end on its left and the other on its right; an end exactly
/// on the unmoved line counts as right. The right side is treated likewise. So corners on edges, corners on corners,
/// and edges on edges need no special case: the sides of corners are exact, and the order along the line is exact
/// (geometry/exact_segment.hpp).

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/polygons/contour_face.hpp"

namespace ligne {

/// Windings of up to three sets on the two sides of a part of an edge, in the direction of its segment.
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

  /// Calls visit(from, to, sides, corner) for the parts of edge i between `from` and `to` on its segment, in order,
  /// without gaps. Nothing changes within a part. `corner`: a border that continues along the edge may have a corner at
  /// `from`, because other edges end, meet or begin to run along it there. A single edge that passes through makes no
  /// such corner.
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
    bool passes;  ///< the ends of the edge lie strictly on opposite sides of the line
  };

  /// Fills events_ with the changes between from and to, in order; returns the windings at `from`.
  EdgeSides start(std::size_t i, SegmentParameter from, SegmentParameter to);

  void add_ends(const LatticeSegment& line, const ContourEdge& edge, SegmentParameter from, SegmentParameter to);

  std::vector<Item> edges_;
  std::vector<Event> events_;
};

}  // namespace ligne
