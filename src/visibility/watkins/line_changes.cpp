#include <algorithm>

#include "base/no_index.hpp"
#include "visibility/watkins/line_scan.hpp"

// Changes from one scan line to the next, and whether they are visible ([Boulle1980] 2.3.5.5, figure 2.59).

namespace ligne::watkins {

/// True if exchanging two edges may be visible. It is not if neither bounds a span (figure 2.59 c), or if one crosses the
/// end of a span and the next span hides it as well.
bool LineScan::exchange_matters(std::uint32_t line, std::uint32_t to_the_left, std::uint32_t to_the_right) {
  if (!options_.recognise || must_study_) return true;
  const ActiveEdge &l = slots_[to_the_left], &r = slots_[to_the_right];
  if (!l.boundary && !r.boundary) return false;
  if (l.boundary && r.boundary) return true;
  const std::uint32_t span = l.boundary ? l.after : r.before, hidden = l.boundary ? to_the_right : to_the_left;
  if (span == kNone || !behind(line, slots_[hidden], spans_[span].face)) return true;
  listener_.hidden_point(*this, hidden, spans_[span].face);
  return false;
}

/// True if an edge is behind a face by more than the face's depth changes within a cell.
bool LineScan::behind(std::uint32_t line, const ActiveEdge& a, std::uint32_t face) const {
  const GridPlane& plane = scene_.planes[face];
  return a.track.z > plane.z(a.u, line) + std::abs(plane.zu) + std::abs(plane.zv);
}

bool LineScan::same_faces(std::uint32_t a, std::uint32_t b) const {
  const auto p = scene_.faces_of(scene_.edges[a]), q = scene_.faces_of(scene_.edges[b]);
  return std::equal(p.begin(), p.end(), q.begin(), q.end());
}

/// Sorts the ended edges by their bottom vertex, and the entered ones by their top vertex.
void LineScan::sort_by_vertex() {
  const auto sort = [this](std::vector<std::uint32_t>& slots, auto vertex_of) {
    by_vertex_.clear();
    for (const std::uint32_t slot : slots) by_vertex_.push_back({vertex_of(scene_.edges[slots_[slot].edge]), slot});
    std::ranges::sort(by_vertex_);
    for (std::size_t i = 0; i < slots.size(); ++i) slots[i] = by_vertex_[i].second;
  };
  sort(ended_, [](const ScanEdge& e) { return e.bottom; });
  sort(entered_, [](const ScanEdge& e) { return e.top; });
}

/// Calls visit(ended, entered) for each vertex, with the edges that end and begin there.
template <class Visit>
void LineScan::for_each_vertex(Visit visit) const {
  const std::span<const std::uint32_t> ended = ended_, entered = entered_;
  std::size_t i = 0, k = 0;
  while (i < ended.size() || k < entered.size()) {
    const auto bottom = [&](std::size_t n) { return n < ended.size() ? scene_.edges[slots_[ended[n]].edge].bottom : kNone; };
    const auto top = [&](std::size_t n) { return n < entered.size() ? scene_.edges[slots_[entered[n]].edge].top : kNone; };
    const std::uint32_t vertex = std::min(bottom(i), top(k));
    std::size_t i_end = i, k_end = k;
    while (bottom(i_end) == vertex) ++i_end;
    while (top(k_end) == vertex) ++k_end;
    visit(ended.subspan(i, i_end - i), entered.subspan(k, k_end - k));
    i = i_end;
    k = k_end;
  }
}

/// Links an ended edge to its continuation in another direction (figure 2.59 a). The new edge takes the place of the old one
/// before the list is sorted, so that it is exchanged with others as the old one would have been.
void LineScan::link_chains() {
  if (ended_.empty() || entered_.empty()) return;
  sort_by_vertex();
  bool any = false;
  for_each_vertex([&](std::span<const std::uint32_t> ended, std::span<const std::uint32_t> entered) {
    if (ended.size() != 1 || entered.size() != 1) return;
    ActiveEdge &from = slots_[ended[0]], &to = slots_[entered[0]];
    // A hidden line tells nothing about its continuation.
    const bool known = scene_.lines_of(scene_.edges[to.edge]).empty() || from.boundary;
    if (!known || !same_faces(from.edge, to.edge)) return;
    from.continues = entered[0];
    to.entered = false;
    to.boundary = from.boundary;
    to.before = from.before;
    to.after = from.after;
    if (to.before != kNone) spans_[to.before].right = from.continues;
    if (to.after != kNone) spans_[to.after].left = from.continues;
    ++counts_.passed_chains;
    any = true;
  });
  if (!any) return;
  std::erase_if(ended_, [this](std::uint32_t slot) { return slots_[slot].continues != kNone; });
  std::erase_if(entered_, [this](std::uint32_t slot) { return !slots_[slot].entered; });
}

/// True if edges that end or begin change the visible picture.
bool LineScan::changes_matter(std::uint32_t line) {
  if (!options_.recognise) return !ended_.empty() || scene_.first_of_line[line] != scene_.first_of_line[line + 1];
  if (flat_edge_matters(line)) return true;
  if (ended_.empty() && entered_.empty()) return false;
  sort_by_vertex();
  bool matters = false;
  for_each_vertex([&](std::span<const std::uint32_t> ended, std::span<const std::uint32_t> entered) {
    matters = matters || vertex_matters(line, ended, entered);
  });
  return matters;
}

/// True if a horizontal or short edge between this scan line and the preceding one may change the picture. Such edges are in
/// no list. A face visible through a hole may begin or end with one, and at a horizontal line of intersection two faces may
/// exchange their order.
bool LineScan::flat_edge_matters(std::uint32_t line) const {
  for (std::uint32_t e = scene_.first_of_line[line]; e < scene_.first_of_line[line + 1]; ++e) {
    const ScanEdge& edge = scene_.edges[e];
    if (edge.track.first == edge.track.last && !behind_spans(line, edge)) return true;
  }
  return false;
}

/// True if an edge that no scan line meets lies behind the spans that it passes, which leave no gap.
bool LineScan::behind_spans(std::uint32_t line, const ScanEdge& edge) const {
  const EdgeTrack& track = edge.track;
  const bool rising = track.du >= 0;
  const double u0 = rising ? track.u : track.u + track.du, u1 = rising ? track.u + track.du : track.u;
  const double z0 = rising ? track.z : track.z + track.dz, z1 = rising ? track.z + track.dz : track.z;
  const auto hidden_at = [&](double u, const GridPlane& plane) {
    const double z = u1 - u0 > 1 ? z0 + (z1 - z0) * ((u - u0) / (u1 - u0)) : std::min(z0, z1);
    return z > plane.z(u, line) + std::abs(plane.zu) + std::abs(plane.zv);
  };
  auto span = std::partition_point(spans_.begin(), spans_.end(), [&](const LineSpan& s) { return s.u1 < u0; });
  if (span == spans_.end() || !(span->u0 < u0 - 1)) return false;
  for (double from = u0;; from = span->u1, ++span) {
    if (span == spans_.end() || span->u0 > from) return false;
    const double to = std::min(u1, span->u1);
    const GridPlane& plane = scene_.planes[span->face];
    if (!hidden_at(from, plane) || !hidden_at(to, plane)) return false;
    if (u1 < span->u1) return u1 < span->u1 - 1;
  }
}

/// True if the edges that end and begin at one vertex change the visible picture.
bool LineScan::vertex_matters(std::uint32_t line, std::span<const std::uint32_t> ended,
                              std::span<const std::uint32_t> entered) {
  for (const std::uint32_t slot : ended) {
    if (slots_[slot].boundary || bounds_a_penetration(slot)) return true;
  }
  for (const std::uint32_t slot : entered) {
    if (bounds_a_penetration(slot)) return true;
  }
  if (!entered.empty() && !behind_a_span(line, entered)) return true;
  ++counts_.passed_points;  // figure 2.59 b
  return false;
}

/// True if the edge bounds a face in a penetration without an edge: only the edges of the face show where the penetration
/// ends.
bool LineScan::bounds_a_penetration(std::uint32_t slot) const {
  if (penetrating_.empty()) return false;
  const std::span<const std::uint32_t> faces = scene_.faces_of(scene_.edges[slots_[slot].edge]);
  return std::ranges::any_of(faces,
                             [this](std::uint32_t f) { return std::ranges::find(penetrating_, f) != penetrating_.end(); });
}

/// True if all edges that enter at a vertex lie inside one span, behind its face.
bool LineScan::behind_a_span(std::uint32_t line, std::span<const std::uint32_t> entered) {
  const auto u0 = [this](const LineSpan& s) { return slots_[s.left].u; };
  const auto u1 = [this](const LineSpan& s) { return slots_[s.right].u; };
  const double u = slots_[entered.front()].u;
  const auto after = std::partition_point(spans_.begin(), spans_.end(), [&](const LineSpan& s) { return u0(s) < u; });
  if (after == spans_.begin()) return false;
  const LineSpan& span = *(after - 1);
  for (const std::uint32_t slot : entered) {
    const ActiveEdge& a = slots_[slot];
    // Margin of one cell: an edge that comes this near to the end of the span within the line must be studied.
    if (!(a.u - std::abs(a.track.du) > u0(span) && a.u + std::abs(a.track.du) < u1(span))) return false;
    if (!behind(line, a, span.face)) return false;
  }
  for (const std::uint32_t slot : entered) listener_.hidden_point(*this, slot, span.face);
  return true;
}

}  // namespace ligne::watkins
