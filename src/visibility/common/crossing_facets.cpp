#include "visibility/common/crossing_facets.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "drawing/key_table.hpp"
#include "geometry/parallel.hpp"
#include "visibility/common/facet_functions.hpp"

namespace ligne {
namespace {

// Adjustable: the side of the smallest cells, in steps, and how many facets or entries are searched by one task.
constexpr int kSmallestBits = 8;
constexpr std::size_t kBlock = 1024;

/// A facet's box on the page and in depth.
struct DepthBox {
  std::int32_t left, right, top, bottom;
  float z_near, z_far;
  std::uint32_t facet;
};

/// A facet's plane: its depth over the page, as rounded arithmetic has it.
struct Plane {
  double z, zx, zy, slack;
};

/// One grid: its entries by cell, and in each cell by z_near.
struct Level {
  int bits = 0;  ///< the side of a cell is 2^bits steps
  std::vector<std::uint64_t> cells;
  std::vector<DepthBox> entries;
  std::vector<std::uint32_t> end;  ///< behind the last entry of its cell, for each entry
  KeyTable first;                  ///< by cell

  std::uint64_t cell_at(std::int32_t x, std::int32_t y) const { return KeyTable::key(x >> bits, y >> bits); }
};

class CrossingSearch {
 public:
  CrossingSearch(const ProjectedScene& scene, const std::vector<Facet>& facets) : scene_(scene), facets_(facets) {
    planes_.resize(facets.size());
    boxes_.resize(facets.size());
    parallel_blocks(facets.size(), kBlock, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) prepare(static_cast<std::uint32_t>(i));
    });
    fill_levels();
  }

  PenetrationSearch run() const;

 private:
  void prepare(std::uint32_t i);
  int bits_of(const DepthBox& box) const;
  void fill_levels();
  bool planes_are_apart(const DepthBox& a, const DepthBox& b) const;
  /// Compares two facets that are listed in the cell; `placed` is the first.
  void compare(const Level& level, std::uint64_t cell, const DepthBox& a, const DepthBox& b, const PlacedFacet& placed,
               PenetrationSearch& found) const;
  void search_level(const Level& level, PenetrationSearch& all) const;
  void search_coarser(PenetrationSearch& all) const;

  const ProjectedScene& scene_;
  const std::vector<Facet>& facets_;
  std::vector<Plane> planes_;
  std::vector<DepthBox> boxes_;
  std::vector<Level> levels_;  ///< those that have facets, the finest first
};

void CrossingSearch::prepare(std::uint32_t i) {
  const Facet& f = facets_[i];
  const FacetFunctions g(f, scene_.vertices.data());
  planes_[i] = {g.z, g.zx, g.zy, g.slack};
  const LatticePoint a = scene_.vertices[f.v[0]].p, b = scene_.vertices[f.v[1]].p, c = scene_.vertices[f.v[2]].p;
  const auto [left, right] = std::minmax({a.x, b.x, c.x});
  const auto [top, bottom] = std::minmax({a.y, b.y, c.y});
  boxes_[i] = {left, right, top, bottom, f.z_near, f.z_far, i};
}

/// Of the smallest cells that are as large as the box.
int CrossingSearch::bits_of(const DepthBox& box) const {
  const std::int32_t extent = std::max(box.right - box.left, box.bottom - box.top);
  int bits = kSmallestBits;
  while ((extent >> bits) != 0) ++bits;
  return bits;
}

void CrossingSearch::fill_levels() {
  constexpr int kMostBits = std::numeric_limits<std::int32_t>::digits;
  struct Filed {
    std::uint64_t cell;
    DepthBox box;
  };
  std::vector<std::vector<Filed>> filed(kMostBits + 1);
  for (const DepthBox& box : boxes_) {
    const int bits = bits_of(box);
    for (std::int32_t row = box.top >> bits; row <= box.bottom >> bits; ++row) {
      for (std::int32_t column = box.left >> bits; column <= box.right >> bits; ++column) {
        filed[static_cast<std::size_t>(bits)].push_back({KeyTable::key(column, row), box});
      }
    }
  }
  for (int bits = 0; bits <= kMostBits; ++bits) {
    std::vector<Filed>& here = filed[static_cast<std::size_t>(bits)];
    if (here.empty()) continue;
    parallel_sort(here.begin(), here.end(), [](const Filed& a, const Filed& b) {
      return std::tie(a.cell, a.box.z_near, a.box.facet) < std::tie(b.cell, b.box.z_near, b.box.facet);
    });
    Level& level = levels_.emplace_back();
    level.bits = bits;
    level.end.resize(here.size());
    for (std::size_t begin = 0, end = 0; begin < here.size(); begin = end) {
      while (end < here.size() && here[end].cell == here[begin].cell) ++end;
      level.first[here[begin].cell] = static_cast<std::uint32_t>(begin);
      std::fill(level.end.begin() + static_cast<std::ptrdiff_t>(begin), level.end.begin() + static_cast<std::ptrdiff_t>(end),
                static_cast<std::uint32_t>(end));
    }
    for (const Filed& f : here) {
      level.cells.push_back(f.cell);
      level.entries.push_back(f.box);
    }
    std::vector<Filed>().swap(here);
  }
}

