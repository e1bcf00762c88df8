#include "visibility/watkins/exact/line_study.hpp"

#include <algorithm>
#include <array>

#include "base/parallel.hpp"
#include "visibility/common/clock.hpp"

namespace ligne::watkins {
namespace {

/// Collects the spans of every line, and passes the lines to the trackers.
class Collector final : public LineListener {
 public:
  Collector(EdgeTracker* tracker, StateTracker* states, const ProjectedScene& scene, bool spans)
      : tracker_(tracker), states_(states), scene_(scene), collect_(spans) {}

  void line(const LineScan& scan, std::uint32_t line, bool studied) override {
    if (tracker_) tracker_->line(scan, line, studied);
    if (states_) states_->line(scan, line, studied);
    if (!collect_) return;
    const LineGrid& grid = scan.scene().grid;
    const Rect& window = scene_.view.window;  // faces extend slightly beyond the window
    const auto mm = [&](double u) {
      return std::clamp(scene_.lattice.origin_mm.x + grid.x(u) * scene_.lattice.step_mm, window.min.x, window.max.x);
    };
    for (const LineSpan& s : scan.spans()) {
      const double from = mm(s.u0), to = mm(s.u1);
      if (from < to) spans.push_back({line, from, to, s.face});
    }
  }
  void ended(const LineScan& scan, std::uint32_t slot) override {
    if (tracker_) tracker_->ended(scan, slot);
  }
  void hidden_point(const LineScan& scan, std::uint32_t slot, std::uint32_t face) override {
    if (tracker_) tracker_->hidden_point(scan, slot, face);
  }

  std::vector<Span> spans;

