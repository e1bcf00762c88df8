#pragma once
/// Visible strokes as a graph: where lines end on the side of lines, too.

#include <cstdint>
#include <span>
#include <vector>

#include "base/disjoint_sets.hpp"
#include "drawing/stroke.hpp"

namespace ligne {

/// The strokes that are seen, cut where free ends of others lie on them.
class StrokeNet {
 public:
  /// The part of one stroke between two cuts, and the nodes at both.
  struct Piece {
    Stroke stroke;
    std::uint32_t of;  ///< the stroke that it is a part of
    std::uint32_t from, to;
    bool alive = true;
  };
  /// Pieces that continue each other at nodes of two arms.
  struct Arc {
    std::vector<std::uint32_t> pieces;
    double length = 0;                ///< lattice steps
    std::vector<std::uint32_t> ends;  ///< nodes of one or of more than two arms; none for a ring
  };

  /// Ends that lie within `touching` steps of another line meet it. O(n + m), with m the grid cells of the side of
  /// `touching` x 16 that lines pass, or fewer: see walked_cell().
  StrokeNet(const std::vector<Stroke>& strokes, double touching);

  const std::vector<Piece>& pieces() const { return pieces_; }
  /// The number of pieces at a node that are alive.
  std::uint32_t arms(std::uint32_t node) const { return arms_[node]; }
  /// All pieces at a node, ascending.
  std::span<const std::uint32_t> pieces_at(std::uint32_t node) const {
    return {at_node_.data() + first_at_[node], at_node_.data() + first_at_[node + 1]};
  }
  /// Arcs of the pieces that are alive, by their lowest piece.
  std::vector<Arc> arcs() const;
  void take_away(const Arc& arc);

 private:
  void file_pieces();

  std::vector<Piece> pieces_;
  std::vector<std::uint32_t> arms_;                ///< by node
  std::vector<std::uint32_t> first_at_, at_node_;  ///< by node the first of its pieces; these
};

}  // namespace ligne
