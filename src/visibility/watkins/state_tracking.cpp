#include "visibility/watkins/state_tracking.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

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

void StateTracker::line(const LineScan& scan, std::uint32_t line, bool) {
  const std::vector<LineSpan>& spans = scan.spans();
  for (std::size_t i = 0; i < spans.size(); ++i) {
    const LineSpan& s = spans[i];
    see(scan, s.left, line);
    see(scan, s.right, line);
    if (i + 1 == spans.size() || s.u1 != spans[i + 1].u0) continue;
    if (scan.active(s.right).edge != scan.scene().unlisted) continue;
    points_.push_back({s.u1, line, std::min(s.face, spans[i + 1].face), std::max(s.face, spans[i + 1].face)});
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

std::vector<Intersection> marks_of_points(const std::vector<PenetrationPoint>& points, const ScanScene& scene) {
  const LineGrid& grid = scene.grid;
  std::vector<Intersection> marks;
  for (const PenetrationPoint& p : points) {
    const double y = grid.v_origin + p.line * grid.spacing;
    const auto end = [&](double u) {
      const LatticePoint at{static_cast<std::int32_t>(std::lround(grid.x(u))), static_cast<std::int32_t>(std::lround(y))};
      return ProjectedVertex{at, scene.planes[p.face0].z(u, p.line)};
    };
    constexpr double kHalfCell = 0.5;
    marks.push_back({end(p.u - kHalfCell), end(p.u + kHalfCell), p.face0, p.face1});
  }
  return marks;
}

}  // namespace ligne::watkins
