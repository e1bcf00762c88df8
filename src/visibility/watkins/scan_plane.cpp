#include "visibility/watkins/scan_plane.hpp"

#include <algorithm>

namespace ligne::watkins {
namespace {

/// Stores the result of the study of its only line. Grid units are page mm.
class PlaneKeeper final : public LineListener {
 public:
  PlaneKeeper(ScanPlane& plane, const SpanTrace& trace) : plane_(plane), trace_(trace) {}

  void line(const LineScan& scan, std::uint32_t, bool) override {
    for (const ScanSegment<double>& s : scan.segments())
      plane_.segments.push_back({s.x0, s.z0, s.x1, s.z1, scan.face_of(s)});
    for (const SpanTrace::Bar& bar : trace_.bars) plane_.bars.push_back({bar.x0, bar.x1, bar.row, bar.segment});
    for (const LineSpan& span : scan.spans()) keep_run(span, scan);
  }

 private:
  void keep_run(const LineSpan& span, const LineScan& scan) {
    const auto& segments = scan.segments();
    const auto found = std::ranges::find_if(segments, [&](const ScanSegment<double>& s) {
      return scan.face_of(s) == span.face && s.x0 <= span.u0 && span.u1 <= s.x1;
    });
    if (found != segments.end())
      plane_.runs.push_back({span.u0, span.u1, 0, static_cast<std::uint32_t>(found - segments.begin())});
  }

  ScanPlane& plane_;
  const SpanTrace& trace_;
};

}  // namespace

ScanPlane scan_plane(const ProjectedScene& scene, const std::vector<Facet>& facets, std::span<const SweepLine> lines,
                     double y_mm, const LineStudyOptions& options) {
  const double step = scene.lattice.step_mm;
  LineGrid grid;
  grid.spacing = 1 / step;  // one mm per grid unit
  grid.u_origin = -scene.lattice.origin_mm.x / step;
  grid.v_origin = (y_mm - scene.lattice.origin_mm.y) / step;
  const ScanScene scan_scene = make_scan_scene(scene, facets, lines, grid, options.coincidence_steps, options.skew);
  ScanPlane plane;
  plane.y_mm = y_mm;
  plane.kind = static_cast<std::uint8_t>(options.scan.kind);
  SpanTrace trace;
  ScanOptions with_trace = options.scan;
  with_trace.trace = &trace;
  PlaneKeeper keeper(plane, trace);
  LineScan(scan_scene, scene.vertices, facets, lines, with_trace, keeper).scan(0, 1);
  return plane;
}

}  // namespace ligne::watkins
