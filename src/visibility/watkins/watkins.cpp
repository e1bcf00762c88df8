#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "base/parallel.hpp"
#include "view/tolerances.hpp"
#include "visibility/common/cell_grid.hpp"
#include "visibility/common/clock.hpp"
#include "visibility/common/opaque_scene.hpp"
#include "visibility/edges/line_strokes.hpp"
#include "visibility/edges/visible_parts.hpp"
#include "visibility/methods.hpp"
#include "visibility/penetration/intersections.hpp"
#include "visibility/watkins/exact/exact_study.hpp"
#include "visibility/watkins/exact/line_study.hpp"
#include "visibility/watkins/exact/occluder_grid.hpp"
#include "visibility/watkins/scan_plane.hpp"
#include "visibility/watkins/skew_faces.hpp"
#include "visibility/watkins/transparent_spans.hpp"
#include "visibility/watkins/watkins_options.hpp"

// Phases: (1) facets; (2) omission of facets and lines that are surely hidden; (3) the scan over the edges, which also finds
// penetrations; (4) the scan over the lines of intersection, if any; (5) spans, if requested; (6) strokes. With a number of
// lines, (3) only finds penetrations, and (4) scans by lines, over edges and intersections together. A scan by lines needs
// the intersections even if they are not drawn, because they show where faces penetrate each other. See
// docs/methods/watkins.md.

namespace ligne {
namespace {

using namespace watkins;

constexpr unsigned kShownLines = 48;    ///< scan lines shown for an exact study. Tuned
constexpr double kShownStepMm = 0.01;   ///< the y of the middle scan line is rounded to this, for a short number
constexpr double kTickOfSpacing = 0.3;  ///< height of the ticks at span ends, as a part of the line distance. Taste

/// Moves the ends of strokes to the nearest points of the grid.
void snap_strokes(const LineGrid& grid, StrokeModel& model) {
  const auto snapped = [&](const LatticePoint& p) {
    return LatticePoint{static_cast<std::int32_t>(std::lround(grid.x(grid.u(p.x)))),
                        static_cast<std::int32_t>(std::lround(grid.v_origin + grid.v(p.y) * grid.spacing))};
  };
  for (Stroke& s : model.strokes) {
    s.from = snapped(s.from);
    s.to = snapped(s.to);
  }
  std::erase_if(model.strokes, [](const Stroke& s) { return s.from == s.to; });
}

/// A study; one member function per phase.
class WatkinsStudy {
 public:
  /// `skew`: the faces of the scene without a plane, or null.
  WatkinsStudy(const ProjectedScene& scene, const VisibilityOptions& options, const SkewFaces* skew)
      : scene_(scene),
        options_(options),
        step_(scene.lattice.step_mm),
        own_(watkins_options(options.settings)),
        exact_(own_.exact) {
    // Between events there is no line before, whose divisions could be remembered.
    exact_options_.kind = own_.kind == SpanMethodKind::remembered ? SpanMethodKind::box : own_.kind;
    exact_options_.coincidence_steps = coincidence_mm(scene) / step_;
    exact_options_.penetrations = finds_intersections();
    exact_options_.progress = options.progress;
    by_lines_.scan.kind = own_.kind;
    by_lines_.coincidence_steps = exact_options_.coincidence_steps;
    by_lines_.group = own_.group;
    by_lines_.ahead = own_.ahead;
    by_lines_.skew = skew;
  }

  VisibilityResult run();

 private:
  LineGrid lines() const { return grid_of_lines(scene_, own_.line_count, own_.whole); }
  bool finds_intersections() const { return scene_.with_intersections || !exact_ || options_.span_lines; }
  void make_lines();
  void leave_out_what_is_hidden();
  void edge_visibility();
  const CellGrid& cells_to_search();
  LineVisibility by_cells();
  void study_intersections();
  void study_lines();
  void make_spans();
  std::vector<LinePart> tracked_parts(std::size_t line) const {
    return by_states_.visible_parts(line,
                                    own_.tracking == Tracking::overrun ? PartEnd::first_hidden : PartEnd::last_visible);
  }
  void make_strokes();
  void show_spans();
  void show_plane();
  std::vector<SweepLine> all_lines() const {
    std::vector<SweepLine> all = lines_;
    all.insert(all.end(), crossed_.begin(), crossed_.end());
    return all;
  }

  const ProjectedScene& scene_;
  const VisibilityOptions& options_;
  const double step_;
  const WatkinsOptions own_;
  const bool exact_;  ///< true: scans at every event; false: by lines
  ExactOptions exact_options_;
  LineStudyOptions by_lines_;
  TrackedParts by_states_;
  Clock clock_;

