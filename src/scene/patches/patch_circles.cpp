#include "scene/patches/patch_circles.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/no_index.hpp"
#include "base/parallel.hpp"

namespace ligne {
namespace {

/// Largest difference between places along the axis, and between radii, of the ends of edges of one circle, as a fraction of
/// its radius. A pen's width is a hundred times as much on any page.
constexpr double kSamePlace = 1e-5;

/// The circle of an edge of a patch.
struct EdgeCircle {
  std::uint32_t patch;
  double along, radius;
  bool operator<(const EdgeCircle& o) const { return std::tie(patch, along, radius) < std::tie(o.patch, o.along, o.radius); }
  bool is_same(const EdgeCircle& o) const {
    const double most = kSamePlace * radius;
    return patch == o.patch && std::abs(along - o.along) <= most && std::abs(radius - o.radius) <= most;
  }
};

/// The circles on which edges between patches lie, in the order of the edges.
std::vector<EdgeCircle> circles_of_edges(const Scene& scene, const Topology& topology, const Patches& patches) {
  std::vector<std::vector<EdgeCircle>> found(block_count(topology.edges.size(), kShortWorkBlock));
  const auto add = [&](const Edge& edge, std::uint32_t patch, std::vector<EdgeCircle>& circles) {
    // A sphere is round about any axis.
    if (patch == kNone) return;
    const SurfaceKind kind = patches.list[patch].surface.kind;
    if (kind == SurfaceKind::sphere || kind == SurfaceKind::extruded) return;
    const AxisPlace from = axis_place(patches.list[patch].surface, scene.vertices[edge.v0]);
    const AxisPlace to = axis_place(patches.list[patch].surface, scene.vertices[edge.v1]);
    const EdgeCircle circle{patch, (from.along + to.along) / 2, (from.radius + to.radius) / 2};
    if (circle.radius > 0 && circle.is_same({patch, from.along, from.radius})) circles.push_back(circle);
  };
  parallel_blocks(topology.edges.size(), kShortWorkBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) {
      const Edge& edge = topology.edges[e];
      const std::uint32_t first = patches.patch_of[edge.face0];
      const std::uint32_t second = edge.face1 == kNone ? kNone : patches.patch_of[edge.face1];
      if (first == second) continue;
      for (const std::uint32_t patch : {first, second}) add(edge, patch, found[begin / kShortWorkBlock]);
    }
  });
  std::vector<EdgeCircle> all;
  for (const std::vector<EdgeCircle>& circles : found) all.insert(all.end(), circles.begin(), circles.end());
  return all;
}

}  // namespace

std::vector<PatchCircle> patch_circles(const Scene& scene, const Topology& topology, const Patches& patches) {
  std::vector<EdgeCircle> found = circles_of_edges(scene, topology, patches);
  std::sort(found.begin(), found.end());
  std::vector<PatchCircle> circles;
  std::vector<EdgeCircle> kept;  // of the last patch, by their places along its axis
  for (const EdgeCircle& circle : found) {
    if (!kept.empty() && kept.front().patch != circle.patch) kept.clear();
    const auto is_near = [&](const EdgeCircle& other) { return circle.along - other.along <= kSamePlace * circle.radius; };
    bool is_kept = false;
    for (auto other = kept.rbegin(); other != kept.rend() && is_near(*other) && !is_kept; ++other) {
      is_kept = circle.is_same(*other);
    }
    if (is_kept) continue;
    kept.push_back(circle);
    const PatchSurface& surface = patches.list[circle.patch].surface;
    circles.push_back({surface.at + circle.along * surface.axis, surface.axis, circle.radius});
  }
  return circles;
}

}  // namespace ligne
