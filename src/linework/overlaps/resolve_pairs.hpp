#pragma once
/// Cuts strokes that lie on each other, so that one stays.

#include <span>
#include <vector>

#include "linework/overlaps/compared_strokes.hpp"
#include "linework/overlaps/overlap_search.hpp"

namespace ligne {

/// Resolves pairs of overlapping strokes, ascending, where strokes are numbered by falling precedence. Returns what stays of
/// the strokes in pairs, ascending. It may overlap other strokes only where a cut has made new ends.
std::vector<CutStroke> resolve_pairs(const std::vector<Stroke>& strokes, std::span<const StrokePair> pairs,
                                     const OverlapTolerance& tolerance);

}  // namespace ligne
