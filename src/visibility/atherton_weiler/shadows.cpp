#include "visibility/atherton_weiler/shadows.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <oneapi/tbb/parallel_for.h>

#include "geometry/clip_contour_by_contour.hpp"
#include "visibility/atherton_weiler/region_faces.hpp"
#include "visibility/atherton_weiler/visible_faces.hpp"
#include "visibility/tolerances.hpp"

namespace ligne::atherton_weiler {
namespace {

/// The page of a light: as large as A4, so that its lattice is as fine as that of a drawing.
const Rect kLightPage{{0, 0}, {297, 210}};

/// Lit and shadowed parts narrower than this are the rounding of contours that went from the light's page to the viewer's.
constexpr double kNarrowestMm = 0.001;

/// A light outside of the scene sees all of it in one picture, somewhat wider than the sphere round it.
constexpr double kOutside = 1.05;

struct Sphere {
  Point3 centre{0, 0, 0};
  double radius = 0;
};

Sphere sphere_round(const Scene& scene) {
  Point3 low(1e300), high(-1e300);
  for (const Point3& p : scene.vertices) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  return {(low + high) * 0.5, glm::length(high - low) * 0.5};
}

std::vector<CameraRequest> pictures_of(const Light& light, const Scene& scene) {
  CameraRequest request;
  request.up_axis = scene.up_axis;
  if (light.kind == Light::Kind::parallel) {
    request.direction = light.vector;
    return {request};
  }
  const Sphere sphere = sphere_round(scene);
  request.eye = light.vector;
  const double distance = glm::length(sphere.centre - light.vector);
  if (distance > kOutside * sphere.radius) {
    constexpr double kDegrees = 57.29577951308232;
    request.target = sphere.centre;
    request.fov_degrees = 2 * kDegrees * std::asin(std::min(1.0, sphere.radius / distance)) * kOutside;
    if (request.fov_degrees < 150) return {request};
  }
  std::vector<CameraRequest> pictures;  // the six sides of a cube round the light
  request.fov_degrees = 90;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      Point3 forward(0);
      forward[axis] = sign * sphere.radius;
      request.target = light.vector + forward;
      pictures.push_back(request);
    }
  }
  return pictures;
}

struct Plane {
  Point3 normal, point;
};

Plane plane_of(const Scene& scene, std::uint32_t face) { return {face_normal(scene, face), scene.vertices[scene.faces.contour(face, 0)[0]]}; }

/// Carries points of a face from one page to another.
class Carrier {
 public:
  Carrier(const View& from, const View& to, const Lattice& lattice) : from_(from), to_(to), lattice_(lattice) {
    far_ = from.camera.perspective ? 0.5 * from.scale * from.camera.target_distance : 100;  // any depth but 0
  }

  /// False when the point can not be drawn: the sight runs along the face, or it is not in front of the viewer.
  bool carry(Point2 page_mm, const Plane& plane, LatticePoint& out) const {
    const Point3 a = to_model_point(from_, page_mm, 0), b = to_model_point(from_, page_mm, far_);
    const double rise = glm::dot(plane.normal, b - a);
    if (rise == 0) return false;
    const Point3 p = a + (b - a) * (glm::dot(plane.normal, plane.point - a) / rise);
    const HomogeneousPoint h = to_homogeneous(to_, p);
    if (!(h.w > to_.near_distance * (to_.camera.perspective ? 1 : 0))) return false;
    out = lattice_.snap({h.x / h.w, h.y / h.w});
    return true;
  }

 private:
  const View& from_;
  const View& to_;
  const Lattice& lattice_;
  double far_;
};

/// On which side of the face's plane the eye is.
double side_of_eye(const Camera& camera, const Plane& plane) {
  return camera.perspective ? glm::dot(plane.normal, camera.eye - plane.point) : -glm::dot(plane.normal, camera.forward);
}

using LitFaces = std::vector<std::vector<ContourFace>>;  ///< per face of the scene, on the viewer's page

void add_lit(const Scene& scene, const Topology& topology, const View& view, const Lattice& lattice, const CameraRequest& request, LitFaces& lit) {
  const Camera camera = make_camera(request, scene);
  const View light_view = make_view(scene, camera, {kLightPage}, kLightPage);
  const ProjectedScene seen = project(scene, topology, light_view, {});
  const Facets facets = make_facets(seen, coincidence_mm(seen) / seen.lattice.step_mm);
  appel::CellGrid::Options grid_options;
  grid_options.margin_steps = coincidence_mm(seen) / seen.lattice.step_mm + 1;
  grid_options.drop_hidden = seen.face_is_transparent.empty();
  const appel::CellGrid grid(seen, facets.facets, grid_options);
  const VisibleFaces visible = find_visible_faces(seen, facets.facets, grid, {});
  const Carrier carrier(light_view, view, lattice);
  for (const Region& region : visible.regions) {
    const Plane plane = plane_of(scene, region.face);
    if (side_of_eye(camera, plane) * side_of_eye(view.camera, plane) <= 0) continue;
    std::vector<std::vector<LatticePoint>> contours;
    bool drawn = true;
    for (const std::vector<Point2>& contour : region.contours) {
      auto& points = contours.emplace_back(contour.size());
      for (std::size_t i = 0; i < contour.size(); ++i) drawn = drawn && carrier.carry(contour[i], plane, points[i]);
    }
    if (drawn) lit[region.face].push_back(make_contour_face(contours));
  }
}

bool narrow(const ContourFace& face, const Lattice& lattice) {
  double length = 0;
  for (const EdgeLoop& loop : face.contours) {
    for (const ContourEdge& e : loop) length += std::hypot(e.dx(), e.dy()) * (value(e.to) - value(e.from));
  }
  return twice_area(face) * lattice.step_mm < length * kNarrowestMm;
}

}  // namespace

std::vector<Region> cast_shadows(const Scene& scene, const Topology& topology, const View& view, std::span<const Light> lights,
                                 const std::vector<Region>& regions) {
  const Lattice lattice = Lattice::covering(view.window);
  std::vector<Region> pieces = regions;
  for (Region& r : pieces) r.lights = 0;
  for (std::size_t i = 0; i < std::min(lights.size(), kMostLights); ++i) {
    LitFaces lit(scene.faces.size());
    for (const CameraRequest& request : pictures_of(lights[i], scene)) add_lit(scene, topology, view, lattice, request, lit);
    std::vector<std::vector<Region>> cut(pieces.size());
    tbb::parallel_for(std::size_t{0}, pieces.size(), [&](std::size_t k) {
      const Region& piece = pieces[k];
      if (lit[piece.face].empty()) {
        cut[k].push_back(piece);
        return;
      }
      const std::vector<ContourFace> subject{on_lattice(piece, lattice)};
      const ClipResult result = clip_contour_by_contour(subject, lit[piece.face]);
      for (const ContourFace& face : result.outside) {
        if (!narrow(face, lattice)) cut[k].push_back(region_of(face, lattice, piece));
      }
      Region like = piece;
      like.lights |= 1u << i;
      if (cut[k].empty() && !result.inside.empty()) {  // lit as a whole: the contours stay as they were
        cut[k].push_back(std::move(like));
        return;
      }
      for (const ContourFace& face : result.inside) {
        if (!narrow(face, lattice)) cut[k].push_back(region_of(face, lattice, like));
      }
    });
    pieces.clear();
    for (std::vector<Region>& c : cut) std::move(c.begin(), c.end(), std::back_inserter(pieces));
  }
  return pieces;
}

}  // namespace ligne::atherton_weiler
