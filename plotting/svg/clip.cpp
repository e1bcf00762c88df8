#include "plotting/svg/clip.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <glm/geometric.hpp>

#include "plotting/svg/endless_work.hpp"

namespace ligne::svg {
namespace {

/// Adjustable: edges to a row.
constexpr std::size_t kRowEdges = 4, kMostRows = 4096;
constexpr std::size_t kMostClipWork = 1'000'000'000;
/// Edges that stand in rows count for more: they take memory.
constexpr std::size_t kEntryWork = 40;
/// Parts of a line that are shorter, in parts of it, are the rounding of a crossing.
constexpr double kLeastPart = 1e-12;

bool near_edge(Point2 p, Point2 a, Point2 b) {
  constexpr double kNearMm = 1e-6;  // rounding of coordinates
  if (p.x < std::min(a.x, b.x) - kNearMm || p.x > std::max(a.x, b.x) + kNearMm || p.y < std::min(a.y, b.y) - kNearMm ||
      p.y > std::max(a.y, b.y) + kNearMm)
    return false;
  return std::abs(cross(b - a, p - a)) <= kNearMm * glm::length(b - a);
}

void add(Polylines& out, std::vector<Point2>& line) {
  if (line.size() > 1) out.add(line);
  line.clear();
}

Polylines clipped_by_one(const Polylines& lines, const Clip& clip) {
  Polylines out;
  std::vector<double> at;
  std::vector<Point2> line;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto points = lines[i];
    for (std::size_t k = 1; k < points.size(); ++k) {
      const Point2 a = points[k - 1], b = points[k];
      at.assign({0, 1});
      for (const Area& area : clip.any_of) area.crossings(a, b, at);
      std::sort(at.begin(), at.end());
      bool shown = false;  // the part before, of this segment
      for (std::size_t n = 1; n < at.size(); ++n) {
        if (at.size() > 2 && at[n] - at[n - 1] <= kLeastPart) continue;
        const Point2 from = a + (b - a) * at[n - 1], to = at[n] == 1 ? b : a + (b - a) * at[n];
        if (!clip.shows(a + (b - a) * ((at[n - 1] + at[n]) / 2))) {
          add(out, line);
          shown = false;
          continue;
        }
        if (shown) line.pop_back();
        if (line.empty()) line.push_back(from);
        line.push_back(to);
        shown = true;
      }
    }
    add(out, line);
  }
  return out;
}

}  // namespace

void Area::count(std::size_t edges) const {
  if ((*work_ += edges) > kMostClipWork) throw EndlessWork("has a clip path that asks for endless work");
}

Area::Area(const Polylines& contours, FillRule rule, ClipWork work) : rule_(rule), work_(std::move(work)) {
  for (std::size_t i = 0; i < contours.size(); ++i) {
    const auto points = contours[i];
    for (std::size_t k = 0; k < points.size(); ++k) {
      const Point2 a = points[k], b = points[k + 1 == points.size() ? 0 : k + 1];
      box_.extend(a);
      if (a != b) edges_.push_back({a, b});
    }
  }
  rows_.resize(std::clamp<std::size_t>(edges_.size() / kRowEdges, 1, kMostRows));
  for (std::uint32_t i = 0; i < edges_.size(); ++i) {
    const std::size_t first = row(std::min(edges_[i].a.y, edges_[i].b.y)),
                      last = row(std::max(edges_[i].a.y, edges_[i].b.y));
    count(kEntryWork * (last - first + 1));
    for (std::size_t r = first; r <= last; ++r) rows_[r].push_back(i);
  }
}

std::size_t Area::row(double y) const {
  const double height = box_.height();
  if (!(height > 0)) return 0;
  return static_cast<std::size_t>(
      std::clamp((y - box_.min.y) / height * static_cast<double>(rows_.size()), 0.0, static_cast<double>(rows_.size() - 1)));
}

