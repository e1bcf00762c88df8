#include "visibility/watkins/state_tracking.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "base/no_index.hpp"

namespace ligne::watkins {

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

TrackedParts::TrackedParts(const std::vector<std::vector<TrackedPart>>& parts, std::size_t line_count)
    : first_(line_count + 1, 0) {
  std::vector<TrackedPart> all;
  for (const std::vector<TrackedPart>& group : parts) all.insert(all.end(), group.begin(), group.end());
  std::stable_sort(all.begin(), all.end(), [](const TrackedPart& a, const TrackedPart& b) { return a.line < b.line; });
  for (const TrackedPart& part : all) {
    if (!parts_.empty() && parts_.back().line == part.line && parts_.back().last + 1 == part.first) {
      parts_.back().last = part.last;
      parts_.back().to = part.to;
      parts_.back().beyond = part.beyond;
    } else {
      parts_.push_back(part);
      ++first_[part.line + 1];
    }
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
}

std::vector<LinePart> TrackedParts::visible_parts(std::size_t line, PartEnd end) const {
  std::vector<LinePart> parts;
  for (std::uint32_t i = first_[line]; i < first_[line + 1]; ++i) {
    const double from = parts_[i].from, to = end == PartEnd::first_hidden ? parts_[i].beyond : parts_[i].to;
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
  return static_cast<std::size_t>(
      std::count_if(parts_.begin(), parts_.end(), [](const TrackedPart& part) { return part.first == part.last; }));
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

}  // namespace ligne::watkins
