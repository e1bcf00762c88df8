#include "linework/overlaps/coincident_strokes.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "base/indices_where.hpp"
#include "base/parallel.hpp"
#include "linework/overlaps/compared_strokes.hpp"

namespace ligne {
namespace {

/// Sorts the strokes numbered in `of` by falling precedence, with the depths in their middles.
void sort_by_precedence(const std::vector<Stroke>& strokes, std::vector<std::uint32_t>& of, double tolerance_mm) {
  using Entry = std::pair<PrecedenceKey, std::uint32_t>;
  std::vector<Entry> order(of.size());
  for (std::size_t k = 0; k < of.size(); ++k) order[k] = {precedence_key(strokes[of[k]], 0.5, tolerance_mm), of[k]};
  parallel_sort(order.begin(), order.end(), [&](const Entry& a, const Entry& b) {
    if (a.first != b.first) return a.first < b.first;
    const Stroke &l = strokes[a.second], &r = strokes[b.second];
    return std::tie(l.source, l.t_from, l.t_to, a.second) < std::tie(r.source, r.t_from, r.t_to, b.second);
  });
  for (std::size_t k = 0; k < of.size(); ++k) of[k] = order[k].second;
}

/// Returns, ascending, the numbers of the strokes longer than the tolerance that need a check
/// (Stroke::needs_overlap_check) or pass near one that does.
std::vector<std::uint32_t> strokes_to_compare(const std::vector<Stroke>& strokes, double tolerance_steps) {
  const auto is_long = [&](std::uint32_t i) { return page_length(strokes[i]) > tolerance_steps; };
  std::vector<std::uint32_t> flagged =
      indices_where(strokes.size(), [&](std::size_t i) { return strokes[i].needs_overlap_check && is_long(i); });
  if (flagged.empty()) return flagged;
  std::vector<std::uint32_t> chosen = strokes_near(strokes, flagged, tolerance_steps);
  std::erase_if(chosen, [&](std::uint32_t i) { return !is_long(i); });
  return chosen;
}

/// Cuts strokes until no two overlap. Rests may overlap strokes that their wholes did not, where a wedge has become short
/// enough.
void resolve_overlaps(ComparedStrokes& compared, const OverlapTolerance& tolerance) {
  for (;;) {
    const std::vector<StrokePair> pairs = find_new_overlaps(compared, tolerance.steps);
    if (pairs.empty()) return;
    compared.replace(resolve_pairs(compared.strokes, pairs, tolerance));
  }
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
  ComparedStrokes compared;
  compared.strokes.reserve(order.size());
  for (const std::uint32_t i : order) compared.strokes.push_back(strokes[i]);
  compared.replace(thin_crowded_lines(compared.strokes, tolerance));
  compared.is_new.assign(compared.strokes.size(), 1);
  resolve_overlaps(compared, tolerance);
  others.insert(others.end(), compared.strokes.begin(), compared.strokes.end());
  strokes = std::move(others);
}

}  // namespace ligne
