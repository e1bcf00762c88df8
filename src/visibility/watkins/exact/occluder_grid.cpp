#include "visibility/watkins/exact/occluder_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.hpp"
#include "visibility/common/hidden_interval.hpp"

namespace ligne::watkins {
namespace {

/// Grid cells across a mean facet. Tuned: smaller cells hide more, but take longer to fill.
constexpr double kCellsAcross = 8;
constexpr double kFewestCells = 64, kMostCells = 1024;  // along the longer side

}  // namespace

OccluderGrid::OccluderGrid(const std::vector<ProjectedVertex>& vertices, const std::vector<Facet>& facets,
                           double margin_steps)
    : margin_(margin_steps) {
  Rect box;
  double sum = 0;
  for (const Facet& f : facets) {
    for (const std::uint32_t v : f.v) box.extend({double(vertices[v].p.x), double(vertices[v].p.y)});
    sum += f.size;
  }
  if (facets.empty()) {
    depth_ = std::vector<std::atomic<float>>(1);
    depth_[0] = std::numeric_limits<float>::infinity();
    return;
  }
  const double extent = std::max({box.width(), box.height(), 1.0});
  size_ = extent / std::clamp(std::ceil(kCellsAcross * extent / (sum / static_cast<double>(facets.size()))), kFewestCells,
                              kMostCells);
  x_ = box.min.x;
  y_ = box.min.y;
  columns_ = static_cast<std::uint32_t>(box.width() / size_) + 1;
  rows_ = static_cast<std::uint32_t>(box.height() / size_) + 1;
  depth_ = std::vector<std::atomic<float>>(std::size_t{columns_} * rows_);
  for (std::atomic<float>& d : depth_) d.store(std::numeric_limits<float>::infinity(), std::memory_order_relaxed);
  parallel_for(facets.size(), [&](std::size_t i) {
    if (facets[i].size >= size_) add(facets[i], vertices);
  });
  empty_ = std::all_of(depth_.begin(), depth_.end(), [](const std::atomic<float>& d) {
    return d.load(std::memory_order_relaxed) == std::numeric_limits<float>::infinity();
  });
}

std::uint32_t OccluderGrid::column(double x) const {
  return static_cast<std::uint32_t>(std::clamp((x - x_) / size_, 0.0, double(columns_ - 1)));
}
std::uint32_t OccluderGrid::row(double y) const {
  return static_cast<std::uint32_t>(std::clamp((y - y_) / size_, 0.0, double(rows_ - 1)));
}

/// Stores the facet's depth in the cells that lie inside it with their margin. The smallest depth wins, so the order of
/// facets does not matter.
void OccluderGrid::add(const Facet& facet, const std::vector<ProjectedVertex>& vertices) {
  const ProjectedVertex* const p[3] = {&vertices[facet.v[0]], &vertices[facet.v[1]], &vertices[facet.v[2]]};
  // E_i(q) = e_i + ex_i x + ey_i y is positive inside. Its minimum over a cell is at a corner.
  double e[3], ex[3], ey[3];
  const double reach = size_ / 2 + margin_;
  for (int i = 0; i < 3; ++i) {
    const LatticePoint a = p[i]->p, b = p[(i + 1) % 3]->p;
    ex[i] = -(double(b.y) - a.y);
    ey[i] = double(b.x) - a.x;
    e[i] = -(ex[i] * a.x + ey[i] * a.y) - (std::abs(ex[i]) + std::abs(ey[i])) * reach;
  }
  const double area = orientation(p[0]->p, p[1]->p, p[2]->p);
  // z(q) = (E_1 z_0 + E_2 z_1 + E_0 z_2) / area
  const double zx = (ex[1] * p[0]->z + ex[2] * p[1]->z + ex[0] * p[2]->z) / area;
  const double zy = (ey[1] * p[0]->z + ey[2] * p[1]->z + ey[0] * p[2]->z) / area;
  const double deeper = (std::abs(zx) + std::abs(zy)) * reach + facet.depth_tolerance;
  const auto [y_low, y_high] = std::minmax({p[0]->p.y, p[1]->p.y, p[2]->p.y});
  const std::uint32_t last = row(y_high);
  for (std::uint32_t r = row(y_low); r <= last; ++r) {
    const double y = y_ + (r + 0.5) * size_;
    double from = -std::numeric_limits<double>::infinity(), to = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
      const double at = e[i] + ey[i] * y;
      if (ex[i] > 0) {
        from = std::max(from, -at / ex[i]);
      } else if (ex[i] < 0) {
        to = std::min(to, -at / ex[i]);
      } else if (at < 0) {
        to = -std::numeric_limits<double>::infinity();
      }
    }
    if (!(from <= to)) continue;
    const double first_column = std::max(0.0, std::ceil((from - x_) / size_ - 0.5)),
                 last_column = std::min(double(columns_) - 1, std::floor((to - x_) / size_ - 0.5));
    for (double c = first_column; c <= last_column; ++c) {
      const double x = x_ + (c + 0.5) * size_;
      const float z = round_up(p[0]->z + zx * (x - p[0]->p.x) + zy * (y - p[0]->p.y) + deeper);
      std::atomic<float>& cell = depth_[std::size_t{r} * columns_ + static_cast<std::size_t>(c)];
      float known = cell.load(std::memory_order_relaxed);
      while (z < known && !cell.compare_exchange_weak(known, z, std::memory_order_relaxed)) {
      }
    }
  }
}

