#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

#include "base/index_lists.hpp"
#include "view/tolerances.hpp"
#include "visibility/common/clock.hpp"
#include "visibility/common/opaque_scene.hpp"
#include "visibility/edges/line_strokes.hpp"
#include "visibility/methods.hpp"
#include "visibility/warnock/control.hpp"
#include "visibility/warnock/initial_window.hpp"
#include "visibility/warnock/regions.hpp"

// Phases: (1) facets and faces, sorted by depth; (2) windows with the candidate edges: visible parts, penetrating pairs; (3)
// windows with the found intersections: their visible parts, and areas; (4) parts joined into strokes, areas into regions.
// See docs/methods/warnock.md.

namespace ligne {
namespace {

using namespace warnock;

constexpr std::string_view kWindowNames[] = {"screen", "bounding", "principal"};
constexpr std::string_view kSplitNames[] = {"centre", "vertex", "side"};
constexpr std::string_view kKnowledgeNames[] = {"nothing", "two", "four", "all"};
constexpr std::string_view kShowNames[] = {"windows"};
constexpr unsigned kLowestResolution = 1, kHighestResolution = 1 << 20;
constexpr unsigned kFinestPrecision = 1, kRoughestPrecision = 1000;
constexpr double kPrecisionUnit = 0.01;  ///< unit of --set precision, as a part of the smallest window

constexpr MethodParameter kParameters[] = {
    experiment(
        {"warnock-window", "screen|bounding|principal",
         "first window: the sheet, the bounding square of the scene, or its smallest bounding rectangle in any direction",
         "bounding", kWindowNames}),
    experiment({"warnock-split", "centre|vertex|side",
                "where windows are divided: at the centre, at a vertex, or along a side of a face", "centre", kSplitNames}),
    experiment({"understanding", "nothing|two|four|all",
                "how many cases of a window are recognized and drawn without division", "all", kKnowledgeNames}),
    experiment(
        {"warnock-precision",
         "N",
         "with --set resolution: ignore a strip of N/100 of the smallest window along its border when a case is recognized",
         "",
         {},
         kFinestPrecision,
         kRoughestPrecision}),
    experiment({"resolution",
                "N",
                "limit of resolution: the smallest window is 1/N of the longer side of the sheet (default: none, exact)",
                "",
                {},
                kLowestResolution,
                kHighestResolution}),
    {"show", "windows", "layer debug: the subdivision into windows", "", kShowNames},
};

constexpr std::string_view kCaseNames[kUnderstoodCount] = {"",
                                                           "understood: surrounder in front of everything",
                                                           "understood: two penetrating surrounders",
                                                           "understood: visible edges on one line",
                                                           "understood: single intersector",
                                                           "understood: visible edges meet in one vertex",
                                                           "understood: visible intersectors disjoint"};

double longer_side_mm(const ProjectedScene& scene) {
  return std::max(scene.view.window.width(), scene.view.window.height());
}

/// The visible parts of the lines.
using PartsByLine = ListsOf<FoundPart>;

PartsByLine by_line(const std::vector<FoundPart>& found, std::size_t lines) {
  return {lines, [&](const auto& put) {
            for (const FoundPart& p : found) put(p.line, p);
          }};
}

/// Joins the parts of each line that the windows found.
LineVisibility parts_of_lines(const PartsByLine& sorted) {
  return
      [&sorted, of_line = std::vector<FoundPart>()](std::size_t i, const PageLine&, std::vector<LinePart>& parts) mutable {
        of_line.assign(sorted[i].begin(), sorted[i].end());
        std::ranges::sort(of_line, [](const FoundPart& a, const FoundPart& b) { return a.part.from < b.part.from; });
        bool near_side = false;
        for (const FoundPart& p : of_line) {
          append_part(parts, p.part);
          near_side |= p.near_side;
        }
        return near_side;
      };
}

std::vector<Piece> whole_lines(const std::vector<PageLine>& lines) {
  std::vector<Piece> pieces;
  for (std::uint32_t i = 0; i < lines.size(); ++i) {
    if (!(lines[i].p0 == lines[i].p1)) pieces.push_back({i, 0, 1});
  }
  return pieces;
}

void report(const Counts& c, Statistics& s) {
  s.count("windows studied", c.windows);
  s.count("windows divided", c.divided);
  s.count("windows with nothing to draw", c.empty);
  for (std::size_t i = 1; i < kUnderstoodCount; ++i) s.count(std::string(kCaseNames[i]), c.understood[i]);
  s.count("solved exactly", c.solved);
  s.count("at the limit of resolution", c.limit);
  s.count("analysis: faces examined", c.analysis.faces);
  s.count("analysis: surrounders inherited", c.analysis.inherited);
  s.count("analysis: disjoint by their boxes", c.analysis.box);
  s.count("analysis: intersectors by their boxes", c.analysis.inside);
  s.count("analysis: intersectors by the remembered side", c.analysis.remembered);
  s.count("analysis: sides against windows", c.analysis.side_tests);
  s.count("analysis: faces not studied behind a cover", c.analysis.not_studied);
  s.count("understanding: pairs of faces compared", c.depth.comparisons);
  s.count("understanding: depths computed", c.depth.depths);
  s.count("understanding: contours cut by the window", c.depth.clipped);
  s.count("drawing: line-facet tests", c.solution.line_facet_tests);
  s.count("drawing: facet-facet tests", c.solution.pair_tests);
}

/// Times of the modules, summed over the threads.
void report_times(const Counts& c, Statistics& s) {
  s.time("analysis, all threads", c.analysis_seconds);
  s.time("understanding, all threads", c.understanding_seconds);
  s.time("drawing, all threads", c.solution_seconds);
  s.time("areas, all threads", c.area_seconds);
}

/// The rules of the study.
Rules rules_of(const ProjectedScene& scene, const VisibilityOptions& options, const InitialWindow& first) {
  const double step = scene.lattice.step_mm;
  const auto resolution = options.settings.count("resolution");
  Rules rules;
  rules.coincidence_steps = coincidence_mm(scene) / step;
  rules.margin_steps = rules.coincidence_steps + 1;
  rules.split = options.settings.choice("warnock-split", SplitChoice::centre);
  if (resolution) rules.limit = std::max(1.0, std::ceil(longer_side_mm(scene) / *resolution / step * first.frame.unit()));
  const auto precision = options.settings.count("warnock-precision");
  if (resolution && precision) rules.precision = std::floor(rules.limit * *precision * kPrecisionUnit);
  rules.knowledge = options.settings.choice("understanding", Knowledge::all);
  rules.find_pairs = scene.with_intersections || (options.wanted & kRegions);
  rules.drop_hidden = !(options.hidden_strokes && scene.with_intersections);
  rules.show_windows = options.settings.has("show");
  return rules;
}

/// Maps the progress of a phase to the interval [from, to] of the whole.
std::function<void(double)> part_of_progress(const VisibilityOptions& options, double from, double to) {
  if (!options.progress) return {};
  return [&options, from, to](double part) { options.progress(from + part * (to - from)); };
}

std::vector<PageLine> edge_lines(const ProjectedScene& scene) {
  std::vector<PageLine> lines;
  lines.reserve(scene.edges.size());
  for (const ProjectedEdge& e : scene.edges) {
    lines.emplace_back(scene.vertices[e.v0], scene.vertices[e.v1], e.face0, e.face1);
  }
  return lines;
}

std::vector<PageLine> intersection_lines(const std::vector<Intersection>& intersections) {
  std::vector<PageLine> lines;
  lines.reserve(intersections.size());
  for (const Intersection& x : intersections) lines.emplace_back(x.from, x.to, x.face0, x.face1);
  return lines;
}

std::vector<std::vector<Point2>> page_lines(const std::vector<WindowCut>& cuts, const WindowFrame& frame,
                                            const Lattice& lattice) {
  std::vector<std::vector<Point2>> lines;
  const auto point = [&](FramePoint p) { return lattice.origin_mm + frame.to_page(p.u, p.v) * lattice.step_mm; };
  lines.reserve(cuts.size());
  for (const WindowCut& c : cuts) lines.push_back({point(c.from), point(c.to)});
  return lines;
}

void report(const OpaqueScene& opaque, VisibilityResult& result) {
  result.statistics.count("transparent faces, left out", opaque.faces_left_out);
  result.left_out = opaque.left_out();
}

/// The rules of the second pass, in which the intersections are known.
Rules second_rules(const Rules& first, bool regions) {
  Rules second = first;
  second.find_pairs = second.show_windows = false;
  second.areas = regions;
  return second;
}

VisibilityResult warnock_visibility(const ProjectedScene& whole, const VisibilityOptions& options) {
  const std::optional<OpaqueScene> opaque = without_transparent_faces(whole);
  const ProjectedScene& scene = opaque ? opaque->scene : whole;
  VisibilityResult result;
  Statistics& statistics = result.statistics;
  const double step = scene.lattice.step_mm;
  const bool regions = (options.wanted & kRegions) != 0;
  Clock clock;

  // 1. Faces by depth.
  const InitialWindow first = initial_window(scene, options.settings.choice("warnock-window", WindowChoice::bounding));
  const Rules rules = rules_of(scene, options, first);
  const Facets facets = make_facets(scene, rules.coincidence_steps);
  const FaceTable table = make_faces(scene, facets.facets, first.frame);
  statistics.time("faces", clock.lap());

  // 2. Windows with the candidate edges.
  const double half = rules.find_pairs ? 0.5 : 1;
  const std::vector<PageLine> lines = edge_lines(scene);
  Outcome of_edges =
      Control(table, lines, rules).study(first.window, whole_lines(lines), part_of_progress(options, 0, half));
  LineStrokes strokes(scene, facets, options.hidden_strokes, kLeastPartMm / step);
  const PartsByLine edge_parts = by_line(of_edges.parts, lines.size());
  strokes.add_edges([&] { return parts_of_lines(edge_parts); });
  statistics.time("windows", clock.lap());

  // 3. Windows with the intersections.
  std::vector<Intersection> intersections;
  if (rules.find_pairs) intersections = of_edges.pairs.finish(kLeastPartMm / step);
  std::optional<Outcome> of_intersections;
  if (!intersections.empty() || regions) {
    const std::vector<PageLine> crossings = intersection_lines(intersections);
    Control control(table, crossings, second_rules(rules, regions));
    of_intersections.emplace(control.study(first.window, whole_lines(crossings), part_of_progress(options, half, 1)));
    if (scene.with_intersections) {
      const PartsByLine crossing_parts = by_line(of_intersections->parts, crossings.size());
      strokes.add_intersections(intersections, [&] { return parts_of_lines(crossing_parts); });
    }
    statistics.time("windows of intersections", clock.lap());
  }
  result.strokes = strokes.take();
  if (regions) {
    result.regions = make_regions(of_intersections->areas, first.frame, scene.lattice, kLeastPartMm / step);
    statistics.time("regions", clock.lap());
  }

  statistics.count("faces", table.faces.size());
  statistics.count("facets", facets.facets.size());
  statistics.count("candidate edges", scene.edges.size());
  report(of_edges.counts, statistics);
  statistics.count("intersection segments tested", intersections.size());
  statistics.count("windows studied for intersections and areas", of_intersections ? of_intersections->counts.windows : 0);
  statistics.count("strokes", result.strokes->strokes.size());
  if (result.regions) statistics.count("regions", result.regions->size());
  report_times(of_edges.counts, statistics);
  if (opaque) report(*opaque, result);
  result.debug = page_lines(of_edges.cuts, first.frame, scene.lattice);
  return result;
}

}  // namespace

double warnock_tolerance_mm(const Rect& sheet, unsigned resolution) {
  return 2 * std::numbers::sqrt2 * std::max(sheet.width(), sheet.height()) / resolution;
}

const Method& warnock_method() {
  static const FunctionMethod method(
      {.name = "warnock",
       .summary =
           "subdivision of the picture into windows that are simple enough; edges and areas; exact, or limited by --set "
           "resolution",
       .products = kStrokes | kRegions,
       .paper = "J. E. Warnock, A hidden surface algorithm for computer generated halftone pictures, 1969",
       .parameters = kParameters,
       .transparency = TransparencyMode::left_out},
      warnock_visibility);
  return method;
}

}  // namespace ligne
