/// Scans by lines: states of edges, two tasks, and the scan plane that a picture shows.

#include "support/line_scans.hpp"
#include "visibility/watkins/scan_plane.hpp"

namespace ligne::watkins {
namespace {

using namespace ligne::test;

// The scan by lines as its source has it: edges tracked by their states, intersections as points, whole coordinates; and two
// tasks in place of one.

LineStudyResult by_states(const PreparedScan& p, std::uint32_t lines) {
  LineStudyOptions options = p.options(kRecognising, 50);
  options.states = true;
  return p.study(lines, options, false);
}

/// A line of the page that lies at a parameter of a candidate line.
double line_at(const PreparedScan& p, const LineGrid& grid, std::size_t line, double t) {
  const double a = grid.v(p.lines[line].from.p.y), b = grid.v(p.lines[line].to.p.y);
  return a + t * (b - a);
}

/// Ends are off by no more than a line, before the true end or, where edges run on to the line on which they are hidden,
/// behind it. A gap between two lines is missed.
/// These bodies do not touch: of edges that coincide one bounds the span, now this one, now that.
TEST(WatkinsStates, EndsAreOffByALine) {
  constexpr std::uint32_t kLines = 400;
  for (const char* name : {"cube", "house", "stair", "cyclic_3", "cyclic_5", "gear"}) {
    const PreparedScan p(corpus_scene(name), kOdd);
    const LineGrid grid = grid_of_lines(p.projected, kLines);
    const LineStudyResult found = by_states(p, kLines);
    OpenParts open;
    std::size_t parts = 0;
    for (const PartEnd end : {PartEnd::last_visible, PartEnd::first_hidden}) {
      for (std::size_t i = 0; i < p.lines.size(); ++i) {
        const std::vector<LinePart> exact = found.found.visible_parts(i, open);
        for (const LinePart& part : found.by_states.visible_parts(i, end)) {
          ++parts;
          for (const double t : {part.from, part.to}) {
            double off = 1e300;
            for (const LinePart& e : exact) off = std::min({off, std::abs(e.from - t), std::abs(e.to - t)});
            const double lines = std::abs(line_at(p, grid, i, 1) - line_at(p, grid, i, 0));
            EXPECT_LE(off * lines, 1 + 1e-6) << name << ", line " << i;
          }
        }
      }
    }
    EXPECT_GT(parts, 10u) << name;
  }
}

/// Two tasks find the spans of one that studies after every change, to the last bit. On whole coordinates corners leave
/// their planes, and a penetration without an edge is carried on by one task and studied by two; so there every line is.
TEST(WatkinsPipeline, TwoTasksFindWhatOneDoes) {
  for (const char* name : {"cube", "bricks", "house", "cross_of_plates", "lattice_of_bars_merged", "cyclic_5"}) {
    const PreparedScan p(corpus_scene(name), kOdd);
    for (const bool whole : {false, true}) {
      const LineStudyOptions one_task = p.options(whole ? kEveryLine : kCoherent, 200);
      const LineStudyResult one = p.study(600, one_task, whole);
      for (const std::uint32_t ahead : {1u, 5u, 64u, 1000u}) {
        LineStudyOptions two_tasks = one_task;
        two_tasks.ahead = ahead;
        const LineStudyResult two = p.study(600, two_tasks, whole);
        ASSERT_EQ(one.spans.size(), two.spans.size()) << name << ' ' << ahead;
        for (std::size_t i = 0; i < one.spans.size(); ++i) {
          ASSERT_EQ(one.spans[i].line, two.spans[i].line);
          ASSERT_EQ(one.spans[i].face, two.spans[i].face);
          ASSERT_EQ(one.spans[i].x_from, two.spans[i].x_from);
          ASSERT_EQ(one.spans[i].x_to, two.spans[i].x_to);
        }
        EXPECT_EQ(one.scan.lines, two.scan.lines);
        EXPECT_EQ(one.scan.studied, two.scan.studied) << name;
        EXPECT_EQ(two.scan.studied < two.scan.lines, !whole) << name;
      }
    }
  }
}

/// The points of an intersection lie on the exact line: to rounding on real coordinates, to a cell on whole ones.
TEST(WatkinsStates, PointsOfIntersectionsLieOnTheExactLines) {
  const PreparedScan exact(corpus_scene("cross_of_plates"), kOdd);
  PreparedScan p(corpus_scene("cross_of_plates"), kOdd);
  p.lines.resize(p.projected.edges.size());
  ASSERT_GT(exact.lines.size(), p.lines.size());
  for (const bool whole : {false, true}) {
    LineStudyOptions options = p.options({SpanMethodKind::stack, false, false, true}, 64);
    options.states = true;
    const LineStudyResult found = p.study(256, options, whole);
    const LineGrid grid = grid_of_lines(p.projected, 256);
    ASSERT_GT(found.places.size(), 50u);
    double farthest = 0;
    for (const PenetrationPoint& point : found.places) {
      double distance = 1e300;
      for (std::size_t i = p.lines.size(); i < exact.lines.size(); ++i) {
        const SweepLine& l = exact.lines[i];
        const double au = grid.u(l.from.p.x), av = grid.v(l.from.p.y), bu = grid.u(l.to.p.x), bv = grid.v(l.to.p.y);
        const double length = std::hypot(bu - au, bv - av);
        distance = std::min(distance, std::abs((bu - au) * (point.line - av) - (bv - av) * (point.u - au)) / length);
      }
      farthest = std::max(farthest, distance);
    }
    EXPECT_LT(farthest, whole ? 2 : 1e-3) << whole;
    EXPECT_GT(farthest, whole ? 0.05 : 0) << "corners are rounded to the grid";
  }
}

/// Through the method: on whole coordinates all ends of tracked strokes are points of the grid, by any span method, among
/// them the array of points of 2.3.2.6.
TEST(WatkinsStates, WholeCoordinatesGiveEndsOnTheGrid) {
  constexpr std::uint32_t kLines = 200;
  const PreparedScan p(corpus_scene("house"), kOdd);
  const LineGrid grid = grid_of_lines(p.projected, kLines);
  const Method& watkins = *find_method("watkins");
  for (std::size_t kind = 0; kind < kSpanMethodNames.size(); ++kind) {
    VisibilityOptions options;
    options.settings.set("lines", kLines);
    options.settings.set("span-method", ParameterWord{kind});
    options.settings.set("coordinates", ParameterWord{1});
    options.settings.set("tracking", ParameterWord{1});
    const VisibilityResult result = watkins.compute_visibility(p.projected, options);
    ASSERT_GT(result.strokes->strokes.size(), 20u) << kSpanMethodNames[kind];
    const double half_step = 0.51 / grid.spacing;
    for (const Stroke& s : result.strokes->strokes) {
      for (const LatticePoint& end : {s.from, s.to}) {
        EXPECT_NEAR(grid.u(end.x), std::round(grid.u(end.x)), half_step);
        EXPECT_NEAR(grid.v(end.y), std::round(grid.v(end.y)), half_step);
      }
    }
    if (kSpanMethodNames[kind] != "point") continue;
    const auto points =
        std::ranges::find(result.statistics.counts, "span method: points", [](const auto& c) { return c.first; });
    EXPECT_GT(points->second, 10000u) << "cells of the array, not runs between ends";
  }
}

// The scan plane that a picture shows: its runs are those of the scan, whatever the span method, and the steps of each
// method are what the source says of them.

ScanPlane plane_of(const PreparedScan& p, double y_mm, SpanMethodKind kind) {
  LineStudyOptions options;
  options.scan.kind = kind;
  options.coincidence_steps = coincidence_mm(p.projected) / p.projected.lattice.step_mm;
  return scan_plane(p.projected, p.facets.facets, p.lines, y_mm, options);
}

double depth_at(const ScanPlane::Segment& s, double x) { return s.z0 + (s.z1 - s.z0) * (x - s.x0) / (s.x1 - s.x0); }

/// Depth of the nearest facet on the page at (x, y).
double nearest_facet(const ProjectedScene& scene, double x, double y) {
  double nearest = 1e300;
  for_triangles_at(scene, (Point2(x, y) - scene.lattice.origin_mm) / scene.lattice.step_mm,
                   [&](const Triangle&, double z, double least) {
                     if (least >= 0) nearest = std::min(nearest, z);
                   });
  return nearest;
}

class ScanPlanes : public testing::TestWithParam<const char*> {};

/// Runs lie on the nearest facet, by each of the methods.
TEST_P(ScanPlanes, RunsLieOnTheNearestFace) {
  constexpr double kDepthSlackMm = 1e-4;
  const PreparedScan p(corpus_scene(GetParam()), kOdd);
  for (const double y : {71.13, 98.7, 120.37}) {
    for (const SpanMethodKind kind :
         {SpanMethodKind::merge, SpanMethodKind::stack, SpanMethodKind::box, SpanMethodKind::point}) {
      const ScanPlane plane = plane_of(p, y, kind);
      ASSERT_FALSE(plane.runs.empty());
      double last = -1e300;
      for (const ScanPlane::Run& run : plane.runs) {
        EXPECT_GE(run.x0, last);
        last = run.x1;
        const double x = (run.x0 + run.x1) / 2;
        EXPECT_NEAR(depth_at(plane.segments[run.segment], x), nearest_facet(p.projected, x, y), kDepthSlackMm);
      }
    }
  }
}

/// The current segment is the nearest; all others over that run lie on the stack.
TEST_P(ScanPlanes, TheStackHoldsAllOtherSegments) {
  const PreparedScan p(corpus_scene(GetParam()), kOdd);
  const ScanPlane plane = plane_of(p, 98.7, SpanMethodKind::stack);
  std::size_t compared = 0;
  for (const ScanPlane::Run& current : plane.bars) {
    if (current.row != 0) continue;
    const double x = (current.x0 + current.x1) / 2;
    std::vector<std::uint32_t> expected, found;
    for (std::uint32_t i = 0; i < plane.segments.size(); ++i)
      if (plane.segments[i].x0 < x && x < plane.segments[i].x1) expected.push_back(i);
    for (const ScanPlane::Run& bar : plane.bars) {
      const bool lives = plane.segments[bar.segment].x1 > x;  // ended ones may still lie there
      if (bar.x0 == current.x0 && bar.x1 == current.x1 && lives) found.push_back(bar.segment);
    }
    std::ranges::sort(found);
    EXPECT_EQ(found, expected);
    compared += expected.size();
  }
  EXPECT_GT(compared, 4u);
}

/// The last visible list of merge, and the parts of box that are not divided, are the runs.
TEST_P(ScanPlanes, StepsEndWithTheRuns) {
  const PreparedScan p(corpus_scene(GetParam()), kOdd);
  for (const SpanMethodKind kind : {SpanMethodKind::merge, SpanMethodKind::box}) {
    const ScanPlane plane = plane_of(p, 98.7, kind);
    unsigned last = 0;
    for (const ScanPlane::Run& bar : plane.bars) last = std::max(last, bar.row);
    double of_bars = 0, of_runs = 0;
    for (const ScanPlane::Run& bar : plane.bars) {
      const bool ends = kind == SpanMethodKind::merge ? bar.row == last : bar.segment != kNone;
      if (ends) of_bars += bar.x1 - bar.x0;
      if (!ends || bar.segment == kNone) continue;
      const bool is_run = std::ranges::any_of(plane.runs, [&](const ScanPlane::Run& run) {
        return run.segment == bar.segment && run.x0 <= bar.x0 && bar.x1 <= run.x1;
      });
      EXPECT_TRUE(is_run);
    }
    for (const ScanPlane::Run& run : plane.runs) of_runs += run.x1 - run.x0;
    EXPECT_NEAR(of_bars, of_runs, 1e-9 * of_runs);
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, ScanPlanes,
                         testing::Values("bricks", "house", "plate_many_holes", "penetrating_plates_with_holes",
                                         "lattice_of_bars_merged", "cyclic_5"));

}  // namespace
}  // namespace ligne::watkins
