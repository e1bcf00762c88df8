#include "contours/contour_strokes.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "contours/contour_junctions.hpp"
#include "contours/contour_support.hpp"
#include "contours/surfaces/outline_probes.hpp"
#include "geometry/nearest_on_segment.hpp"

namespace ligne {
namespace {

/// Lengths on the page, mm. Parts up to `shortest_mm` long do not change, except visible parts longer than `clear_mm`
/// without a visible edge within ContourNode::most_mm plus `clear_mm`.
struct EvidenceSizes {
  double shortest_mm, clear_mm;
};

constexpr double kEvidenceCellMm = 1;
/// Step at which contours are compared with the outlines, mm.
constexpr double kEvidenceStepMm = 1;
/// Largest distance of an edge that is evidence, mm. The sag on the page is larger only where the eye is right before
/// the mesh.
constexpr double kMostReachMm = 10;
/// Largest number of steps on one segment of a contour. Only segments right before the eye are longer.
constexpr double kMostSteps = 1000;

/// Visibility of the outline beside a contour, the weakest evidence first. `hollow`: hidden at a concave edge, where
/// the mesh hides its own outline by a hair.
enum class Evidence : std::uint8_t { none, hollow, hidden, seen };

/// Lines on the page, each with its evidence.
class PagePieces {
 public:
  explicit PagePieces(const Lattice& lattice) : finder_(lattice, kEvidenceCellMm) {}

  void expect_within(const Rect& box) { finder_.expect_within(box); }
  void add(Point2 from, Point2 to, Evidence evidence) {
    finder_.add({from, to, 0, 0, static_cast<std::uint32_t>(evidence)});
  }
  /// The strongest evidence within `reach` of p.
  Evidence at(Point2 p, double reach) const {
    auto strongest = static_cast<std::uint32_t>(Evidence::none);
    finder_.any_near(p, p, reach, [&](const OutlineSegment& s) {
      if (s.chain > strongest && s.may_reach(p, reach) && squared_distance(p, s.from, s.to) <= reach * reach)
        strongest = s.chain;
      return strongest == static_cast<std::uint32_t>(Evidence::seen);
    });
    return static_cast<Evidence>(strongest);
  }

