#include "drawing/stroke_index.hpp"

#include "drawing/stroke_overlap.hpp"

namespace ligne {
namespace {

// Adjustable: a stroke may cross this many cells of the index on the average.
constexpr double kCellsPerStroke = 64;

double median(std::vector<float>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

StrokeIndex::Cell& StrokeIndex::cell(std::uint64_t key) {
  std::uint32_t& number = cell_table_[key];
  if (number == kNone) {
    number = static_cast<std::uint32_t>(cells_.size());
    cells_.emplace_back();
  }
  return cells_[number];
}

std::uint32_t StrokeIndex::add_end(LatticePoint p, std::uint32_t segment) {
  std::uint32_t& point = point_table_[KeyTable::key(p)];
  if (point == kNone) {
    point = static_cast<std::uint32_t>(points_.size());
    Cell& home = cell(grid_.cell_of(p));
    points_.push_back({p, kNone, home.first_point});
    home.first_point = point;
  }
  arms_.push_back({segment, points_[point].first_arm});
  points_[point].first_arm = static_cast<std::uint32_t>(arms_.size() - 1);
  return point;
}

void StrokeIndex::insert(LatticePoint from, LatticePoint to) {
  const auto segment = static_cast<std::uint32_t>(segments_.size());
  segments_.push_back({from, to, static_cast<float>(length(from, to))});
  const std::uint64_t homes[] = {grid_.cell_of(from), grid_.cell_of(to)};
  grid_.walk(from, to, [&](std::uint64_t key) {
    if (key == homes[0] || key == homes[1]) return false;
    Cell& passed = cell(key);
    throughs_.push_back({segment, passed.first_through});
    passed.first_through = static_cast<std::uint32_t>(throughs_.size() - 1);
    return false;
  });
  const std::uint32_t a = add_end(from, segment), b = add_end(to, segment);
  pair_table_[pair_key(a, b)] = segment;
}

double index_cell(const std::vector<Stroke>& strokes, const std::vector<std::uint32_t>& of, double tolerance_steps) {
  if (of.empty()) return 8 * tolerance_steps;
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
  return std::max({std::min<double>(median(lengths), side / std::sqrt(n)), sum / n / kCellsPerStroke, 8 * tolerance_steps});
}

}  // namespace ligne
