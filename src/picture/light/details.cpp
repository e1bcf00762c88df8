#include "picture/light/details.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "geometry/polygons/clip_contour_by_contour.hpp"
#include "picture/light/face_carrier.hpp"
#include "picture/light/region_faces.hpp"
#include "scene/model/topology.hpp"

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

/// A face projected along the axis nearest to its normal. The projection is affine.
class FlatFace {
 public:
  FlatFace(const Scene& scene, std::uint32_t face) {
    const Point3 normal = glm::abs(face_normal(scene, face));
    dropped_ = normal.x >= normal.y && normal.x >= normal.z ? 0 : normal.y >= normal.z ? 1 : 2;
    for (std::size_t c = 0; c < scene.faces.contour_count(face); ++c) {
      const auto contour = scene.faces.contour(face, c);
      for (std::size_t i = 0; i < contour.size(); ++i) {
        const std::uint32_t next = contour[i + 1 == contour.size() ? 0 : i + 1];
        sides_.push_back({flat(scene.vertices[contour[i]]), flat(scene.vertices[next])});
      }
    }
  }

  /// Calls visit(from, to) for the parts of the segment a-b that lie on the face, as fractions of the segment.
  template <class Visit>
  void parts_inside(const Point3& a, const Point3& b, Visit visit) const {
    const Point2 p = flat(a), along = flat(b) - p;
    std::vector<double> places{0, 1};
    for (const auto& [q, r] : sides_) {
      const double of_q = cross(along, q - p), of_r = cross(along, r - p);
      if ((of_q < 0) == (of_r < 0)) continue;
      const Point2 x = q + (r - q) * (of_q / (of_q - of_r));
      places.push_back(std::clamp(glm::dot(x - p, along) / glm::dot(along, along), 0.0, 1.0));
    }
    std::sort(places.begin(), places.end());
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
      if (places[i] < places[i + 1] && inside(p + along * ((places[i] + places[i + 1]) / 2)))
        visit(places[i], places[i + 1]);
    }
  }

 private:
  Point2 flat(const Point3& p) const {
    return dropped_ == 0 ? Point2{p.y, p.z} : dropped_ == 1 ? Point2{p.z, p.x} : Point2{p.x, p.y};
  }

  bool inside(Point2 p) const {
    bool in = false;
    for (const auto& [a, b] : sides_) {
      if ((a.y <= p.y) != (b.y <= p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) in = !in;
    }
    return in;
  }

  int dropped_ = 2;
  std::vector<std::array<Point2, 2>> sides_;
};

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

std::vector<DetailLine> detail_lines(const Scene& scene) {
  std::vector<DetailLine> lines;
  for (const Detail& detail : scene.details) {
    const FlatFace face(scene, detail.face);
    for (std::size_t i = 0; i < detail.contour.size(); ++i) {
      const Point3 &from = detail.contour[i], &to = detail.contour[i + 1 == detail.contour.size() ? 0 : i + 1];
      if (from == to) continue;
      face.parts_inside(from, to, [&](double t, double u) {
        const Point3 end = u == 1 ? to : from + (to - from) * u;
        lines.push_back({{t == 0 ? from : from + (to - from) * t, end}, detail.face});
      });
    }
  }
  return lines;
}

}  // namespace ligne