 private:
  SegmentFinder finder_;  ///< OutlineSegment::chain stores the evidence
};

/// A part of a run, and the place at which it is compared with the outlines.
struct Part {
  double from, to;  ///< as CurvePoint::at
  Point2 middle;
  double reach;
  double length;
};

std::vector<Part> parts_of_run(const ContourRun& run, const ContourCurve& curve, const ContourChain& chain) {
  std::vector<Part> parts;
  for (double from = run.from; from < run.to;) {
    const double segment = std::min(std::floor(from), double(chain.size() - 1));
    const double end = std::min(run.to, segment + 1);
    const double length = curve.point_at(end).length - curve.point_at(from).length;
    const auto steps = static_cast<int>(std::ceil(std::clamp(length / kEvidenceStepMm, 1.0, kMostSteps)));
    const auto i = static_cast<std::size_t>(segment);
    const double reach = std::min(kMostReachMm, std::max(chain.nodes[i].most_mm, chain.nodes[i + 1].most_mm));
    for (int k = 0; k < steps; ++k) {
      const auto at = [&](double step) { return from + step / steps * (end - from); };
      parts.push_back({at(k), k + 1 == steps ? end : at(k + 1), curve.point_at(at(k + 0.5)).mm, reach, length / steps});
    }
    from = end;
  }
  return parts;
}

/// The longest possible sequences of parts that satisfy the predicate, if longer than `shortest_mm`, as runs of the
/// given state.
template <class Predicate>
std::vector<ContourRun> rows(std::span<const Part> parts, double shortest_mm, int state, const Predicate& holds) {
  std::vector<ContourRun> found;
  double length = 0;
  bool open = false;
  const auto finish = [&] {
    if (open && length <= shortest_mm) found.pop_back();
    open = false;
  };
  for (const Part& part : parts) {
    if (!holds(part)) {
      finish();
      continue;
    }
    if (!open) {
      found.push_back({part.from, part.to, state});
      length = 0;
      open = true;
    }
    found.back().to = part.to;
    length += part.length;
  }
  finish();
  return found;
}

/// The parts of a visible run that the outlines show to be hidden: parts longer than `shortest_mm` beside hidden
/// outlines. If there are none: parts longer than `clear_mm` that have an outline within reach, and no visible one
/// within `clear_mm` more.
std::vector<ContourRun> hidden_parts(std::span<const Part> parts, const PagePieces& outlines, double shortest_mm,
                                     double clear_mm) {
  double all = 0, unseen = 0;
  bool any_seen = false;
  std::vector<Evidence> within_reach;  // by part
  for (const Part& part : parts) {
    const Evidence evidence = within_reach.emplace_back(outlines.at(part.middle, part.reach));
    any_seen |= evidence == Evidence::seen;
    all += part.length;
    if (evidence == Evidence::hollow || evidence == Evidence::hidden) unseen += part.length;
  }
  const auto evidence_of = [&](const Part& part) { return within_reach[static_cast<std::size_t>(&part - parts.data())]; };
  // If no outline beside the run is visible, hidden concave edges count too.
  if (!any_seen && 2 * unseen > all) return {{parts.front().from, parts.back().to, kHiddenState}};
  std::vector<ContourRun> found =
      rows(parts, shortest_mm, kHiddenState, [&](const Part& part) { return evidence_of(part) == Evidence::hidden; });
  if (!found.empty()) return found;
  return rows(parts, clear_mm, kHiddenState, [&](const Part& part) {
    return evidence_of(part) != Evidence::none && outlines.at(part.middle, part.reach + clear_mm) < Evidence::seen;
  });
}

/// Per contour and run: the parts of the run. It holds either the visible runs or the hidden ones.
using PartsOfRuns = std::vector<std::vector<std::vector<Part>>>;

PartsOfRuns parts_of_runs(const std::vector<SeenContour>& seen, const SmoothContours& contours, bool visible) {
  PartsOfRuns parts(seen.size());
  parallel_tasks(seen.size(), [&](std::size_t c) {
    for (const ContourRun& run : seen[c].runs) {
      const bool asked = visible ? run.state >= 0 : run.state == kHiddenState;
      if (asked && run.from < run.to) parts[c].push_back(parts_of_run(run, seen[c].curve, contours.chains[c]));
    }
  });
  return parts;
}

/// Overwrites parts of runs with the runs that find(parts of a run) returns.
template <class Find>
void change_runs(std::vector<SeenContour>& seen, const PartsOfRuns& parts, const Find& find) {
  parallel_tasks(seen.size(), [&](std::size_t c) {
    std::vector<ContourRun> changed;
    for (const std::vector<Part>& of_run : parts[c]) {
      const std::vector<ContourRun> found = find(of_run);
      changed.insert(changed.end(), found.begin(), found.end());
    }
    if (!changed.empty()) put_in(seen[c].runs, changed);
  });
}

/// Adds the replaced edges, each part with its visibility. `edges`: the strokes of these edges.
void add_outlines(PagePieces& outlines, const SmoothContours& contours, const View& view, const Lattice& lattice,
                  const std::vector<Stroke>& edges) {
  auto stroke = edges.begin();
  for (std::size_t k = 0; k < contours.replaced.size(); ++k) {
    const auto& ends = contours.replaced[k].ends;
    const auto place = [&](double t) { return page_point(view, ends[0] + t * (ends[1] - ends[0])); };
    const Evidence unseen = contours.bulges[k] ? Evidence::hidden : Evidence::hollow;
    double hidden_from = 0;
    for (; stroke != edges.end() && stroke->source == contours.first_edge + k; ++stroke) {
      if (!stroke->visible) continue;
      if (hidden_from < stroke->t_from) outlines.add(place(hidden_from), place(stroke->t_from), unseen);
      outlines.add(lattice.to_mm(stroke->from), lattice.to_mm(stroke->to), Evidence::seen);
      hidden_from = stroke->t_to;
    }
    if (hidden_from < 1) outlines.add(place(hidden_from), place(1), unseen);
  }
}

/// Changes runs of contours by the replaced edges beside them, which are those within ContourNode::most_mm:
/// - Hides a visible part if an edge beside it is hidden and none is visible. At a concave edge the mesh hides its own
///   outline by a hair, so concave edges count only for runs beside which no edge is visible.
/// - Makes a hidden part visible if an edge beside it is visible and no visible contour stands for that edge.
/// `edges`: strokes of the edges themselves, sorted as by take_strokes().
void hold_against_outlines(std::vector<SeenContour>& seen, const SmoothContours& contours, const View& view,
                           const Lattice& lattice, const std::vector<Stroke>& edges, const EvidenceSizes& sizes) {
  const double shortest_mm = sizes.shortest_mm, clear_mm = sizes.clear_mm;
  const PartsOfRuns visible = parts_of_runs(seen, contours, true), hidden = parts_of_runs(seen, contours, false);
  PagePieces outlines(lattice), drawn(lattice);
  const auto for_parts = [&](const PartsOfRuns& parts, const auto& visit) {
    for (const auto& of_contour : parts) {
      for (const std::vector<Part>& of_run : of_contour) {
        for (const Part& part : of_run) {
          if (in_window(view, part.middle)) visit(part.middle, part.reach + clear_mm);
        }
      }
    }
  };
  Rect box;
  const auto extend = [&](Point2 p, double reach) {
    box.extend(p - reach);
    box.extend(p + reach);
  };
  for_parts(visible, extend);
  for_parts(hidden, extend);
  outlines.expect_within(box);
  add_outlines(outlines, contours, view, lattice, edges);
  change_runs(seen, visible,
              [&](std::span<const Part> parts) { return hidden_parts(parts, outlines, shortest_mm, clear_mm); });
  for (const SeenContour& contour : seen) {
    for (const ContourRun& run : contour.runs) {
      if (run.state < 0) continue;
      const std::vector<CurvePoint> points = contour.curve.part(run.from, run.to);
      for (std::size_t i = 1; i < points.size(); ++i) drawn.add(points[i - 1].mm, points[i].mm, Evidence::seen);
    }
  }
  change_runs(seen, hidden, [&](std::span<const Part> parts) {
    return rows(parts, shortest_mm, 0, [&](const Part& part) {
      return outlines.at(part.middle, part.reach) == Evidence::seen && drawn.at(part.middle, part.reach) == Evidence::none;
    });
  });
}

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
