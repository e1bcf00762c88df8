#include "visibility/watkins/exact/exact_sweep.hpp"

#include <cmath>

#include "base/no_index.hpp"

namespace ligne::watkins {
namespace {

/// x of an edge at a height within its range; for a horizontal edge the given x.
double abscissa(LatticePoint top, LatticePoint bottom, double y, double x) {
  if (top.y == bottom.y) return x;
  return top.x + (double(bottom.x) - top.x) * ((y - top.y) / (double(bottom.y) - top.y));
}

}  // namespace

void ExactSweep::scan(const SweepBand& band) {
  begin(band);
  for (std::uint32_t p = band.first; p < band.end; ++p) {
    if (effort_.spent()) return;
    at_crossings(scene_.points[p].y, scene_.points[p].x);
    at_point(p);
    counts_.most_active = std::max(counts_.most_active, active_count_);
  }
  if (band.end < scene_.points.size()) {
    const LatticePoint seam = scene_.points[band.end];
    at_crossings(seam.y, seam.x);
    finish(seam.y, seam.x);
  }
}

std::uint32_t ExactSweep::local_of(std::uint32_t e) const {
  const auto n = static_cast<std::uint32_t>(active_->size());
  if (e >= first_edge_) return n + (e - first_edge_);
  return static_cast<std::uint32_t>(std::lower_bound(active_->begin(), active_->end(), e) - active_->begin());
}

/// Inserts the edges from above in the order in which they cross the top of the band. Ties and rounding errors are corrected
/// as elsewhere.
void ExactSweep::begin(const SweepBand& band) {
  active_ = &band.active;
  first_edge_ = scene_.first_start[band.first];
  const std::size_t locals = band.active.size() + (scene_.first_start[band.end] - first_edge_);
  node_of_.assign(locals, kNone);
  next_in_node_.assign(locals, kNone);
  state_of_.assign(locals, kNone);
  const LatticePoint start = scene_.points[band.first];
  queue_ = {};
  x_ = start.x;
  y_ = start.y;
  struct Entry {
    double x, slope;
    std::uint32_t local;
  };
  std::vector<Entry> entries;
  entries.reserve(band.active.size());
  for (std::uint32_t i = 0; i < band.active.size(); ++i) {
    const SweepEdge& e = edge(i);
    const double dy = double(e.bottom.y) - e.top.y, dx = double(e.bottom.x) - e.top.x;
    entries.push_back({abscissa(e.top, e.bottom, y_, x_), dy == 0 ? dx * 0x1p30 : dx / dy, i});
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    if (a.x != b.x) return a.x < b.x;
    if (a.slope != b.slope) return a.slope < b.slope;
    return a.local < b.local;
  });
  std::uint32_t slot = SweepStatus::kLeftEnd;
  for (const Entry& e : entries) {
    const std::uint32_t node = make_node(std::span(&e.local, 1), e.x, y_);
    const std::uint32_t fresh = status_.insert_after(slot);
    status_.put(fresh, node);
    status_.cover(fresh) = status_.cover(slot);
    toggle_node(node, status_.cover(fresh));
    slot = fresh;
    ++active_count_;
  }
  for (std::uint32_t s = status_.next(SweepStatus::kLeftEnd); s != SweepStatus::kLeftEnd; s = status_.next(s)) check_pair(s);
}

std::uint32_t ExactSweep::make_node(std::span<const std::uint32_t> edges, double x, double y) {
  const std::uint32_t index = status_.make_node();
  SweepNode& node = status_.node(index);
  const SweepEdge& first = edge(edges.front());
  node.top = first.top;
  node.bottom = first.bottom;
  node.bottom_point = first.bottom_point;
  node.first = edges.front();
  node.has_lines = false;
  node.x = x;
  node.y = y;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    node_of_[edges[i]] = index;
    next_in_node_[edges[i]] = i + 1 < edges.size() ? edges[i + 1] : kNone;
    const SweepEdge& e = edge(edges[i]);
    node.has_lines |= e.lines_begin != e.lines_end;
  }
  return index;
}

void ExactSweep::toggle_node(std::uint32_t node, Cover& cover) {
  for (std::uint32_t e = status_.node(node).first; e != kNone; e = next_in_node_[e]) {
    for (const std::uint32_t f : scene_.facets_of(edge(e))) toggle(cover, f);
  }
}

