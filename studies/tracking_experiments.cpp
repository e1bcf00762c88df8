// Experiments on scan lines as the source describes them, compared with the program: strokes tracked from line to line and
// intersections as points ([Boulle1980] 2.3.4), divisions remembered by box (2.3.3.3), and two tasks (2.3.6.3).

#include <algorithm>
#include <cmath>
#include <limits>

#include "studies/experiments.hpp"
#include "studies/measure.hpp"
#include "studies/scenes/scan_input.hpp"
#include "view/tolerances.hpp"
#include "visibility/common/clock.hpp"

namespace ligne::studies {
namespace {

using namespace watkins;

constexpr ScanOptions kStudyAll{SpanMethodKind::stack, false, false, true};
constexpr ScanOptions kStudySeen{SpanMethodKind::stack, true, true, true};

LineStudyOptions study_options(const ScanInput& input, const ScanOptions& scan) {
  return {.scan = scan, .coincidence_steps = coincidence_mm(input.scene) / input.scene.lattice.step_mm};
}

double length_mm(const ScanInput& input, const SweepLine& line) {
  return std::hypot(double(line.to.p.x) - line.from.p.x, double(line.to.p.y) - line.from.p.y) * input.scene.lattice.step_mm;
}

/// Lengths on the page, mm: of the exact visible parts, of the part that tracking misses, and of the part that it adds.
struct TrackedLengths {
  double exact = 0, missing = 0, added = 0;
};

TrackedLengths tracked_lengths(const ScanInput& input, const LineStudyResult& found, PartEnd end) {
  TrackedLengths sum;
  OpenParts open;
  for (std::size_t i = 0; i < input.lines.size(); ++i) {
    const std::vector<LinePart> exact = found.found.visible_parts(i, open), tracked = found.by_states.visible_parts(i, end);
    double of_exact = 0, of_tracked = 0, common = 0;
    for (const LinePart& e : exact) {
      of_exact += e.to - e.from;
      for (const LinePart& t : tracked) common += std::max(0.0, std::min(e.to, t.to) - std::max(e.from, t.from));
    }
    for (const LinePart& t : tracked) of_tracked += t.to - t.from;
    const double mm = length_mm(input, input.lines[i]);
    sum.exact += mm * of_exact;
    sum.missing += mm * (of_exact - common);
    sum.added += mm * (of_tracked - common);
  }
  return sum;
}

Table table_of_strokes(const StudyRequest& request, bool& finer_is_better) {
  Table table{"Strokes tracked from line to line against exact ends, lengths in mm",
              {{"scene", ColumnKind::label},
               {"lines", ColumnKind::label},
               {"thesis", ColumnKind::source},
               {"exact", ColumnKind::measure},
               {"missing", ColumnKind::measure},
               {"added, to the last line", ColumnKind::measure},
               {"added, to the next line", ColumnKind::measure},
               {"missing, whole numbers", ColumnKind::measure},
               {"seen on one line only", ColumnKind::count}}};
  for (const NamedScene& s : scan_scenes(request)) {
    const ScanInput input = make_scan_input(s);
    double before = std::numeric_limits<double>::infinity();
    for (const std::uint32_t lines : {256u, 512u, 1024u}) {
      LineStudyOptions options = study_options(input, kStudySeen);
      options.states = true;
      const auto study = [&](bool whole) {
        return study_by_lines(input.scene, input.facets, input.lines, grid_of_lines(input.scene, lines, whole), options);
      };
      const LineStudyResult real = study(false), whole = study(true);
      const TrackedLengths last = tracked_lengths(input, real, PartEnd::last_visible),
                           next = tracked_lengths(input, real, PartEnd::first_hidden),
                           of_whole = tracked_lengths(input, whole, PartEnd::last_visible);
      finer_is_better = finer_is_better && last.missing <= before;
      before = last.missing;
      table.rows.push_back({s.name, std::to_string(lines), "imprecise; better with twice the lines", last.exact,
                            last.missing, last.added, next.added, of_whole.missing, std::uint64_t{real.by_states.points()}});
    }
  }
  return table;
}

/// Distance in grid units of a point from the nearest intersection of the same two faces; infinite if there is none.
double distance_from_exact(const ScanInput& input, const LineGrid& grid, const PenetrationPoint& point) {
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = input.scene.edges.size(); i < input.lines.size(); ++i) {
    const SweepLine& l = input.lines[i];
    if (std::min(l.face0, l.face1) != point.face0 || std::max(l.face0, l.face1) != point.face1) continue;
    const double au = grid.u(l.from.p.x), av = grid.v(l.from.p.y), du = grid.u(l.to.p.x) - au, dv = grid.v(l.to.p.y) - av;
    const double square = du * du + dv * dv;
    if (!(square > 0)) continue;
    const double t = std::clamp(((point.u - au) * du + (point.line - av) * dv) / square, 0.0, 1.0);
    best = std::min(best, std::hypot(point.u - au - t * du, point.line - av - t * dv));
  }
  return best;
}

/// Points of intersection on all scan lines, and their distances from the exact lines, in distances of two scan lines.
struct PointErrors {
  std::uint64_t points = 0, of_no_line = 0;
  double mean = 0, most = 0;
};

PointErrors point_errors(const ScanInput& input, std::uint32_t lines, bool whole) {
  LineStudyOptions options = study_options(input, kStudyAll);
  options.track = false;
  options.states = true;
  const std::span<const SweepLine> edges(input.lines.data(), input.scene.edges.size());
  const LineGrid real = grid_of_lines(input.scene, lines);
  const LineStudyResult found =
      study_by_lines(input.scene, input.facets, edges, grid_of_lines(input.scene, lines, whole), options);
  PointErrors errors{found.places.size()};
  for (const PenetrationPoint& point : found.places) {
    const double distance = distance_from_exact(input, real, point);
    if (!std::isfinite(distance)) {
      ++errors.of_no_line;
      continue;
    }
    errors.mean += distance;
    errors.most = std::max(errors.most, distance);
  }
  errors.mean /= double(std::max<std::uint64_t>(1, errors.points - errors.of_no_line));
  return errors;
}

Table table_of_points(const StudyRequest& request) {
  const std::uint32_t lines = request.pick(128u, 512u);
  Table table{"Intersections as a point on each of " + std::to_string(lines) +
                  " lines; distances from the exact line in distances of two lines",
              {{"scene", ColumnKind::label},
               {"thesis", ColumnKind::source},
               {"exact segments", ColumnKind::count},
               {"points", ColumnKind::count},
               {"points of pairs without a line", ColumnKind::count},
               {"mean distance", ColumnKind::measure},
               {"greatest distance", ColumnKind::measure},
               {"points, whole", ColumnKind::count},
               {"mean distance, whole", ColumnKind::measure},
               {"greatest distance, whole", ColumnKind::measure}}};
  for (const NamedScene& s : scan_scenes(request)) {
    const ScanInput input = make_scan_input(s);
    const PointErrors real = point_errors(input, lines, false), whole = point_errors(input, lines, true);
    table.rows.push_back({s.name, "a very poor drawing", std::uint64_t{input.lines.size() - input.scene.edges.size()},
                          real.points, real.of_no_line, real.mean, real.most, whole.points, whole.mean, whole.most});
  }
  return table;
}

}  // namespace

