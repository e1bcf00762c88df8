#include "linework/overlaps/compared_strokes.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <tuple>
#include <utility>

#include "linework/stroke_geometry.hpp"

namespace ligne {

void append_rests(const Stroke& stroke, std::vector<CoveredPart>& covered, double tolerance_steps,
                  std::vector<Stroke>& rests) {
  std::sort(covered.begin(), covered.end(), [](const CoveredPart& l, const CoveredPart& r) {
    return std::tie(l.from.fraction, l.to.fraction) < std::tie(r.from.fraction, r.to.fraction);
  });
  const double stroke_length = page_length(stroke);
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
}

ComparedStrokes::ComparedStrokes(std::vector<Stroke> in_order)
    : strokes(std::move(in_order)), place(strokes.size()), is_gone(strokes.size(), 0) {
  std::iota(place.begin(), place.end(), 0u);
}

void ComparedStrokes::replace(std::span<const CutStroke> cut) {
  for (const auto& [number, rests] : cut) {
    const Stroke whole = strokes[number];
    if (rests.size() == 1 && rests[0].from == whole.from && rests[0].to == whole.to) continue;
    is_gone[number] = 1;
    strokes.insert(strokes.end(), rests.begin(), rests.end());
    place.insert(place.end(), rests.size(), place[number]);
    is_gone.insert(is_gone.end(), rests.size(), 0);
  }
}

void ComparedStrokes::append_remaining(std::vector<Stroke>& result) const {
  const auto before = [&](std::uint32_t a, std::uint32_t b) { return comes_before(a, b); };
  std::vector<std::uint32_t> whole, rests, all;
  for (std::uint32_t i = 0; i < strokes.size(); ++i) {
    if (!is_gone[i]) (place[i] == i ? whole : rests).push_back(i);
  }
  std::sort(rests.begin(), rests.end(), before);
  all.reserve(whole.size() + rests.size());
  std::merge(whole.begin(), whole.end(), rests.begin(), rests.end(), std::back_inserter(all), before);
  for (const std::uint32_t i : all) result.push_back(strokes[i]);
}

}  // namespace ligne