/// Processes all crossings before (y, x).
void ExactSweep::at_crossings(double y, double x) {
  while (const std::optional<Crossing> next = queue_.take_before(y, x)) {
    const Crossing& c = *next;
    if (effort_.spent()) return;
    if (!still_to_come(c)) continue;
    const SweepNode &p = status_.node(c.left), &q = status_.node(c.right);
    y_ = c.y;
    x_ = c.x;
    ++counts_.crossings;
    if (!p.has_lines && !q.has_lines) ++counts_.hidden_crossings;
    exchange(p.slot);
  }
}

void ExactSweep::exchange(std::uint32_t s) {
  effort_.spend(status_.cover(s).size());
  const std::uint32_t t = status_.next(s), a = status_.node_at(s), b = status_.node_at(t), before = status_.previous(s);
  close(s, x_, y_);
  close(t, x_, y_);
  if (pairs_) {
    facets_of(a, left_facets_);
    facets_of(b, right_facets_);
    pairs_->at_crossing(left_facets_, right_facets_, status_.cover(before));
  }
  status_.put(s, b);
  status_.put(t, a);
  status_.cover(s) = status_.cover(before);
  toggle_node(b, status_.cover(s));
  open(a, x_, y_);
  open(b, x_, y_);
  check_pair(before);
  check_pair(t);
}

void ExactSweep::open(std::uint32_t node, double x, double y) {
  status_.node(node).x = x;
  status_.node(node).y = y;
}

/// Tests whether two neighbours must be exchanged, and where. The edge that ends first decides: its end lies on one side of
/// the other edge. Collinear neighbours become one node.
void ExactSweep::check_pair(std::uint32_t left_slot) {
  const std::uint32_t right_slot = status_.next(left_slot);
  if (left_slot == SweepStatus::kLeftEnd || right_slot == SweepStatus::kLeftEnd) return;
  const std::uint32_t a = status_.node_at(left_slot), b = status_.node_at(right_slot);
  const SweepNode &p = status_.node(a), &q = status_.node(b);
  // o0, o1: sides of the other edge on which the ends of the shorter-lived edge lie; positive in correct order.
  const bool p_ends_first = p.bottom_point <= q.bottom_point;
  const SweepNode &ending = p_ends_first ? p : q, &staying = p_ends_first ? q : p;
  const double sign = p_ends_first ? 1 : -1;
  const double o1 = sign * side(staying.top, staying.bottom, ending.bottom);
  if (o1 > 0) return;
  const double o0 = sign * side(staying.top, staying.bottom, ending.top);
  if (o1 == 0) {
    if (o0 == 0) join(left_slot);
    return;
  }
  const double t = o0 > 0 ? o0 / (o0 - o1) : 0;
  double y = ending.top.y + t * (double(ending.bottom.y) - ending.top.y);
  double x = ending.top.x + t * (double(ending.bottom.x) - ending.top.x);
  if (staying.top.y == staying.bottom.y) {
    y = staying.top.y;
    x = abscissa(ending.top, ending.bottom, y, x);
  } else if (ending.top.y == ending.bottom.y) {
    y = ending.top.y;
    x = abscissa(staying.top, staying.bottom, y, x);
  }
  if (y < y_ || (y == y_ && x < x_)) {
    y = y_;
    x = x_;
  }
  queue_.put({y, x, a, b, p.generation, q.generation});
}

bool ExactSweep::still_to_come(const Crossing& c) const {
  const SweepNode &p = status_.node(c.left), &q = status_.node(c.right);
  return p.generation == c.left_generation && q.generation == c.right_generation && status_.next(p.slot) == q.slot;
}

/// Joins two collinear neighbours.
void ExactSweep::join(std::uint32_t left_slot) {
  const std::uint32_t right_slot = status_.next(left_slot), before = status_.previous(left_slot);
  close(left_slot, x_, y_);
  close(right_slot, x_, y_);
  std::vector<std::uint32_t> edges;
  for (const std::uint32_t s : {left_slot, right_slot}) {
    const std::uint32_t n = status_.node_at(s);
    for (std::uint32_t e = status_.node(n).first; e != kNone; e = next_in_node_[e]) edges.push_back(e);
    status_.free_node(n);
  }
  const SweepEdge& e = edge(edges.front());
  const std::uint32_t node = make_node(edges, abscissa(e.top, e.bottom, y_, x_), y_);
  status_.put(left_slot, node);
  status_.cover(left_slot) = status_.cover(right_slot);
  status_.erase(right_slot);
  check_pair(before);
  check_pair(left_slot);
}

