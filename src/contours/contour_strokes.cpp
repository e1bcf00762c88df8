#include "contours/contour_strokes.hpp"

#include <algorithm>
#include <cmath>

#include "contours/contour_curves.hpp"
#include "contours/contour_states.hpp"
#include "geometry/parallel.hpp"

namespace ligne {
namespace {

/// Pieces of a curve are straight to this; four times the accuracy that drawings owe would still not be seen.
constexpr double kFlatnessMm = 0.002;

/// Takes the strokes of contours out of the model, in the order of their sources.
std::vector<Stroke> take_strokes(StrokeModel& model, const SmoothContours& contours) {
  const std::uint32_t first = contours.first_source.front();
  const auto last = contours.first_source.back() + static_cast<std::uint32_t>(contours.chains.back().size());
  std::vector<Stroke> taken;
  std::erase_if(model.strokes, [&](const Stroke& s) {
    const bool is_contour = s.source >= first && s.source < last;
    if (is_contour) taken.push_back(s);
    return is_contour;
  });
  std::sort(taken.begin(), taken.end(), [](const Stroke& l, const Stroke& r) {
    return l.source != r.source ? l.source < r.source : l.t_from < r.t_from;
  });
  return taken;
}

class Writer {
 public:
  Writer(StrokeModel& model, const View& view, bool hidden_too) : model_(model), view_(view), hidden_too_(hidden_too) {}

  void add(const ContourChain& chain, const std::vector<std::uint32_t>& faces, const ContourCurve& curve,
           const std::vector<ContourRun>& runs) {
    std::vector<std::uint32_t> sources(chain.size(), kNone);
    const auto source_of = [&](std::size_t segment) {
      if (sources[segment] == kNone) {
        sources[segment] = model_.edge_count + static_cast<std::uint32_t>(model_.intersections.size());
        SourceEdge source;
        source.ends = {chain.nodes[segment].on_mesh, chain.nodes[segment + 1].on_mesh};
        source.faces[0] = faces[segment];
        model_.intersections.push_back(source);
      }
      return sources[segment];
    };
    for (const ContourRun& run : runs) {
      if (run.state == kOutsideState || (run.state == kHiddenState && !hidden_too_)) continue;
      CurvePoint from = curve.point_at(run.from);
      const auto first = std::upper_bound(curve.points.begin(), curve.points.end(), run.from,
                                          [](double at, const CurvePoint& p) { return at < p.at; });
      for (auto p = first; p != curve.points.end(); ++p) {
        const CurvePoint to = p->at >= run.to ? curve.point_at(run.to) : *p;
        add_stroke(from, to, run.state, source_of(std::min(static_cast<std::size_t>(from.at), chain.size() - 1)));
        from = to;
        if (p->at >= run.to) break;
      }
    }
  }

 private:
  void add_stroke(const CurvePoint& from, const CurvePoint& to, int state, std::uint32_t source) {
    Stroke s;
    s.from = model_.lattice.snap(from.mm);
    s.to = model_.lattice.snap(to.mm);
    if (s.from == s.to || !(from.at < to.at)) return;
    const double segment = std::floor(from.at);
    s.t_from = from.at - segment;
    s.t_to = to.at - segment;
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
  const View& view_;
  bool hidden_too_;
};

}  // namespace

void draw_contours(StrokeModel& model, const Scene& scene, const View& view, const SmoothContours& contours, bool hidden_too,
                   const ContourOptions& options) {
  if (contours.empty()) return;
  const std::vector<Stroke> strokes = take_strokes(model, contours);
  const std::size_t n = contours.chains.size();
  std::vector<ContourCurve> curves(n);
  std::vector<std::vector<ContourRun>> runs(n);
  constexpr std::size_t kChainsPerTask = 8;
  parallel_blocks(n, kChainsPerTask, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      curves[c] = contour_curve(scene, view, contours.chains[c], kFlatnessMm);
      runs[c] = runs_of(strokes, contours.first_source[c], contours.chains[c].size(), hidden_too);
      drop_short_runs(runs[c], curves[c], options.pen_width_mm);
    }
  });
  Writer writer(model, view, hidden_too);
  for (std::size_t c = 0; c < n; ++c) writer.add(contours.chains[c], contours.faces[c], curves[c], runs[c]);
}

}  // namespace ligne
