#include "visibility/edges/nearest_along.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <span>

#include "base/index_lists.hpp"
#include "base/parallel.hpp"

namespace ligne {
namespace {

// Adjustable: facets and lines per task, and grid cells along the longer side of the lines' bounding box.
constexpr std::size_t kFacetsPerTask = 16'384;
constexpr std::size_t kLinesPerTask = 256;
constexpr int kMostCells = 256;

constexpr float kNearest = -std::numeric_limits<float>::infinity(), kFarthest = std::numeric_limits<float>::infinity();

/// The part of a line over which a facet lies.
struct Cover {
  std::uint32_t line, facet;
  double from, to;
};

/// Whether the facet covers a part of the line, which goes to `cover`. The ends are quotients of exact determinants:
/// two facets with a common side give the same end to the last bit, and no gap shows between them.
bool covers(const LineOnPage& line, const Facet& facet, const std::vector<ProjectedVertex>& vertices, Cover& cover) {
  cover.from = 0;
  cover.to = 1;
  for (int i = 0; i < 3; ++i) {
    const LatticePoint a = vertices[facet.v[i]].p, b = vertices[facet.v[(i + 1) % 3]].p;
    const double e0 = orientation(a, b, line[0]), e1 = orientation(a, b, line[1]);
    if (e0 < 0 && e1 < 0) return false;
    if (e0 < 0) {
      cover.from = std::max(cover.from, e0 / (e0 - e1));
    } else if (e1 < 0) {
      cover.to = std::min(cover.to, e0 / (e0 - e1));
    }
  }
  return cover.from < cover.to;
}

/// A rectangle of the lattice.
struct LineBox {
  std::int32_t left = kLatticeLimit, top = kLatticeLimit, right = -kLatticeLimit, bottom = -kLatticeLimit;

  void extend(LatticePoint p) {
    left = std::min(left, p.x);
    right = std::max(right, p.x);
    top = std::min(top, p.y);
    bottom = std::max(bottom, p.y);
  }
  bool meets(const LineBox& o) const { return left <= o.right && o.left <= right && top <= o.bottom && o.top <= bottom; }
};

/// A grid whose cells list the lines that run through them.
class LineGrid {
 public:
  explicit LineGrid(const std::vector<LineOnPage>& lines) : boxes_(lines.size()) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
      for (const LatticePoint p : lines[i]) {
        boxes_[i].extend(p);
        all_.extend(p);
      }
    }
    const double width = double(all_.right) - all_.left + 1, height = double(all_.bottom) - all_.top + 1;
    size_ = std::ceil(std::max(width, height) / kMostCells);
    columns_ = static_cast<int>(width / size_) + 1;
    cells_ = {static_cast<std::size_t>(columns_) * (static_cast<std::size_t>(height / size_) + 1), [&](const auto& put) {
                for (std::uint32_t i = 0; i < lines.size(); ++i) {
                  for_cells_of(lines[i], [&](std::size_t cell) { put(cell, i); });
                }
              }};
  }

  /// Calls visit(line) for the lines that may run through the box, some more than once.
  template <class Visit>
  void near(const LineBox& box, Visit visit) const {
    if (!box.meets(all_)) return;
    for_cells(box, [&](std::size_t cell) {
      for (const std::uint32_t line : cells_[cell]) {
        if (boxes_[line].meets(box)) visit(line);
      }
    });
  }

 private:
  template <class Visit>
  void for_cells(const LineBox& box, Visit visit) const {
    const auto index = [&](std::int32_t v, std::int32_t origin) {
      return static_cast<std::size_t>((double(v) - origin) / size_);
    };
    const std::size_t left = index(std::max(box.left, all_.left), all_.left),
                      right = index(std::min(box.right, all_.right), all_.left);
    const std::size_t top = index(std::max(box.top, all_.top), all_.top),
                      bottom = index(std::min(box.bottom, all_.bottom), all_.top);
    for (std::size_t row = top; row <= bottom; ++row) {
      for (std::size_t column = left; column <= right; ++column) visit(row * static_cast<std::size_t>(columns_) + column);
    }
  }