Result study_tracking(const StudyRequest& request) {
  Result result;
  bool finer_is_better = true;
  result.tables.push_back(table_of_strokes(request, finer_is_better));
  result.tables.push_back(table_of_points(request));
  result.finding = finer_is_better ? Finding::holds : Finding::in_part;
  result.sentence =
      "Strokes that end at lines miss what lies before the first and behind the last line of an edge, and horizontal edges "
      "altogether; twice the lines halve it. Points of an intersection lie on its line, but only where lines of the page are: "
      "flat lines of intersection fall apart, and on whole numbers the points leave the line.";
  return result;
}

Result study_remembered(const StudyRequest& request) {
  Table table{"Box: divisions of the line before, against dividing anew",
              {{"scene", ColumnKind::label},
               {"lines", ColumnKind::label},
               {"studied", ColumnKind::label},
               {"thesis", ColumnKind::source},
               {"parts, anew", ColumnKind::count},
               {"parts, remembered", ColumnKind::count},
               {"divisions remembered", ColumnKind::count},
               {"operations, anew", ColumnKind::count},
               {"operations, remembered", ColumnKind::count},
               {"operations, remembered over anew", ColumnKind::measure},
               {"time, remembered over anew", ColumnKind::time}}};
  bool fewer = true;
  const std::vector<std::uint32_t> numbers =
      request.full() ? std::vector<std::uint32_t>{512, 4096} : std::vector<std::uint32_t>{256};
  for (const NamedScene& s : scan_scenes(request)) {
    const ScanInput input = make_scan_input(s);
    for (const std::uint32_t lines : numbers) {
      for (const bool coherent : {false, true}) {
        const auto cost = [&](SpanMethodKind kind) {
          return scan_cost(input, lines, false, {kind, coherent, coherent, true}, request.pick(1, 2));
        };
        const ScanCost anew = cost(SpanMethodKind::box), remembered = cost(SpanMethodKind::remembered);
        fewer = fewer && remembered.spans.total() <= anew.spans.total();
        table.rows.push_back({s.name, std::to_string(lines), coherent ? "visible changes" : "every line",
                              "proposed, not measured", anew.spans.boxes, remembered.spans.boxes,
                              remembered.spans.remembered, anew.spans.total(), remembered.spans.total(),
                              double(remembered.spans.total()) / double(anew.spans.total()),
                              times_as_long(remembered.seconds, anew.seconds)});
      }
    }
  }
  Result result;
  result.tables.push_back(std::move(table));
  result.finding = fewer ? Finding::holds : Finding::in_part;
  result.sentence =
      "The divisions of the line before spare the parts that are only studied to be divided: under half of the parts are left, "
      "and about half of the operations, on every scene.";
  return result;
}

