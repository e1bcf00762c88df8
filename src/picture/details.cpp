#include "picture/details.hpp"

#include <iterator>
#include <optional>

#include "geometry/clip_contour_by_contour.hpp"
#include "picture/region_faces.hpp"

namespace ligne {
namespace {

std::optional<ContourFace> on_page(const Detail& detail, const View& view, const Lattice& lattice) {
  std::vector<std::vector<LatticePoint>> contours(1);
  for (const Point3& p : detail.contour) {
    const HomogeneousPoint h = to_homogeneous(view, p);
    if (view.camera.perspective && !(h.w > view.near_distance)) return std::nullopt;
    contours[0].push_back(lattice.snap({h.x / h.w, h.y / h.w}));
  }
  return make_contour_face(contours);
}

}  // namespace

std::vector<Region> cut_details(const Scene& scene, const View& view, std::vector<Region> regions) {
  const Lattice lattice = Lattice::covering(view.window);
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
