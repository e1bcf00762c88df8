#include "visibility/watkins/watkins.hpp"

#include <algorithm>
#include <string>

#include "geometry/parallel.hpp"
#include "visibility/common/clock.hpp"
#include "visibility/common/make_strokes.hpp"
#include "visibility/common/stroke_maker.hpp"
#include "visibility/tolerances.hpp"
#include "visibility/watkins/exact_study.hpp"
#include "visibility/watkins/line_study.hpp"

// Phases: (1) facets, (2) facets and lines that are surely hidden are left out, (3) the scan over the edges, which also
// finds what penetrates, (4) the scan over the lines of intersection, where there are any, (5) spans for those who want
// them, (6) strokes. With a number of lines (3) only looks for penetrations, and (4) goes by lines, over edges and
// intersections at once. A scan by lines needs the intersections even when nobody wants them drawn: without them it would
// not know where faces come out of each other. See docs/methods/watkins.md.

namespace ligne {
namespace {

using namespace watkins;

constexpr std::string_view kExactWord[] = {"exact"};
constexpr unsigned kMostLines = 1u << 20;

constexpr MethodParameter kParameters[] = {
    {"span-method", "NAME", "how the nearest face along a scan line is found: merge, stack, box or point", "stack",
     kSpanMethodNames, 0, 0},
    {"lines", "N|exact", "scan lines over the height of the page, or a stop at every event", "exact", kExactWord, 1,
     kMostLines},
};

void report(const SpanCounts& counts, Statistics& statistics) {
  for (const auto& [name, value] : counts.named()) statistics.count("span method: " + std::string(name), value);
}

void report(const ExactCounts& counts, Statistics& statistics) {
  statistics.count("bands", counts.bands);
  statistics.count("stops at points", counts.sweep.points);
  statistics.count("of them dangling", counts.sweep.searches);
  statistics.count("stops at crossings", counts.sweep.crossings);
  statistics.count("of them without a line", counts.sweep.hidden_crossings);
  statistics.count("longest active list", counts.sweep.most_active);
  statistics.count("stretches of lines", counts.stretches.stretches);
  statistics.count("stretches known to be hidden", counts.stretches.carried);
  statistics.count("stretches with nothing in front", counts.stretches.in_front);
  statistics.count("scan lines studied", counts.stretches.studied);
  statistics.count("line-facet tests", counts.stretches.facet_tests);
  report(counts.spans, statistics);
}

void report(const LineStudyResult& result, Statistics& statistics) {
  statistics.count("groups of lines", result.groups);
  statistics.count("scan lines", result.scan.lines);
  statistics.count("scan lines studied", result.scan.studied);
  statistics.count("of them at the beginning of a group", result.scan.studied_first);
  statistics.count("of them where edges change places", result.scan.studied_exchanges);
  statistics.count("of them where edges enter or end", result.scan.studied_ends);
  statistics.count("segments on them", result.scan.segments);
  statistics.count("edges that entered", result.scan.entered);
  statistics.count("exchanges from line to line", result.scan.exchanges);
  statistics.count("changes passed over: edges that go on", result.scan.passed_chains);
  statistics.count("changes passed over: hidden points", result.scan.passed_points);
  statistics.count("changes passed over: hidden exchanges", result.scan.passed_exchanges);
  statistics.count("edges looked at", result.tracking.positions);
  statistics.count("line-facet tests", result.tracking.facet_tests);
  report(result.span_method, statistics);
}

LineGrid grid_of(const ProjectedScene& scene, const SpanLines& lines) {
  const double step = scene.lattice.step_mm;
  LineGrid grid;
  grid.count = lines.count;
  grid.spacing = lines.spacing_mm / step;
  grid.u_origin = (scene.view.window.min.x - scene.lattice.origin_mm.x) / step;
  grid.v_origin = (lines.first_mm - scene.lattice.origin_mm.y) / step;
  return grid;
}

/// Takes facets that lie behind covers out of the list, and marks lines that do.
void leave_out_hidden(const ProjectedScene& scene, const CoverGrid& covers, std::vector<Facet>& facets,
                      std::vector<SweepLine>& lines) {
  std::vector<std::uint8_t> hidden(facets.size());
  parallel_for(facets.size(), [&](std::size_t i) { hidden[i] = covers.hides(facets[i], scene.vertices); });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    if (!hidden[i]) facets[kept++] = facets[i];
  }
  facets.resize(kept);
  parallel_for(lines.size(), [&](std::size_t i) {
    const ProjectedVertex &a = lines[i].from, &b = lines[i].to;
    lines[i].behind = covers.hides(PageSegment{{double(a.p.x), double(a.p.y), a.z}, {double(b.p.x), double(b.p.y), b.z}});
  });
}

/// What the study of the lines found, in either precision.
struct Found {
  FoundIntervals edges, intersections;
  std::vector<std::uint8_t> near;  ///< by edge; empty: any may have another one on it
};

}  // namespace

