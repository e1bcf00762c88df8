#include "visibility/atherton_weiler/atherton_weiler.hpp"

#include <algorithm>

#include "visibility/atherton_weiler/border_lines.hpp"
#include "visibility/atherton_weiler/glass_lines.hpp"
#include "visibility/atherton_weiler/polygon_study.hpp"
#include "visibility/atherton_weiler/visible_faces.hpp"
#include "visibility/common/clock.hpp"
#include "visibility/common/intersections.hpp"
#include "visibility/common/make_strokes.hpp"
#include "visibility/common/stroke_maker.hpp"
#include "visibility/common/visible_parts.hpp"
#include "visibility/tolerances.hpp"

// Phases: (1) facets and the grid of their cells, (2) visible faces, (3) their borders led back to edges, and the lines that
// borders do not tell. See docs/methods/atherton-weiler.md.

namespace ligne {
namespace {

using namespace atherton_weiler;

/// Finds the visible parts of lines; one for each task.
class LineSearch {
 public:
  LineSearch(const ProjectedScene& scene, const Facets& facets, const appel::CellGrid& grid, double coincidence_steps)
      : has_glass_(!scene.face_is_transparent.empty()),
        opaque_(scene, facets.facets, grid, coincidence_steps),
        glass_(scene, facets.facets, grid, coincidence_steps) {}

  std::vector<LinePart>& find(const PageLine& line) { return has_glass_ ? glass_.find(line) : opaque_.find(line); }

 private:
  bool has_glass_;
  appel::VisibleParts opaque_;
  GlassLines glass_;
};

enum class Study : std::uint8_t { faces, polygons, silhouettes };
constexpr std::string_view kStudies[] = {"faces", "polygons", "silhouettes"};
constexpr MethodParameter kParameters[] = {
    {"study", "HOW",
     "every face by itself, or the classical study of polygons nearest first, convex bodies by faces or by silhouettes",
     "faces", kStudies}};

void report(const StudyCounts& counts, Statistics& statistics) {
  statistics.count("facets behind covers", counts.not_listed);
  statistics.count("pairs compared", counts.compared);
  statistics.count("wrong sorts", counts.wrong_sorts);
  statistics.count("pairs cut", counts.cuts);
  statistics.count("pairs that coincide", counts.ties);
  statistics.count("clip faces", counts.clips);
}

void report(const PolygonCounts& counts, Statistics& statistics) {
  statistics.count("zones", counts.zones);
  statistics.count("slabs", counts.slabs);
  statistics.count("convex objects", counts.bodies);
  statistics.count("clips", counts.clips);
  statistics.count("wrong sorts", counts.wrong_sorts);
  statistics.count("cuts along common lines", counts.splits);
  statistics.count("deepest recursion", counts.deepest);
}

}  // namespace

const MethodTraits& AthertonWeilerMethod::traits() const {
  static const MethodTraits traits{
      "atherton-weiler",
      "faces clipped by the faces in front of them: visible polygons with holes, and their borders as lines",
      kStrokes | kRegions,
      true,
      true,
      "K. Weiler, P. Atherton, Hidden surface removal using polygon area sorting, 1977",
      MethodTraits{}.tolerance_mm,
      kParameters};
  return traits;
}

VisibilityResult AthertonWeilerMethod::study(const ProjectedScene& scene, const StudyOptions& options) const {
  VisibilityResult result;
  Statistics& statistics = result.statistics;
  const double step = scene.lattice.step_mm;
  const double coincidence_steps = coincidence_mm(scene) / step;
  const double least = kLeastPartMm / step;
  Clock clock;

  // 1. Facets and cells.
  const Facets facets = make_facets(scene, coincidence_steps);
  appel::CellGrid::Options grid_options;
  grid_options.margin_steps = coincidence_steps + 1;
  grid_options.drop_hidden = !(options.hidden_strokes && scene.with_intersections);
  grid_options.see_through = true;
  const appel::CellGrid grid(scene, facets.facets, grid_options);
  statistics.time("grid", clock.lap());

  // 2. Visible faces.
  const Study study = options.settings.choice("study", Study::faces);
  PolygonCounts polygon_counts;
  VisibleFaces visible = study == Study::faces ? find_visible_faces(scene, facets.facets, grid, options.progress)
                                               : study_polygons(scene, facets.facets, study == Study::silhouettes,
                                                                options.progress, polygon_counts);
  statistics.time("faces", clock.lap());

  // 3. Lines.
  StrokeModel model;
  model.lattice = scene.lattice;
  model.edge_count = scene.source_count;
  const BorderLines borders(scene, facets, visible);
  const StrokeMaker maker(scene, options.hidden_strokes);
  make_strokes(scene.edges.size(), model.strokes, [&] {
    return [&, search = LineSearch(scene, facets, grid, coincidence_steps), parts = std::vector<LinePart>()](
               std::size_t i, std::vector<Stroke>& out) mutable {
      const ProjectedEdge& edge = scene.edges[i];
      const ProjectedVertex &a = scene.vertices[edge.v0], &b = scene.vertices[edge.v1];
      if (a.p == b.p) return;  // seen end on
      const PageLine line(a, b, edge.face0, edge.face1);
      if (borders.needs_study(i)) {
        parts = search.find(line);
      } else {
        parts.assign(borders.parts(i).begin(), borders.parts(i).end());
      }
      drop_short_parts(parts, page_length(line), least);
      const auto range = scene.edge_parts.empty() ? std::array<double, 2>{0, 1} : scene.edge_parts[i];
      maker.add(line, parts, range, edge.source, edge.line_class, true, out);
    };
  });
  std::vector<Intersection> intersections;
  if (scene.with_intersections) {
    intersections = appel::find_intersections(scene, facets.facets, grid, grid_options.margin_steps);
  }
  make_strokes(intersections.size(), model.strokes, [&] {
    return [&, search = LineSearch(scene, facets, grid, coincidence_steps)](std::size_t i,
                                                                            std::vector<Stroke>& out) mutable {
      const Intersection& s = intersections[i];
      const PageLine line(s.from, s.to, s.face0, s.face1);
      std::vector<LinePart>& parts = search.find(line);
      drop_short_parts(parts, page_length(line), least);
      maker.add(line, parts, {0, 1}, scene.source_count + static_cast<std::uint32_t>(i), LineClass::intersection, true, out);
    };
  });
  number_intersections(scene, intersections, model);
  statistics.time("lines", clock.lap());

  std::size_t studied = 0;
  for (std::size_t i = 0; i < scene.edges.size(); ++i) studied += borders.needs_study(i);
  statistics.count("facets", facets.facets.size());
  if (study == Study::faces) {
    report(visible.counts, statistics);
  } else {
    report(polygon_counts, statistics);
  }
  statistics.count("regions", visible.regions.size());
  statistics.count("lines beside borders", studied);
  statistics.count("strokes", model.strokes.size());
  if (options.wanted & kRegions) result.regions = std::move(visible.regions);
  result.strokes = std::move(model);
  return result;
}

}  // namespace ligne
