#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "view/tolerances.hpp"
#include "visibility/atherton_weiler/polygon_study.hpp"
#include "visibility/common/clock.hpp"
#include "visibility/common/open_parts.hpp"
#include "visibility/edges/line_strokes.hpp"
#include "visibility/edges/visible_parts.hpp"
#include "visibility/methods.hpp"
#include "visibility/penetration/intersections.hpp"
#include "visibility/polygons/visible_faces.hpp"

// Phases: (1) facets and the grid of their cells, (2) visible faces, (3) their borders matched to edges, and the lines that
// borders do not give. See docs/methods/atherton-weiler.md.

namespace ligne {
namespace {

/// Matches the borders of regions to the edges of the scene.
class BorderLines {
 public:
  /// Assigns every border part to its candidate edge, if it has one.
  BorderLines(const ProjectedScene& scene, const Facets& facets, const VisibleFaces& visible);

  /// The visible parts of a candidate edge, sorted and disjoint, where regions border on it. Each part has the lowest level
  /// of these regions: farther regions are seen through more transparent faces.
  std::span<const LinePart> parts(std::size_t edge) const {
    return std::span(parts_).subspan(begin_[edge], begin_[edge + 1] - begin_[edge]);
  }
  /// True if borders do not give the whole edge: a face of it has no area on the page, or touches another face, which may
  /// take its region but does not hide its lines.
  bool needs_study(std::size_t edge) const { return needs_study_[edge] != 0; }

 private:
  std::vector<std::uint32_t> begin_;
  std::vector<LinePart> parts_;
  std::vector<std::uint8_t> needs_study_;
};

struct EdgeKey {
  std::uint32_t low, high, edge;
  friend auto operator<=>(const EdgeKey&, const EdgeKey&) = default;
};

/// Finds candidate edges by their vertices.
class EdgeFinder {
 public:
  explicit EdgeFinder(const ProjectedScene& scene) {
    keys_.reserve(scene.edges.size());
    for (std::uint32_t i = 0; i < scene.edges.size(); ++i) {
      const ProjectedEdge& e = scene.edges[i];
      keys_.push_back({std::min(e.v0, e.v1), std::max(e.v0, e.v1), i});
    }
    parallel_sort(keys_.begin(), keys_.end());
  }

  /// Calls visit(edge) for all edges between the two vertices.
  template <class Visit>
  void find(std::uint32_t v, std::uint32_t w, Visit visit) const {
    const EdgeKey key{std::min(v, w), std::max(v, w), 0};
    for (auto it = std::lower_bound(keys_.begin(), keys_.end(), key);
         it != keys_.end() && it->low == key.low && it->high == key.high; ++it) {
      visit(it->edge);
    }
  }

