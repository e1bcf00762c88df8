#pragma once
/// Strokes while overlaps are resolved: covered parts are cut away, and rests are added.

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

/// Appends to `rests` what the covered parts leave of the stroke, in order along it. Rests up to the tolerance vanish.
/// Sorts the covered parts.
void append_rests(const Stroke& stroke, std::vector<CoveredPart>& covered, double tolerance_steps,
                  std::vector<Stroke>& rests);

/// A stroke, by its number, and what stays of it: parts of it, or all of it.
struct CutStroke {
  std::uint32_t number = 0;
  std::vector<Stroke> rests{};
};

/// The strokes that are compared, in the order of precedence, followed by the rests of those that were cut. Numbers of
/// strokes do not change.
struct ComparedStrokes {
  std::vector<Stroke> strokes;
  std::vector<std::uint32_t> place;   ///< by stroke: in the order of precedence; a rest has the place of its stroke
  std::vector<std::uint8_t> is_gone;  ///< by stroke: whether its rests stand for it

  /// `in_order` is sorted by precedence.
  explicit ComparedStrokes(std::vector<Stroke> in_order);

  /// The order in which strokes are decided: by place, then along the stroke.
  bool comes_before(std::uint32_t a, std::uint32_t b) const {
    return place[a] != place[b] ? place[a] < place[b] : strokes[a].t_from < strokes[b].t_from;
  }
  /// Adds the rests of strokes that have changed.
  void replace(std::span<const CutStroke> cut);
  /// Appends what stays, in the order of comes_before().
  void append_remaining(std::vector<Stroke>& result) const;
};

}  // namespace ligne