  /// Visits the cells row by row. One step on both sides allows for rounding.
  template <class Visit>
  void for_cells_of(const LineOnPage& line, Visit visit) const {
    LineBox box;
    for (const LatticePoint p : line) box.extend(p);
    const double slope = line[0].y == line[1].y ? 0 : (double(line[1].x) - line[0].x) / (double(line[1].y) - line[0].y);
    const auto row_of = [&](std::int32_t y) { return std::floor((double(y) - all_.top) / size_); };
    for (double row = row_of(box.top), last = row_of(box.bottom); row <= last; ++row) {
      const double top = std::max<double>(box.top, all_.top + row * size_);
      const double bottom = std::min<double>(box.bottom, all_.top + (row + 1) * size_);
      double x0 = line[0].x + (top - line[0].y) * slope, x1 = line[0].x + (bottom - line[0].y) * slope;
      if (line[0].y == line[1].y) x0 = box.left, x1 = box.right;
      LineBox part{.left = std::max<std::int32_t>(box.left, static_cast<std::int32_t>(std::floor(std::min(x0, x1))) - 1),
                   .right = std::min<std::int32_t>(box.right, static_cast<std::int32_t>(std::ceil(std::max(x0, x1))) + 1)};
      part.top = part.bottom =
          static_cast<std::int32_t>(std::clamp<double>(std::floor((top + bottom) / 2), box.top, box.bottom));
      for_cells(part, visit);
    }
  }

  std::vector<LineBox> boxes_;
  LineBox all_;
  double size_ = 1;
  int columns_ = 1;
  IndexLists cells_;
};

/// The covers of all lines, by line. The tasks skip facets behind one that covers a whole line, but which ones they
/// skip depends on the order of the tasks; so a last pass drops all of them.
class Covers {
 public:
  Covers(const std::vector<ProjectedVertex>& vertices, const std::vector<Facet>& facets,
         const std::vector<LineOnPage>& lines, bool any_facet)
      : facets_(facets), depths_(lines.size()) {
    for (auto& depth : depths_) depth.store(kFarthest, std::memory_order_relaxed);
    const LineGrid grid(lines);
    std::vector<std::vector<Cover>> found((facets.size() + kFacetsPerTask - 1) / kFacetsPerTask);
    parallel_blocks(facets.size(), kFacetsPerTask, [&](std::size_t first, std::size_t last) {
      std::vector<Cover>& out = found[first / kFacetsPerTask];
      std::vector<std::uint32_t> met(lines.size(), kNone);  // per line: the last facet tested against it
      for (std::size_t f = first; f < last; ++f) {
        const Facet& facet = facets[f];
        LineBox box;
        for (const std::uint32_t v : facet.v) box.extend(vertices[v].p);
        grid.near(box, [&](std::uint32_t line) {
          if (met[line] == f || facet.z_near > depths_[line].load(std::memory_order_relaxed)) return;
          met[line] = static_cast<std::uint32_t>(f);
          Cover cover{line, met[line], 0, 1};
          if (!covers(lines[line], facet, vertices, cover)) return;
          out.push_back(cover);
          if (cover.from == 0 && cover.to == 1) hide_behind(line, any_facet ? kNearest : facet.z_far);
        });
      }
    });
    covers_ = {lines.size(), [&](const auto& put) {
                 for (const std::vector<Cover>& some : found) {
                   for (const Cover& c : some) {
                     if (kept(c)) put(c.line, c);
                   }
                 }
               }};
  }

  std::span<const Cover> of(std::size_t line) const { return covers_[line]; }
  bool hides_all(std::size_t line) const { return depths_[line].load(std::memory_order_relaxed) == kNearest; }

