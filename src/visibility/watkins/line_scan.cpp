#include "visibility/watkins/line_scan.hpp"

#include <algorithm>
#include <cassert>
#include <type_traits>

#include "base/no_index.hpp"

namespace ligne::watkins {

LineScan::LineScan(const ScanScene& scene, const std::vector<ProjectedVertex>& vertices, const std::vector<Facet>& facets,
                   std::span<const SweepLine> lines, const ScanOptions& options, LineListener& listener)
    : scene_(scene),
      lines_(lines),
      options_(options),
      listener_(listener),
      face_orders_(vertices, facets, scene.of_faces, scene.skew),
      open_(scene.face_count, 0) {
  if (scene.grid.whole) {
    whole_ = make_span_method<std::int32_t>(options.kind);
    whole_->ask(this);
  } else {
    real_ = make_span_method<double>(options.kind);
    real_->ask(this);
    real_->record(options.trace);
  }
}

SpanCounts LineScan::span_counts() const {
  SpanCounts counts = whole_ ? whole_->counts() : real_->counts();
  counts.swaps += sort_swaps_;
  return counts;
}

void LineScan::scan(std::uint32_t first, std::uint32_t end) {
  begin(first);
  for (std::uint32_t line = first; line < end; ++line) {
    if (line != first) ended_edges_.clear();
    const bool studied = take_line(line);
    if (order_.empty()) {
      listener_.line(*this, line, studied);
      continue;
    }
    ++counts_.lines;
    listener_.line(*this, line, studied);
  }
  for (const std::uint32_t slot : order_) listener_.ended(*this, slot);
}

std::uint32_t LineScan::make_slot(std::uint32_t edge, const EdgeTrack& track) {
  if (free_slots_.empty()) {
    free_slots_.push_back(static_cast<std::uint32_t>(slots_.size()));
    slots_.emplace_back();
  }
  const std::uint32_t slot = free_slots_.back();
  free_slots_.pop_back();
  slots_[slot] = {track, key(track.u), edge, false, true, kNone, kNone, kNone};
  return slot;
}

/// Begins a group with the edges that enter from above.
void LineScan::begin(std::uint32_t line) {
  order_.clear();
  spans_.clear();
  penetrating_.clear();
  must_study_ = true;
  opens_ = bends_ = false;
  ended_edges_.clear();
  if (line == 0) return;
  for (std::uint32_t e = 0; e < scene_.first_of_line[line]; ++e) {
    const EdgeTrack& track = scene_.edges[e].track;
    if (track.last == line && track.first < line) ended_edges_.push_back(e);
    if (track.last <= line) continue;
    // Places the edges one line above; taking the line advances them.
    EdgeTrack before = track.on(line);
    before.u -= track.du;
    before.z -= track.dz;
    order_.push_back(make_slot(e, before));
  }
}

/// Sorts the line's edges, and studies its spans or continues them; returns true if it studied them.
bool LineScan::take_line(std::uint32_t line) {
  advance_edges(line);
  const bool first = must_study_, exchanged = sort(line);
  const bool study = first || opens_ || bends_ || !options_.coherence || exchanged || changes_matter(line);
  for (const std::uint32_t slot : gone_) listener_.ended(*this, slot);
  if (study) {
    with_segments([this](auto& method, auto& segments) {
      collect_segments(segments);
      study_segments(method, segments);
    });
    opens_ = has_opening();
    count_study(first, exchanged);
  } else {
    follow_edges();
  }
  for (const std::uint32_t slot : gone_) free_slots_.push_back(slot);
  return study;
}

bool LineScan::has_opening() const {
  return std::ranges::any_of(ends_, [this](const SegmentEnds& ends) { return is_opening(ends); });
}

void LineScan::count_study(bool first, bool exchanged) {
  if (order_.empty()) return;
  ++counts_.studied;
  ++(first ? counts_.studied_first : exchanged ? counts_.studied_exchanges : counts_.studied_ends);
}

/// Moves the edges of the list to the line, takes out those that end, and collects those that enter.
void LineScan::advance_edges(std::uint32_t line) {
  ended_.clear();
  entered_.clear();
  gone_.clear();
  for (const std::uint32_t slot : order_) {
    ActiveEdge& a = slots_[slot];
    if (a.track.last == line) {
      ended_.push_back(slot);
      gone_.push_back(slot);
      ended_edges_.push_back(a.edge);
      continue;
    }
    a.track.advance();
    a.u = key(a.track.u);
    a.entered = false;
  }
  for (std::uint32_t e = scene_.first_of_line[line]; e < scene_.first_of_line[line + 1]; ++e) {
    if (scene_.edges[e].track.first == scene_.edges[e].track.last) continue;
    entered_.push_back(make_slot(e, scene_.edges[e].track));
  }
  counts_.ended += ended_.size();
  counts_.entered += entered_.size();
  if (options_.recognise && !must_study_) link_chains();
  std::erase_if(order_, [&](std::uint32_t& slot) {
    if (slots_[slot].track.last != line) return false;
    slot = slots_[slot].continues;
    return slot == kNone;
  });
}

/// Sorts the list. The old edges are nearly sorted, and each exchange is a change of the scene. Entering edges are sorted
/// separately and merged. Returns true if an exchange may be visible.
bool LineScan::sort(std::uint32_t line) {
  const auto before = [this](std::uint32_t a, std::uint32_t b) {
    const ActiveEdge &p = slots_[a], &q = slots_[b];
    if (p.u != q.u) return p.u < q.u;
    if (p.track.du != q.track.du) return p.track.du < q.track.du;
    return p.edge < q.edge;
  };
  bool matters = false;
  for (std::size_t i = 1; i < order_.size(); ++i) {
    const std::uint32_t moving = order_[i];
    std::size_t k = i;
    for (; k > 0 && slots_[moving].u < slots_[order_[k - 1]].u - kSamePlace; --k) {
      ++counts_.exchanges;
      if (!matters) matters = exchange_matters(line, moving, order_[k - 1]);
      if (!matters) ++counts_.passed_exchanges;
      order_[k] = order_[k - 1];
    }
    order_[k] = moving;
  }
  std::sort(entered_.begin(), entered_.end(), before);
  const auto middle = static_cast<std::ptrdiff_t>(order_.size());
  order_.insert(order_.end(), entered_.begin(), entered_.end());
  std::inplace_merge(order_.begin(), order_.begin() + middle, order_.end(),
                     [this](std::uint32_t a, std::uint32_t b) { return slots_[a].u < slots_[b].u; });
  if (!entered_.empty()) put_apart();
  return matters;
}

/// If an edge enters exactly on another edge, its side is undetermined. It goes to the side that it leaves; if the two
/// diverge, they are exchanged on the next line.
void LineScan::put_apart() {
  for (std::size_t i = 1; i < order_.size(); ++i) {
    for (std::size_t k = i; k > 0; --k) {
      const ActiveEdge &p = slots_[order_[k - 1]], &q = slots_[order_[k]];
      if (q.u - p.u > kSamePlace || !(p.entered || q.entered) || p.track.du >= q.track.du) break;
      std::swap(order_[k - 1], order_[k]);
    }
  }
}

/// Continues the spans: each keeps its edges.
void LineScan::follow_edges() {
  for (LineSpan& s : spans_) {
    s.u0 = slots_[s.left].u;
    s.u1 = slots_[s.right].u;
  }
}

/// The segments of a face lie between its first and second edge on the line, its third and fourth, and so on.
template <class X>
void LineScan::collect_segments(std::vector<ScanSegment<X>>& segments) {
  segments.clear();
  ends_.clear();
  const auto coordinate = [](double u) {
    if constexpr (std::is_integral_v<X>) {
      return static_cast<X>(u);
    } else {
      return u;
    }
  };
  for (const std::uint32_t slot : order_) {
    const ActiveEdge& a = slots_[slot];
    for (const std::uint32_t face : scene_.faces_of(scene_.edges[a.edge])) {
      if (open_[face] == 0) {
        segments.push_back({coordinate(a.u), coordinate(a.u), a.track.z, a.track.z, static_cast<std::uint32_t>(ends_.size()),
                            face, scene_.depth_tolerance[face]});
        ends_.push_back({slot, slot, a.u, a.u, face});
        open_[face] = static_cast<std::uint32_t>(ends_.size());
      } else {
        const std::uint32_t i = open_[face] - 1;
        segments[i].x1 = coordinate(a.u);
        segments[i].z1 = a.track.z;
        ends_[i].right = slot;
        ends_[i].u1 = a.u;
        open_[face] = 0;
      }
    }
  }
  counts_.segments += segments.size();
  if (!options_.sorted) {
    std::sort(segments.begin(), segments.end(), [this](const auto& a, const auto& b) {
      return std::pair(ends_[a.face].face, a.face) < std::pair(ends_[b.face].face, b.face);
    });
    return;
  }
  // The segments are sorted by left end; depth and slope decide equal ends.
  for (std::size_t i = 1; i < segments.size(); ++i) {
    const ScanSegment<X> moving = segments[i];
    std::size_t k = i;
    for (; k > 0 && comes_before(moving, segments[k - 1]); --k) {
      ++sort_swaps_;
      segments[k] = segments[k - 1];
    }
    segments[k] = moving;
  }
}

template <class X>
void LineScan::study_segments(SpanMethod<X>& method, const std::vector<ScanSegment<X>>& segments) {
  method.study(segments, found_);
  for (VisibleSpan& s : found_) s.segment = segments[s.segment].face;
  place_spans(found_);
}

template void LineScan::collect_segments(std::vector<ScanSegment<double>>&);
template void LineScan::collect_segments(std::vector<ScanSegment<std::int32_t>>&);
template void LineScan::study_segments(SpanMethod<double>&, const std::vector<ScanSegment<double>>&);
template void LineScan::study_segments(SpanMethod<std::int32_t>&, const std::vector<ScanSegment<std::int32_t>>&);

/// Finds the edges that bound the spans.
void LineScan::place_spans(const std::vector<VisibleSpan>& found) {
  assert(are_left_to_right(found));
  std::erase_if(order_, [this](std::uint32_t slot) {
    slots_[slot].boundary = false;
    slots_[slot].before = slots_[slot].after = kNone;
    if (slots_[slot].edge != scene_.unlisted) return false;
    free_slots_.push_back(slot);
    return true;
  });
  spans_.clear();
  penetrating_.clear();
  bends_ = false;
  must_study_ = false;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const VisibleSpan& s = found[i];
    const SegmentEnds& ends = ends_[s.segment];
    LineSpan span{kNone, kNone, s.x0, s.x1, ends.face};
    span.left = i > 0 && found[i - 1].x1 == s.x0 ? spans_.back().right : ends.left;
    span.right = i + 1 < found.size() && found[i + 1].x0 == s.x1 ? boundary_between(s, found[i + 1]) : ends.right;
    slots_[span.left].boundary = slots_[span.right].boundary = true;
    slots_[span.left].after = slots_[span.right].before = static_cast<std::uint32_t>(i);
    spans_.push_back(span);
  }
}