Result study_two_tasks(const StudyRequest& request) {
  const std::uint32_t lines = request.pick(512u, 4096u);
  Table table{std::to_string(lines) + " lines: one task prepares the segments, one studies",
              {{"scene", ColumnKind::label},
               {"groups", ColumnKind::label},
               {"lines ahead", ColumnKind::label},
               {"thesis", ColumnKind::source},
               {"lines studied", ColumnKind::count},
               {"segments", ColumnKind::count},
               {"ms, preparing", ColumnKind::time},
               {"ms, studying", ColumnKind::time},
               {"bound of the gain", ColumnKind::time},
               {"ms, one task", ColumnKind::time},
               {"ms, two tasks", ColumnKind::time},
               {"ms, groups, visible changes", ColumnKind::time}}};
  for (const NamedScene& s : scan_scenes(request)) {
    const ScanInput input = make_scan_input(s);
    const LineGrid grid = grid_of_lines(input.scene, lines);
    const auto timed = [&](const LineStudyOptions& options, LineStudyResult& found) {
      Clock clock;
      found = study_by_lines(input.scene, input.facets, input.lines, grid, options);
      return 1e3 * clock.lap();
    };
    for (const std::uint32_t groups : {1u, 8u}) {
      LineStudyOptions options = study_options(input, {SpanMethodKind::stack, true, false, true});
      options.group = lines / groups;
      LineStudyResult found;
      const double one_task = timed(options, found);
      LineStudyOptions visible = study_options(input, kStudySeen);
      const double by_groups = timed(visible, found);
      for (const std::uint32_t ahead : {1u, 16u, 128u}) {
        options.ahead = ahead;
        const double two_tasks = timed(options, found);
        const double preparing = 1e3 * found.pipeline.preparing, studying = 1e3 * found.pipeline.studying;
        table.rows.push_back({s.name, std::to_string(groups), std::to_string(ahead), "uses coherence; more communication",
                              found.scan.studied, found.scan.segments, preparing, studying,
                              (preparing + studying) / std::max({preparing, studying, 1e-9}), one_task, two_tasks,
                              by_groups});
      }
    }
  }
  Result result;
  result.tables.push_back(std::move(table));
  result.finding = Finding::in_part;
  result.sentence =
      "Two tasks keep the coherence of the whole page and find the same lines, but the one that prepares does not know what is "
      "visible, so it asks for more studies; handing over line by line costs more than it gains, and groups gain more on any "
      "number of threads.";
  return result;
}

}  // namespace ligne::studies
