// The division of the list into sets without a comparison between them: cells by separating planes, then zones on the page
// and slabs in depth, nested ([Boulle1980] 2.5.2.7).

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/stop.hpp"
#include "visibility/newell/priority_list.hpp"

namespace ligne::newell {

/// The whole set, or its cells by separating planes, farthest last.
std::vector<PriorityList::OpenSet> PriorityList::cells() {
  std::vector<OpenSet> sets(1);
  Set& all = sets[0].set;
  all.resize(elements_.size());
  std::iota(all.begin(), all.end(), 0u);
  sets[0].node = add_node(all, 0);
  std::ranges::stable_sort(all, [&](std::uint32_t a, std::uint32_t b) { return elements_.cell(a) > elements_.cell(b); });
  if (all.empty() || elements_.cell(all.front()) == elements_.cell(all.back())) return sets;
  set_division(sets[0], Division::depth);
  std::vector<OpenSet> parts;
  for (const std::uint32_t e : all) {
    if (parts.empty() || elements_.cell(parts.back().set.front()) != elements_.cell(e)) parts.emplace_back();
    parts.back().set.push_back(e);
  }
  for (OpenSet& part : parts) part.node = add_node(part.set, sets[0].node);
  return parts;
}

/// Adds a tree node for a set, if sets are kept.
std::uint32_t PriorityList::add_node(const Set& set, std::uint32_t parent) {
  if (!options_.keep_sets) return 0;
  tree_.push_back({parent, Division::list, set});
  return static_cast<std::uint32_t>(tree_.size() - 1);
}

void PriorityList::set_division(const OpenSet& open, Division division) {
  if (options_.keep_sets) tree_[open.node].division = division;
}

/// Finds zones and slabs: sets with disjoint extents along one axis need no comparison. In depth the farthest set comes last
/// in `waiting`, because it is painted first.
bool PriorityList::decompose(const OpenSet& open, std::vector<OpenSet>& waiting) {
  for (const int axis : {2, 0, 1}) {
    check_stop();
    Set by_low = open.set;
    std::ranges::sort(by_low, [&](std::uint32_t a, std::uint32_t b) {
      return std::pair(elements_[a].extents.low[axis], a) < std::pair(elements_[b].extents.low[axis], b);
    });
    std::vector<Set> parts;
    double end = 0;
    for (const std::uint32_t e : by_low) {
      if (parts.empty() || elements_[e].extents.low[axis] >= end) {
        parts.emplace_back();
        end = elements_[e].extents.high[axis];
      }
      parts.back().push_back(e);
      end = std::max(end, elements_[e].extents.high[axis]);
    }
    if (parts.size() == 1) continue;
    (axis == 2 ? counts_.slabs : counts_.zones) += parts.size();
    if (options_.keep_sets) keep(parts, axis == 2);
    set_division(open, axis == 2 ? Division::depth : axis == 0 ? Division::x : Division::y);
    for (Set& part : parts) {
      const std::uint32_t node = add_node(part, open.node);
      waiting.push_back({std::move(part), node});
    }
    return true;
  }
  return false;
}

/// Keeps the parts of a division, ordered from the nearest, from the left, or from the top.
void PriorityList::keep(const std::vector<Set>& parts, bool slabs) {
  for (std::size_t i = 0; i < parts.size(); ++i) {
    FoundSet found{{}, static_cast<std::uint32_t>(slabs ? parts.size() - i : i + 1)};
    for (const std::uint32_t e : parts[i]) found.extents.extend(elements_[e].extents);
    (slabs ? slabs_ : zones_).push_back(found);
  }
}

}  // namespace ligne::newell
