#include "visibility/newell/list_sorter.hpp"

#include <bit>
#include <functional>
#include <iterator>
#include <utility>

#include "base/parallel.hpp"
#include "base/stop.hpp"

// [Boulle1980] 2.5.2.4. P, the head of the list, is compared with the elements whose farthest depth lies behind P's nearest
// depth. If P can hide none of them, it is painted. If P may hide Q, Q is marked and becomes the head. If Q is already
// marked, or if each may hide the other, there may be no order, and one of the two is cut.
//
// Results for a pair do not depend on the list. All threads therefore compare the next elements ahead with their sets, each
// up to the first element that it may hide. Comparisons with elements that leave the list meanwhile are wasted.
//
// The algorithm terminates. Marks stay, so an element moves at most once between two cuts. A cut by a face's plane leaves
// pieces that this plane does not cut again, so the planes cut each face into finitely many pieces. Pieces smaller than a
// lattice step overlap nothing, which ends the halving on the page.

namespace ligne::newell {

SortKey sort_key(double reach, std::uint32_t element) {
  const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(0 - reach));
  const std::uint32_t rising = bits >> 31 ? ~bits : bits | 0x80000000u;
  return SortKey{rising} << 32 | element;
}

ListSorter::ListSorter(PaintElements& elements, std::vector<SortKey> keys, const Extents& page, std::size_t count)
    : elements_(elements), keys_(std::move(keys)), levels_(page, count) {
  for (std::uint32_t i = 0; i < elements.size(); ++i) note(i);
  state_.assign(elements.size(), State::gone);
}

/// Stores the box of the next element.
void ListSorter::note(std::uint32_t element) {
  boxes_.emplace_back(elements_[element].extents);
  element % kBlock == 0 ? blocks_.push_back(boxes_.back()) : blocks_.back().extend(boxes_.back());
}

std::vector<std::uint32_t> ListSorter::sort(std::span<const std::uint32_t> list) {
  ++counts_.lists;
  sorted_.assign(list.begin(), list.end());
  std::sort(sorted_.begin(), sorted_.end(), [&](std::uint32_t a, std::uint32_t b) { return keys_[a] < keys_[b]; });
  // The nearest first: each becomes the last of its cells.
  for (auto e = sorted_.rbegin(); e != sorted_.rend(); ++e) {
    check_stop();
    state_[*e] = State::waiting;
    levels_.add(*e, elements_[*e].extents);
  }
  first_ = ahead_end_ = 0;
  order_.clear();
  for (std::uint32_t p = head(); p != kNone; p = head()) {
    check_stop();
    if (moved_.empty() && first_ >= ahead_end_ && first_ < sorted_.size()) look_ahead();
    if (!settle(p)) continue;
    remove(p);
    order_.push_back(p);
  }
  return std::move(order_);
}

std::uint32_t ListSorter::head() {
  if (!moved_.empty()) return moved_.back();
  while (first_ < sorted_.size() && state_[sorted_[first_]] != State::waiting) ++first_;
  const SortKey sorted = first_ < sorted_.size() ? keys_[sorted_[first_]] : kLast;
  const SortKey inserted = inserted_.empty() ? kLast : *inserted_.begin();
  return element_of(std::min(sorted, inserted));
}

void ListSorter::remove(std::uint32_t element) {
  if (state_[element] == State::marked) std::erase(moved_, element);
  inserted_.erase(keys_[element]);
  comparisons_.erase(element);
  state_[element] = State::gone;
  ++gone_;
}

void ListSorter::insert(std::uint32_t element) {
  state_.resize(elements_.size(), State::waiting);
  for (auto i = static_cast<std::uint32_t>(keys_.size()); i < elements_.size(); ++i) {
    keys_.push_back(sort_key(elements_[i].extents.high[2], i));
    note(i);
  }
  inserted_.insert(keys_[element]);
  levels_.add(element, elements_[element].extents);
}