/// Studies the stretches of the slot's lines up to here.
void ExactSweep::close(std::uint32_t slot, double x, double y) {
  const SweepNode& node = status_.node(status_.node_at(slot));
  if (!node.has_lines) return;
  const Cover &left = status_.cover(status_.previous(slot)), &right = status_.cover(slot);
  const bool shared = next_in_node_[node.first] != kNone || neighbour_along(slot, x, y);
  for (std::uint32_t e = node.first; e != kNone; e = next_in_node_[e]) {
    const std::span<const std::uint32_t> lines = scene_.lines_of(edge(e));
    if (lines.empty()) continue;
    if (state_of_[e] == kNone) {
      if (free_states_.empty()) {
        free_states_.push_back(static_cast<std::uint32_t>(states_.size()));
        states_.emplace_back();
      }
      state_of_[e] = free_states_.back();
      free_states_.pop_back();
      states_[state_of_[e]].lines.resize(lines.size());
      for (LineState& s : states_[state_of_[e]].lines) s.clear();
    }
    const bool accompanied = shared || lines.size() > 1;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      LineState& state = states_[state_of_[e]].lines[i];
      state.near_side |= accompanied;
      study_.study(lines[i], state, {node.x, node.y}, {x, y}, left, right);
    }
  }
}

/// True if the left or right neighbour lies within the coincidence tolerance along the part of the slot's stretch that both
/// have reached.
bool ExactSweep::neighbour_along(std::uint32_t slot, double x, double y) const {
  const SweepNode& node = status_.node(status_.node_at(slot));
  const auto distance = [](const SweepNode& n, double px, double py) {
    const double dx = double(n.bottom.x) - n.top.x, dy = double(n.bottom.y) - n.top.y;
    return std::abs(dx * (py - n.top.y) - dy * (px - n.top.x)) / std::hypot(dx, dy);
  };
  for (const std::uint32_t s : {status_.previous(slot), status_.next(slot)}) {
    if (s == SweepStatus::kLeftEnd) continue;
    const SweepNode& other = status_.node(status_.node_at(s));
    if (distance(other, x, y) > near_steps_) continue;
    const bool later = other.top.y > node.y || (other.top.y == node.y && other.top.x > node.x);
    if ((later ? distance(node, other.top.x, other.top.y) : distance(other, node.x, node.y)) <= near_steps_) return true;
  }
  return false;
}

/// Stores the findings about the lines of an edge.
void ExactSweep::end_edge(std::uint32_t local) {
  --active_count_;
  if (state_of_[local] == kNone) return;
  const std::span<const std::uint32_t> lines = scene_.lines_of(edge(local));
  EdgeState& state = states_[state_of_[local]];
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (const HiddenInterval& h : state.lines[i].hidden) findings_.push_back({lines[i], h});
    if (state.lines[i].near_side) near_lines_.push_back(lines[i]);
  }
  free_states_.push_back(state_of_[local]);
  state_of_[local] = kNone;
}

/// Ends the band; the next one continues.
void ExactSweep::finish(double y, double x) {
  for (std::uint32_t s = status_.next(SweepStatus::kLeftEnd); s != SweepStatus::kLeftEnd; s = status_.next(s)) {
    const SweepNode& node = status_.node(status_.node_at(s));
    close(s, abscissa(node.top, node.bottom, y, x), y);
    for (std::uint32_t e = node.first; e != kNone; e = next_in_node_[e]) end_edge(e);
  }
}

/// Collects the facets with a side in the node in `facets`.
void ExactSweep::facets_of(std::uint32_t node, std::vector<std::uint32_t>& facets) const {
  facets.clear();
  for (std::uint32_t e = status_.node(node).first; e != kNone; e = next_in_node_[e]) {
    const std::span<const std::uint32_t> of_edge = scene_.facets_of(edge(e));
    facets.insert(facets.end(), of_edge.begin(), of_edge.end());
  }
}

}  // namespace ligne::watkins
