#pragma once
/// Reduces the strokes that lie on one line by the dozen.

#include "linework/overlaps/compared_strokes.hpp"

namespace ligne {

/// Where many strokes of about the same length lie on one line in one place, only the parts stay that no other of these
/// strokes covers. So the number of pairs that remain for resolve_pairs() grows as n log n. Strokes that need no check
/// (Stroke::needs_overlap_check) take no part. `strokes` are sorted by precedence. Returns what stays of the crowded ones,
/// ascending.
std::vector<CutStroke> thin_crowded_lines(const std::vector<Stroke>& strokes, const OverlapTolerance& tolerance);

}  // namespace ligne