/// The edge between two adjacent spans: the right end of the left one, the left end of the right one, or, if neither ends,
/// the line along which their faces penetrate.
std::uint32_t LineScan::boundary_between(const VisibleSpan& left, const VisibleSpan& right) {
  const SegmentEnds &l = ends_[left.segment], &r = ends_[right.segment];
  if (l.u1 == left.x1) return l.right;
  if (r.u0 == right.x0) return r.left;
  const double near = 1;  // one cell
  std::uint32_t best = kNone;
  double distance = near;
  const std::uint32_t f = std::min(l.face, r.face), g = std::max(l.face, r.face);
  const auto from =
      std::partition_point(order_.begin(), order_.end(), [&](std::uint32_t s) { return slots_[s].u < left.x1 - near; });
  for (auto s = from; s != order_.end() && slots_[*s].u <= left.x1 + near; ++s) {
    const ActiveEdge& a = slots_[*s];
    for (const std::uint32_t line : scene_.lines_of(scene_.edges[a.edge])) {
      if (std::min(lines_[line].face0, lines_[line].face1) != f || std::max(lines_[line].face0, lines_[line].face1) != g)
        continue;
      if (std::abs(a.u - left.x1) < distance) {
        distance = std::abs(a.u - left.x1);
        best = *s;
      }
    }
  }
  return best == kNone ? penetration_edge(left, right) : best;
}

