#include "visibility/watkins/state_tracking.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/no_index.hpp"

namespace ligne::watkins {
namespace {

/// The depth of two faces where they penetrate on a line: that of a plane, or of the segment of a skew face.
double depth_at(const LineScan& scan, double u, std::uint32_t face, std::uint32_t other, std::uint32_t line) {
  const ScanScene& scene = scan.scene();
  if (!scene.is_skew(face)) return scene.planes[face].z(u, line);
  if (!scene.is_skew(other)) return scene.planes[other].z(u, line);
  for (const ScanSegment<double>& s : scan.segments()) {
    if (scan.face_of(s) == face && s.x0 <= u && u <= s.x1) return s.z(u);
  }
  return scene.skew->farthest(face);  // whole coordinates keep no segments
}

}  // namespace

/// The parameter of a line where a scan line meets it.
double StateTracker::place(const ScanEdge& edge, std::uint32_t line_index, std::uint32_t line) const {
  const SweepLine& l = lines_[line_index];
  const double down = std::clamp((line - edge.v_top) / (edge.v_bottom - edge.v_top), 0.0, 1.0);
  return comes_before(l.from.p, l.to.p) ? down : 1 - down;
}

/// The edge of the slot bounds a span: state 2.
void StateTracker::see(const LineScan& scan, std::uint32_t slot, std::uint32_t line) {
  const ScanEdge& edge = scan.scene().edges[scan.active(slot).edge];
  for (const std::uint32_t index : scan.scene().lines_of(edge)) {
    const double t = place(edge, index, line);
    const double beyond = line + 1 < edge.track.last ? place(edge, index, line + 1) : t;
    if (part_of_.size() <= index) part_of_.resize(lines_.size(), kNone);
    const std::uint32_t known = part_of_[index];
    if (known != kNone && parts_[known].last + 1 >= line) {
      parts_[known].last = line;
      parts_[known].to = t;
      parts_[known].beyond = beyond;
    } else {
      part_of_[index] = static_cast<std::uint32_t>(parts_.size());
      parts_.push_back({index, line, line, t, t, beyond});
    }
  }
}

void StateTracker::line(const LineScan& scan, std::uint32_t line, bool) {
  const std::vector<LineSpan>& spans = scan.spans();
  for (std::size_t i = 0; i < spans.size(); ++i) {
    const LineSpan& s = spans[i];
    see(scan, s.left, line);
    see(scan, s.right, line);
    if (i + 1 == spans.size() || s.u1 != spans[i + 1].u0) continue;
    if (scan.active(s.right).edge != scan.scene().unlisted) continue;
    points_.push_back({s.u1, depth_at(scan, s.u1, s.face, spans[i + 1].face, line), line,
                       std::min(s.face, spans[i + 1].face), std::max(s.face, spans[i + 1].face)});
  }
}

std::vector<TrackedPart> StateTracker::take_parts() {
  std::stable_sort(parts_.begin(), parts_.end(), [](const TrackedPart& a, const TrackedPart& b) { return a.line < b.line; });
  return std::move(parts_);
}

TrackedParts::TrackedParts(const std::vector<std::vector<TrackedPart>>& parts, std::size_t line_count) {
  std::vector<TrackedPart> all;
  for (const std::vector<TrackedPart>& group : parts) all.insert(all.end(), group.begin(), group.end());
  std::stable_sort(all.begin(), all.end(), [](const TrackedPart& a, const TrackedPart& b) { return a.line < b.line; });
  std::vector<TrackedPart> joined;
  for (const TrackedPart& part : all) {
    if (!joined.empty() && joined.back().line == part.line && joined.back().last + 1 == part.first) {
      joined.back().last = part.last;
      joined.back().to = part.to;
      joined.back().beyond = part.beyond;
    } else {
      joined.push_back(part);
    }
  }
  parts_ = {line_count, [&](const auto& put) {
              for (const TrackedPart& part : joined) put(part.line, part);
            }};
}

std::vector<LinePart> TrackedParts::visible_parts(std::size_t line, PartEnd end) const {
  std::vector<LinePart> parts;
  for (const TrackedPart& part : parts_[line]) {
    const double from = part.from, to = end == PartEnd::first_hidden ? part.beyond : part.to;
    parts.push_back({std::min(from, to), std::max(from, to)});
  }
  std::sort(parts.begin(), parts.end(), [](const LinePart& a, const LinePart& b) { return a.from < b.from; });
  std::vector<LinePart> joined;
  for (const LinePart& part : parts) {
    if (!(part.from < part.to)) continue;
    if (!joined.empty() && part.from <= joined.back().to) {
      joined.back().to = std::max(joined.back().to, part.to);
    } else {
      joined.push_back(part);
    }
  }
  return joined;
}

std::size_t TrackedParts::points() const {
  const auto is_point = [](const TrackedPart& part) { return part.first == part.last; };
  return static_cast<std::size_t>(std::ranges::count_if(parts_.values, is_point));
}

/// A place on a line of the grid as a point of the page.
static ProjectedVertex vertex_at(const LineGrid& grid, double u, std::uint32_t line, double z) {
  const double y = grid.v_origin + line * grid.spacing;
  return {{static_cast<std::int32_t>(std::lround(grid.x(u))), static_cast<std::int32_t>(std::lround(y))}, z};
}

std::vector<Intersection> curves_of_points(std::vector<PenetrationPoint> points, const ScanScene& scene) {
  std::erase_if(points, [&](const PenetrationPoint& p) { return !scene.is_skew(p.face0) && !scene.is_skew(p.face1); });
  const auto key = [](const PenetrationPoint& p) { return std::tuple(p.face0, p.face1, p.line, p.u); };
  std::ranges::sort(points, {}, key);
  const auto end_of_row = [&](std::size_t begin) {
    std::size_t end = begin;
    const auto row = [](const PenetrationPoint& p) { return std::tuple(p.face0, p.face1, p.line); };
    while (end < points.size() && row(points[end]) == row(points[begin])) ++end;
    return end;
  };
  std::vector<Intersection> curves;
  for (std::size_t begin = 0; begin < points.size();) {
    const std::size_t middle = end_of_row(begin), end = middle < points.size() ? end_of_row(middle) : middle;
    const PenetrationPoint& first = points[begin];
    const bool adjacent = middle < end && points[middle].face0 == first.face0 && points[middle].face1 == first.face1 &&
                          points[middle].line == first.line + 1;
    if (adjacent && end - middle == middle - begin) {
      for (std::size_t i = begin; i < middle; ++i) {
        const PenetrationPoint &a = points[i], &b = points[middle + i - begin];
        curves.push_back(
            {vertex_at(scene.grid, a.u, a.line, a.z), vertex_at(scene.grid, b.u, b.line, b.z), a.face0, a.face1});
      }
    }
    begin = middle;
  }
  return curves;
}

std::vector<Intersection> marks_of_points(const std::vector<PenetrationPoint>& points, const ScanScene& scene) {
  std::vector<Intersection> marks;
  for (const PenetrationPoint& p : points) {
    const auto end = [&](double u) {
      return vertex_at(scene.grid, u, p.line, scene.is_skew(p.face0) ? p.z : scene.planes[p.face0].z(u, p.line));
    };
    constexpr double kHalfCell = 0.5;
    marks.push_back({end(p.u - kHalfCell), end(p.u + kHalfCell), p.face0, p.face1});
  }
  return marks;
}

EdgeTracker::Tracks& EdgeTracker::tracks_of(const LineScan& scan, std::uint32_t slot) {
  if (slot >= tracks_.size()) tracks_.resize(slot + 1);
  Tracks& tracks = tracks_[slot];
  if (tracks.used == 0) {
    tracks.used = scan.scene().lines_of(scan.scene().edges[scan.active(slot).edge]).size();
    if (tracks.of_line.size() < tracks.used) tracks.of_line.resize(tracks.used);
    for (std::size_t i = 0; i < tracks.used; ++i) {
      tracks.of_line[i].tested.clear();
      tracks.of_line[i].hidden.clear();
      tracks.of_line[i].state = State::unknown;
    }
  }
  return tracks;
}

void EdgeTracker::line(const LineScan& scan, std::uint32_t line, bool studied) {
  between_lines(scan, line);
  if (!studied) return;
  for (const std::uint32_t slot : scan.order()) {
    const ScanEdge& edge = scan.scene().edges[scan.active(slot).edge];
    if (edge.lines_begin != edge.lines_end) look(scan, slot, line);
  }
}

template <class Visit>
void EdgeTracker::for_each_span(const LineScan& scan, double low, double high, Visit visit) const {
  const std::vector<LineSpan>& spans = scan.spans();
  auto s = std::partition_point(spans.begin(), spans.end(), [&](const LineSpan& span) { return span.u1 < low; });
  for (; s != spans.end() && s->u0 <= high; ++s) visit(*s);
}

/// Reads the state of an edge from the spans of a scan line.
void EdgeTracker::look(const LineScan& scan, std::uint32_t slot, std::uint32_t line) {
  const ActiveEdge& a = scan.active(slot);
  const ScanEdge& edge = scan.scene().edges[a.edge];
  Tracks& tracks = tracks_of(scan, slot);
  ++counts_.positions;
  const double up = std::max(-1.0, edge.v_top - line), down = std::min(1.0, edge.v_bottom - line);
  const double u_up = a.track.u + up * a.track.du, u_down = a.track.u + down * a.track.du;
  const double low = std::min({u_up, u_down, a.u}), high = std::max({u_up, u_down, a.u});
  const std::span<const std::uint32_t> lines = scan.scene().lines_of(edge);
  for_each_span(scan, low, high, [&](const LineSpan& s) {
    for (std::size_t i = 0; i < lines.size(); ++i) hold_against(lines[i], tracks.of_line[i], s.face);
  });
  for (std::size_t i = 0; i < lines.size(); ++i) {
    Track& track = tracks.of_line[i];
    const SweepLine& l = lines_[lines[i]];
    if (track.state == State::unknown) track.t = -1;
    // The parameter of the scan line on the edge's line, counted from l.from.
    const double down_share = (line - edge.v_top) / (edge.v_bottom - edge.v_top);
    const double t = std::clamp(comes_before(l.from.p, l.to.p) ? down_share : 1 - down_share, 0.0, 1.0);
    bool left = false, right = false;
    for (const HiddenInterval& h : track.hidden) {
      if (h.from > t || h.to < t) continue;
      left |= h.sides != HiddenSides::right;
      right |= h.sides != HiddenSides::left;
    }
    const State now = left && right ? State::hidden : State::visible;
    if (now != track.state && track.state != State::unknown)
      ++(now == State::visible ? counts_.became_visible : counts_.became_hidden);
    // The edge is hidden on two successive scan lines that it crosses steeply. A visible part between them is below the
    // resolution.
    if (now == State::hidden && std::abs(a.track.du) <= 1) {
      if (track.state == State::unknown && edge.v_top > line - 1.0)
        track.t = comes_before(l.from.p, l.to.p) ? 0 : 1;  // from the top of the edge on
      if (track.state != State::visible && track.t >= 0)
        track.hidden.push_back({std::min(track.t, t), std::max(track.t, t), HiddenSides::both});
      if (edge.v_bottom <= line + 1.0) {  // and down to its bottom
        const double end = comes_before(l.from.p, l.to.p) ? 1 : 0;
        track.hidden.push_back({std::min(t, end), std::max(t, end), HiddenSides::both});
      }
    }
    track.state = now;
    track.t = t;
  }
}

/// Parts of edges between this scan line and the preceding or following one, if that one does not meet them: whole edges
/// between two scan lines, and the parts of other edges beyond their first and last scan line.
void EdgeTracker::between_lines(const LineScan& scan, std::uint32_t line) {
  const ScanScene& scene = scan.scene();
  for (std::uint32_t e = scene.first_of_line[line]; e < scene.first_of_line[line + 2]; ++e) {
    const ScanEdge& edge = scene.edges[e];
    if (edge.track.first == edge.track.last) {
      hold_part(scan, edge, edge.u_top, edge.u_bottom);
    } else if (edge.track.first == line + 1) {
      hold_part(scan, edge, edge.u_top, edge.track.u);
    }
  }
  for (const std::uint32_t e : scan.ended_edges()) {
    const ScanEdge& edge = scene.edges[e];
    hold_part(scan, edge, edge.track.on(edge.track.last - 1).u, edge.u_bottom);
  }
}

void EdgeTracker::hold_part(const LineScan& scan, const ScanEdge& edge, double u0, double u1) {
  for (const std::uint32_t index : scan.scene().lines_of(edge)) {
    Track track;
    for_each_span(scan, std::min(u0, u1), std::max(u0, u1), [&](const LineSpan& s) { hold_against(index, track, s.face); });
    for (const HiddenInterval& h : track.hidden) findings_.push_back({index, h});
  }
}

void EdgeTracker::hidden_point(const LineScan& scan, std::uint32_t slot, std::uint32_t face) {
  const std::span<const std::uint32_t> lines = scan.scene().lines_of(scan.scene().edges[scan.active(slot).edge]);
  if (lines.empty()) return;
  Tracks& tracks = tracks_of(scan, slot);
  for (std::size_t i = 0; i < lines.size(); ++i) hold_against(lines[i], tracks.of_line[i], face);
}

void EdgeTracker::hold_against(std::uint32_t index, Track& track, std::uint32_t face) {
  const SweepLine& l = lines_[index];
  if (face == l.face0 || face == l.face1 || !l.to_study()) return;
  if (std::find(track.tested.begin(), track.tested.end(), face) != track.tested.end()) return;
  track.tested.push_back(face);
  const PageLine line(l.from, l.to, l.face0, l.face1);
  if (scene_.is_skew(face)) {
    for (const RuledPart& part : scene_.skew->parts(face)) {
      ++counts_.facet_tests;
      for (const HiddenInterval& h : behind_ruled_part(line, part, scene_.skew->depth_tolerance(face))) {
        if (h.sides != HiddenSides::none) track.hidden.push_back(h);
      }
    }
    return;
  }
  bool near_side = false;
  for (const std::uint32_t f : scene_.of_faces[face]) {
    ++counts_.facet_tests;
    const HiddenInterval h = hidden_interval(line, facets_[f], vertices_.data(), {0, 1}, coincidence_steps_, near_side);
    if (h.sides != HiddenSides::none) track.hidden.push_back(h);
  }
}

void EdgeTracker::ended(const LineScan& scan, std::uint32_t slot) {
  if (slot >= tracks_.size() || tracks_[slot].used == 0) return;
  const std::span<const std::uint32_t> lines = scan.scene().lines_of(scan.scene().edges[scan.active(slot).edge]);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (const HiddenInterval& h : tracks_[slot].of_line[i].hidden) findings_.push_back({lines[i], h});
  }
  tracks_[slot].used = 0;
}

}  // namespace ligne::watkins