/// Whether the planes neither cross nor touch where the boxes meet on the page.
bool CrossingSearch::planes_are_apart(const DepthBox& a, const DepthBox& b) const {
  const Plane &p = planes_[a.facet], &q = planes_[b.facet];
  const double left = std::max(a.left, b.left), right = std::min(a.right, b.right);
  const double top = std::max(a.top, b.top), bottom = std::min(a.bottom, b.bottom);
  const double zx = p.zx - q.zx, zy = p.zy - q.zy;
  const double z = p.z - q.z + (zx * (left + right) + zy * (top + bottom)) / 2;
  return std::abs(z) > (std::abs(zx) * (right - left) + std::abs(zy) * (bottom - top)) / 2 + 2 * (p.slack + q.slack);
}

void CrossingSearch::compare(const Level& level, std::uint64_t cell, const DepthBox& a, const DepthBox& b,
                             const PlacedFacet& placed, PenetrationSearch& found) const {
  const std::int32_t left = std::max(a.left, b.left), top = std::max(a.top, b.top);
  if (left > a.right || left > b.right || top > a.bottom || top > b.bottom) return;
  if (a.z_near > b.z_far || b.z_near > a.z_far || level.cell_at(left, top) != cell) return;
  if (placed.face == facets_[b.facet].face || planes_are_apart(a, b)) return;
  const auto every = [](const PageSegment&) { return true; };
  const PlacedFacet other = found.place(b.facet);
  // Always the nearer one first: a side in a plane that goes along the rim of its facet counts in one order only.
  if (std::tie(a.z_near, a.facet) < std::tie(b.z_near, b.facet)) {
    found.test(placed, other, every);
  } else {
    found.test(other, placed, every);
  }
}

/// Compares the facets of one grid with each other.
void CrossingSearch::search_level(const Level& level, PenetrationSearch& all) const {
  std::vector<PenetrationSearch> found(block_count(level.entries.size(), kBlock), all.empty_copy());
  parallel_blocks(level.entries.size(), kBlock, [&](std::size_t begin, std::size_t last) {
    PenetrationSearch& own = found[begin / kBlock];
    for (std::size_t i = begin; i < last; ++i) {
      const DepthBox& a = level.entries[i];
      const PlacedFacet placed = own.place(a.facet);
      for (std::size_t k = i + 1; k < level.end[i] && level.entries[k].z_near <= a.z_far; ++k) {
        compare(level, level.cells[i], a, level.entries[k], placed, own);
      }
    }
  });
  for (PenetrationSearch& part : found) all.add(std::move(part));
}

/// Compares all facets with those of the grids that are coarser than their own.
void CrossingSearch::search_coarser(PenetrationSearch& all) const {
  std::vector<PenetrationSearch> found(block_count(boxes_.size(), kBlock), all.empty_copy());
  parallel_blocks(boxes_.size(), kBlock, [&](std::size_t begin, std::size_t last) {
    PenetrationSearch& own = found[begin / kBlock];
    for (std::size_t i = begin; i < last; ++i) {
      const DepthBox& a = boxes_[i];
      const PlacedFacet placed = own.place(a.facet);
      const int bits = bits_of(a);
      for (const Level& level : levels_) {
        if (level.bits <= bits) continue;
        for (std::int32_t row = a.top >> level.bits; row <= a.bottom >> level.bits; ++row) {
          for (std::int32_t column = a.left >> level.bits; column <= a.right >> level.bits; ++column) {
            const std::uint64_t cell = KeyTable::key(column, row);
            const std::uint32_t first = level.first.find(cell);
            if (first == KeyTable::kNone) continue;
            for (std::uint32_t k = first; k < level.end[first] && level.entries[k].z_near <= a.z_far; ++k) {
              compare(level, cell, a, level.entries[k], placed, own);
            }
          }
        }
      }
    }
  });
  for (PenetrationSearch& part : found) all.add(std::move(part));
}

PenetrationSearch CrossingSearch::run() const {
  PenetrationSearch all(facets_, scene_.vertices);
  for (const Level& level : levels_) search_level(level, all);
  if (levels_.size() > 1) search_coarser(all);
  return all;
}

}  // namespace

PenetrationSearch find_crossing_facets(const ProjectedScene& scene, const std::vector<Facet>& facets) {
  return CrossingSearch(scene, facets).run();
}

}  // namespace ligne
