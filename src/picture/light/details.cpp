#include "picture/light/details.hpp"

#include <iterator>
#include <optional>
#include <utility>

#include "geometry/polygons/clip_contour_by_contour.hpp"
#include "picture/light/face_carrier.hpp"
#include "picture/light/region_faces.hpp"

namespace ligne {
namespace {

/// Returns the part of the detail in view, or nothing.
std::optional<ContourFace> on_page(const Detail& detail, const View& view, const Lattice& lattice) {
  std::vector<HomogeneousPoint> contour;
  for (const Point3& p : detail.contour) contour.push_back(to_homogeneous(view, p));
  const std::vector<std::vector<LatticePoint>> contours{points_in_view(std::move(contour), view, lattice)};
  if (contours[0].size() < 3) return std::nullopt;
  return make_contour_face(contours);
}

}  // namespace

std::vector<Region> cut_details(const Scene& scene, const View& view, std::vector<Region> regions) {
  const Lattice lattice = page_lattice(view);
  for (const Detail& detail : scene.details) {
    const std::optional<ContourFace> clip = on_page(detail, view, lattice);
    if (!clip) continue;
    std::vector<Region> cut;
    for (Region& region : regions) {
      if (region.face != detail.face) {
        cut.push_back(std::move(region));
        continue;
      }
      const ClipResult result = clip_contour_by_contour(on_lattice(region, lattice), *clip);
      for (const ContourFace& face : result.outside) cut.push_back(region_of(face, lattice, region));
      region.material = detail.material;
      for (const ContourFace& face : result.inside) cut.push_back(region_of(face, lattice, region));
    }
    regions = std::move(cut);
  }
  return regions;
}

}  // namespace ligne