  Facets facets_;
  std::vector<SweepLine> lines_;    ///< candidate edges
  std::vector<SweepLine> crossed_;  ///< intersections
  std::optional<OccluderGrid> occluders_;
  std::optional<CellGrid> cells_;     ///< for their covers
  std::optional<CellGrid> searched_;  ///< of the remaining facets
  bool edges_by_cells_ = false, intersections_by_cells_ = false;
  std::vector<Intersection> intersections_;
  /// Intervals of edges; by lines, also of intersections behind them. The exact study keeps those of intersections
  /// separately.
  FoundIntervals found_, found_of_intersections_;
  std::vector<std::uint8_t> near_;  ///< by edge: 1 if another line may coincide with it; empty: any may
  ExactCounts counts_;
  VisibilityResult result_;
};

// 1. Facets.
void WatkinsStudy::make_lines() {
  facets_ = make_facets(scene_, exact_options_.coincidence_steps);
  if (const SkewFaces* const skew = by_lines_.skew) {
    std::erase_if(facets_.facets, [skew](const Facet& f) { return skew->has(f.face); });
    result_.statistics.count("skew faces, by the slopes of their sides", skew->count());
  }
  result_.statistics.count("facets", facets_.facets.size());
  result_.statistics.count("candidate edges", scene_.edges.size());
  lines_.reserve(scene_.edges.size());
  for (const ProjectedEdge& e : scene_.edges) {
    lines_.push_back({scene_.vertices[e.v0], scene_.vertices[e.v1], e.face0, e.face1});
  }
  result_.statistics.time("facets", clock_.lap());
}

// 2. Omission of hidden elements. Hidden intersections can only be found among all facets.
void WatkinsStudy::leave_out_what_is_hidden() {
  if (!(options_.hidden_strokes && scene_.with_intersections)) {
    occluders_.emplace(scene_.vertices, facets_.facets, exact_options_.coincidence_steps + 1);
    exact_options_.covers = &*occluders_;
    leave_out_hidden(scene_, *occluders_, facets_.facets, lines_);
    cells_.emplace(scene_, facets_.facets, CellGrid::Options{exact_options_.coincidence_steps + 1});
    leave_out_hidden(*cells_, facets_.facets, lines_);
    result_.statistics.count("facets in front of all covers", facets_.facets.size());
  }
  result_.statistics.time("covers", clock_.lap());
}

// 3. Edges and penetrating pairs.
void WatkinsStudy::edge_visibility() {
  const std::span<const SweepLine> studied = exact_ ? std::span<const SweepLine>(lines_) : std::span<const SweepLine>{};
  ExactResult first = study_exactly(scene_.vertices, facets_.facets, studied, exact_options_);
  counts_ += first.counts;
  edges_by_cells_ = exact_ && first.gave_up;
  if (edges_by_cells_) cells_to_search();
  found_ = std::move(first.found);
  near_ = std::move(first.near);
  if (finds_intersections()) {
    intersections_ =
        first.gave_up ? find_intersections(scene_, facets_.facets, cells_to_search(), exact_options_.coincidence_steps + 1)
                      : take_intersections(first, scene_.vertices, facets_.facets, kLeastPartMm / step_);
  }
  for (const Intersection& i : intersections_) {
    crossed_.push_back({i.from, i.to, i.face0, i.face1});
    crossed_.back().behind = cells_ && lies_behind(*cells_, crossed_.back());
  }
  result_.statistics.count("intersection segments", intersections_.size());
  result_.statistics.time("edges", clock_.lap());
}

/// The cells for the lines of scans that gave up.
const CellGrid& WatkinsStudy::cells_to_search() {
  if (!searched_) {
    CellGrid::Options options{.margin_steps = exact_options_.coincidence_steps + 1, .drop_hidden = cells_.has_value()};
    searched_.emplace(scene_, facets_.facets, options);
  }
  return *searched_;
}

/// Finds the visible parts of lines by cells.
LineVisibility WatkinsStudy::by_cells() {
  const auto search =
      std::make_shared<VisibleParts>(scene_, facets_.facets, cells_to_search(), exact_options_.coincidence_steps);
  return [search](std::size_t, const PageLine& line, std::vector<LinePart>& parts) {
    parts = search->find(line);
    return search->near_side();
  };
}

// 4. Intersections.
void WatkinsStudy::study_intersections() {
  if (scene_.with_intersections && !intersections_.empty()) {
    exact_options_.penetrations = false;
    exact_options_.progress = {};
    ExactResult r = study_exactly(scene_.vertices, facets_.facets, crossed_, exact_options_);
    counts_ += r.counts;
    intersections_by_cells_ = r.gave_up;
    if (r.gave_up) cells_to_search();
    found_of_intersections_ = std::move(r.found);
  }
  report(counts_, result_.statistics);
  const int gave_up = edges_by_cells_ + intersections_by_cells_;
  if (gave_up > 0)
    result_.statistics.count("scans aborted, lines studied by grid cells", static_cast<std::uint64_t>(gave_up));
}

// 4. By lines: edges and intersections together.
void WatkinsStudy::study_lines() {
  by_lines_.collect_spans = (options_.wanted & kSpans) != 0 && !options_.span_lines;
  LineStudyOptions options = by_lines_;
  const bool with_curves = by_lines_.skew && scene_.with_intersections && !own_.points;
  options.states = own_.tracking != Tracking::exact || own_.points || with_curves;
  if (own_.points) options.scan.coherence = false;  // 2.3.5.4: where faces penetrate every line is studied
  LineStudyResult r = study_by_lines(scene_, facets_.facets, own_.points ? lines_ : all_lines(), lines(), options);
  report(r, result_.statistics);
  found_ = std::move(r.found);
  by_states_ = std::move(r.by_states);
  if (own_.points) {
    intersections_ = std::move(r.points);
    result_.statistics.count("points of intersections", intersections_.size());
  } else if (with_curves) {
    intersections_.insert(intersections_.end(), r.curves.begin(), r.curves.end());
    result_.statistics.count("pieces of curves of intersection", r.curves.size());
  }
  near_.clear();
  if (!by_lines_.collect_spans) return;
  const double spacing = scene_.view.window.height() / own_.line_count;
  result_.spans = SpanModel{{scene_.view.window.min.y + spacing / 2, spacing, own_.line_count}, std::move(r.spans)};
}

// 5. Spans.
void WatkinsStudy::make_spans() {
  if (!options_.span_lines) return;
  by_lines_.track = false;
  by_lines_.collect_spans = true;
  const LineGrid lines = grid_of(scene_, *options_.span_lines, own_.whole);
  result_.spans =
      SpanModel{*options_.span_lines, study_by_lines(scene_, facets_.facets, all_lines(), lines, by_lines_).spans};
  result_.statistics.time("spans", clock_.lap());
}

// 6. Strokes.
void WatkinsStudy::make_strokes() {
  // By lines, parts shorter than the line distance are below the resolution.
  const double least = kLeastPartMm / step_;
  const bool by_states = own_.tracking != Tracking::exact;
  const double shortest = exact_ || by_states ? least : std::max(least, lines().spacing);
  LineStrokes strokes(scene_, facets_, options_.hidden_strokes, shortest);
  strokes.add_edges([&]() -> LineVisibility {
    if (edges_by_cells_) return by_cells();
    return [this, by_states, open = OpenParts()](std::size_t i, const PageLine& line, std::vector<LinePart>& parts) mutable {
      // A line of no face bounds no span, so it has no state.
      if (by_states && (line.face0 != kNone || line.face1 != kNone)) {
        parts = tracked_parts(i);
      } else if (!lines_[i].behind) {
        parts = found_.visible_parts(i, open);
      }
      return near_.empty() || near_[i];
    };
  });
  if (scene_.with_intersections) {
    strokes.add_intersections(intersections_, [&]() -> LineVisibility {
      if (intersections_by_cells_) return by_cells();
      return [this, by_states, open = OpenParts()](std::size_t i, const PageLine&, std::vector<LinePart>& parts) mutable {
        if (own_.points || i >= crossed_.size()) {  // visible where they were found
          parts.assign(1, {0, 1});
        } else if (by_states) {
          parts = tracked_parts(lines_.size() + i);
        } else if (!crossed_[i].behind) {
          parts = exact_ ? found_of_intersections_.visible_parts(i, open) : found_.visible_parts(lines_.size() + i, open);
        }
        return true;
      };
    });
  }
  result_.strokes = strokes.take();
  if (by_states && own_.whole) snap_strokes(lines(), *result_.strokes);
  result_.statistics.time("strokes", clock_.lap());
  result_.statistics.count("strokes", result_.strokes->strokes.size());
}

/// The plane of one scan line with all faces, including those behind others.
void WatkinsStudy::show_plane() {
  Rect extent;
  for (const Triangle& t : scene_.triangles) {
    for (const std::uint32_t v : t.v) extent.extend(scene_.lattice.to_mm(scene_.vertices[v].p));
  }
  if (extent.empty()) return;
  const double y =
      options_.settings.number("show").value_or(std::round((extent.min.y + extent.max.y) / 2 / kShownStepMm) * kShownStepMm);
  const Facets all = make_facets(scene_, exact_options_.coincidence_steps);
  ScanPlane plane = scan_plane(scene_, all.facets, all_lines(), y, by_lines_);
  if (!plane.segments.empty()) result_.plane = std::move(plane);
}

/// Shows spans as lines on the page with a tick at either end. An exact study shows kShownLines scan lines.
void WatkinsStudy::show_spans() {
  if (!options_.settings.has("show")) return;
  if (options_.settings.choice("show", WatkinsShow::spans) == WatkinsShow::plane) return show_plane();
  LineStudyOptions options = by_lines_;
  options.track = false;
  options.collect_spans = true;
  const unsigned count = exact_ ? kShownLines : own_.line_count;
  const double spacing = scene_.view.window.height() / count;
  const SpanLines lines{scene_.view.window.min.y + spacing / 2, spacing, count};
  const Point2 tick{0, kTickOfSpacing * spacing};
  for (const Span& s :
       study_by_lines(scene_, facets_.facets, all_lines(), grid_of_lines(scene_, count, own_.whole), options).spans) {
    const Point2 from{s.x_from, lines.y_mm(s.line)}, to{s.x_to, lines.y_mm(s.line)};
    result_.debug.push_back({from + tick, from, to, to + tick});
  }
}

VisibilityResult WatkinsStudy::run() {
  make_lines();
  leave_out_what_is_hidden();
  edge_visibility();
  exact_ ? study_intersections() : study_lines();
  result_.statistics.time("lines", clock_.lap());
  make_spans();
  if (result_.spans) result_.statistics.count("spans", result_.spans->spans.size());
  make_strokes();
  show_spans();
  return std::move(result_);
}

/// The study of a scene whose skew faces, if any, have the surfaces of `skew`.
VisibilityResult study(const ProjectedScene& scene, const VisibilityOptions& options, const SkewFaces* skew) {
  const std::optional<OpaqueScene> opaque = without_transparent_faces(scene, TransparentEdges::kept);
  if (!opaque) return WatkinsStudy(scene, options, skew).run();
  const bool composed = options.with_transparent_faces && options.span_lines;
  VisibilityOptions of_opaque = options;
  if (composed) {
    of_opaque.span_lines.reset();
    of_opaque.wanted &= static_cast<std::uint8_t>(~kSpans);
  }
  VisibilityResult result = WatkinsStudy(opaque->scene, of_opaque, skew).run();
  result.statistics.count("transparent faces, not occluding", opaque->faces_left_out);
  if (composed) {
    Clock clock;
    LineStudyOptions by_lines;
    by_lines.scan.kind = watkins_options(options.settings).kind;
    by_lines.coincidence_steps = coincidence_mm(scene) / scene.lattice.step_mm;
    by_lines.skew = skew;
    result.spans = transparent_spans(scene, make_facets(scene, by_lines.coincidence_steps).facets,
                                     grid_of(scene, *options.span_lines, false), *options.span_lines, by_lines);
    result.statistics.time("spans", clock.lap());
    result.statistics.count("spans", result.spans->spans.size());
  }
  if (result.spans && !composed) result.left_out = opaque->left_out() + " from the areas";
  return result;
}

VisibilityResult watkins_visibility(const ProjectedScene& scene, const VisibilityOptions& options) {
  if (!watkins_options(options.settings).slopes) return study(scene, options, nullptr);
  const std::optional<SkewScene> skew =
      join_skew_faces(scene, make_facets(scene, coincidence_mm(scene) / scene.lattice.step_mm).facets);
  if (!skew) return study(scene, options, nullptr);
  VisibilityResult result = study(skew->scene, options, &skew->faces);
  if (skew->left_as_triangles > 0) {
    result.statistics.count("skew faces of many sides, as triangles", skew->left_as_triangles);
  }
  return result;
}

}  // namespace

const Method& watkins_method() {
  static const FunctionMethod method(
      {.name = "watkins",
       .summary = "scan lines: the nearest face of each span; visible edges tracked between events",
       .products = kStrokes | kSpans,
       .paper =
           "G. S. Watkins, A real time visible surface algorithm, 1970; M. Archuleta, Hidden surface line-drawing algorithm, "
           "1972",
       .parameters = watkins_parameters(),
       .transparency = TransparencyMode::hides_nothing},
      watkins_visibility);
  return method;
}

}  // namespace ligne
