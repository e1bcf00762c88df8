#include "plotting/svg/occluder.hpp"

#include <algorithm>
#include <cmath>

namespace ligne::svg {
namespace {

/// Adjustable: most cells along a side of the grid of occluders.
constexpr double kMostCells = 256;
/// Parts of a segment that are shorter, in parts of it, are the rounding of a crossing.
constexpr double kLeastPartSeen = 1e-12;

bool hidden_by(const Occluder& occluder, Point2 p) {
  if (!occluder.area.surrounds(p)) return false;
  for (const Clip* clip = occluder.clip.get(); clip; clip = clip->outer.get()) {
    if (!clip->shows(p)) return false;
  }
  return true;
}

void add_crossings(const Occluder& occluder, Point2 a, Point2 b, std::vector<double>& at) {
  occluder.area.crossings(a, b, at);
  for (const Clip* clip = occluder.clip.get(); clip; clip = clip->outer.get()) {
    for (const Area& area : clip->any_of) area.crossings(a, b, at);
  }
}

}  // namespace

Occluders::Occluders(std::span<const Occluder> occluders) : occluders_(occluders) {
  for (const Occluder& occluder : occluders) {
    if (occluder.area.empty()) continue;
    box_.extend(occluder.area.box().min);
    box_.extend(occluder.area.box().max);
  }
  side_ = static_cast<std::size_t>(std::clamp(std::sqrt(static_cast<double>(occluders.size())), 1.0, kMostCells));
  cells_.resize(side_ * side_);
  for (std::uint32_t i = 0; i < occluders.size(); ++i) {
    if (occluders[i].area.empty()) continue;
    const Rect& box = occluders[i].area.box();
    for (std::size_t y = cell(box.min.y, 1); y <= cell(box.max.y, 1); ++y) {
      for (std::size_t x = cell(box.min.x, 0); x <= cell(box.max.x, 0); ++x) cells_[y * side_ + x].push_back(i);
    }
  }
}

std::size_t Occluders::cell(double at, int axis) const {
  const double size = box_.max[axis] - box_.min[axis];
  if (!(size > 0)) return 0;
  const double side = static_cast<double>(side_);
  return static_cast<std::size_t>(std::clamp((at - box_.min[axis]) / size * side, 0.0, side - 1));
}

void Occluders::find_over(Point2 a, Point2 b, std::uint32_t painted) {
  over_.clear();
  const Point2 low{std::min(a.x, b.x), std::min(a.y, b.y)}, high{std::max(a.x, b.x), std::max(a.y, b.y)};
  for (std::size_t y = cell(low.y, 1); y <= cell(high.y, 1); ++y) {
    for (std::size_t x = cell(low.x, 0); x <= cell(high.x, 0); ++x) {
      for (const std::uint32_t i : cells_[y * side_ + x]) {
        const Rect& box = occluders_[i].area.box();
        // Of a line that stands upright the borders count too.
        const bool across =
            low.x == high.x ? box.min.x <= low.x && box.max.x >= low.x : box.min.x < high.x && box.max.x > low.x;
        const bool along = box.min.y <= high.y && box.max.y >= low.y;
        if (occluders_[i].painted > painted && across && along) over_.push_back(i);
      }
    }
  }
  std::sort(over_.begin(), over_.end());
  over_.erase(std::unique(over_.begin(), over_.end()), over_.end());
}

void Occluders::remove_hidden(Polylines& lines, std::vector<std::uint32_t>& painted) {
  Polylines seen;
  std::vector<std::uint32_t> when;
  std::vector<Point2> line;
  std::vector<double> at;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto points = lines[i];
    const auto end = [&] {
      if (line.size() > 1) {
        seen.add(line);
        when.push_back(painted[i]);
      }
      line.clear();
    };
    for (std::size_t k = 1; k < points.size(); ++k) {
      const Point2 a = points[k - 1], b = points[k];
      find_over(a, b, painted[i]);
      at.assign({0, 1});
      for (const std::uint32_t c : over_) add_crossings(occluders_[c], a, b, at);
      std::sort(at.begin(), at.end());
      bool goes_on = false;  // the part before, of this segment, is seen
      for (std::size_t n = 1; n < at.size(); ++n) {
        if (at.size() > 2 && at[n] - at[n - 1] <= kLeastPartSeen) continue;
        const Point2 middle = a + (b - a) * ((at[n - 1] + at[n]) / 2);
        const bool hidden =
            std::any_of(over_.begin(), over_.end(), [&](std::uint32_t c) { return hidden_by(occluders_[c], middle); });
        if (hidden) {
          end();
          goes_on = false;
          continue;
        }
        if (line.empty()) line.push_back(at[n - 1] == 0 ? a : a + (b - a) * at[n - 1]);
        // A crossing where nothing ends is no point of the line. A corner is one, also if rounding cuts there.
        if (goes_on) line.pop_back();
        line.push_back(at[n] == 1 ? b : a + (b - a) * at[n]);
        goes_on = true;
      }
    }
    end();
  }
  lines = std::move(seen);
  painted = std::move(when);
}

}  // namespace ligne::svg
