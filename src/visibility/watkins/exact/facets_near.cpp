#include "visibility/watkins/exact/facets_near.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace ligne::watkins {
namespace {

/// Grid cells along each side of the page. Tuned.
constexpr std::uint32_t kCells = 512;

/// The lattice cells that a line crosses.
class CellMarks {
 public:
  explicit CellMarks(double margin) : margin_(margin), marked_(std::size_t{kCells} * kCells, 0) {}

  /// Marks the cells row by row, with the margin on all sides.
  void mark(const SweepLine& line) {
    LatticePoint a = line.from.p, b = line.to.p;
    if (b.y < a.y) std::swap(a, b);
    const std::uint32_t last = cell(b.y + margin_);
    for (std::uint32_t row = cell(a.y - margin_); row <= last; ++row) {
      double x0 = a.x, x1 = b.x;
      if (b.y > a.y) {
        const double slope = (double(b.x) - a.x) / (double(b.y) - a.y);
        const double y0 = std::clamp(row * kSize - kLatticeLimit - margin_, double(a.y), double(b.y));
        const double y1 = std::clamp((row + 1) * kSize - kLatticeLimit + margin_, double(a.y), double(b.y));
        x0 = a.x + (y0 - a.y) * slope;
        x1 = a.x + (y1 - a.y) * slope;
      }
      const std::uint32_t end = cell(std::max(x0, x1) + margin_);
      for (std::uint32_t column = cell(std::min(x0, x1) - margin_); column <= end; ++column)
        marked_[std::size_t{row} * kCells + column] = 1;
    }
  }

  bool any(double x0, double y0, double x1, double y1) const {
    const std::uint32_t c0 = cell(x0), c1 = cell(x1), last = cell(y1);
    for (std::uint32_t row = cell(y0); row <= last; ++row) {
      const auto begin = marked_.begin() + static_cast<std::ptrdiff_t>(std::size_t{row} * kCells);
      if (std::find(begin + c0, begin + c1 + 1, 1) != begin + c1 + 1) return true;
    }
    return false;
  }

 private:
  static constexpr double kSize = 2.0 * kLatticeLimit / kCells;

  static std::uint32_t cell(double v) {
    return static_cast<std::uint32_t>(std::clamp((v + kLatticeLimit) / kSize, 0.0, kCells - 1.0));
  }

  double margin_;
  std::vector<std::uint8_t> marked_;
};

}  // namespace

std::vector<Facet> facets_near(std::span<const SweepLine> lines, const std::vector<Facet>& facets,
                               const std::vector<ProjectedVertex>& vertices, double margin_steps) {
  CellMarks marks(margin_steps);
  for (const SweepLine& line : lines) {
    if (line.to_study()) marks.mark(line);
  }
  std::vector<Facet> near;
  for (const Facet& f : facets) {
    const LatticePoint a = vertices[f.v[0]].p, b = vertices[f.v[1]].p, c = vertices[f.v[2]].p;
    const auto [x0, x1] = std::minmax({a.x, b.x, c.x});
    const auto [y0, y1] = std::minmax({a.y, b.y, c.y});
    if (marks.any(x0, y0, x1, y1)) near.push_back(f);
  }
  return near;
}

}  // namespace ligne::watkins
