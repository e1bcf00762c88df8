#include "visibility/atherton_weiler/atherton_weiler.hpp"

#include <functional>
#include <memory>

#include "view/tolerances.hpp"
#include "visibility/atherton_weiler/border_lines.hpp"
#include "visibility/atherton_weiler/polygon_study.hpp"
#include "visibility/common/clock.hpp"
#include "visibility/edges/line_strokes.hpp"
#include "visibility/edges/transparent_lines.hpp"
#include "visibility/edges/visible_parts.hpp"
#include "visibility/penetration/intersections.hpp"
#include "visibility/polygons/visible_faces.hpp"

// Phases: (1) facets and the grid of their cells, (2) visible faces, (3) their borders matched to edges, and the lines that
// borders do not give. See docs/methods/atherton-weiler.md.

namespace ligne {
namespace {

using namespace atherton_weiler;

/// Finds the visible parts of lines. Each task has its own.
class LineSearch {
 public:
  LineSearch(const ProjectedScene& scene, const Facets& facets, const CellGrid& grid, double coincidence_steps)
      : has_transparent_(!scene.face_is_transparent.empty()),
        opaque_(scene, facets.facets, grid, coincidence_steps),
        transparent_(scene, facets.facets, grid, coincidence_steps) {}

  std::vector<LinePart>& find(const PageLine& line) {
    return has_transparent_ ? transparent_.find(line) : opaque_.find(line);
  }