/// The set Q_p, up to rounding of boxes: waiting elements that overlap P in x and y and reach behind P's nearest depth.
ListSorter::Comparison& ListSorter::comparison_of(std::uint32_t p) {
  const auto [place, is_new] = comparisons_.try_emplace(p);
  Comparison& result = place->second;
  if (!is_new) return result;
  result.known = static_cast<std::uint32_t>(elements_.size());
  seen_.resize(elements_.size(), 0);
  levels_.visit(elements_[p].extents, [&](std::uint32_t q) {
    if (state_[q] == State::gone) return false;
    if (seen_[q] != p + 1 && q != p) result.others.push_back(keys_[q]);
    seen_[q] = p + 1;
    return true;
  });
  std::sort(result.others.begin(), result.others.end(), std::greater<>());
  return result;
}

/// The comparison of an element for a piece cut from it: the piece does not hide faces that the whole does not hide.
ListSorter::Comparison ListSorter::inherited(const Comparison& whole, std::uint32_t piece) const {
  Comparison result{{}, {}, whole.known};
  const auto is_left = [&](SortKey k) {
    const std::uint32_t q = element_of(k);
    return state_[q] != State::gone && boxes_[piece].meets(boxes_[q]);
  };
  std::copy_if(whole.others.begin(), whole.others.end(), std::back_inserter(result.others), is_left);
  std::copy_if(whole.before.begin(), whole.before.end(), std::back_inserter(result.before), is_left);
  return result;
}

/// Compares the next elements of the list with their sets, in parallel.
void ListSorter::look_ahead() {
  constexpr std::size_t kAhead = 4096, kTask = 64, kForget = 1024;  // adjustable
  if (gone_ >= kForget) {
    levels_.forget([&](std::uint32_t e) { return state_[e] == State::gone; });
    gone_ = 0;
  }
  Set next;
  for (ahead_end_ = first_; ahead_end_ < sorted_.size() && next.size() < kAhead; ++ahead_end_) {
    const std::uint32_t e = sorted_[ahead_end_];
    if (state_[e] == State::waiting && !comparisons_.contains(e)) next.push_back(e);
  }
  std::vector<Comparison> compared(next.size());
  works_.resize(thread_count());
  parallel_tasks_apart(block_count(next.size(), kTask), [&](std::size_t task) {
    AheadWork& work = works_[thread_index()];
    work.seen.resize(elements_.size(), 0);
    for (std::size_t i = task * kTask; i < std::min(next.size(), (task + 1) * kTask); ++i) {
      compared[i] = compared_ahead(next[i], work);
    }
  });
  for (AheadWork& work : works_) counts_.add(std::exchange(work.counts, {}));  // the sums do not depend on the threads
  counts_.ahead += next.size();
  for (std::size_t i = 0; i < next.size(); ++i) comparisons_.emplace(next[i], std::move(compared[i]));
}

/// Compares an element with the elements behind it in the list, up to the first that it may hide.
ListSorter::Comparison ListSorter::compared_ahead(std::uint32_t p, AheadWork& work) const {
  Comparison result;
  result.known = static_cast<std::uint32_t>(elements_.size());
  levels_.look(elements_[p].extents, [&](std::uint32_t q) {
    if (work.seen[q] == p + 1 || q == p || state_[q] == State::gone) return;
    work.seen[q] = p + 1;
    (keys_[q] < keys_[p] ? result.before : result.others).push_back(keys_[q]);
  });
  std::sort(result.others.begin(), result.others.end(), std::greater<>());
  while (!result.others.empty() && !may_hide(p, element_of(result.others.back()), work.counts, work.common)) {
    result.others.pop_back();
  }
  return result;
}

/// Compares the head of the list with its set Q_p. Returns false if the list has changed.
bool ListSorter::settle(std::uint32_t p) {
  Comparison& comparison = comparison_of(p);
  if (!work_off(p, comparison.others)) return false;
  if (!comparison.before.empty()) {
    // Elements wait before P only if some element was moved to the head.
    if (!moved_.empty()) {
      std::erase_if(comparison.before, [&](SortKey k) { return state_[element_of(k)] == State::gone; });
      std::sort(comparison.before.begin(), comparison.before.end(), std::greater<>());
      comparison.others.swap(comparison.before);
    }
    comparison.before.clear();
    if (!work_off(p, comparison.others)) return false;
  }
  const Box& box = boxes_[p];
  const auto count = static_cast<std::uint32_t>(elements_.size());
  while (comparison.known < count) {
    const std::uint32_t block = comparison.known / kBlock, end = std::min((block + 1) * kBlock, count);
    if (!box.meets(blocks_[block])) {
      comparison.known = end;
      continue;
    }
    for (; comparison.known < end; ++comparison.known) {
      const std::uint32_t q = comparison.known;
      if (q != p && state_[q] != State::gone && box.meets(boxes_[q]) && !resolve(p, q)) return false;
    }
  }
  return true;
}

