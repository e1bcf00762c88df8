#include "visibility/watkins/watkins.hpp"

#include <algorithm>
#include <chrono>
#include <string>

#include <oneapi/tbb/parallel_for.h>

#include "visibility/common/stroke_maker.hpp"
#include "visibility/tolerances.hpp"
#include "visibility/watkins/exact_study.hpp"

// Phases of the exact mode: (1) facets, (2) the scan over the edges, which also finds what penetrates, (3) the scan over the lines of
// intersection, where there are any, (4) strokes. See docs/methods/watkins.md.

namespace ligne {
namespace {

using namespace watkins;

constexpr MethodParameter kParameters[] = {
    {"span-method", "NAME", "how the nearest face along a scan line is found: merge, stack, box or point", "stack", kSpanMethodNames},
};

class Clock {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double s = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    return s;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// Runs work(i, open, strokes) for i in [0, n) in blocks; strokes come out in that order.
template <class Work>
void make_strokes(std::size_t n, std::vector<Stroke>& strokes, Work work) {
  constexpr std::size_t kBlock = 4096;
  const std::size_t blocks = (n + kBlock - 1) / kBlock;
  std::vector<std::vector<Stroke>> made(blocks);
  tbb::parallel_for(std::size_t{0}, blocks, [&](std::size_t block) {
    OpenParts open;
    for (std::size_t i = block * kBlock; i < std::min(n, (block + 1) * kBlock); ++i) work(i, open, made[block]);
  });
  for (const std::vector<Stroke>& m : made) strokes.insert(strokes.end(), m.begin(), m.end());
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
  for (const auto& [name, value] : counts.spans.named()) statistics.count("span method: " + std::string(name), value);
}

}  // namespace

const MethodTraits& WatkinsMethod::traits() const {
  static const MethodTraits traits{
      "watkins",
      "scan lines: the nearest face by spans, visible edges tracked from stop to stop",
      kStrokes,
      true,
      true,
      "G. S. Watkins, A real time visible surface algorithm, 1970; M. Archuleta, Hidden surface line-drawing algorithm, 1972",
      0.001,
      kParameters};
  return traits;
}

VisibilityResult WatkinsMethod::study(const ProjectedScene& scene, const StudyOptions& options) const {
  VisibilityResult result;
  StrokeModel model;
  model.lattice = scene.lattice;
  model.edge_count = scene.source_count;
  const double step = scene.lattice.step_mm, least = kLeastPartMm / step;
  Clock clock;

  // 1. Facets.
  ExactOptions exact;
  exact.kind = options.settings.choice("span-method", SpanMethodKind::stack);
  exact.coincidence_steps = coincidence_mm(scene) / step;
  exact.penetrations = scene.with_intersections;
  exact.progress = options.progress;
  const Facets facets = make_facets(scene, exact.coincidence_steps);
  result.statistics.time("facets", clock.lap());

  // 2. Edges.
  std::vector<SweepLine> lines;
  lines.reserve(scene.edges.size());
  for (const ProjectedEdge& e : scene.edges) lines.push_back({scene.vertices[e.v0], scene.vertices[e.v1], e.face0, e.face1});
  ExactResult edges = study_exactly(scene.vertices, facets.facets, lines, exact);
  result.statistics.time("edges", clock.lap());

  // 3. Intersections.
  std::vector<Intersection> intersections;
  ExactResult crossed;
  if (scene.with_intersections) {
    PenetrationSearch all(facets.facets, scene.vertices);
    for (PenetrationSearch& p : edges.penetrations) all.add(std::move(p));
    intersections = all.finish(least);
  }
  std::vector<SweepLine> crossed_lines;
  for (const Intersection& i : intersections) crossed_lines.push_back({i.from, i.to, i.face0, i.face1});
  if (!intersections.empty()) {
    exact.penetrations = false;
    exact.progress = {};
    crossed = study_exactly(scene.vertices, facets.facets, crossed_lines, exact);
  }
  result.statistics.time("intersections", clock.lap());

  // 4. Strokes.
  const StrokeMaker maker(scene, options.hidden_strokes);
  const auto add = [&](const ExactResult& found, std::size_t i, const SweepLine& l, OpenParts& open, std::array<double, 2> range, std::uint32_t source,
                       LineClass line_class, bool may_coincide, std::vector<Stroke>& out) {
    if (l.from.p == l.to.p) return;  // seen end on
    const PageLine line(l.from, l.to, l.face0, l.face1);
    std::vector<LinePart> parts = visible_parts(found, i, open);
    drop_short_parts(parts, page_length(line), least);
    maker.add(line, parts, range, source, line_class, may_coincide, out);
  };
  make_strokes(lines.size(), model.strokes, [&](std::size_t i, OpenParts& open, std::vector<Stroke>& out) {
    const ProjectedEdge& edge = scene.edges[i];
    const auto thin = [&](std::uint32_t f) { return f < facets.face_is_thin.size() && facets.face_is_thin[f]; };
    const auto range = scene.edge_parts.empty() ? std::array<double, 2>{0, 1} : scene.edge_parts[i];
    add(edges, i, lines[i], open, range, edge.source, edge.line_class, edges.near[i] || thin(edge.face0) || thin(edge.face1), out);
  });
  make_strokes(crossed_lines.size(), model.strokes, [&](std::size_t i, OpenParts& open, std::vector<Stroke>& out) {
    add(crossed, i, crossed_lines[i], open, {0, 1}, scene.source_count + static_cast<std::uint32_t>(i), LineClass::intersection, true, out);
  });
  number_intersections(scene, intersections, model);
  result.statistics.time("strokes", clock.lap());

  result.statistics.count("facets", facets.facets.size());
  result.statistics.count("candidate edges", scene.edges.size());
  result.statistics.count("intersection segments", intersections.size());
  ExactCounts counts = edges.counts;
  counts += crossed.counts;
  report(counts, result.statistics);
  result.statistics.count("strokes", model.strokes.size());
  result.strokes = std::move(model);
  return result;
}

}  // namespace ligne
