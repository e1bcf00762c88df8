#pragma once
/// Cuts strokes that lie on each other, so that one stays.

#include <vector>

#include "linework/overlaps/overlap_search.hpp"

namespace ligne {

/// Resolves pairs of overlapping strokes. Groups of strokes that are connected by pairs are resolved in parallel. What stays
/// may overlap other strokes only where a cut has made new ends.
void resolve_pairs(ComparedStrokes& strokes, const std::vector<StrokePair>& pairs, const OverlapTolerance& tolerance);

}  // namespace ligne