Polylines Area::contours_near(const Rect& box) const {
  Polylines all;
  if (edges_.empty() || box.min.y > box_.max.y || box.max.y < box_.min.y) return all;
  std::vector<std::uint32_t> near;
  for (std::size_t r = row(box.min.y); r <= row(box.max.y); ++r) {
    count(rows_[r].size() + 1);
    for (const std::uint32_t i : rows_[r]) {
      const Edge& e = edges_[i];
      if (std::max(e.a.x, e.b.x) < box.min.x || std::min(e.a.x, e.b.x) > box.max.x) continue;
      if (std::max(e.a.y, e.b.y) < box.min.y || std::min(e.a.y, e.b.y) > box.max.y) continue;
      near.push_back(i);
    }
  }
  std::ranges::sort(near);
  near.erase(std::unique(near.begin(), near.end()), near.end());
  std::vector<Point2> line;
  for (const std::uint32_t i : near) {
    const Edge& e = edges_[i];
    if (!line.empty() && line.back() != e.a) add(all, line);
    if (line.empty()) line.push_back(e.a);
    line.push_back(e.b);
    if (e.b == line.front()) add(all, line);
  }
  add(all, line);
  return all;
}

bool Area::contains(Point2 p) const { return place_of(p) != Place::outside; }
bool Area::surrounds(Point2 p) const { return place_of(p) == Place::inside; }

bool Clip::shows(Point2 p) const {
  for (std::size_t i = any_of.size(); i-- > 0;) {
    if (open ? any_of[i].surrounds(p) : any_of[i].contains(p)) return opens.empty() || opens[i];
  }
  return false;
}

Area::Place Area::place_of(Point2 p) const {
  if (edges_.empty() || p.x < box_.min.x || p.x > box_.max.x || p.y < box_.min.y || p.y > box_.max.y) return Place::outside;
  const std::vector<std::uint32_t>& near = rows_[row(p.y)];
  count(near.size());
  int winding = 0;
  for (const std::uint32_t i : near) {
    const Edge& e = edges_[i];
    if (near_edge(p, e.a, e.b)) return Place::rim;
    if ((e.a.y <= p.y) == (e.b.y <= p.y)) continue;
    const bool up = e.b.y > e.a.y;
    if ((cross(e.b - e.a, p - e.a) > 0) == up) winding += up ? 1 : -1;
  }
  return (rule_ == FillRule::nonzero ? winding != 0 : winding % 2 != 0) ? Place::inside : Place::outside;
}

void Area::crossings(Point2 a, Point2 b, std::vector<double>& out) const {
  if (edges_.empty() || std::max(a.x, b.x) < box_.min.x || std::min(a.x, b.x) > box_.max.x ||
      std::max(a.y, b.y) < box_.min.y || std::min(a.y, b.y) > box_.max.y)
    return;
  const Point2 along = b - a;
  const std::size_t first = row(std::min(a.y, b.y)), last = row(std::max(a.y, b.y));
  for (std::size_t r = first; r <= last; ++r) {
    count(rows_[r].size() + 1);
    for (const std::uint32_t i : rows_[r]) {
      const Edge& e = edges_[i];
      const double da = cross(along, e.a - a), db = cross(along, e.b - a);
      if ((da > 0 && db > 0) || (da < 0 && db < 0)) continue;
      const double across = cross(along, e.b - e.a), squared = glm::dot(along, along);
      // An edge on the line begins and ends there.
      for (const double t : across != 0
                                ? std::array{cross(e.a - a, e.b - e.a) / across, -1.0}
                                : std::array{glm::dot(e.a - a, along) / squared, glm::dot(e.b - a, along) / squared}) {
        if (t > 0 && t < 1) out.push_back(t);
      }
    }
  }
}

Polylines clipped(const Polylines& lines, const Clip& clip) {
  const Polylines inside = clipped_by_one(lines, clip);
  return clip.outer ? clipped(inside, *clip.outer) : inside;
}

}  // namespace ligne::svg
