#pragma once
/// Exact solution of a window: the visible parts of its lines, and the pairs of faces that penetrate in it.

#include <span>
#include <vector>

#include "base/add_counts.hpp"
#include "visibility/common/open_parts.hpp"
#include "visibility/penetration/penetration.hpp"
#include "visibility/warnock/analysis.hpp"

namespace ligne::warnock {

/// The part of a line in a window. Pieces of adjacent windows share their ends bitwise.
struct Piece {
  std::uint32_t line = 0;
  double from = 0, to = 1;
};

/// A visible part of a line.
struct FoundPart {
  std::uint32_t line = 0;
  bool near_side = false;  ///< a side of a facet lies along the line; see hidden_interval()
  LinePart part;
};

struct SolutionCounts {
  std::uint64_t line_facet_tests = 0;
  std::uint64_t pair_tests = 0;
  void operator+=(const SolutionCounts& o) { add_counts(*this, o); }
};

/// Solves windows; keeps scratch memory between them.
class Solution {
 public:
  Solution(const FaceTable& table, const std::vector<PageLine>& lines, double coincidence_steps, double margin_steps)
      : table_(table), lines_(lines), coincidence_steps_(coincidence_steps), margin_steps_(margin_steps) {}

  /// Loads the facets of the elements near the window, sorted by depth.
  void load(const Lists& lists, const Window& window);

  /// Appends the visible parts of the pieces.
  void draw_lines(std::span<const Piece> pieces, std::vector<FoundPart>& out);

  /// Appends each piece if its midpoint is visible.
  void draw_by_middle(std::span<const Piece> pieces, std::vector<FoundPart>& out);

  /// Tests all pairs of facets of different faces. Skips facets that lie wholly behind `cover` in the window.
  void find_pairs(const Window& window, float cover, PenetrationSearch& found);

  const SolutionCounts& counts() const { return counts_; }

 private:
  struct Item {
    std::uint32_t facet;
    float z_near, z_far;
    std::int32_t x0, x1, y0, y1;  ///< bounding box of the projection, with the margin
  };

  /// Calls visit(interval) for all hidden intervals of the piece until it returns true; returns true if it did.
  template <class Visit>
  bool visit_hidden(const Piece& piece, bool& near_side, Visit visit);

  const FaceTable& table_;
  const std::vector<PageLine>& lines_;
  double coincidence_steps_, margin_steps_;
  std::vector<Item> items_;
  std::vector<PlacedFacet> placed_;
  OpenParts open_;
  SolutionCounts counts_;
};

}  // namespace ligne::warnock
