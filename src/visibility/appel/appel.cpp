#include "visibility/appel/appel.hpp"

#include <algorithm>
#include <mutex>

#include "geometry/parallel.hpp"
#include "visibility/common/cell_grid.hpp"
#include "visibility/common/clock.hpp"
#include "visibility/common/intersections.hpp"
#include "visibility/common/stroke_maker.hpp"
#include "visibility/common/visible_parts.hpp"
#include "visibility/tolerances.hpp"

// Phases: (1) facets, (2) the screen grid with covers, (3) intersections that are not behind covers, (4) every line through
// the cells it crosses, nearest facets first, until nothing of it is left. See docs/methods/appel.md.

namespace ligne {
namespace {

using namespace appel;

/// Runs work(i, search, strokes) for i in [0, n) in blocks; strokes come out in that order.
template <class Work>
void study_lines(std::size_t n, const ProjectedScene& scene, const Facets& facets, const CellGrid& grid,
                 double coincidence_steps, const StudyOptions& options, std::vector<Stroke>& strokes, TestCounts& counts,
                 Work work) {
  constexpr std::size_t kBlock = 4096;
  const std::size_t blocks = (n + kBlock - 1) / kBlock;
  std::vector<std::vector<Stroke>> found(blocks);
  std::vector<TestCounts> block_counts(blocks);
  std::mutex progress_mutex;
  std::size_t done = 0;
  parallel_for(blocks, [&](std::size_t block) {
    VisibleParts search(scene, facets.facets, grid, coincidence_steps);
    std::vector<Stroke>& out = found[block];
    for (std::size_t i = block * kBlock; i < std::min(n, (block + 1) * kBlock); ++i) work(i, search, out);
    block_counts[block] = search.counts();
    if (options.progress) {
      const std::lock_guard lock(progress_mutex);
      options.progress(static_cast<double>(++done) / static_cast<double>(blocks));
    }
  });
  std::vector<std::size_t> first(blocks + 1, strokes.size());
  for (std::size_t b = 0; b < blocks; ++b) first[b + 1] = first[b] + found[b].size();
  strokes.resize(first[blocks]);
  parallel_for(blocks, [&](std::size_t b) {
    std::copy(found[b].begin(), found[b].end(), strokes.begin() + static_cast<std::ptrdiff_t>(first[b]));
    std::vector<Stroke>().swap(found[b]);
  });
  for (const TestCounts& c : block_counts) counts += c;
}

}  // namespace

const MethodTraits& AppelMethod::traits() const {
  static const MethodTraits traits{
      "appel",
      "every edge against the faces that can hide it, by exact intervals; the default for line drawings",
      kStrokes,
      true,
      true,
      "A. Appel, The notion of quantitative invisibility, 1967; R. Galimberti, U. Montanari, An algorithm for hidden line "
      "elimination, 1969"};
  return traits;
}

VisibilityResult AppelMethod::study(const ProjectedScene& scene, const StudyOptions& options) const {
  VisibilityResult result;
  StrokeModel model;
  model.lattice = scene.lattice;
  model.edge_count = scene.source_count;
  const double step = scene.lattice.step_mm;
  const double coincidence_steps = coincidence_mm(scene) / step;
  const double least = kLeastPartMm / step;
  Clock clock;

  // 1. Facets.
  const Facets facets = make_facets(scene, coincidence_steps);
  result.statistics.time("facets", clock.lap());

  // 2. The screen grid. Few candidate lines need few of its cells.
  constexpr std::size_t kManyLines = 4;
  CellGrid::Options grid_options;
  grid_options.margin_steps = coincidence_steps + 1;
  grid_options.drop_hidden = !(options.hidden_strokes && scene.with_intersections);
  if (!scene.with_intersections && scene.edges.size() * kManyLines < facets.facets.size()) {
    grid_options.only_along = &scene.edges;
  }
  const CellGrid grid(scene, facets.facets, grid_options);
  result.statistics.time("grid", clock.lap());

  // 3. Intersections.
  std::vector<Intersection> intersections;
  if (scene.with_intersections) {
    intersections = find_intersections(scene, facets.facets, grid, grid_options.margin_steps);
  }
  result.statistics.time("intersections", clock.lap());

  // 4. Lines.
  const StrokeMaker maker(scene, options.hidden_strokes);
  TestCounts counts;
  study_lines(scene.edges.size(), scene, facets, grid, coincidence_steps, options, model.strokes, counts,
              [&](std::size_t i, VisibleParts& search, std::vector<Stroke>& out) {
                const ProjectedEdge& edge = scene.edges[i];
                const ProjectedVertex &a = scene.vertices[edge.v0], &b = scene.vertices[edge.v1];
                if (a.p == b.p) return;  // seen end on
                const PageLine line(a, b, edge.face0, edge.face1);
                std::vector<LinePart>& parts = search.find(line);
                drop_short_parts(parts, page_length(line), least);
                const auto thin = [&](std::uint32_t f) { return f < facets.face_is_thin.size() && facets.face_is_thin[f]; };
                const bool may_coincide = search.near_side() || thin(edge.face0) || thin(edge.face1);
                const auto range = scene.edge_parts.empty() ? std::array<double, 2>{0, 1} : scene.edge_parts[i];
                maker.add(line, parts, range, edge.source, edge.line_class, may_coincide, out);
              });
  study_lines(intersections.size(), scene, facets, grid, coincidence_steps, {}, model.strokes, counts,
              [&](std::size_t i, VisibleParts& search, std::vector<Stroke>& out) {
                const Intersection& s = intersections[i];
                const PageLine line(s.from, s.to, s.face0, s.face1);
                std::vector<LinePart>& parts = search.find(line);
                drop_short_parts(parts, page_length(line), least);
                maker.add(line, parts, {0, 1}, scene.source_count + static_cast<std::uint32_t>(i), LineClass::intersection,
                          true, out);
              });
  number_intersections(scene, intersections, model);
  result.statistics.time("lines", clock.lap());

  Statistics& statistics = result.statistics;
  statistics.count("facets", facets.facets.size());
  statistics.count("candidate edges", scene.edges.size());
  statistics.count("grid leaves", grid.leaf_count());
  statistics.count("grid entries", grid.entry_count());
  statistics.count("intersection segments tested", intersections.size());
  statistics.count("leaves visited", counts.leaves);
  statistics.count("leaves behind their cover", counts.covered);
  statistics.count("line-facet tests", counts.facet_tests);
  statistics.count("strokes", model.strokes.size());
  result.strokes = std::move(model);
  return result;
}

}  // namespace ligne
