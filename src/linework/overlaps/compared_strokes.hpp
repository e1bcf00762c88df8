#pragma once
/// Strokes of which parts are covered by others.

#include <cstdint>
#include <span>
#include <vector>

#include "linework/stroke_piece.hpp"

namespace ligne {

/// The tolerance of coincidence, on the page and in depth.
struct OverlapTolerance {
  double steps, mm;
};

/// A part of a stroke on which another stroke lies. Where the part ends inside the stroke, the point of the cut is the end
/// of that other stroke. So what stays of the stroke meets it in one lattice point, and make_drawing.cpp joins them.
struct CoveredPart {
  StrokeCut from, to;
};

/// Returns what the covered parts leave of the stroke, in order along it. Rests up to the tolerance vanish. Sorts the
/// covered parts.
std::vector<Stroke> rests_of(const Stroke& stroke, std::vector<CoveredPart>& covered, double tolerance_steps);

/// A stroke, by its number, and what stays of it: parts of it, or all of it.
struct CutStroke {
  std::uint32_t number = 0;
  std::vector<Stroke> rests{};
};

/// Strokes by falling precedence, while overlaps are resolved.
struct ComparedStrokes {
  std::vector<Stroke> strokes;
  std::vector<std::uint8_t> is_new;  ///< by stroke: whether it was not yet compared with the others

  /// Puts rests in the place of their strokes. Then only the rests of strokes that were cut are new. `cut` is ascending.
  void replace(std::span<const CutStroke> cut);
};

}  // namespace ligne
