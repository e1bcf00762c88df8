#include "linework/overlaps/coincident_strokes.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "base/parallel.hpp"
#include "linework/overlaps/crowded_lines.hpp"
#include "linework/overlaps/overlap_search.hpp"
#include "linework/overlaps/precedence.hpp"
#include "linework/overlaps/resolve_pairs.hpp"

namespace ligne {
namespace {

/// Sorts the strokes numbered in `of` by falling precedence, with the depths in their middles.
void sort_by_precedence(const std::vector<Stroke>& strokes, std::vector<std::uint32_t>& of, double tolerance_mm) {
  struct Entry {
    std::size_t rank;
    double depth;
    std::uint32_t stroke;
  };
  std::vector<Entry> order(of.size());
  for (std::size_t k = 0; k < of.size(); ++k) {
    const Stroke& s = strokes[of[k]];
    order[k] = {rank(s), rounded_depth(depth(s, 0.5), tolerance_mm), of[k]};
  }
  parallel_sort(order.begin(), order.end(), [&](const Entry& a, const Entry& b) {
    if (a.rank != b.rank) return a.rank < b.rank;
    if (a.depth != b.depth) return a.depth < b.depth;
    const Stroke &l = strokes[a.stroke], &r = strokes[b.stroke];
    return std::tie(l.source, l.t_from, l.t_to, a.stroke) < std::tie(r.source, r.t_from, r.t_to, b.stroke);
  });
  for (std::size_t k = 0; k < of.size(); ++k) of[k] = order[k].stroke;
}

/// Returns, in order, the numbers of the strokes longer than the tolerance that need a check (Stroke::needs_overlap_check)
/// or pass near one that does.
std::vector<std::uint32_t> strokes_to_compare(const std::vector<Stroke>& strokes, double tolerance_steps) {
  std::vector<std::uint32_t> flagged, chosen;
  for (std::uint32_t i = 0; i < strokes.size(); ++i) {
    if (strokes[i].needs_overlap_check && page_length(strokes[i]) > tolerance_steps) flagged.push_back(i);
  }
  if (flagged.empty()) return flagged;
  const std::vector<std::uint8_t> is_near = strokes_near(strokes, flagged, tolerance_steps);
  for (std::uint32_t i = 0; i < strokes.size(); ++i) {
    if (is_near[i] && page_length(strokes[i]) > tolerance_steps) chosen.push_back(i);
  }
  return chosen;
}

}  // namespace

void remove_coincident_strokes(StrokeModel& model, double tolerance_mm) {
  std::vector<Stroke>& strokes = model.strokes;
  // Positions on the lattice are known to one step.
  const OverlapTolerance tolerance{std::max(tolerance_mm / model.lattice.step_mm, 1.0), tolerance_mm};
  std::vector<std::uint32_t> order = strokes_to_compare(strokes, tolerance.steps);
  if (order.empty()) return;
  std::vector<Stroke> others;
  others.reserve(strokes.size());
  for (std::size_t i = 0, k = 0; i < strokes.size(); ++i) {
    if (k < order.size() && order[k] == i) {
      ++k;
    } else {
      others.push_back(strokes[i]);
    }
  }
  sort_by_precedence(strokes, order, tolerance_mm);
  std::vector<Stroke> in_order(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) in_order[k] = strokes[order[k]];

  ComparedStrokes compared(std::move(in_order));
  thin_crowded_lines(compared, tolerance);
  OverlapSearch search(compared, tolerance.steps);
  for (;;) {
    const std::vector<StrokePair> pairs = search.new_pairs();
    if (pairs.empty()) break;
    resolve_pairs(compared, pairs, tolerance);
  }
  compared.append_remaining(others);
  strokes = std::move(others);
}

}  // namespace ligne
