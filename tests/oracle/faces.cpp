#include "oracle/faces.hpp"

#include <cmath>

namespace oracle {
namespace {

/// docs/numerics.md, "The near plane and faces seen edge on": a face as high as an A4 sheet is then a micrometre wide.
constexpr double kEdgeOnSine = 0.001 / 297;
/// Sines that differ from it by less than this factor may be told either way.
constexpr double kEdgeOnDoubt = 2;

using Contour = std::vector<SightPoint>;

Contour contour_of(const ligne::Scene& scene, std::size_t face, std::size_t contour, const Projection& projection) {
  Contour points;
  for (const std::uint32_t v : scene.faces.contour(face, contour)) {
    points.push_back(projection.sight_point(exact(scene.vertices[v])));
  }
  return points;
}

/// Cuts off what is nearer than the near plane. A contour that leaves and comes back runs along the plane between; such
/// sides lie on each other in pairs where nothing is between them, and the count of sides comes out right.
Contour behind_near_plane(const Contour& contour, const Projection& projection) {
  Contour kept;
  for (std::size_t k = 0; k < contour.size(); ++k) {
    const SightPoint &p = contour[k], &q = contour[k + 1 == contour.size() ? 0 : k + 1];
    const bool p_out = projection.too_near(p), q_out = projection.too_near(q);
    if (!p_out) kept.push_back(p);
    if (p_out != q_out) {
      const Exact t = (projection.near() - p.f) / (q.f - p.f);
      kept.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y), projection.near()});
    }
  }
  return kept;
}

void set_plane(Face& face, const ligne::Scene& scene, std::size_t f) {
  const auto outer = scene.faces.contour(f, 0);
  const Vector3 origin = exact(scene.vertices[outer[0]]);
  Vector3 normal{0, 0, 0}, sum{0, 0, 0};
  for (std::size_t k = 0; k < outer.size(); ++k) {
    const Vector3 p = exact(scene.vertices[outer[k]]) - origin;
    const Vector3 q = exact(scene.vertices[outer[k + 1 == outer.size() ? 0 : k + 1]]) - origin;
    normal = normal + cross(p, q);
    sum = sum + p;
  }
  face.normal = normal;
  face.centre = origin + (Exact(1) / Exact(static_cast<double>(outer.size()))) * sum;
  face.flat = is_zero(normal);
}

void set_facing(Face& face, const ligne::Scene& scene, std::size_t f, const Projection& projection) {
  const Vector3 first = exact(scene.vertices[scene.faces.contour(f, 0)[0]]);
  const Vector3 sight = projection.perspective() ? first - projection.eye() : projection.forward();
  const Exact d = dot(face.normal, sight);
  if (face.flat || d == 0) return;
  const double sine = std::abs(to_double(d)) / (length(face.normal) * length(sight));
  face.facing_sure = sine < kEdgeOnSine / kEdgeOnDoubt || sine > kEdgeOnSine * kEdgeOnDoubt;
  if (sine > kEdgeOnSine) face.facing = d < 0 ? 1 : -1;
}

}  // namespace

void Box::add(const PagePoint& p) {
  x0 = std::min(x0, lower(p.x)), x1 = std::max(x1, upper(p.x));
  y0 = std::min(y0, lower(p.y)), y1 = std::max(y1, upper(p.y));
  z0 = std::min(z0, lower(p.z)), z1 = std::max(z1, upper(p.z));
}

std::vector<Face> make_faces(const ligne::Scene& scene, const Projection& projection, double input_error) {
  std::vector<Face> faces(scene.faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    Face& face = faces[f];
    set_plane(face, scene, f);
    if (face.flat) continue;
    set_facing(face, scene, f, projection);
    bool edge_on = false;
    face.plane = projection.page_plane(face.normal, face.centre, input_error, edge_on);
    if (edge_on) continue;
    for (std::size_t c = 0; c < scene.faces.contour_count(f); ++c) {
      const Contour contour = behind_near_plane(contour_of(scene, f, c, projection), projection);
      const auto first = static_cast<std::uint32_t>(face.corners.size()), n = static_cast<std::uint32_t>(contour.size());
      for (std::uint32_t k = 0; k < n; ++k) {
        const PagePoint p = projection.page_point(contour[k]);
        face.slack_mm = std::max(face.slack_mm, projection.mm_z() * std::abs(to_double(p.z - face.plane.z(p.x, p.y))));
        face.box.add(p);
        face.corners.push_back(p);
        face.corners_mm.push_back(projection.page_mm(p));
        face.sides.push_back({first + k, k + 1 == n ? first : first + k + 1});
      }
    }
    face.hides = face.corners.size() >= 3;
    face.gradient = std::hypot(to_double(face.plane.b) * projection.mm_z() / projection.mm_x(),
                               to_double(face.plane.c) * projection.mm_z() / projection.mm_y());
  }
  return faces;
}

}  // namespace oracle
