// Heights are expressed as ranks: 2 i at level i, 2 i - 1 between the levels i - 1 and i. A vertex has one rank in all
// its triangles, so that neighbours cut their common edge at the same levels. A triangle is cut from below upwards. The
// part above a level is the convex polygon that the next level cuts.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <utility>

#include "base/hash.hpp"
#include "scene/surfaces/surface_mesh.hpp"

namespace ligne {
namespace {

/// Largest number of triangles: three times the samples of the largest mesh, so that memory stays within 3 GB.
constexpr std::size_t kMostTriangles = 3 * kMostMeshSamples;

class ContourCut {
 public:
  ContourCut(SurfaceMesh& mesh, std::span<const double> levels) : mesh_(mesh) {
    double largest = 0;
    for (const auto& triangle : mesh.triangles) {
      for (const std::uint32_t v : triangle) largest = std::max(largest, std::abs(mesh.vertices[v].z));
    }
    const double rounding = largest * kFormulaRounding;
    for (const double level : levels) {
      if (levels_.empty() || level - levels_.back() > 2 * rounding) levels_.push_back(level);
    }
    ranks_.reserve(mesh.vertices.size());
    for (const Point3& p : mesh.vertices) ranks_.push_back(rank(p.z, rounding));
  }

  void run() {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::array<std::uint8_t, 3>> flags;
    triangles.swap(mesh_.triangles);
    flags.swap(mesh_.flags);
    reserve(triangles);
    for (std::size_t t = 0; t < triangles.size(); ++t) cut(triangles[t], flags[t]);
  }

 private:
  /// A corner of a polygon, and the side from it to the next.
  struct Corner {
    std::uint32_t vertex;
    int rank;
    std::uint8_t flags;
    std::size_t edge;  ///< the triangle's edge on which the side lies; kLevel if it runs along a level
  };
  static constexpr std::size_t kLevel = 3;
  /// Largest number of corners of a slice: a triangle has one corner between its lowest and its highest, and a slice
  /// has two sides along levels.
  static constexpr std::size_t kMostCorners = 5;
  struct Polygon {
    std::array<Corner, kMostCorners + 1> corners;
    std::size_t size = 0;
    void add(const Corner& corner) { corners[size++] = corner; }
  };
  struct CutKey {
    std::uint32_t low, high;
    int rank;
    bool operator==(const CutKey&) const = default;
  };
  struct Hash {
    std::size_t operator()(const CutKey& key) const {
      return extend_hash(extend_hash(0, std::uint64_t{key.low} << 32 | key.high), static_cast<std::uint64_t>(key.rank));
    }
  };

  int rank(double z, double rounding) const {
    const auto above = std::lower_bound(levels_.begin(), levels_.end(), z - rounding);
    const int i = static_cast<int>(above - levels_.begin());
    return above != levels_.end() && *above <= z + rounding ? 2 * i : 2 * i - 1;
  }

  /// Range [first, end) of the levels strictly between two ranks.
  static std::pair<int, int> between(int low, int high) { return {(low + 2) >> 1, (high + 1) >> 1}; }
  std::array<int, 3> ranks(const std::array<std::uint32_t, 3>& t) const {
    return {ranks_[t[0]], ranks_[t[1]], ranks_[t[2]]};
  }

  void reserve(const std::vector<std::array<std::uint32_t, 3>>& triangles) {
    std::size_t count = triangles.size();
    for (const auto& t : triangles) {
      const std::array<int, 3> r = ranks(t);
      const auto [low, high] = std::minmax({r[0], r[1], r[2]});
      const auto [first, end] = between(low, high);
      count += 2 * static_cast<std::size_t>(std::max(end - first, 0));
      if (count > kMostTriangles)
        throw InputError(mesh_.name, "has too many contour lines: they cut it into more than 12 million triangles");
    }
    mesh_.triangles.reserve(count);
    mesh_.flags.reserve(count);
  }

  void cut(const std::array<std::uint32_t, 3>& t, const std::array<std::uint8_t, 3>& flags) {
    const std::array<int, 3> r = ranks(t);
    Polygon rest;
    for (std::size_t k = 0; k < 3; ++k) {
      // The edge lies at a level, and the face lies below it.
      const bool along = r[k] % 2 == 0 && r[k] == r[(k + 1) % 3] && r[(k + 2) % 3] < r[k];
      rest.add({t[k], r[k], static_cast<std::uint8_t>(flags[k] | (along ? kCornerContour : 0)), k});
    }
    const auto [low, high] = std::minmax({r[0], r[1], r[2]});
    const auto [first, end] = between(low, high);
    for (int level = first; level < end; ++level) {
      Polygon below, above;
      split(rest, t, 2 * level, below, above);
      add(below);
      rest = above;
    }
    add(rest);
  }

  void split(const Polygon& polygon, const std::array<std::uint32_t, 3>& t, int rank, Polygon& below, Polygon& above) {
    for (std::size_t k = 0; k < polygon.size; ++k) {
      const Corner& c = polygon.corners[k];
      const int next = polygon.corners[(k + 1) % polygon.size].rank;
      const Corner along{c.vertex, c.rank, kCornerContour, kLevel};
      if (c.rank < rank) below.add(c);
      if (c.rank > rank) above.add(c);
      if (c.rank == rank) {
        below.add(next < rank ? c : along);
        above.add(next < rank ? along : c);
      }
      if ((c.rank < rank && next > rank) || (c.rank > rank && next < rank)) {
        const std::uint32_t vertex = cut_vertex(t[c.edge], t[(c.edge + 1) % 3], rank);
        const Corner onward{vertex, rank, c.flags, c.edge}, back{vertex, rank, kCornerContour, kLevel};
        (c.rank < rank ? below : above).add(back);
        (c.rank < rank ? above : below).add(onward);
      }
    }
  }

  void add(const Polygon& polygon) {
    const auto& c = polygon.corners;
    for (std::size_t k = 2; k < polygon.size; ++k) {
      mesh_.triangles.push_back({c[0].vertex, c[k - 1].vertex, c[k].vertex});
      mesh_.flags.push_back(
          {k == 2 ? c[0].flags : std::uint8_t{0}, c[k - 1].flags, k + 1 == polygon.size ? c[k].flags : std::uint8_t{0}});
    }
  }

  /// The vertex at which an edge of the mesh reaches a level; shared by the triangles of the edge.
  std::uint32_t cut_vertex(std::uint32_t low, std::uint32_t high, int rank) {
    if (ranks_[low] > ranks_[high]) std::swap(low, high);
    const auto [place, is_new] =
        cuts_.try_emplace(CutKey{low, high, rank}, static_cast<std::uint32_t>(mesh_.vertices.size()));
    if (is_new) {
      const Point3 a = mesh_.vertices[low], b = mesh_.vertices[high];
      const double level = levels_[static_cast<std::size_t>(rank / 2)];
      const double t =
          (level / 2 - a.z / 2) / (b.z / 2 - a.z / 2);  // halves, since a difference of two heights may overflow
      mesh_.vertices.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), level});
    }
    return place->second;
  }

  SurfaceMesh& mesh_;
  std::vector<double> levels_;
  std::vector<int> ranks_;  ///< of the vertices before cutting
  std::unordered_map<CutKey, std::uint32_t, Hash> cuts_;
};

}  // namespace

void cut_contours(SurfaceMesh& mesh, std::span<const double> levels) {
  if (!levels.empty()) ContourCut(mesh, levels).run();
}

}  // namespace ligne
