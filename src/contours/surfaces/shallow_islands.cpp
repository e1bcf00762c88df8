#include "contours/surfaces/shallow_islands.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <glm/geometric.hpp>

#include "base/disjoint_sets.hpp"
#include "base/no_index.hpp"
#include "geometry/degrees.hpp"

namespace ligne {
namespace {

/// Adjustable. An island is shallow if its surface is everywhere inclined to the line of sight by less than this angle.
constexpr double kShallowDegrees = 4;

/// A sector, or a connected set of sectors with one sign of g.
struct Island {
  double most = 0;    ///< largest sine of the angle between its surface and the line of sight
  bool whole = true;  ///< g has the other sign all around it, and it lies entirely on a scan
};

bool is_of_scan(std::span<const ScanObject> scans, std::uint32_t face) {
  const auto scan = std::ranges::upper_bound(scans, face, {}, &ScanObject::face_end);
  return scan != scans.end() && face >= scan->face_begin;
}

}  // namespace

void level_shallow_islands(SmoothPatch& patch, const Scene& scene, const Camera& camera, std::span<const ScanObject> scans) {
  if (scans.empty()) return;
  DisjointSets sets(patch.g.size());
  for (std::uint32_t corner = 0; corner < patch.sector.size(); ++corner) {
    if (patch.across[corner] < corner) continue;  // the neighbour has the same side
    const std::uint32_t next = next_corner(corner);
    if (patch.looks_at_viewer(corner) == patch.looks_at_viewer(next)) sets.join(patch.sector[corner], patch.sector[next]);
  }
  std::vector<Island> parts(patch.g.size());  // by sector
  for (std::uint32_t t = 0; t < patch.triangles.size(); ++t) {
    const bool on_scan = is_of_scan(scans, patch.triangles[t].face);
    for (std::uint32_t corner = 3 * t; corner < 3 * t + 3; ++corner) {
      Island& part = parts[patch.sector[corner]];
      const bool at_border = patch.across[corner] == kNone || patch.across[last_corner(corner)] == kNone;
      if (at_border || patch.complete[corner] == 0 || !on_scan) part.whole = false;
      if (part.most > 0) continue;  // the sector has one place
      const Point3 eye = to_eye(camera, scene.vertices[patch.triangles[t].v[corner - 3 * t]]);
      part.most = std::abs(patch.g[patch.sector[corner]]) / glm::length(eye);
    }
  }
  std::vector<Island> islands(patch.g.size());  // by the sector that stands for one
  for (std::uint32_t s = 0; s < parts.size(); ++s) {
    Island& island = islands[sets.find(s)];
    island.most = std::max(island.most, parts[s].most);
    island.whole = island.whole && parts[s].whole;
  }
  const double sine = sine_cosine_degrees(kShallowDegrees).sine;
  for (std::uint32_t s = 0; s < patch.g.size(); ++s) {
    const Island& island = islands[sets.find(s)];
    if (!island.whole || island.most >= sine) continue;
    double& g = patch.g[s];
    // Zero counts as looking at the viewer.
    g = g >= 0 ? std::min(-g, -std::numeric_limits<double>::min()) : -g;
  }
}

}  // namespace ligne