 private:
  void hide_behind(std::uint32_t line, float depth) {
    float known = depths_[line].load(std::memory_order_relaxed);
    while (depth < known && !depths_[line].compare_exchange_weak(known, depth, std::memory_order_relaxed)) {
    }
  }
  bool kept(const Cover& c) const { return !(facets_[c.facet].z_near > depths_[c.line].load(std::memory_order_relaxed)); }

  const std::vector<Facet>& facets_;
  std::vector<std::atomic<float>> depths_;  ///< per line: depth behind which everything is hidden
  ListsOf<Cover> covers_;
};

void append(std::vector<SeenStretch>& stretches, double from, double to, std::uint32_t facet) {
  if (!(from < to)) return;
  if (!stretches.empty() && stretches.back().facet == facet) {
    stretches.back().to = to;
  } else {
    stretches.push_back({from, to, facet});
  }
}

/// The stretches of the line that anything covers.
std::vector<SeenStretch> any_stretches(std::vector<Cover> covers) {
  std::sort(covers.begin(), covers.end(), [](const Cover& a, const Cover& b) { return a.from < b.from; });
  std::vector<SeenStretch> stretches;
  double seen = 0;
  for (const Cover& c : covers) {
    append(stretches, seen, c.from, kNone);
    append(stretches, std::max(seen, c.from), c.to, covers[0].facet);
    seen = std::max(seen, c.to);
  }
  append(stretches, seen, 1, kNone);
  return stretches;
}

/// Depths of a facet's plane at both ends of a line. The facet covers a part of the line.
struct CoverDepth {
  const Cover* cover;
  double z_from, z_to;
};

std::uint32_t nearest_at(const std::vector<CoverDepth>& depths, double t) {
  std::uint32_t nearest = kNone;
  double depth = 0;
  for (const CoverDepth& d : depths) {
    const Cover& c = *d.cover;
    if (t < c.from || t > c.to) continue;
    const double z = d.z_from + t * (d.z_to - d.z_from);
    if (nearest != kNone && !(z < depth || (z == depth && c.facet < nearest))) continue;
    nearest = c.facet;
    depth = z;
  }
  return nearest;
}

}  // namespace

double plane_depth(const Facet& facet, const std::vector<ProjectedVertex>& vertices, double x, double y) {
  return FacetFunctions(facet, vertices.data()).depth(x, y);
}

std::vector<std::vector<SeenStretch>> nearest_along(const std::vector<ProjectedVertex>& vertices,
                                                    const std::vector<Facet>& facets, const std::vector<LineOnPage>& lines,
                                                    bool any_facet) {
  std::vector<std::vector<SeenStretch>> seen(lines.size());
  if (lines.empty()) return seen;
  const Covers covers(vertices, facets, lines, any_facet);
  parallel_blocks(lines.size(), kLinesPerTask, [&](std::size_t first, std::size_t last) {
    std::vector<double> ends;
    std::vector<CoverDepth> depths;
    for (std::size_t i = first; i < last; ++i) {
      const auto own = covers.of(i);
      if (any_facet) {
        seen[i] = covers.hides_all(i) ? std::vector<SeenStretch>{{0, 1, 0}} : any_stretches({own.begin(), own.end()});
        continue;
      }
      ends = {0, 1};
      depths.clear();
      for (const Cover& c : own) {
        ends.insert(ends.end(), {c.from, c.to});
        const FacetFunctions plane(facets[c.facet], vertices.data());
        depths.push_back({&c, plane.depth(lines[i][0].x, lines[i][0].y), plane.depth(lines[i][1].x, lines[i][1].y)});
      }
      std::sort(ends.begin(), ends.end());
      for (std::size_t k = 1; k < ends.size(); ++k) {
        if (ends[k - 1] < ends[k]) append(seen[i], ends[k - 1], ends[k], nearest_at(depths, (ends[k - 1] + ends[k]) / 2));
      }
    }
  });
  return seen;
}

}  // namespace ligne
