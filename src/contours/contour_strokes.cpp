#include "contours/contour_strokes.hpp"

#include <algorithm>
#include <utility>

#include "contours/contour_junctions.hpp"
#include "contours/outline_probes.hpp"
#include "geometry/parallel.hpp"

namespace ligne {
namespace {

/// Pieces of a curve are straight to this; four times the accuracy that drawings owe would still not be seen.
constexpr double kFlatnessMm = 0.002;
/// Ends are moved to the line that they meet by so many widths of the pen.
constexpr double kReachInPens = 2;

/// Takes the strokes of `count` sources from `first` on out of the model, in the order of their sources.
std::vector<Stroke> take_strokes(StrokeModel& model, std::uint32_t first, std::size_t count) {
  std::vector<Stroke> taken;
  std::erase_if(model.strokes, [&](const Stroke& s) {
    const bool found = s.source >= first && s.source - first < count;
    if (found) taken.push_back(s);
    return found;
  });
  std::sort(taken.begin(), taken.end(), [](const Stroke& l, const Stroke& r) {
    return l.source != r.source ? l.source < r.source : l.t_from < r.t_from;
  });
  return taken;
}

class Writer {
 public:
  Writer(StrokeModel& model, const View& view, bool hidden_too, double longest_fold_mm)
      : model_(model), view_(view), hidden_too_(hidden_too), longest_fold_mm_(longest_fold_mm) {
    sources_.first = model.edge_count + static_cast<std::uint32_t>(model.intersections.size());
  }

  /// The sources of all that was added.
  ContourSources take_sources() { return std::move(sources_); }

  /// The first segment of the chain was studied at `first_line`.
  void add(const ContourChain& chain, std::uint32_t first_line, const std::vector<std::uint32_t>& faces,
           const ContourCurve& curve, const std::vector<ContourRun>& runs) {
    std::vector<std::uint32_t> sources(chain.size(), kNone);
    const auto source_of = [&](std::size_t segment) {
      if (sources[segment] == kNone) {
        sources[segment] = model_.edge_count + static_cast<std::uint32_t>(model_.intersections.size());
        SourceEdge source;
        source.ends = {chain.nodes[segment].on_mesh, chain.nodes[segment + 1].on_mesh};
        source.faces[0] = faces[segment];
        model_.intersections.push_back(source);
        sources_.lines.push_back(first_line + static_cast<std::uint32_t>(segment));
      }
      return sources[segment];
    };
    for (const ContourRun& run : runs) {
      if (run.state == kOutsideState || (run.state == kHiddenState && !hidden_too_)) continue;
      std::vector<CurvePoint> points = curve.part(run.from, run.to);
      unfold(points, longest_fold_mm_);
      for (std::size_t i = 1; i < points.size(); ++i) {
        const auto segment = std::min(static_cast<std::size_t>(points[i - 1].at), chain.size() - 1);
        add_stroke(points[i - 1], points[i], run.state, source_of(segment), double(segment));
      }
    }
  }

 private:
  void add_stroke(const CurvePoint& from, const CurvePoint& to, int state, std::uint32_t source, double segment) {
    Stroke s;
    s.from = model_.lattice.snap(from.mm);
    s.to = model_.lattice.snap(to.mm);
    if (s.from == s.to || !(from.at < to.at)) return;
    s.t_from = from.at - segment;
    s.t_to = std::min(to.at - segment, 1.0);
    s.z_from = static_cast<float>(from.depth);
    s.z_to = static_cast<float>(to.depth);
    if (view_.camera.perspective) {
      s.w_from = static_cast<float>(from.weight);
      s.w_to = static_cast<float>(to.weight);
    }
    s.source = source;
    s.line_class = LineClass::outline;
    s.visible = state >= 0;
    s.level = static_cast<std::uint8_t>(std::max(state, 0));
    model_.strokes.push_back(s);
  }

  StrokeModel& model_;
  ContourSources sources_;
  const View& view_;
  bool hidden_too_;
  double longest_fold_mm_;
};

}  // namespace

ContourSources draw_contours(StrokeModel& model, const Scene& scene, const View& view, const SmoothContours& contours,
                             bool hidden_too, const ContourOptions& options) {
  if (contours.empty()) return {};
  const std::vector<Stroke> probes = take_strokes(model, contours.first_probe, contours.replaced.size());
  const std::size_t n = contours.chains.size();
  const std::uint32_t first = n > 0 ? contours.first_source.front() : contours.first_probe;
  const std::vector<Stroke> strokes = take_strokes(model, first, contours.first_probe - first);
  std::vector<SeenContour> seen(n);
  constexpr std::size_t kChainsPerTask = 8;
  parallel_blocks(n, kChainsPerTask, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      seen[c].curve = contour_curve(scene, view, contours.chains[c], kFlatnessMm);
      seen[c].runs = runs_of(strokes, contours.first_source[c], contours.chains[c].size(), hidden_too);
      seen[c].sides = contours.sides[c];
      drop_short_runs(seen[c].runs, seen[c].curve, options.pen_width_mm);
    }
  });
  const double reach_mm = kReachInPens * options.pen_width_mm;
  move_ends_of_contours(seen, model, reach_mm);
  for (SeenContour& contour : seen) drop_short_runs(contour.runs, contour.curve, options.pen_width_mm);
  add_missing_outlines(model, view, contours, probes, seen, options.pen_width_mm, reach_mm);
  move_ends_of_strokes(model, seen, reach_mm);
  Writer writer(model, view, hidden_too, reach_mm);
  for (std::size_t c = 0; c < n; ++c) {
    writer.add(contours.chains[c], contours.first_source[c], contours.faces[c], seen[c].curve, seen[c].runs);
  }
  return writer.take_sources();
}

}  // namespace ligne
