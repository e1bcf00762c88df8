#include "linework/overlaps/compared_strokes.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace ligne {

std::vector<Stroke> rests_of(const Stroke& stroke, std::vector<CoveredPart>& covered, double tolerance_steps) {
  std::sort(covered.begin(), covered.end(), [](const CoveredPart& l, const CoveredPart& r) {
    return std::tie(l.from.fraction, l.to.fraction) < std::tie(r.from.fraction, r.to.fraction);
  });
  const double stroke_length = page_length(stroke);
  std::vector<Stroke> rests;
  StrokeCut from{0, stroke.from};
  const auto add_rest_to = [&](const StrokeCut& to) {
    if ((to.fraction - from.fraction) * stroke_length <= tolerance_steps) return;
    const Stroke rest = stroke_piece(stroke, from, to);
    if (rest.from != rest.to && rest.t_from < rest.t_to) rests.push_back(rest);
  };
  for (const CoveredPart& part : covered) {
    add_rest_to(part.from);
    if (part.to.fraction > from.fraction) from = part.to;
  }
  add_rest_to({1, stroke.to});
  return rests;
}

void ComparedStrokes::replace(std::span<const CutStroke> cut) {
  ComparedStrokes changed;
  changed.strokes.reserve(strokes.size() + cut.size());
  changed.is_new.reserve(strokes.size() + cut.size());
  auto next = cut.begin();
  for (std::uint32_t i = 0; i < strokes.size(); ++i) {
    const Stroke& whole = strokes[i];
    if (next == cut.end() || next->number != i) {
      changed.strokes.push_back(whole);
      changed.is_new.push_back(0);
      continue;
    }
    const std::vector<Stroke>& rests = (next++)->rests;
    const bool is_whole = rests.size() == 1 && rests[0].from == whole.from && rests[0].to == whole.to;
    changed.strokes.insert(changed.strokes.end(), rests.begin(), rests.end());
    changed.is_new.insert(changed.is_new.end(), rests.size(), !is_whole);
  }
  *this = std::move(changed);
}

}  // namespace ligne