 private:
  std::vector<EdgeKey> keys_;
};

struct EdgePart {
  std::uint32_t edge;
  LinePart part;
};

/// Appends a part of an edge to the parts from `first` on, or extends the last part if they overlap.
void unite(std::vector<LinePart>& parts, std::size_t first, const LinePart& part) {
  if (parts.size() > first && part.from <= parts.back().to) {
    parts.back().to = std::max(parts.back().to, part.to);
  } else {
    parts.push_back(part);
  }
}

/// Inserts parts of a higher level into the gaps between the parts from `first` on. Both lists are sorted and disjoint.
void fill_gaps(std::vector<LinePart>& parts, std::size_t first, const std::vector<LinePart>& higher) {
  std::vector<LinePart> all(parts.begin() + static_cast<std::ptrdiff_t>(first), parts.end());
  const std::size_t n = all.size();
  for (LinePart p : higher) {
    for (std::size_t i = 0; i < n && p.from < p.to; ++i) {
      const LinePart& lower = parts[first + i];
      if (lower.to <= p.from) continue;
      if (lower.from >= p.to) break;
      if (p.from < lower.from) all.push_back({p.from, lower.from, p.level});
      p.from = lower.to;
    }
    if (p.from < p.to) all.push_back(p);
  }
  std::sort(all.begin(), all.end(), [](const LinePart& a, const LinePart& b) { return a.from < b.from; });
  parts.resize(first);
  parts.insert(parts.end(), all.begin(), all.end());
}

BorderLines::BorderLines(const ProjectedScene& scene, const Facets& facets, const VisibleFaces& visible) {
  const EdgeFinder finder(scene);
  const auto vertices = [&](std::uint32_t side) {
    const Facet& f = facets.facets[side / 3];
    return std::pair(f.v[side % 3], f.v[(side % 3 + 1) % 3]);
  };
  // Borders give an edge completely if each of its faces has a facet on it that touches no other face.
  needs_study_.assign(scene.edges.size(), 1);
  for (std::uint32_t f = 0; f < facets.facets.size(); ++f) {
    for (unsigned k = 0; k < 3; ++k) {
      const auto [v, w] = vertices(side_source(f, k));
      finder.find(v, w, [&](std::uint32_t edge) {
        std::uint8_t& needs = needs_study_[edge];
        needs = static_cast<std::uint8_t>(visible.facet_touches[f] ? 2 : needs == 1 ? 0 : needs);
      });
    }
  }
  const auto thin = [&](std::uint32_t face) { return face < facets.face_is_thin.size() && facets.face_is_thin[face]; };
  for (std::size_t i = 0; i < scene.edges.size(); ++i) {
    if (thin(scene.edges[i].face0) || thin(scene.edges[i].face1)) needs_study_[i] = 1;
  }

  std::vector<EdgePart> found;
  found.reserve(visible.borders.size());
  for (const BorderPart& b : visible.borders) {
    const auto [v, w] = vertices(b.side);
    finder.find(v, w, [&](std::uint32_t edge) {
      const bool along = scene.edges[edge].v0 < scene.edges[edge].v1;
      found.push_back({edge, along ? LinePart{b.from, b.to, b.level} : LinePart{1 - b.to, 1 - b.from, b.level}});
    });
  }
  parallel_sort(found.begin(), found.end(), [](const EdgePart& a, const EdgePart& b) {
    return std::tuple(a.edge, a.part.level, a.part.from, a.part.to) <
           std::tuple(b.edge, b.part.level, b.part.from, b.part.to);
  });
  begin_.assign(scene.edges.size() + 1, 0);
  std::size_t k = 0;
  std::vector<LinePart> higher;
  for (std::uint32_t edge = 0; edge < scene.edges.size(); ++edge) {
    const std::size_t first = parts_.size();
    for (; k < found.size() && found[k].edge == edge && found[k].part.level == 0; ++k) unite(parts_, first, found[k].part);
    while (k < found.size() && found[k].edge == edge) {
      const std::uint32_t level = found[k].part.level;
      higher.clear();
      for (; k < found.size() && found[k].edge == edge && found[k].part.level == level; ++k) unite(higher, 0, found[k].part);
      fill_gaps(parts_, first, higher);
    }
    begin_[edge + 1] = static_cast<std::uint32_t>(parts_.size());
  }
}

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
  return {.margin_steps = coincidence_steps + 1, .drop_hidden = !hidden_intersections, .see_through = true};
}

VisibilityResult atherton_weiler_visibility(const ProjectedScene& scene, const VisibilityOptions& options) {
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

}  // namespace

const Method& atherton_weiler_method() {
  static const FunctionMethod method(
      {.name = "atherton-weiler",
       .summary = "faces clipped by the faces in front of them: visible polygons with holes, and their borders as lines",
       .products = kStrokes | kRegions,
       .paper = "K. Weiler, P. Atherton, Hidden surface removal using polygon area sorting, 1977",
       .parameters = kParameters,
       .transparency = TransparencyMode::seen_through},
      atherton_weiler_visibility);
  return method;
}

}  // namespace ligne
