#include "contours/contour_strokes.hpp"

#include <algorithm>

#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "contours/contour_junctions.hpp"
#include "contours/contour_sights.hpp"
#include "contours/surfaces/outline_evidence.hpp"
#include "contours/surfaces/outline_probes.hpp"
#include "contours/tangent_joints.hpp"

namespace ligne {
namespace {

/// Ends are moved to the line that they meet by so many widths of the pen.
constexpr double kReachInPens = 2;

/// Adjustable: contours are hidden or seen with the mesh's outline beside them where that is so for more than so many times
/// as long. On rough meshes less is hidden by a hair.
constexpr double kTestifiedInReaches = 8;

/// Adjustable: a contour is hidden where its surface bends to the other side than where so many times as much of it is seen.
constexpr double kMostlyTimes = 4;

/// Calls visit(segment, from, to) for the visible parts of the segments of a chain.
template <class Visit>
void for_visible_parts(const ContourChain& chain, const std::vector<ContourRun>& runs, const Visit& visit) {
  for (const ContourRun& run : runs) {
    if (run.state < 0) continue;
    for (auto i = static_cast<std::size_t>(run.from); i < chain.size() && static_cast<double>(i) < run.to; ++i) {
      const auto at = static_cast<double>(i);
      visit(i, std::max(run.from, at), std::min(run.to, at + 1));
    }
  }
}

/// A surface that bends towards the viewer along the sight hides its own contour, whatever the mesh says. The body may be
/// inside out, so the side to which most of the contour bends that is seen tells which side is meant.
void hide_by_surfaces(const ContourChain& chain, const ContourCurve& curve, std::vector<ContourRun>& runs) {
  double seen[2] = {0, 0};  // lengths where the surface bends towards its normal, and away from it
  for_visible_parts(chain, runs, [&](std::size_t i, double from, double to) {
    const int bend = chain.nodes[i].bend_ahead;
    if (bend != 0) seen[bend > 0] += curve.point_at(to).length - curve.point_at(from).length;
  });
  const int hollow = seen[1] >= seen[0] ? -1 : 1;
  if (std::min(seen[0], seen[1]) == 0 || std::min(seen[0], seen[1]) * kMostlyTimes > std::max(seen[0], seen[1])) return;
  std::vector<ContourRun> hidden;
  for_visible_parts(chain, runs, [&](std::size_t i, double from, double to) {
    if (chain.nodes[i].bend_ahead == hollow) hidden.push_back({from, to, kHiddenState});
  });
  put_in(runs, hidden);
}

/// Directions on the page from the segments of a chain away from the body.
std::vector<Point2> free_sides_of(const ContourChain& chain, const std::vector<int>& sides, const View& view) {
  std::vector<Point2> found(chain.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    const ContourNode &a = chain.nodes[i], &b = chain.nodes[i + 1];
    found[i] = double(sides[i]) * (page_direction(view, a.on_mesh, a.normal) + page_direction(view, b.on_mesh, b.normal));
  }
  return found;
}

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
      seen[c].sides = contours.sides[c];
      if (contours.chains[c].on_surface) seen[c].free_sides = free_sides_of(contours.chains[c], contours.sides[c], view);
      for (std::size_t i = 0; i < contours.chains[c].size(); ++i) {
        const std::vector<ContourNode>& nodes = contours.chains[c].nodes;
        seen[c].beside_mm.push_back(std::max(nodes[i].most_mm, nodes[i + 1].most_mm));
      }
      hide_by_surfaces(contours.chains[c], seen[c].curve, seen[c].runs);
      drop_short_runs(seen[c].runs, seen[c].curve, options.pen_width_mm);
    }
  });
  hold_against_outlines(seen, contours, view, model.lattice, edges, {kTestifiedInReaches * reach_mm, options.pen_width_mm});
  move_ends_of_contours(seen, model, reach_mm);
  parallel_blocks(n, kChainsPerTask, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      hide_by_surfaces(contours.chains[c], seen[c].curve, seen[c].runs);
      drop_short_runs(seen[c].runs, seen[c].curve, options.pen_width_mm);
    }
  });
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
  return writer.take_sources();
}

}  // namespace ligne
