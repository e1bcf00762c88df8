#pragma once
/// Drawing of a window: exact visible parts of its lines, and the faces that penetrate each other in it.

#include <span>
#include <vector>

#include "visibility/common/open_parts.hpp"
#include "visibility/penetration/penetration.hpp"
#include "visibility/warnock/analysis.hpp"

namespace ligne::warnock {

/// The part of a line that lies in a window. Neighbouring windows share its ends to the last bit.
struct Piece {
  std::uint32_t line = 0;
  double from = 0, to = 1;
};

/// A visible part of a line.
struct FoundPart {
  std::uint32_t line = 0;
  bool near_side = false;  ///< a side of a facet lies along the line, see hidden_interval()
  LinePart part;
};

struct SolutionCounts {
  std::uint64_t line_facet_tests = 0;
  std::uint64_t pair_tests = 0;
  void operator+=(const SolutionCounts& o) {
    line_facet_tests += o.line_facet_tests;
    pair_tests += o.pair_tests;
  }
};

/// Working memory that is kept from window to window.
class Solution {
 public:
  Solution(const FaceTable& table, const std::vector<PageLine>& lines, double coincidence_steps, double margin_steps)
      : table_(table), lines_(lines), coincidence_steps_(coincidence_steps), margin_steps_(margin_steps) {}

  /// Takes the facets of the elements that come near the window, by depth.
  void load(const Lists& lists, const Window& window);

  /// Appends the visible parts of the pieces.
  void draw_lines(std::span<const Piece> pieces, std::vector<FoundPart>& out);

  /// Decides for the middle of each piece: it is visible as a whole or not at all.
  void draw_by_middle(std::span<const Piece> pieces, std::vector<FoundPart>& out);

  /// Tests all pairs of facets of different faces; those wholly behind `cover` in the window are not wanted.
  void find_pairs(const Window& window, float cover, PenetrationSearch& found);

  const SolutionCounts& counts() const { return counts_; }

 private:
  struct Item {
    std::uint32_t facet;
    float z_near, z_far;
    std::int32_t x0, x1, y0, y1;  ///< of its projection, margin included
  };

  /// Calls visit(interval) for all that hides a part of the piece, until it returns true; true when it did.
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
