#include "scene/heal/collapse_edges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <span>
#include <vector>

#include "base/disjoint_sets.hpp"
#include "base/parallel.hpp"
#include "scene/clean/clean.hpp"
#include "scene/model/precision.hpp"

namespace ligne {
namespace {

/// Edges of this many roundings or more are not collapsed. A step of the coordinates is two roundings, so vertices that lie
/// on neighbouring steps of the coarsest coordinate stay apart.
constexpr double kLeastRoundings = 1.9;
/// Adjustable. A chain of such edges is collapsed over up to this many roundings.
constexpr double kChainRoundings = 8;

using VertexPair = std::array<std::uint32_t, 2>;

bool are_within(double distance, const Point3& p, const Point3& q) {
  // Nearly all edges are long in each direction.
  if (!(std::abs(p.x - q.x) < distance)) return false;
  const Point3 way = p - q;
  return glm::dot(way, way) < distance * distance;
}

/// The least length of the edges of a face that stay.
double least_length(const Scene& scene, std::size_t face, double precision) {
  double largest = 0;
  for (const std::uint32_t v : scene.faces.contour(face, 0)) {
    const Point3& p = scene.vertices[v];
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  return kLeastRoundings * std::min(precision, half_ulp_float32(largest));
}

/// Appends the short edges of an object.
void append_short_edges(const Scene& scene, const Object& object, std::vector<VertexPair>& edges) {
  const std::size_t count = object.face_end - object.face_begin;
  std::vector<std::vector<VertexPair>> found(block_count(count, kShortWorkBlock));
  const double most = kLeastRoundings * object.precision;
  const std::span<const std::uint32_t> corners = scene.faces.corners();
  const bool all_triangles = scene.faces.all_triangles();
  // Nearly all triangles have no such edge.
  const auto has_long_edges = [&](std::size_t f) {
    const Point3 &a = scene.vertices[corners[3 * f]], &b = scene.vertices[corners[3 * f + 1]],
                 &c = scene.vertices[corners[3 * f + 2]];
    return !are_within(most, a, b) && !are_within(most, b, c) && !are_within(most, c, a);
  };
  parallel_blocks(count, kShortWorkBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = object.face_begin + begin; f < object.face_begin + end; ++f) {
      if (all_triangles && has_long_edges(f)) continue;
      for (std::size_t c = 0; c < scene.faces.contour_count(f); ++c) {
        const std::span<const std::uint32_t> contour = scene.faces.contour(f, c);
        std::uint32_t last = contour.back();
        for (const std::uint32_t v : contour) {
          const Point3 &p = scene.vertices[last], &q = scene.vertices[v];
          if (are_within(most, p, q) && are_within(least_length(scene, f, object.precision), p, q))
            found[begin / kShortWorkBlock].push_back({last, v});
          last = v;
        }
      }
    }
  });
  for (const auto& block : found) edges.insert(edges.end(), block.begin(), block.end());
}

}  // namespace

std::size_t collapse_short_edges(Scene& scene) {
  std::vector<VertexPair> edges;
  for (const Object& object : scene.objects) append_short_edges(scene, object, edges);
  if (edges.empty()) return 0;
  DisjointSets chains(scene.vertices.size());
  for (const auto& [first, second] : edges) chains.join(first, second);
  std::size_t merged = 0;
  for (const Object& object : scene.objects) {
    for (std::uint32_t v = object.vertex_begin; v < object.vertex_end; ++v) {
      const std::uint32_t to = chains.find(v);
      if (to == v || !are_within(kChainRoundings * object.precision, scene.vertices[to], scene.vertices[v])) continue;
      scene.vertices[v] = scene.vertices[to];
      ++merged;
    }
  }
  Warnings vanished;  // faces without thickness are no loss
  finish_scene(scene, vanished);
  return merged;
}

}  // namespace ligne
