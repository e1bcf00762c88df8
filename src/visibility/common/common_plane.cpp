#include "visibility/common/common_plane.hpp"

#include <algorithm>
#include <cmath>

namespace ligne {
namespace {

/// Rounding error as a share of the sum of the terms: a dozen roundings of a depth and of the value compared with it.
constexpr double kPlaneRounding = 0x1p-49;
/// Largest distance of a corner from the plane, as a share of the depth tolerance: see CommonPlane.
constexpr double kPart = 0.5;
/// Distance in tolerances by which the plane of a small facet may miss other facets in the same plane. Adjustable.
constexpr double kTurnedByRounding = 16;

}  // namespace

CommonPlane CommonPlane::of_facet(const ProjectedScene& scene, const Facet& facet) {
  const FacetFunctions f(facet, scene.vertices.data());
  CommonPlane plane;
  plane.zx_ = f.zx, plane.zy_ = f.zy, plane.z_ = f.z;
  return plane;
}

std::optional<CommonPlane> CommonPlane::nearest_to(const ProjectedScene& scene, const std::vector<Facet>& facets,
                                                   std::span<const CellFacet> list) {
  const auto for_each_corner = [&](auto&& visit) {
    for (const CellFacet& entry : list) {
      for (const std::uint32_t v : facets[entry.facet].v) visit(scene.vertices[v]);
    }
  };
  const double n = 3 * static_cast<double>(list.size());
  double x0 = 0, y0 = 0, z0 = 0;
  for_each_corner([&](const ProjectedVertex& v) { x0 += v.p.x, y0 += v.p.y, z0 += v.z; });
  x0 /= n, y0 /= n, z0 /= n;
  double xx = 0, xy = 0, yy = 0, xz = 0, yz = 0;
  for_each_corner([&](const ProjectedVertex& v) {
    const double x = v.p.x - x0, y = v.p.y - y0, z = v.z - z0;
    xx += x * x, xy += x * y, yy += y * y, xz += x * z, yz += y * z;
  });
  const double determinant = xx * yy - xy * xy;
  if (!(determinant > 0)) return std::nullopt;
  CommonPlane plane;
  plane.zx_ = (xz * yy - yz * xy) / determinant;
  plane.zy_ = (yz * xx - xz * xy) / determinant;
  plane.z_ = z0 - plane.zx_ * x0 - plane.zy_ * y0;
  return plane;
}

double CommonPlane::distance(LatticePoint p, double z) const {
  const double x = p.x, y = p.y;
  const double sizes = std::abs(zx_ * x) + std::abs(zy_ * y) + std::abs(z_) + std::abs(z);
  return std::abs(zx_ * x + zy_ * y + z_ - z) + kPlaneRounding * sizes;
}

double CommonPlane::farthest(const ProjectedScene& scene, const std::vector<Facet>& facets, std::span<const CellFacet> list,
                             double enough) {
  touch_ = facets[list.front().facet].depth_tolerance;
  double off = 0;
  for (const CellFacet& entry : list) {
    const Facet& facet = facets[entry.facet];
    touch_ = std::min<double>(touch_, facet.depth_tolerance);
    for (const std::uint32_t v : facet.v) off = std::max(off, distance(scene.vertices[v].p, scene.vertices[v].z));
    if (!(off <= enough * touch_)) break;
  }
  return off / touch_;
}

std::optional<CommonPlane> CommonPlane::of(const ProjectedScene& scene, const std::vector<Facet>& facets,
                                           std::span<const CellFacet> list) {
  // The plane of the first facet costs nothing, and shows at once where planes differ. But rounded corners tilt the
  // plane of a small facet, too far to fit all facets.
  const bool is_long = list.size() > kLongList;
  CommonPlane plane = of_facet(scene, facets[list.front().facet]);
  const double enough = is_long ? kTurnedByRounding : kPart;
  const double off = plane.farthest(scene, facets, list, enough);
  if (off <= kPart) return plane;
  if (!(off <= enough)) return std::nullopt;
  std::optional<CommonPlane> nearest = nearest_to(scene, facets, list);
  if (nearest && !(nearest->farthest(scene, facets, list, kPart) <= kPart)) nearest.reset();
  return nearest;
}

bool CommonPlane::holds(const PageLine& line) const {
  return distance(line.p0, line.z0) <= kPart * touch_ && distance(line.p1, line.z1) <= kPart * touch_;
}

}  // namespace ligne