bool OccluderGrid::hides(double x0, double y0, double x1, double y1, double z_near) const {
  if (empty_) return false;
  const std::uint32_t c0 = column(x0 - margin_), c1 = column(x1 + margin_), r0 = row(y0 - margin_), r1 = row(y1 + margin_);
  for (std::uint32_t r = r0; r <= r1; ++r) {
    for (std::uint32_t c = c0; c <= c1; ++c) {
      if (!(z_near > double(depth_[std::size_t{r} * columns_ + c].load(std::memory_order_relaxed)))) return false;
    }
  }
  return true;
}

bool OccluderGrid::hides(const Facet& facet, const std::vector<ProjectedVertex>& vertices) const {
  const LatticePoint a = vertices[facet.v[0]].p, b = vertices[facet.v[1]].p, c = vertices[facet.v[2]].p;
  const auto [x0, x1] = std::minmax({a.x, b.x, c.x});
  const auto [y0, y1] = std::minmax({a.y, b.y, c.y});
  return hides(x0, y0, x1, y1, double(facet.z_near) - facet.depth_tolerance);
}

/// Walks the cells row by row, and compares each with the nearest depth of the part of the segment in it.
bool OccluderGrid::hides(const PageSegment& s) const {
  if (empty_) return false;
  const double y0 = std::min(s.from.y, s.to.y), y1 = std::max(s.from.y, s.to.y);
  const std::uint32_t r0 = row(y0 - margin_), r1 = row(y1 + margin_);
  for (std::uint32_t r = r0; r <= r1; ++r) {
    double t0 = 0, t1 = 1;
    if (y1 > y0) {
      const double top = y_ + r * size_ - margin_, bottom = y_ + (r + 1) * size_ + margin_;
      const double ta = (top - s.from.y) / (s.to.y - s.from.y), tb = (bottom - s.from.y) / (s.to.y - s.from.y);
      t0 = std::clamp(std::min(ta, tb), 0.0, 1.0);
      t1 = std::clamp(std::max(ta, tb), 0.0, 1.0);
    }
    const PagePoint a = s.at(t0), b = s.at(t1);
    const double y = y_ + (r + 0.5) * size_;
    if (!hides(std::min(a.x, b.x), y, std::max(a.x, b.x), y, std::min(a.z, b.z))) return false;
  }
  return true;
}

bool lies_behind(const CellGrid& grid, const SweepLine& line) {
  bool behind = true;
  const PageLine on_page(line.from, line.to, line.face0, line.face1);
  grid.for_each_leaf(on_page, [&](const Cell& cell, const CellSquare&, double from, double to) {
    behind = behind && cell.occluder_depth < on_page.z(from) && cell.occluder_depth < on_page.z(to);
  });
  return behind;
}

void leave_out_hidden(const ProjectedScene& scene, const OccluderGrid& covers, std::vector<Facet>& facets,
                      std::vector<SweepLine>& lines) {
  std::vector<std::uint8_t> hidden(facets.size());
  parallel_for(facets.size(), [&](std::size_t i) { hidden[i] = covers.hides(facets[i], scene.vertices); });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    if (!hidden[i]) facets[kept++] = facets[i];
  }
  facets.resize(kept);
  parallel_for(lines.size(), [&](std::size_t i) {
    const ProjectedVertex &a = lines[i].from, &b = lines[i].to;
    lines[i].behind = covers.hides(PageSegment{{double(a.p.x), double(a.p.y), a.z}, {double(b.p.x), double(b.p.y), b.z}});
  });
}

void leave_out_hidden(const CellGrid& grid, std::vector<Facet>& facets, std::vector<SweepLine>& lines) {
  const std::vector<std::uint8_t> listed = grid.listed(facets.size());
  std::size_t kept = 0;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    if (listed[i]) facets[kept++] = facets[i];
  }
  facets.resize(kept);
  parallel_for(lines.size(), [&](std::size_t i) { lines[i].behind = lines[i].behind || lies_behind(grid, lines[i]); });
}

}  // namespace ligne::watkins