/// Compares P with the elements of a set from the back and removes them. Returns false if the list has changed.
bool ListSorter::work_off(std::uint32_t p, Keys& set) {
  for (; !set.empty(); set.pop_back()) {
    const std::uint32_t q = element_of(set.back());
    if (state_[q] != State::gone && !resolve(p, q)) return false;
  }
  return true;
}

/// Returns true if P does not hide Q. Otherwise changes the list so that this pair does not recur.
bool ListSorter::resolve(std::uint32_t p, std::uint32_t q) {
  if (!may_hide(p, q)) return true;
  if (state_[q] != State::marked) {
    if (elements_.hide_one_way(p, q)) {
      ++counts_.one_way;
    } else if (may_hide(q, p)) {
      if (open_body(p, q)) return false;
      return !replace(p, elements_[q].plane, counts_.plane_cuts);
    }
    inserted_.erase(keys_[q]);
    state_[q] = State::marked;
    moved_.push_back(q);
    ++counts_.moved;
    return false;
  }
  if (open_body(p, q)) return false;
  if (elements_.side(q, p) == PlaneSide::both) return !replace(q, elements_[p].plane, counts_.plane_cuts);
  if (elements_.side(p, q) == PlaneSide::both) return !replace(p, elements_[q].plane, counts_.plane_cuts);
  // Both planes fail. The larger element is halved. Halving only P need not end: if P hides Q and is itself hidden, so are
  // its halves.
  const std::uint32_t larger = elements_[q].extents.longest_side() > elements_[p].extents.longest_side() ? q : p;
  return !replace(larger, elements_.halving_plane(larger), counts_.page_cuts);
}

/// Cuts the element and inserts its pieces into the list. Returns false if the plane does not cut it.
bool ListSorter::replace(std::uint32_t element, const ModelPlane& plane, std::uint64_t& count) {
  const auto pieces = elements_.cut(element, plane);
  if (pieces.empty()) return false;
  ++count;
  put_in_place(element, pieces);
  return true;
}

/// Replaces an element of the list by its parts.
void ListSorter::put_in_place(std::uint32_t element, const std::vector<std::uint32_t>& parts) {
  const Comparison whole = std::move(comparisons_[element]);
  remove(element);
  for (const std::uint32_t part : parts) {
    insert(part);
    comparisons_.emplace(part, inherited(whole, part));
  }
}

/// Opens a body among two elements without an order, the one with more faces first. Returns false if neither is a body.
bool ListSorter::open_body(std::uint32_t p, std::uint32_t q) {
  const auto size = [&](std::uint32_t e) { return elements_.is_body(e) ? elements_[e].parts.size() : 0; };
  const std::uint32_t body = size(q) > size(p) ? q : p;
  if (!elements_.is_body(body)) return false;
  ++counts_.opened;
  put_in_place(body, elements_.open(body));
  return true;
}

/// Tests in order of cost; each may prove that P does not hide Q.
bool ListSorter::may_hide(std::uint32_t p, std::uint32_t q, ListCounts& counts, CommonPart& work) const {
  if (elements_.never_hides(p, q)) {
    const std::uint32_t f = elements_[p].face, g = elements_[q].face;
    if (f != g) ++(elements_.bodies().never_hides(f, g) ? counts.one_body : counts.separated);
    return false;
  }
  ++counts.compared;
  const Extents &e = elements_[p].extents, &f = elements_[q].extents;
  if (!e.overlap(f, 0)) {
    ++counts.apart_in_x;
  } else if (!e.overlap(f, 1)) {
    ++counts.apart_in_y;
  } else if (elements_.lies_behind(p, q)) {
    ++counts.behind_plane;
  } else if (elements_.lies_before(q, p)) {
    ++counts.before_plane;
  } else {
    ++counts.projections;
    if (elements_.disjoint(p, q)) {
      ++counts.disjoint;
      return false;
    }
    ++counts.depths;
    if (elements_.hiding(p, q, work).first) return true;
    ++counts.farther;
  }
  return false;
}

}  // namespace ligne::newell
