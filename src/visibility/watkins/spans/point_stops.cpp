#include <algorithm>

#include "base/no_index.hpp"
#include "visibility/watkins/exact/exact_sweep.hpp"

// Stops of the exact scan at points: the slots whose edges pass through the point are closed and removed, edges that end
// there are dropped, edges that begin there are added, and all edges below it are inserted in the order of their directions.

namespace ligne::watkins {

/// The slots (before, last] whose nodes pass through the point; last == before if there is none.
void ExactSweep::find_range(std::uint32_t point, std::uint32_t& before, std::uint32_t& last) {
  const LatticePoint v = scene_.points[point];
  const std::span<const std::uint32_t> ends = scene_.ends[point];
  std::uint32_t first;
  if (ends.empty()) {
    ++counts_.searches;
    before = status_.last_left_of(v);
    last = before;
  } else {
    first = status_.node(node_of_[local_of(ends.front())]).slot;
    last = first;
    before = status_.previous(first);
  }
  while (before != SweepStatus::kLeftEnd && through(before, v)) before = status_.previous(before);
  while (status_.next(last) != SweepStatus::kLeftEnd && through(status_.next(last), v)) last = status_.next(last);
  for (const std::uint32_t edge : ends) draw_in(status_.node(node_of_[local_of(edge)]).slot, before, last);
}

/// Exchanges a slot, whose edge ends at the current point but lies outside the range by rounding, with its neighbours until
/// it is inside.
void ExactSweep::draw_in(std::uint32_t slot, std::uint32_t& before, std::uint32_t& last) {
  for (std::uint32_t s = status_.next(before); s != status_.next(last); s = status_.next(s)) {
    if (s == slot) return;
  }
  bool right = false;
  for (std::uint32_t s = status_.next(last); s != SweepStatus::kLeftEnd && !right; s = status_.next(s)) right = s == slot;
  if (right) {
    const std::uint32_t node = status_.node_at(slot);
    while (status_.next(last) != status_.node(node).slot) exchange(status_.previous(status_.node(node).slot));
    last = status_.next(last);
  } else {
    const std::uint32_t node = status_.node_at(slot);
    while (before != status_.node(node).slot) exchange(status_.node(node).slot);
    before = status_.previous(before);
  }
}

/// Collects the edges that continue below the point, and the facets at it.
void ExactSweep::collect_edges(std::uint32_t point, std::uint32_t before, std::uint32_t last) {
  going_on_.clear();
  touched_.clear();
  old_nodes_.clear();
  const auto touch = [this](const SweepEdge& e) {
    if (!pairs_) return;
    for (const std::uint32_t f : scene_.facets_of(e)) {
      if (!contains(touched_, f)) touched_.push_back(f);
    }
  };
  if (before != last) {
    for (std::uint32_t s = status_.next(before);; s = status_.next(s)) {
      const std::uint32_t n = status_.node_at(s);
      old_nodes_.push_back(n);
      for (std::uint32_t e = status_.node(n).first; e != kNone;) {
        const std::uint32_t next = next_in_node_[e];
        touch(edge(e));
        if (edge(e).bottom_point == point) {
          end_edge(e);
        } else {
          going_on_.push_back(e);
        }
        e = next;
      }
      if (s == last) break;
    }
  }
  for (std::uint32_t e = scene_.first_start[point]; e < scene_.first_start[point + 1]; ++e) {
    touch(scene_.edges[e]);
    going_on_.push_back(local_of(e));
    ++active_count_;
  }
}

void ExactSweep::at_point(std::uint32_t point) {
  const LatticePoint v = scene_.points[point];
  ++counts_.points;
  x_ = v.x;
  y_ = v.y;
  std::uint32_t before, last;
  find_range(point, before, last);
  if (before != last) {
    for (std::uint32_t s = status_.next(before);; s = status_.next(s)) {
      close(s, x_, y_);
      if (s == last) break;
    }
  }
  collect_edges(point, before, last);
  for (const std::uint32_t n : old_nodes_) status_.free_node(n);
  // Below the point the edges are sorted by direction; edges of equal direction become one node.
  std::sort(going_on_.begin(), going_on_.end(), [&](std::uint32_t a, std::uint32_t b) {
    const double turn = side(v, edge(b).bottom, edge(a).bottom);
    return turn != 0 ? turn > 0 : a < b;
  });
  std::uint32_t slot = before;
  for (std::size_t i = 0; i < going_on_.size();) {
    std::size_t end = i + 1;
    while (end < going_on_.size() && side(v, edge(going_on_[i]).bottom, edge(going_on_[end]).bottom) == 0) ++end;
    const std::uint32_t left = slot;
    if (slot != last) {
      slot = status_.next(slot);
    } else {
      last = slot = status_.insert_after(slot);
    }
    const std::uint32_t node = make_node(std::span(going_on_).subspan(i, end - i), x_, y_);
    status_.put(slot, node);
    status_.cover(slot) = status_.cover(left);
    toggle_node(node, status_.cover(slot));
    if (pairs_ && left != before) pairs_->at_point(touched_, status_.cover(left));
    i = end;
  }
  while (slot != last) {
    const std::uint32_t gone = status_.next(slot);
    const bool was_last = gone == last;
    status_.erase(gone);
    if (was_last) last = slot;
  }
  check_pair(before);
  if (slot != before) check_pair(slot);
}

}  // namespace ligne::watkins
