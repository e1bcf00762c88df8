// The scan plane that a picture shows: its runs are those of the scan, whatever the span method, and the steps of each
// method are what the source says of them.

#include "visibility/watkins/scan_plane.hpp"
#include "support/line_scans.hpp"

namespace ligne::watkins {
namespace {

using namespace ligne::test;

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
  for (const Triangle& t : scene.triangles) {
    Point3 p[3];
    for (int k = 0; k < 3; ++k) {
      const Point2 q = scene.lattice.to_mm(scene.vertices[t.v[k]].p);
      p[k] = {q.x, q.y, scene.vertices[t.v[k]].z};
    }
    const double area = cross(Point2(p[1]) - Point2(p[0]), Point2(p[2]) - Point2(p[0]));
    if (area == 0) continue;
    const double b = cross(Point2(x, y) - Point2(p[0]), Point2(p[2]) - Point2(p[0])) / area;
    const double c = cross(Point2(p[1]) - Point2(p[0]), Point2(x, y) - Point2(p[0])) / area;
    if (b < 0 || c < 0 || b + c > 1) continue;
    nearest = std::min(nearest, p[0].z + b * (p[1].z - p[0].z) + c * (p[2].z - p[0].z));
  }
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