const MethodTraits& WatkinsMethod::traits() const {
  static const MethodTraits traits{
      "watkins",
      "scan lines: the nearest face by spans, visible edges tracked from stop to stop",
      kStrokes | kSpans,
      true,
      true,
      "G. S. Watkins, A real time visible surface algorithm, 1970; M. Archuleta, Hidden surface line-drawing algorithm, 1972",
      0.001,
      kParameters};
  return traits;
}

VisibilityResult WatkinsMethod::study(const ProjectedScene& scene, const StudyOptions& options) const {
  VisibilityResult result;
  Statistics& statistics = result.statistics;
  StrokeModel model;
  model.lattice = scene.lattice;
  model.edge_count = scene.source_count;
  const double step = scene.lattice.step_mm, least = kLeastPartMm / step;
  const unsigned line_count = options.settings.find("lines").value_or(kMostLines + 1);
  const bool exact = line_count > kMostLines;
  const bool find_intersections = scene.with_intersections || !exact || options.span_lines;
  Clock clock;

  // 1. Facets.
  ExactOptions exact_options;
  exact_options.kind = options.settings.choice("span-method", SpanMethodKind::stack);
  exact_options.coincidence_steps = coincidence_mm(scene) / step;
  exact_options.penetrations = find_intersections;
  exact_options.progress = options.progress;
  Facets facets = make_facets(scene, exact_options.coincidence_steps);
  statistics.count("facets", facets.facets.size());
  statistics.count("candidate edges", scene.edges.size());
  std::vector<SweepLine> lines;
  lines.reserve(scene.edges.size());
  for (const ProjectedEdge& e : scene.edges) lines.push_back({scene.vertices[e.v0], scene.vertices[e.v1], e.face0, e.face1});
  statistics.time("facets", clock.lap());

  // 2. What is surely hidden. Hidden intersections can only be found among all facets.
  std::optional<CoverGrid> covers;
  if (!(options.hidden_strokes && scene.with_intersections)) {
    covers.emplace(scene.vertices, facets.facets, exact_options.coincidence_steps + 1);
    exact_options.covers = &*covers;
    leave_out_hidden(scene, *covers, facets.facets, lines);
    statistics.count("facets before all covers", facets.facets.size());
  }
  statistics.time("covers", clock.lap());

  // 3. Edges, and pairs that penetrate.
  ExactCounts counts;
  Found found;
  std::vector<Intersection> intersections;
  ExactResult first = study_exactly(scene.vertices, facets.facets,
                                    exact ? std::span<const SweepLine>(lines) : std::span<const SweepLine>{}, exact_options);
  counts += first.counts;
  found.edges = std::move(first.found);
  found.near = std::move(first.near);
  if (find_intersections) intersections = take_intersections(first, scene.vertices, facets.facets, least);
  statistics.count("intersection segments", intersections.size());
  statistics.time("edges", clock.lap());

  // 4. Intersections; by lines, edges too.
  std::vector<SweepLine> crossed;
  for (const Intersection& i : intersections) crossed.push_back({i.from, i.to, i.face0, i.face1});
  std::vector<SweepLine> all_lines = lines;
  all_lines.insert(all_lines.end(), crossed.begin(), crossed.end());
  LineStudyOptions by_lines;
  by_lines.scan.kind = exact_options.kind;
  by_lines.coincidence_steps = exact_options.coincidence_steps;
  if (exact && scene.with_intersections && !intersections.empty()) {
    exact_options.penetrations = false;
    exact_options.progress = {};
    ExactResult r = study_exactly(scene.vertices, facets.facets, crossed, exact_options);
    counts += r.counts;
    found.intersections = std::move(r.found);
  }
  if (exact) {
    report(counts, statistics);
  } else {
    by_lines.collect_spans = (options.wanted & kSpans) != 0 && !options.span_lines;
    LineStudyResult r = study_by_lines(scene, facets.facets, all_lines, grid_of_lines(scene, line_count), by_lines);
    report(r, statistics);
    found.edges = std::move(r.found);
    found.near.clear();
    const double spacing = scene.view.window.height() / line_count;
    if (by_lines.collect_spans)
      result.spans = SpanModel{{scene.view.window.min.y + spacing / 2, spacing, line_count}, std::move(r.spans)};
  }
  statistics.time("lines", clock.lap());

  // 5. Spans.
  if (options.span_lines) {
    by_lines.track = false;
    by_lines.collect_spans = true;
    result.spans =
        SpanModel{*options.span_lines,
                  study_by_lines(scene, facets.facets, all_lines, grid_of(scene, *options.span_lines), by_lines).spans};
    statistics.time("spans", clock.lap());
  }
  if (!scene.with_intersections) {  // they have served
    intersections.clear();
    crossed.clear();
  }
  if (result.spans) statistics.count("spans", result.spans->spans.size());

  // 6. Strokes.
  // By lines what is shorter than the distance of two lines is below the resolution.
  const double shortest = exact ? least : std::max(least, grid_of_lines(scene, line_count).spacing);
  const StrokeMaker maker(scene, options.hidden_strokes);
  const auto add = [&](const SweepLine& l, const std::vector<LinePart>& visible, std::array<double, 2> range,
                       std::uint32_t source, LineClass line_class, bool may_coincide, std::vector<Stroke>& out) {
    const PageLine line(l.from, l.to, l.face0, l.face1);
    std::vector<LinePart> parts;
    if (!l.behind) parts = visible;
    drop_short_parts(parts, page_length(line), shortest);
    maker.add(line, parts, range, source, line_class, may_coincide, out);
  };
  const auto add_edge = [&](std::size_t i, OpenParts& open, std::vector<Stroke>& out) {
    if (lines[i].from.p == lines[i].to.p) return;  // seen end on
    const ProjectedEdge& edge = scene.edges[i];
    const auto thin = [&](std::uint32_t f) { return f < facets.face_is_thin.size() && facets.face_is_thin[f]; };
    const auto range = scene.edge_parts.empty() ? std::array<double, 2>{0, 1} : scene.edge_parts[i];
    const bool may_coincide = found.near.empty() || found.near[i] || thin(edge.face0) || thin(edge.face1);
    add(lines[i], found.edges.visible_parts(i, open), range, edge.source, edge.line_class, may_coincide, out);
  };
  const auto add_intersection = [&](std::size_t i, OpenParts& open, std::vector<Stroke>& out) {
    const std::vector<LinePart>& parts =
        exact ? found.intersections.visible_parts(i, open) : found.edges.visible_parts(lines.size() + i, open);
    add(crossed[i], parts, {0, 1}, scene.source_count + static_cast<std::uint32_t>(i), LineClass::intersection, true, out);
  };
  make_strokes(lines.size(), model.strokes, [&] {
    return [&, open = OpenParts()](std::size_t i, std::vector<Stroke>& out) mutable { add_edge(i, open, out); };
  });
  make_strokes(crossed.size(), model.strokes, [&] {
    return [&, open = OpenParts()](std::size_t i, std::vector<Stroke>& out) mutable { add_intersection(i, open, out); };
  });
  number_intersections(scene, intersections, model);
  statistics.time("strokes", clock.lap());
  statistics.count("strokes", model.strokes.size());
  result.strokes = std::move(model);
  return result;
}

}  // namespace ligne