 private:
  EdgeTracker* tracker_;
  StateTracker* states_;
  const ProjectedScene& scene_;
  bool collect_;
};

struct GroupResult {
  std::vector<Finding> findings;
  std::vector<Span> spans;
  std::vector<TrackedPart> parts;
  std::vector<PenetrationPoint> points;
  ScanCounts scan;
  SpanCounts span_method;
  TrackCounts tracking;
  PipelineTimes pipeline;
};

void join_groups(std::vector<GroupResult>& groups, const ScanScene& scene, std::size_t line_count, LineStudyResult& result) {
  std::vector<std::vector<Finding>> findings;
  for (GroupResult& r : groups) {
    findings.push_back(std::move(r.findings));
    result.spans.insert(result.spans.end(), r.spans.begin(), r.spans.end());
    result.places.insert(result.places.end(), r.points.begin(), r.points.end());
    result.scan += r.scan;
    result.span_method += r.span_method;
    result.tracking += r.tracking;
    result.pipeline.preparing += r.pipeline.preparing;
    result.pipeline.studying += r.pipeline.studying;
  }
  result.found = FoundIntervals(findings, line_count);
  result.points = marks_of_points(result.places, scene);
  result.curves = curves_of_points(result.places, scene);
}

void join_parts(std::vector<GroupResult>& groups, std::size_t line_count, LineStudyResult& result) {
  std::vector<std::vector<TrackedPart>> parts;
  parts.reserve(groups.size());
  for (GroupResult& r : groups) parts.push_back(std::move(r.parts));
  result.by_states = TrackedParts(parts, line_count);
}

}  // namespace

LineGrid grid_of(const ProjectedScene& scene, const SpanLines& lines, bool whole) {
  const double step = scene.lattice.step_mm;
  return {.u_origin = (scene.view.window.min.x - scene.lattice.origin_mm.x) / step,
          .v_origin = (lines.first_mm - scene.lattice.origin_mm.y) / step,
          .spacing = lines.spacing_mm / step,
          .count = lines.count,
          .whole = whole};
}

LineGrid grid_of_lines(const ProjectedScene& scene, std::uint32_t count, bool whole) {
  const Rect& window = scene.view.window;
  LineGrid grid{.u_origin = (window.min.x - scene.lattice.origin_mm.x) / scene.lattice.step_mm,
                .spacing = window.height() / scene.lattice.step_mm / count,
                .count = count,
                .whole = whole};
  grid.v_origin = (window.min.y - scene.lattice.origin_mm.y) / scene.lattice.step_mm + grid.spacing / 2;
  return grid;
}

LineStudyResult study_by_lines(const ProjectedScene& scene, const std::vector<Facet>& facets,
                               std::span<const SweepLine> lines, const LineGrid& grid, const LineStudyOptions& options) {
  constexpr std::uint32_t kGroups = 32, kFewestLines = 16;
  const ScanScene scan_scene = make_scan_scene(scene, facets, lines, grid, options.coincidence_steps, options.skew);
  const std::uint32_t size =
      options.group > 0 ? options.group : std::max(kFewestLines, (grid.count + kGroups - 1) / kGroups);
  const std::uint32_t groups = (grid.count + size - 1) / size;
  ScanOptions scan_options = options.scan;
  if (options.ahead > 0) scan_options.recognise = false;
  std::vector<GroupResult> results(groups);
  parallel_tasks(groups, [&](std::size_t task) {
    const auto g = static_cast<std::uint32_t>(task);
    EdgeTracker tracker(scene.vertices, facets, scan_scene, lines, options.coincidence_steps);
    StateTracker states(lines);
    Collector collector(options.track ? &tracker : nullptr, options.states ? &states : nullptr, scene,
                        options.collect_spans);
    LineScan scan(scan_scene, scene.vertices, facets, lines, scan_options, collector);
    GroupResult& result = results[g];
    const std::uint32_t first = g * size, end = std::min(grid.count, (g + 1) * size);
    if (options.ahead > 0) {
      LineScan preparing(scan_scene, scene.vertices, facets, lines, scan_options, collector);
      result.pipeline = scan_in_two_tasks(preparing, scan, first, end, options.ahead);
      result.scan = preparing.counts();
      result.span_method.swaps = preparing.span_counts().swaps;
    } else {
      scan.scan(first, end);
    }
    result.scan += scan.counts();
    result.span_method += scan.span_counts();
    result.findings = tracker.findings();
    result.spans = std::move(collector.spans);
    result.parts = states.take_parts();
    result.points = states.points();
    result.tracking = tracker.counts();
  });
  LineStudyResult result;
  result.groups = groups;
  join_groups(results, scan_scene, lines.size(), result);
  if (options.states) join_parts(results, lines.size(), result);
  return result;
}

void report(const LineStudyResult& result, Statistics& statistics) {
  statistics.count("groups of lines", result.groups);
  statistics.count("scan lines", result.scan.lines);
  statistics.count("scan lines studied", result.scan.studied);
  statistics.count("of these, at the beginning of a group", result.scan.studied_first);
  statistics.count("of these, where edges are exchanged", result.scan.studied_exchanges);
  statistics.count("of these, where edges enter or end", result.scan.studied_ends);
  statistics.count("segments on them", result.scan.segments);
  statistics.count("edges that entered", result.scan.entered);
  statistics.count("exchanges of edges between lines", result.scan.exchanges);
  statistics.count("changes skipped: continued edges", result.scan.passed_chains);
  statistics.count("changes skipped: hidden points", result.scan.passed_points);
  statistics.count("changes skipped: hidden exchanges", result.scan.passed_exchanges);
  statistics.count("edges examined", result.tracking.positions);
  statistics.count("line-facet tests", result.tracking.facet_tests);
  report(result.span_method, statistics);
}

void LineScan::begin_preparing(std::uint32_t first) {
  any_slot_ = make_slot(scene_.unlisted, {});
  begin(first);
}

/// Segments are made on every line, since the second task may have to study a line after a penetration without an edge.
void LineScan::prepare(std::uint32_t line, PreparedLine& out) {
  out.line = line;
  out.first = must_study_;
  advance_edges(line);
  out.exchanged = sort(line);
  out.study = out.first || opens_ || !options_.coherence || out.exchanged || changes_matter(line);
  must_study_ = false;
  with_segments([this](auto&, auto& segments) { collect_segments(segments); });
  out.whole_segments = whole_segments_;
  out.real_segments = real_segments_;
  if (out.study) opens_ = has_opening();
  out.slots = slots_;
  out.order = order_;
  out.gone = gone_;
  out.ended_edges.swap(ended_edges_);
  ended_edges_.clear();
  out.ends = ends_;
  for (const std::uint32_t slot : gone_) free_slots_.push_back(slot);
}

void LineScan::begin_studying(std::uint32_t first) {
  any_slot_ = make_slot(scene_.unlisted, {});
  begin(first);
  prepared_ = true;
}

void LineScan::study_prepared(PreparedLine& prepared) {
  const bool study = prepared.study || must_study_ || !penetrating_.empty();
  if (!study) {  // the list is that of the line before, and so are the edges that bound spans
    for (const std::uint32_t slot : prepared.order) {
      ActiveEdge& now = prepared.slots[slot];
      const ActiveEdge& before = slots_[slot];
      now.boundary = before.boundary;
      now.before = before.before;
      now.after = before.after;
    }
  }
  slots_.swap(prepared.slots);
  order_.swap(prepared.order);
  ended_edges_.swap(prepared.ended_edges);
  for (const std::uint32_t slot : prepared.gone) listener_.ended(*this, slot);
  if (study) {
    ends_.swap(prepared.ends);
    real_segments_.swap(prepared.real_segments);
    whole_segments_.swap(prepared.whole_segments);
    with_segments([this](auto& method, auto& segments) { study_segments(method, segments); });
    count_study(prepared.first, prepared.exchanged);
  } else {
    follow_edges();
  }
  if (!order_.empty()) ++counts_.lines;
  listener_.line(*this, prepared.line, study);
}

void LineScan::finish_studying() {
  for (const std::uint32_t slot : order_) listener_.ended(*this, slot);
}

PipelineTimes scan_in_two_tasks(LineScan& preparing, LineScan& studying, std::uint32_t first, std::uint32_t end,
                                std::uint32_t ahead) {
  PipelineTimes times;
  std::array<std::vector<PreparedLine>, 2> batches;
  std::uint32_t next = first;
  const auto prepare = [&](std::vector<PreparedLine>& batch) {
    Clock clock;
    batch.resize(std::min(ahead, end - next));
    for (PreparedLine& line : batch) preparing.prepare(next++, line);
    times.preparing += clock.lap();
  };
  const auto study = [&](std::vector<PreparedLine>& batch) {
    Clock clock;
    for (PreparedLine& line : batch) studying.study_prepared(line);
    times.studying += clock.lap();
  };
  preparing.begin_preparing(first);
  studying.begin_studying(first);
  prepare(batches[0]);
  for (std::size_t now = 0; !batches[now].empty(); now = 1 - now) {
    parallel_tasks(2, [&](std::size_t task) { task == 0 ? study(batches[now]) : prepare(batches[1 - now]); });
  }
  studying.finish_studying();
  return times;
}

}  // namespace ligne::watkins
