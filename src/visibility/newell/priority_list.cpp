#include "visibility/newell/priority_list.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <memory>
#include <utility>

#include "base/parallel.hpp"
#include "base/stop.hpp"

namespace ligne::newell {

/// Lists that one thread sorts one after the other, consecutive in the order of painting.
struct PriorityList::Group {
  std::vector<std::uint32_t> leaves;  ///< numbers of the lists among the leaves
  Set elements;                       ///< of all lists, rising
  std::unique_ptr<PaintElements> copy{};
  std::vector<Set> orders{};  ///< per list, farthest first
  std::vector<SortedList> sorted{};
  ListCounts counts{};
};

namespace {

void number_in_whole(std::vector<std::vector<std::uint32_t>>& orders, std::span<const std::uint32_t> numbers) {
  for (std::vector<std::uint32_t>& order : orders) {
    for (std::uint32_t& e : order) e = numbers[e];
  }
}

}  // namespace

PriorityList::PriorityList(PaintElements& elements, ListOptions options) : elements_(elements), options_(options) {
  // Elements of an earlier list keep its order: their key is the smallest depth up to their place.
  double reach = std::numeric_limits<double>::infinity();
  keys_.reserve(elements.size());
  for (std::uint32_t i = 0; i < elements.size(); ++i) {
    const double farthest = elements[i].extents.high[2];
    reach = std::min(reach, farthest);
    keys_.push_back(sort_key(i < elements.in_order() ? reach : farthest, i));
  }
}

std::vector<std::uint32_t> PriorityList::sort() {
  std::vector<OpenSet> waiting = cells();
  while (!waiting.empty()) {
    check_stop();
    const OpenSet open = std::move(waiting.back());
    waiting.pop_back();
    if (open.set.size() == 1) set_division(open, Division::one);
    if (open.set.size() > 1 && decompose(open, waiting)) continue;
    if (!open.set.empty()) add_leaf(open.set);
  }
  sort_lists();
  return with_faces_of_bodies();
}

void PriorityList::add_leaf(const Set& set) {
  leaves_.insert(leaves_.end(), set.begin(), set.end());
  leaf_ends_.push_back(leaves_.size());
}

/// The elements of a leaf, as listed by the decomposition.
std::span<const std::uint32_t> PriorityList::leaf(std::size_t number) const {
  const std::size_t begin = number == 0 ? 0 : leaf_ends_[number - 1];
  return std::span(leaves_).subspan(begin, leaf_ends_[number] - begin);
}

/// Groups short lists, whose sort alone is shorter than the preparation of a sorter.
std::vector<PriorityList::Group> PriorityList::groups() const {
  constexpr std::size_t kGroup = 1024;  // elements. Adjustable
  std::vector<Group> groups;
  for (std::uint32_t i = 0; i < leaf_ends_.size(); ++i) {
    const std::span<const std::uint32_t> list = leaf(i);
    if (list.size() == 1) continue;
    if (groups.empty() || groups.back().elements.size() + list.size() > kGroup) groups.emplace_back();
    groups.back().leaves.push_back(i);
    groups.back().elements.insert(groups.back().elements.end(), list.begin(), list.end());
  }
  for (Group& group : groups) std::sort(group.elements.begin(), group.elements.end());
  return groups;
}

/// Sorts all lists. The group with the most elements is sorted in place, the others in copies, so no cut moves what another
/// thread reads. As many copies exist at once as keep the threads busy; their order does not depend on that number.
void PriorityList::sort_lists() {
  constexpr std::size_t kCopiesPerThread = 8;  // adjustable
  std::vector<Group> groups = this->groups();
  std::vector<Group*> longest_first;
  longest_first.reserve(groups.size());
  for (Group& group : groups) longest_first.push_back(&group);
  std::ranges::stable_sort(longest_first, std::greater<>(), [](const Group* group) { return group->elements.size(); });
  const std::size_t at_once = options_.parallel ? kCopiesPerThread * thread_count() : 1;
  for (std::size_t begin = 0; begin < groups.size(); begin += at_once) {
    const auto some = std::span(longest_first).subspan(begin, std::min(at_once, groups.size() - begin));
    parallel_tasks(some.size(), [&](std::size_t i) {
      if (begin + i > 0) some[i]->copy = std::make_unique<PaintElements>(elements_, some[i]->elements);
    });
    parallel_tasks(some.size(), [&](std::size_t i) { sort_group(*some[i]); });
    for (Group* group : some) {
      if (group->copy) number_in_whole(group->orders, elements_.take_over(*group->copy, group->elements));
      group->copy.reset();
    }
  }
  collect(groups);
}

/// Sorts the lists of a group. Elements of a copy are numbered by their place in the group.
void PriorityList::sort_group(Group& group) {
  PaintElements& elements = group.copy ? *group.copy : elements_;
  const auto number = [&](std::uint32_t e) {
    if (!group.copy) return e;
    return static_cast<std::uint32_t>(std::ranges::lower_bound(group.elements, e) - group.elements.begin());
  };
  std::vector<SortKey> keys;
  for (const std::uint32_t e : group.copy ? group.elements : Set{}) keys.push_back(sort_key_of(keys_[e], number(e)));
  Extents page;
  for (const std::uint32_t e : group.elements) page.extend(elements[number(e)].extents);
  ListSorter sorter(elements, group.copy ? std::move(keys) : keys_, page, group.elements.size());
  Set list;
  for (const std::uint32_t i : group.leaves) {
    list.clear();
    for (const std::uint32_t e : leaf(i)) list.push_back(number(e));
    const ListCounts before = sorter.counts();
    group.orders.push_back(sorter.sort(list));
    const ListCounts& after = sorter.counts();
    group.sorted.push_back({list.size(), after.compared - before.compared, after.cuts() - before.cuts()});
  }
  group.counts = sorter.counts();
  // Only cuts and opened bodies are taken over.
  if (group.copy && group.copy->size() == group.elements.size()) {
    number_in_whole(group.orders, group.elements);
    group.copy.reset();
  }
}

/// Joins the orders of all sets, farthest first.
void PriorityList::collect(const std::vector<Group>& groups) {
  auto group = groups.begin();
  std::size_t next = 0;  // list of the group
  for (const Group& g : groups) {
    counts_.add(g.counts);
    lists_.insert(lists_.end(), g.sorted.begin(), g.sorted.end());
  }
  for (std::size_t i = 0; i < leaf_ends_.size(); ++i) {
    if (leaf(i).size() == 1) {
      order_.push_back(leaf(i).front());
      continue;
    }
    order_.insert(order_.end(), group->orders[next].begin(), group->orders[next].end());
    if (++next == group->orders.size()) {
      ++group;
      next = 0;
    }
  }
}

/// The order, with each body that was not opened replaced by its faces.
std::vector<std::uint32_t> PriorityList::with_faces_of_bodies() {
  if (elements_.whole_bodies() == 0) return std::move(order_);
  std::vector<std::uint32_t> faces;
  for (const std::uint32_t e : order_) {
    if (!elements_.is_body(e)) {
      faces.push_back(e);
      continue;
    }
    const std::vector<std::uint32_t> members = elements_.open(e);
    faces.insert(faces.end(), members.begin(), members.end());
  }
  return faces;
}

}  // namespace ligne::newell
