#include "contours/curve_writer.hpp"

#include <algorithm>

#include "base/no_index.hpp"
#include "linework/stroke_geometry.hpp"

namespace ligne {

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

CurveWriter::CurveWriter(StrokeModel& model, const View& view, bool hidden_too, double longest_fold_mm)
    : model_(model), view_(view), hidden_too_(hidden_too), longest_fold_mm_(longest_fold_mm) {
  sources_.first = model.edge_count + static_cast<std::uint32_t>(model.intersections.size());
}

void CurveWriter::add(LineClass line_class, std::size_t segments, std::uint32_t first_line, const ContourCurve& curve,
                      const std::vector<ContourRun>& runs, const std::function<SourceEdge(std::size_t)>& source_of) {
  std::vector<std::uint32_t> sources(segments, kNone);
  const auto number_of = [&](std::size_t segment) {
    if (sources[segment] == kNone) {
      sources[segment] = model_.edge_count + static_cast<std::uint32_t>(model_.intersections.size());
      model_.intersections.push_back(source_of(segment));
      sources_.lines.push_back(first_line + static_cast<std::uint32_t>(segment));
    }
    return sources[segment];
  };
  for (const ContourRun& run : runs) {
    if (run.state == kOutsideState || (run.state == kHiddenState && !hidden_too_)) continue;
    std::vector<CurvePoint> points = curve.part(run.from, run.to);
    unfold(points, longest_fold_mm_);
    for (std::size_t i = 1; i < points.size(); ++i) {
      const std::size_t segment = std::min(static_cast<std::size_t>(points[i - 1].at), segments - 1);
      const auto number = static_cast<std::uint32_t>(segment);
      add_stroke(line_class, points[i - 1], points[i], run.state, {number, number_of(segment), first_line + number});
    }
  }
}

void CurveWriter::add_stroke(LineClass line_class, const CurvePoint& from, const CurvePoint& to, int state,
                             const Segment& segment) {
  Stroke s{.from = model_.lattice.snap(from.mm), .to = model_.lattice.snap(to.mm)};
  if (s.from == s.to || !(from.at < to.at)) return;
  s.t_from = from.at - segment.number;
  s.t_to = std::min(to.at - segment.number, 1.0);
  s.z_from = static_cast<float>(from.depth);
  s.z_to = static_cast<float>(to.depth);
  if (view_.camera.perspective) {
    s.w_from = static_cast<float>(from.weight);
    s.w_to = static_cast<float>(to.weight);
  }
  s.source = segment.source;
  s.line_class = line_class;
  s.visible = state >= 0;
  s.level = static_cast<std::uint8_t>(std::max(state, 0));
  if (!s.visible && !model_.hidden_parts.empty()) carry_count(s, segment.line);
  model_.strokes.push_back(s);
}

/// Gives a hidden stroke the count and the faces of the line that stood for it: the faces in front of the line hide the
/// curve too.
void CurveWriter::carry_count(Stroke& s, std::uint32_t line) {
  const HiddenPart* found = hidden_part_at(model_, line, (s.t_from + s.t_to) / 2);
  if (!found) return;
  HiddenPart part{s.source, s.t_from, s.t_to, found->count, found->faces};
  s.level = static_cast<std::uint8_t>(std::min(part.count, 255u));
  model_.hidden_parts.push_back(std::move(part));
}

}  // namespace ligne
