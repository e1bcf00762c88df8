#include "linework/overlaps/stroke_index.hpp"

#include <algorithm>

#include "base/no_index.hpp"
#include "linework/overlaps/stroke_overlap.hpp"

namespace ligne {
namespace {

// Adjustable: largest mean number of cells that a stroke crosses.
constexpr double kCellsPerStroke = 64;
constexpr std::uint32_t kMaxCellEntries = 256;  ///< adjustable: most segments and points in a cell that is not refined
// Largest number of list entries up to which cells are refined: this many for each segment, plus a constant. So memory
// grows linearly with the input.
constexpr std::size_t kMostCells = 24, kFewEntries = 1 << 20;

double median(std::vector<float>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

std::uint32_t StrokeIndex::cell(std::size_t level, std::uint64_t key) {
  std::uint32_t& number = levels_[level].cells[key];
  if (number == kNone) {
    number = static_cast<std::uint32_t>(cells_.size());
    cells_.emplace_back();
  }
  return number;
}

std::uint32_t StrokeIndex::leaf_at(LatticePoint p) const {
  std::uint32_t c = kNone;
  for (const Level& level : levels_) {
    c = level.cells.find(level.grid.cell_of(p));
    if (c == kNone || !cells_[c].refined) break;
  }
  return c;
}

/// Adds a point that is in no list to its leaf, on this level or below.
void StrokeIndex::put_point(std::size_t level, std::uint32_t point) {
  std::uint64_t key = 0;
  std::uint32_t c = kNone;
  for (;; ++level) {
    key = levels_[level].grid.cell_of(points_[point].p);
    c = cell(level, key);
    if (!cells_[c].refined) break;
  }
  points_[point].listed = true;
  ends_.push(cells_[c].ends, {points_[point].p, point});
  refine_if_full(level, key, c);
}

void StrokeIndex::add_end(std::uint32_t segment, int side) {
  Segment& s = segments_[segment];
  const LatticePoint p = side == 0 ? s.from : s.to, far = side == 0 ? s.to : s.from;
  std::uint32_t& number = point_table_[KeyTable::key(p)];
  const bool is_new = number == kNone;
  if (is_new) {
    number = static_cast<std::uint32_t>(points_.size());
    points_.push_back({p});
  }
  const std::uint32_t point = number;
  s.ends[side] = point;
  s.arms[side] = points_[point].arms.size;
  arms_.push(points_[point].arms, {far, segment});
  if (is_new || !points_[point].listed) put_point(0, point);
}

/// Adds the segment to the leaves of a range through which it passes without ending in them.
void StrokeIndex::pass(std::size_t level, const CellRange& range, std::uint32_t segment) {
  const LatticePoint from = segments_[segment].from, to = segments_[segment].to;
  const SegmentGrid grid = levels_[level].grid;
  const std::uint64_t homes[] = {grid.cell_of(from), grid.cell_of(to)};
  grid.walk_cells(from, to, range, [&](std::int32_t column, std::int32_t row) {
    const std::uint64_t key = KeyTable::key(column, row);
    const std::uint32_t known = levels_[level].cells.find(key);
    if (known != kNone && cells_[known].refined) {
      pass(level + 1, parts_of(column, row), segment);
      return false;
    }
    if (key == homes[0] || key == homes[1]) return false;
    const std::uint32_t c = cell(level, key);
    throughs_.push(cells_[c].throughs, {from, to, segment});
    ++through_count_;
    refine_if_full(level, key, c);
    return false;
  });
}

void StrokeIndex::refine_if_full(std::size_t level, std::uint64_t key, std::uint32_t c) {
  if (cells_[c].throughs.size + cells_[c].ends.size <= kMaxCellEntries) return;
  if (through_count_ > kMostCells * segments_.size() + kFewEntries) return;
  if (levels_[level].side < kParts * kLeastCellInTolerances * tolerance_) return;
  if (levels_.size() == level + 1) levels_.emplace_back(levels_[level].side / kParts, tolerance_);
  std::vector<std::uint32_t> passing;
  for (const Through& t : throughs_.take(cells_[c].throughs)) passing.push_back(t.segment);
  const std::vector<PlacedEnd> ends = ends_.take(cells_[c].ends);
  cells_[c].refined = true;
  for (const auto& [p, point] : ends) {
    for (const Arm& arm : arms_.items(points_[point].arms)) passing.push_back(arm.segment);
    points_[point].listed = false;
    if (points_[point].arms.size > 0) put_point(level + 1, point);
  }
  std::erase_if(passing, [&](std::uint32_t segment) { return segments_[segment].erased; });
  std::sort(passing.begin(), passing.end());
  passing.erase(std::unique(passing.begin(), passing.end()), passing.end());
  const auto column = static_cast<std::int32_t>(key >> 32), row = static_cast<std::int32_t>(key);
  for (const std::uint32_t segment : passing) pass(level + 1, parts_of(column, row), segment);
}

void StrokeIndex::insert(LatticePoint from, LatticePoint to) {
  const auto segment = static_cast<std::uint32_t>(segments_.size());
  segments_.push_back({from, to, false, {}});
  pass(0, {}, segment);
  add_end(segment, 0);
  add_end(segment, 1);
  const auto [a, b] = segments_[segment].ends;
  pair_table_[pair_key(a, b)] = segment;
}

void StrokeIndex::erase(std::uint32_t segment) {
  if (segments_[segment].erased) return;
  segments_[segment].erased = true;
  for (const int side : {0, 1}) {
    const std::uint32_t point = segments_[segment].ends[side], place = segments_[segment].arms[side];
    auto& arms = points_[point].arms;
    arms_.remove(arms, place);
    if (place == arms.size) continue;
    // The last arm has moved to the free place.
    Segment& moved = segments_[arms_.items(arms)[place].segment];
    for (const int k : {0, 1}) {
      if (moved.ends[k] == point && moved.arms[k] == arms.size) moved.arms[k] = place;
    }
  }
}

double index_cell(const std::vector<Stroke>& strokes, const std::vector<std::uint32_t>& of, double tolerance_steps) {
  if (of.empty()) return kLeastCellInTolerances * tolerance_steps;
  std::vector<float> lengths;
  LatticePoint min{kLatticeLimit, kLatticeLimit}, max{-kLatticeLimit, -kLatticeLimit};
  double sum = 0;
  for (const std::uint32_t i : of) {
    const Stroke& s = strokes[i];
    lengths.push_back(static_cast<float>(length(s.from, s.to)));
    sum += lengths.back();
    for (const LatticePoint p : {s.from, s.to}) {
      min = {std::min(min.x, p.x), std::min(min.y, p.y)};
      max = {std::max(max.x, p.x), std::max(max.y, p.y)};
    }
  }
  const double n = static_cast<double>(lengths.size());
  const double side = std::max(double(max.x) - min.x, double(max.y) - min.y);
  return std::max({std::min<double>(median(lengths), side / std::sqrt(n)), sum / n / kCellsPerStroke,
                   kLeastCellInTolerances * tolerance_steps});
}

double walked_cell(const std::vector<Stroke>& strokes, double wanted) {
  constexpr double kCellsOfFew = 1 << 18;
  // Sum of the sides of cells that a stroke of this extent crosses at most.
  double sum = 0;
  for (const Stroke& s : strokes) sum += std::abs(double(s.to.x) - s.from.x) + std::abs(double(s.to.y) - s.from.y);
  return std::max(wanted, sum / (kCellsPerStroke * static_cast<double>(strokes.size()) + kCellsOfFew));
}

}  // namespace ligne
