#include "contours/contour_strokes.hpp"

#include <algorithm>

#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "contours/contour_junctions.hpp"
#include "contours/contour_sights.hpp"
#include "contours/surfaces/outline_evidence.hpp"
#include "contours/surfaces/outline_probes.hpp"

namespace ligne {
namespace {

/// Ends are moved to the line that they meet by so many widths of the pen.
constexpr double kReachInPens = 2;

/// Adjustable: contours are hidden or seen with the mesh's outline beside them where that is so for more than so many times
/// as long. On rough meshes less is hidden by a hair.
constexpr double kTestifiedInReaches = 8;

}  // namespace

ContourSources draw_contours(StrokeModel& model, const Scene& scene, const View& view, const SmoothContours& contours,
                             bool hidden_too, const ContourOptions& options) {
  if (contours.empty()) return {};
  const std::vector<Stroke> edges = take_strokes(model, contours.first_edge, contours.replaced.size());
  const std::vector<Stroke> probes = take_strokes(model, contours.first_probe, contours.replaced.size());
  const std::size_t n = contours.chains.size();
  const std::uint32_t first = n > 0 ? contours.first_source.front() : contours.first_probe;
  const std::vector<Stroke> strokes = take_strokes(model, first, contours.first_probe - first);
  const double reach_mm = kReachInPens * options.pen_width_mm;
  std::vector<SeenContour> seen(n);
  parallel_blocks(n, kChainsPerTask, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      seen[c].curve = contour_curve(scene, view, contours.chains[c], kCurveFlatnessMm);
      seen[c].runs = runs_of(strokes, contours.first_source[c], contours.chains[c].size(), hidden_too);
      for (std::size_t i = 0; i < contours.chains[c].size(); ++i) {
        const std::vector<ContourNode>& nodes = contours.chains[c].nodes;
        seen[c].beside_mm.push_back(std::max(nodes[i].most_mm, nodes[i + 1].most_mm));
      }
      drop_short_runs(seen[c].runs, seen[c].curve, options.pen_width_mm);
    }
  });
  hold_against_outlines(seen, contours, view, model.lattice, edges, {kTestifiedInReaches * reach_mm, options.pen_width_mm});
  move_ends_of_contours(seen, model, reach_mm);
  for (SeenContour& contour : seen) drop_short_runs(contour.runs, contour.curve, options.pen_width_mm);
  add_missing_outlines(model, view, contours, probes, seen, {options.pen_width_mm, reach_mm});
  move_ends_of_strokes(model, seen, reach_mm);
  join_tangents_to_contours(model, scene, view, contours, seen);
  CurveWriter writer(model, view, hidden_too, reach_mm);
  for (std::size_t c = 0; c < n; ++c) {
    const ContourChain& chain = contours.chains[c];
    writer.add(LineClass::outline, chain.size(), contours.first_source[c], seen[c].curve, seen[c].runs, [&](std::size_t i) {
      return SourceEdge{{chain.nodes[i].on_mesh, chain.nodes[i + 1].on_mesh}, {contours.faces[c][i], kNone}, false};
    });
  }
  ContourSources sources = writer.take_sources();
  for (const Stroke& probe : probes) {
    if (!probe.visible) continue;
    const auto& ends = contours.replaced[probe.source - contours.first_probe].ends;
    const auto place = [&](double t) { return page_point(view, ends[0] + t * (ends[1] - ends[0])); };
    sources.replaced.push_back({place(probe.t_from), place(probe.t_to)});
  }
  return sources;
}

}  // namespace ligne
