#include "linework/overlaps/end_grid.hpp"

#include <atomic>
#include <cmath>
#include <limits>
#include <tuple>

#include "base/parallel.hpp"
#include "base/portable.hpp"
#include "linework/overlaps/stroke_overlap.hpp"

namespace ligne {
namespace {

constexpr std::size_t kBlock = 4096;
// Adjustable.
constexpr double kMostCellsPerStroke = 64;  ///< largest mean number of cells that a stroke crosses
constexpr std::size_t kLeastCells = 4;      ///< fewest cells of the finer grid of a cell

}  // namespace

/// Chooses cells for about one end each, as long as the median stroke or else as square as possible. Returns whether
/// the grid has at least kLeastCells cells.
bool EndGrid::choose_cells(const std::vector<End>& ends, const Cells& cells) {
  frame_ = cells.frame;
  constexpr double kFar = std::numeric_limits<double>::max();
  double high_u = -kFar, high_v = -kFar, sum = 0;
  low_u_ = low_v_ = kFar;
  std::vector<float> lengths;
  if (cells.as_strokes) lengths.reserve(ends.size());
  for (const End& e : ends) {
    const double u = frame_.u(e.p), v = frame_.v(e.p);
    low_u_ = std::min(low_u_, u), high_u = std::max(high_u, u);
    low_v_ = std::min(low_v_, v), high_v = std::max(high_v, v);
    if (!cells.as_strokes) continue;
    lengths.push_back(static_cast<float>(length(e.p, e.far)));
    sum += lengths.back();
  }
  const double n = static_cast<double>(ends.size()), width = high_u - low_u_ + 1, height = high_v - low_v_ + 1;
  double stroke = 0;
  if (cells.as_strokes) {
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    stroke = std::max<double>(*middle, sum / n / kMostCellsPerStroke);
    if (cells.is_finer) stroke = std::min(stroke, std::sqrt(cells.longest * width * height / n));
  }
  side_u_ = std::max({std::min(std::max(stroke, std::sqrt(width * height / n)), width), width / n, cells.least});
  side_v_ = std::max({width * height / (n * side_u_), side_u_ / cells.longest, height / n, cells.least});
  columns_ = static_cast<int>((high_u - low_u_) / side_u_) + 1;
  rows_ = static_cast<int>((high_v - low_v_) / side_v_) + 1;
  return static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) >= kLeastCells;
}

EndGrid::EndGrid(std::vector<End> ends, const Cells& cells) {
  if (ends.empty()) return;
  choose_cells(ends, cells);
  const std::size_t cell_count = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  std::vector<std::uint32_t> cell(ends.size());
  parallel_blocks(ends.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) cell[i] = static_cast<std::uint32_t>(cell_of(ends[i].p));
  });
  first_.assign(cell_count + 1, 0);
  for (const std::uint32_t c : cell) ++first_[c + 1];
  for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
  open_.resize(cell_count);
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  ends_.resize(ends.size());
  for (std::size_t i = 0; i < ends.size(); ++i) ends_[next[cell[i]]++] = ends[i];
  std::vector<End>().swap(ends);
  // Sorts equal points together, so that a walk skips a point where thousands of strokes meet in a few steps.
  parallel_blocks(cell_count, kBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      open_[c] = first_[c + 1] - first_[c];
      if (open_[c] < 2) continue;
      std::sort(ends_.begin() + first_[c], ends_.begin() + first_[c + 1],
                [](const End& a, const End& b) { return std::tie(a.p, a.stroke) < std::tie(b.p, b.stroke); });
    }
  });
  for (std::size_t c = 0; c < cell_count; ++c) refine_if_full(c, cells);
}

/// Searches by doubling steps, since thousands of ends may be equal.
std::uint32_t EndGrid::next_of_many(std::uint32_t e, std::uint32_t last) const {
  const LatticePoint p = ends_[e].p;
  std::uint32_t step = 2;
  while (e + step < last && ends_[e + step].p == p) step *= 2;
  const auto from = ends_.begin() + e + step / 2, to = ends_.begin() + std::min(last, e + step);
  return static_cast<std::uint32_t>(std::partition_point(from, to, [&](const End& end) { return end.p == p; }) -
                                    ends_.begin());
}

/// Gives a cell with many points a grid of its own, if that has several cells.
void EndGrid::refine_if_full(std::size_t c, const Cells& cells) {
  if (first_[c + 1] - first_[c] <= kMaxCellEntries) return;
  std::uint32_t points = 0;
  for (std::uint32_t e = first_[c]; e < first_[c + 1]; e = next_point(e, first_[c + 1])) ++points;
  if (points <= kMaxCellEntries) return;
  std::vector<End> here(ends_.begin() + first_[c], ends_.begin() + first_[c + 1]);
  Cells finer = cells;
  finer.is_finer = true;
  if (!EndGrid().choose_cells(here, finer)) return;
  finer_number_[c] = static_cast<std::uint32_t>(finer_.size());
  finer_.emplace_back(std::move(here), finer);
}

void EndGrid::settle_end(LatticePoint p) {
  if (ends_.empty()) return;
  const std::size_t c = cell_of(p);
  AtomicRef<std::uint32_t>(open_[c]).fetch_sub(1, std::memory_order_relaxed);
  if (EndGrid* const finer = finer_in(c)) finer->settle_end(p);
}

}  // namespace ligne
