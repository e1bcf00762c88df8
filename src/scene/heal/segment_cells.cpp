#include "scene/heal/segment_cells.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace ligne {
namespace {

/// Smallest width of a cell: in mean lengths of a segment, and in reaches. Adjustable.
constexpr double kSideInLengths = 2, kSideInReaches = 4;
/// Largest number of cells along the longest side of the box: each of a cell's three numbers has 21 bits.
constexpr double kMostCells = 0x1p20;
/// Bounds on the rounding errors of a cell number, relative to the side of a cell, and of a point, relative to the
/// largest coordinate.
constexpr double kCellRounding = 0x1p-20, kRounding = 0x1p-48;

}  // namespace

SegmentCells::SegmentCells(std::span<const EdgeTree::Segment> segments, double reach) {
  choose_cells(segments, reach);
  begin_.assign(std::bit_ceil(4 * segments.size() + 1) + 1, 0);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> listed;  // slot, segment
  listed.reserve(4 * segments.size());
  for (std::uint32_t s = 0; s < segments.size(); ++s) {
    // Long segments are cut into parts, so that their boxes are no larger than a cell.
    const auto& [a, b] = segments[s];
    const Point3 along = b - a;
    const double parts = std::ceil(std::max(1.0, glm::length(along) / side_));
    for (double part = 0; part < parts; ++part) {
      const Point3 from = a + part / parts * along, to = a + (part + 1) / parts * along;
      const Cell low = cell_of(glm::max(glm::min(from, to) - margin_, low_)), high = cell_of(glm::max(from, to) + margin_);
      for (std::int64_t x = low.x; x <= high.x; ++x) {
        for (std::int64_t y = low.y; y <= high.y; ++y) {
          for (std::int64_t z = low.z; z <= high.z; ++z) {
            listed.emplace_back(static_cast<std::uint32_t>(slot_of({x, y, z})), s);
          }
        }
      }
    }
  }
  for (const auto& entry : listed) ++begin_[entry.first + 1];
  for (std::size_t slot = 1; slot < begin_.size(); ++slot) begin_[slot] += begin_[slot - 1];
  listed_.resize(listed.size());
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  for (const auto& entry : listed) listed_[next[entry.first]++] = entry.second;
}

void SegmentCells::choose_cells(std::span<const EdgeTree::Segment> segments, double reach) {
  if (segments.empty()) return;
  Point3 high = low_ = segments[0].a;
  double length = 0;
  for (const EdgeTree::Segment& s : segments) {
    low_ = glm::min(low_, glm::min(s.a, s.b));
    high = glm::max(high, glm::max(s.a, s.b));
    length += glm::distance(s.a, s.b);
  }
  const Point3 size = high - low_, largest = glm::max(glm::abs(low_), glm::abs(high));
  const double longest = std::max({size.x, size.y, size.z});
  side_ = std::max({kSideInLengths * length / double(segments.size()), kSideInReaches * reach, longest / kMostCells});
  if (!(side_ > 0)) side_ = 1;  // all at one place
  margin_ = reach + kCellRounding * side_ + kRounding * std::max({largest.x, largest.y, largest.z});
}

}  // namespace ligne
