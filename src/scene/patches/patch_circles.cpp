#include "scene/patches/patch_circles.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <tuple>

#include "base/no_index.hpp"

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

}  // namespace

std::vector<PatchCircle> patch_circles(const Scene& scene, const Topology& topology, const Patches& patches) {
  std::vector<EdgeCircle> found;
  for (const Edge& edge : topology.edges) {
    const std::uint32_t first = patches.patch_of[edge.face0];
    const std::uint32_t second = edge.face1 == kNone ? kNone : patches.patch_of[edge.face1];
    if (first == second) continue;
    for (const std::uint32_t patch : {first, second}) {
      // A sphere is round about any axis.
      if (patch == kNone || patches.list[patch].surface.kind == SurfaceKind::sphere) continue;
      const AxisPlace from = axis_place(patches.list[patch].surface, scene.vertices[edge.v0]);
      const AxisPlace to = axis_place(patches.list[patch].surface, scene.vertices[edge.v1]);
      const EdgeCircle circle{patch, (from.along + to.along) / 2, (from.radius + to.radius) / 2};
      if (circle.radius > 0 && circle.is_same({patch, from.along, from.radius})) found.push_back(circle);
    }
  }
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
