#include "linework/rules/close_short_gaps.hpp"

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include "linework/stroke_geometry.hpp"

namespace ligne {
namespace {

Stroke between(const Stroke& a, const Stroke& b) {
  Stroke gap = a;
  gap.t_from = a.t_to;
  gap.t_to = b.t_from;
  gap.from = a.to;
  gap.to = b.from;
  gap.z_from = a.z_to;
  gap.z_to = b.z_from;
  gap.w_from = a.w_to;
  gap.w_to = b.w_from;
  return gap;
}

}  // namespace

std::size_t close_short_gaps(StrokeModel& model, double gap_mm) {
  std::vector<Stroke>& strokes = model.strokes;
  const double longest = gap_mm / model.lattice.step_mm;
  const bool hidden_too = any_hidden(strokes);
  // Looks only at sources with several strokes, since a gap lies between strokes of one source. Most sources have one
  // stroke.
  std::uint32_t sources = 0;
  for (const Stroke& s : strokes) sources = std::max(sources, s.source + 1);
  std::vector<std::uint8_t> met(sources, 0), met_again(sources, 0);
  for (const Stroke& s : strokes) {
    if (is_edge(s) && std::exchange(met[s.source], std::uint8_t{1})) met_again[s.source] = 1;
  }
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < strokes.size(); ++i) {
    if (is_edge(strokes[i]) && met_again[strokes[i].source]) order.push_back(i);
  }
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::tie(strokes[a].source, strokes[a].t_from, a) < std::tie(strokes[b].source, strokes[b].t_from, b);
  });
  std::size_t closed = 0;
  std::vector<Stroke> added;
  for (std::size_t i = 0; i + 1 < order.size(); ++i) {
    const Stroke& a = strokes[order[i]];
    if (!is_seen(a)) continue;
    std::size_t k = i + 1;
    while (k < order.size() && strokes[order[k]].source == a.source && !strokes[order[k]].visible) ++k;
    if (k == order.size()) break;
    const Stroke& b = strokes[order[k]];
    const double gap = length(a.to, b.from);
    if (b.source != a.source || !is_seen(b) || b.line_class != a.line_class || !(gap > 0) || gap >= longest) continue;
    if (hidden_too != (k > i + 1)) continue;  // unknown gap: the drawing has hidden strokes, but not here
    ++closed;
    if (!hidden_too) added.push_back(between(a, b));
    for (std::size_t h = i + 1; h < k; ++h) {
      strokes[order[h]].visible = true;
      strokes[order[h]].level = 0;
    }
  }
  strokes.insert(strokes.end(), added.begin(), added.end());
  return closed;
}

}  // namespace ligne
