#pragma once
/// Spans with the transparent faces in front of them ([Boulle1980] figure 2.88: transparency is possible).

#include "drawing/result_models.hpp"
#include "visibility/common/facet.hpp"
#include "visibility/watkins/exact/line_study.hpp"

namespace ligne::watkins {

/// The spans of a scene with transparent faces. On every line the span method finds the visible runs of the opaque
/// segments. The transparent segments are then kept sorted by depth from left to right: where one begins, ends, crosses
/// another or comes out of an opaque face, a span ends. A span without an opaque face has transparent faces only.
///
/// Every line is studied, since any change of a transparent segment is visible. Takes O(n log n + s) per line, with n
/// segments and s the faces in the lists of its spans. `facets`: of all faces. `grid` has real coordinates.
SpanModel transparent_spans(const ProjectedScene& scene, const std::vector<Facet>& facets, const LineGrid& grid,
                            const SpanLines& lines, const LineStudyOptions& options);

}  // namespace ligne::watkins