/// Makes an edge between two penetrating spans, for the time until the next study, along the intersection of the planes. A
/// skew face penetrates others along a curve: the next line is studied.
std::uint32_t LineScan::penetration_edge(const VisibleSpan& left, const VisibleSpan& right) {
  const std::uint32_t f = ends_[left.segment].face, g = ends_[right.segment].face;
  for (const std::uint32_t face : {f, g}) {
    if (std::find(penetrating_.begin(), penetrating_.end(), face) == penetrating_.end()) penetrating_.push_back(face);
  }
  bends_ = bends_ || scene_.is_skew(f) || scene_.is_skew(g);
  if (prepared_) return any_slot_;
  EdgeTrack track{.u = left.x1, .last = kNone};
  const GridPlane &p = scene_.planes[f], &q = scene_.planes[g];
  const double step = (q.zv - p.zv) / (p.zu - q.zu);
  // Otherwise vertical: parallel planes of faces that are not quite planar, or a curve, which the next study follows.
  if (std::isfinite(step) && !scene_.is_skew(f) && !scene_.is_skew(g)) track.du = step;
  const std::uint32_t slot = make_slot(scene_.unlisted, track);
  slots_[slot].entered = false;
  order_.insert(
      std::partition_point(order_.begin(), order_.end(), [&](std::uint32_t s) { return slots_[s].u < slots_[slot].u; }),
      slot);
  return slot;
}

}  // namespace ligne::watkins
