#include "visibility/edges/edge_visibility.hpp"

#include <memory>
#include <utility>

#include "view/tolerances.hpp"
#include "visibility/common/clock.hpp"
#include "visibility/edges/line_strokes.hpp"
#include "visibility/edges/visible_parts.hpp"
#include "visibility/penetration/intersections.hpp"
#include "visibility/penetration/joined_facets.hpp"
#include "visibility/polygons/visible_faces.hpp"

// Phases: (1) facets, (2) the screen grid with covers, (3) intersections that are not behind covers, (4) every line through
// the cells it crosses, nearest facets first, until nothing of it is left. (5) Where an order of the faces is known,
// regions. See docs/methods/appel.md and docs/methods/bsp.md.

namespace ligne {
namespace {

double coincidence_steps_of(const ProjectedScene& scene) { return coincidence_mm(scene) / scene.lattice.step_mm; }

/// Options of the screen grid. If there are few candidate lines, only the cells along them are filled.
CellGrid::Options grid_options(const ProjectedScene& scene, const Facets& facets, bool hidden_strokes, bool regions,
                               bool see_through) {
  constexpr std::size_t kManyLines = 4;
  CellGrid::Options options{.margin_steps = coincidence_steps_of(scene) + 1,
                            .drop_hidden = !(hidden_strokes && scene.with_intersections),
                            .see_through = see_through};
  if (!regions && !scene.with_intersections && scene.edges.size() * kManyLines < facets.facets.size())
    options.only_along = &scene.edges;
  return options;
}

/// Drops the ranks of faces seen edge on, exactly or within the lattice. Such a face overlaps nothing on the page, so
/// an order may put it, and its lines, anywhere: for them depths decide.
FaceRanks without_thin_faces(FaceRanks ranks, const Facets& facets) {
  for (std::uint32_t f = 0; f < facets.face_is_thin.size(); ++f) {
    if (facets.face_is_thin[f]) ranks.forget(f);
  }
  return ranks;
}

LineVisibility parts_seen_through(const ProjectedScene& scene, const Facets& facets, const CellGrid& grid,
                                  double coincidence_steps) {
  const auto search = std::make_shared<TransparentLines>(scene, facets.facets, grid, coincidence_steps);
  return [search](std::size_t, const PageLine& line, std::vector<LinePart>& parts) {
    parts = search->find(line);
    return true;
  };
}

void report(const VisibleFaces& visible, Statistics& statistics) {
  statistics.count("pairs of facets by the order", visible.counts.by_order);
  statistics.count("pairs of facets by their depths", visible.counts.compared);
  statistics.count("regions", visible.regions.size());
}

void report(const Facets& facets, const ProjectedScene& scene, const CellGrid& grid, Statistics& statistics) {
  statistics.count("facets", facets.facets.size());
  statistics.count("candidate edges", scene.edges.size());
  statistics.count("grid leaves", grid.leaf_count());
  statistics.count("grid entries", grid.entry_count());
}

void report(const TestCounts& counts, Statistics& statistics) {
  statistics.count("leaves visited", counts.leaves);
  statistics.count("leaves behind their cover", counts.covered);
  statistics.count("line-facet tests", counts.facet_tests);
}

}  // namespace

FaceStudy study_faces(const ProjectedScene& scene, const Topology* topology, bool hidden_strokes, bool with_grid) {
  FaceStudy study{make_facets(scene, coincidence_steps_of(scene)), {}, {}};
  if (topology && scene.with_intersections) study.facets.joined = joined_facets(scene, *topology, study.facets.facets);
  if (!with_grid || !scene.with_intersections) return study;
  const std::vector<Facet>& facets = study.facets.facets;
  const CellGrid::Options options = grid_options(scene, study.facets, hidden_strokes, false, false);
  study.grid.emplace(scene, facets, options);
  study.intersections = find_intersections(scene, facets, *study.grid, options.margin_steps, study.facets.joined);
  return study;
}

VisibilityResult edge_visibility(const ProjectedScene& scene, const VisibilityOptions& options, const FaceRanks* ranks) {
  VisibilityResult result;
  Statistics& statistics = result.statistics;
  const double step = scene.lattice.step_mm, coincidence_steps = coincidence_steps_of(scene);
  Clock clock;

  // 1. Facets.
  std::optional<FaceStudy> made;
  if (!options.faces) made = study_faces(scene, nullptr, options.hidden_strokes, false);
  const FaceStudy& faces = made ? *made : *options.faces;
  const Facets& facets = faces.facets;
  statistics.time("facets", clock.lap());

  // 2. The screen grid.
  const bool regions = ranks && (options.wanted & kRegions), see_through = ranks && !scene.face_is_transparent.empty();
  const bool has_grid = faces.grid && !ranks;
  const CellGrid::Options of_grid = grid_options(scene, facets, options.hidden_strokes, regions, see_through);
  std::optional<CellGrid> own;
  const CellGrid& grid = has_grid ? *faces.grid : own.emplace(scene, facets.facets, of_grid);
  statistics.time("grid", clock.lap());

  // 3. Intersections.
  std::vector<Intersection> intersections = faces.intersections;
  if (scene.with_intersections && !has_grid)
    intersections = find_intersections(scene, facets.facets, grid, of_grid.margin_steps, facets.joined);
  statistics.time("intersections", clock.lap());

  // 4. Lines.
  const auto known = ranks ? std::optional(without_thin_faces(*ranks, facets)) : std::nullopt;
  TestTotals totals;
  const auto search_lines = [&]() -> LineVisibility {
    if (see_through) return parts_seen_through(scene, facets, grid, coincidence_steps);
    const auto search =
        std::make_shared<VisibleParts>(scene, facets.facets, grid, coincidence_steps, &totals, known ? &*known : nullptr,
                                       options.blank, options.overlap_if_visible && !ranks);
    return [search](std::size_t, const PageLine& line, std::vector<LinePart>& parts) {
      parts = search->find(line);
      return search->near_side();
    };
  };
  LineStrokes strokes(scene, facets, options.hidden_strokes, kLeastPartMm / step);
  strokes.add_edges(search_lines, options.progress);
  strokes.add_intersections(intersections, search_lines);
  result.strokes = strokes.take();
  statistics.time("lines", clock.lap());

  // 5. Regions.
  if (regions) {
    VisibleFaces visible = find_visible_faces(scene, facets.facets, grid, {}, &*known);
    statistics.time("regions", clock.lap());
    report(visible, statistics);
    result.regions = std::move(visible.regions);
  }
  report(facets, scene, grid, statistics);
  statistics.count("intersection segments tested", intersections.size());
  report(totals.counts, statistics);
  if (ranks) statistics.count("tests saved by the order", totals.counts.behind_in_order);
  statistics.count("strokes", result.strokes->strokes.size());
  return result;
}

}  // namespace ligne
