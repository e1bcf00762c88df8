#pragma once
/// Scenes as a scan by lines takes them.

#include "support/corpus_scene.hpp"
#include "support/scenes.hpp"
#include "visibility/watkins/exact/line_study.hpp"

namespace ligne::test {

using namespace ligne::watkins;

/// Only lines on which something changes that is seen are studied.
inline constexpr ScanOptions kRecognising{SpanMethodKind::stack, true, true, true};
/// Lines on which anything changes are; all lines are.
inline constexpr ScanOptions kEveryLine{SpanMethodKind::stack, false, false, true};
inline constexpr ScanOptions kCoherent{SpanMethodKind::stack, true, false, true};
inline const CameraRequest kOdd = along({-0.31, 0.87, -0.39});

/// Everything that a study by lines needs; intersections as the method finds them.
struct PreparedScan {
  ProjectedScene projected;
  Facets facets;
  std::vector<SweepLine> lines;

  PreparedScan(const Scene& scene, const CameraRequest& camera) {
    projected = project_on_a4(scene, camera);
    const double coincidence = coincidence_mm(projected) / projected.lattice.step_mm;
    facets = make_facets(projected, coincidence);
    for (const ProjectedEdge& e : projected.edges)
      lines.push_back({projected.vertices[e.v0], projected.vertices[e.v1], e.face0, e.face1});
    ExactOptions exact;
    exact.coincidence_steps = coincidence;
    exact.penetrations = true;
    ExactResult found = study_exactly(projected.vertices, facets.facets, {}, exact);
    for (const Intersection& i :
         take_intersections(found, projected.vertices, facets.facets, kLeastPartMm / projected.lattice.step_mm))
      lines.push_back({i.from, i.to, i.face0, i.face1});
  }

  LineStudyOptions options(const ScanOptions& scan, std::uint32_t group) const {
    LineStudyOptions options;
    options.scan = scan;
    options.coincidence_steps = coincidence_mm(projected) / projected.lattice.step_mm;
    options.collect_spans = true;
    options.group = group;
    return options;
  }

  LineStudyResult study(std::uint32_t count, const LineStudyOptions& options, bool whole = false) const {
    return study_by_lines(projected, facets.facets, lines, grid_of_lines(projected, count, whole), options);
  }

  LineStudyResult study(std::uint32_t count, const ScanOptions& scan, std::uint32_t group = 0, bool whole = false) const {
    return study(count, options(scan, group == 0 ? count : group), whole);
  }
};

}  // namespace ligne::test