 private:
  bool has_transparent_;
  VisibleParts opaque_;
  TransparentLines transparent_;
};

enum class Study : std::uint8_t { faces, polygons, silhouettes };
constexpr std::string_view kStudies[] = {"faces", "polygons", "silhouettes"};
constexpr std::string_view kShowNames[] = {"clips"};
constexpr std::string_view kClipNames[] = {"general", "convex"};
constexpr std::string_view kZoneNames[] = {"boxes", "octagons", "hulls", "contours"};
constexpr std::string_view kInsideNames[] = {"after", "at-once"};
constexpr MethodParameter kParameters[] = {
    experiment(
        {"study", "HOW",
         "faces: each face separately; polygons, silhouettes: the classical study, nearest polygon first, with convex "
         "bodies as faces or as silhouettes",
         "faces", kStudies}),
    experiment({"clip", "general|convex",
                "study of polygons: the clip of contours of any form, or convex contours by codes of their corners",
                "convex", kClipNames}),
    experiment(
        {"zones", "boxes|octagons|hulls|contours",
         "study of polygons: which test tells faces apart on the page, by boxes along the axes, along the diagonals as well, by "
         "convex hulls, or by the contours themselves",
         "boxes", kZoneNames}),
    experiment({"inside", "after|at-once",
                "study of polygons: a nearer face inside the clip face takes its place after all clips, or at once", "after",
                kInsideNames}),
    {"show", "clips", "layer debug: the polygons into which clipping divides the faces", "", kShowNames}};

std::vector<std::vector<Point2>> contours_of(const std::vector<Region>& regions) {
  std::vector<std::vector<Point2>> contours;
  for (const Region& region : regions) {
    for (const std::vector<Point2>& contour : region.contours) {
      contours.push_back(contour);
      contours.back().push_back(contour.front());
    }
  }
  return contours;
}

void report(const StudyCounts& counts, Statistics& statistics) {
  statistics.count("facets behind covers", counts.not_listed);
  statistics.count("pairs compared", counts.compared);
  statistics.count("wrong sorts", counts.wrong_sorts);
  statistics.count("pairs cut", counts.cuts);
  statistics.count("pairs that coincide", counts.ties);
  statistics.count("clip faces", counts.clips);
}

void report(const PolygonCounts& counts, const PolygonOptions& options, Statistics& statistics) {
  statistics.count("zones", counts.zones);
  statistics.count("slabs", counts.slabs);
  statistics.count("convex objects", counts.bodies);
  statistics.count("clips", counts.clips);
  statistics.count("wrong sorts", counts.wrong_sorts);
  statistics.count("cuts along common lines", counts.splits);
  statistics.count("deepest recursion", counts.deepest);
  statistics.count("polygons in lists", counts.considered);
  statistics.count("clips with nothing inside", counts.empty_clips);
  statistics.count("convex contours clipped", counts.convex_pairs);
  statistics.count("general clips", counts.general_clips);
  statistics.count("signs of corners in clips", counts.signs);
  if (options.zones != ZoneTest::boxes) {
    statistics.count("tests for zones", counts.zone_tests);
    statistics.count("tests before clips", counts.pair_tests);
    statistics.count("clips spared by tests", counts.told_apart);
    statistics.count("signs of corners in tests", counts.test_signs);
  }
  if (options.inside == InsideTest::at_once) statistics.count("clip faces given up at once", counts.exchanges);
}

PolygonOptions polygon_options(const MethodSettings& settings, bool silhouettes) {
  const PolygonOptions standard;
  return {silhouettes, settings.choice("clip", standard.clip), settings.choice("zones", standard.zones),
          settings.choice("inside", standard.inside)};
}

/// Makes the search for lines whose visible parts the borders of regions do not give.
using MakeSearch = std::function<std::shared_ptr<LineSearch>()>;

LineVisibility parts_of_edges(const BorderLines& borders, const MakeSearch& make_search) {
  return [&borders, search = make_search()](std::size_t i, const PageLine& line, std::vector<LinePart>& parts) {
    if (borders.needs_study(i)) {
      parts = search->find(line);
    } else {
      parts.assign(borders.parts(i).begin(), borders.parts(i).end());
    }
    return true;
  };
}

LineVisibility parts_of_intersections(const MakeSearch& make_search) {
  return [search = make_search()](std::size_t, const PageLine& line, std::vector<LinePart>& parts) {
    parts = search->find(line);
    return true;
  };
}

CellGrid::Options grid_options(double coincidence_steps, bool hidden_intersections) {
  CellGrid::Options options;
  options.margin_steps = coincidence_steps + 1;
  options.drop_hidden = !hidden_intersections;
  options.see_through = true;
  return options;
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
      kParameters,
      {},
      false,
      TransparencyMode::seen_through};
  return traits;
}

VisibilityResult AthertonWeilerMethod::compute_visibility(const ProjectedScene& scene,
                                                          const VisibilityOptions& options) const {
  VisibilityResult result;
  Statistics& statistics = result.statistics;
  const double step = scene.lattice.step_mm;
  const double coincidence_steps = coincidence_mm(scene) / step;
  Clock clock;

  // 1. Facets and cells.
  const Facets facets = make_facets(scene, coincidence_steps);
  const CellGrid::Options of_grid = grid_options(coincidence_steps, options.hidden_strokes && scene.with_intersections);
  const CellGrid grid(scene, facets.facets, of_grid);
  statistics.time("grid", clock.lap());

  // 2. Visible faces.
  const Study study = options.settings.choice("study", Study::faces);
  const PolygonOptions of_polygons = polygon_options(options.settings, study == Study::silhouettes);
  PolygonCounts polygon_counts;
  VisibleFaces visible = study == Study::faces
                             ? find_visible_faces(scene, facets.facets, grid, options.progress)
                             : study_polygons(scene, facets.facets, of_polygons, options.progress, polygon_counts);
  statistics.time("faces", clock.lap());

  // 3. Lines.
  const BorderLines borders(scene, facets, visible);
  LineStrokes strokes(scene, facets, options.hidden_strokes, kLeastPartMm / step);
  const MakeSearch make_search = [&] { return std::make_shared<LineSearch>(scene, facets, grid, coincidence_steps); };
  strokes.add_edges([&] { return parts_of_edges(borders, make_search); });
  std::vector<Intersection> intersections;
  if (scene.with_intersections) {
    intersections = find_intersections(scene, facets.facets, grid, of_grid.margin_steps);
  }
  strokes.add_intersections(intersections, [&] { return parts_of_intersections(make_search); });
  result.strokes = strokes.take();
  statistics.time("lines", clock.lap());

  std::size_t studied = 0;
  for (std::size_t i = 0; i < scene.edges.size(); ++i) studied += borders.needs_study(i);
  statistics.count("facets", facets.facets.size());
  if (study == Study::faces) {
    report(visible.counts, statistics);
  } else {
    report(polygon_counts, of_polygons, statistics);
  }
  statistics.count("regions", visible.regions.size());
  statistics.count("lines apart from borders", studied);
  statistics.count("strokes", result.strokes->strokes.size());
  if (options.settings.has("show")) result.debug = contours_of(visible.regions);
  if (options.wanted & kRegions) result.regions = std::move(visible.regions);
  return result;
}

}  // namespace ligne
