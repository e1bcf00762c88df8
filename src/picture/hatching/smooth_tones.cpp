#include "picture/hatching/smooth_tones.hpp"

#include <algorithm>

#include <glm/geometric.hpp>

#include "base/parallel.hpp"
#include "view/brightness.hpp"

namespace ligne {
namespace {

/// Cosine between the normals of a node and of a face above which the face does not bend there.
constexpr double kSameDirection = 1 - 1e-9;

}  // namespace

SmoothTones::SmoothTones(const PreparedScene& prepared)
    : camera_(prepared.view().camera),
      mesh_(form_mesh(prepared.scene, prepared.topology, prepared.request.lines.crease_degrees)),
      of_face_(face_brightness(prepared.scene, camera_)),
      factor_(eye_brightness_factor(prepared.scene, camera_)) {
  projected_.reserve(mesh_.points.size());
  for (const Point3& p : mesh_.points) {
    const HomogeneousPoint h = to_homogeneous(prepared.view(), p);
    projected_.push_back({h.x, h.y, h.w});
  }
  is_flat_.resize(of_face_.size());
  parallel_for(is_flat_.size(),
               [&](std::size_t f) { is_flat_[f] = is_flat(prepared.scene, static_cast<std::uint32_t>(f)); });
}

bool SmoothTones::is_flat(const Scene& scene, std::uint32_t face) const {
  const Point3 normal = face_normal(scene, face);
  for (std::uint32_t t = mesh_.first[face]; t < mesh_.first[face + 1]; ++t) {
    for (const std::uint32_t node : mesh_.triangles[t].node) {
      if (std::abs(glm::dot(mesh_.normals[node], normal)) < kSameDirection) return false;
    }
  }
  return true;
}

/// Weights of the corners at the point of the triangle's plane that the page point shows; their sum is 1. With P the
/// projected corners and q = (x, y, 1), they solve sum weight_i P_i = c q, so perspective needs no further division.
std::array<double, 3> SmoothTones::weights(const FormTriangle& triangle, Point2 page_mm) const {
  std::array<double, 3> w{};
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Projected &b = projected_[triangle.node[(k + 1) % 3]], &c = projected_[triangle.node[(k + 2) % 3]];
    w[k] = page_mm.x * (b.y * c.w - b.w * c.y) + page_mm.y * (b.w * c.x - b.x * c.w) + (b.x * c.y - b.y * c.x);
    sum += w[k];
  }
  for (double& share : w) share = sum != 0 ? share / sum : 1.0 / 3;
  return w;
}

std::optional<SurfacePoint> SmoothTones::surface_at(std::uint32_t face, Point2 page_mm) const {
  if (face >= is_flat_.size() || is_flat_[face]) return std::nullopt;
  // The triangle of the face that contains the point, or that it is least outside of.
  std::uint32_t best = mesh_.first[face];
  std::array<double, 3> of_best{};
  double least = -1e300;
  for (std::uint32_t t = mesh_.first[face]; t < mesh_.first[face + 1]; ++t) {
    const std::array<double, 3> w = weights(mesh_.triangles[t], page_mm);
    const double inside = *std::min_element(w.begin(), w.end());
    if (inside <= least) continue;
    least = inside;
    best = t;
    of_best = w;
  }
  double sum = 0;
  for (double& share : of_best) sum += share = std::max(share, 0.0);
  Point3 normal{0, 0, 0}, point{0, 0, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t node = mesh_.triangles[best].node[k];
    normal += of_best[k] / sum * mesh_.normals[node];
    point += of_best[k] / sum * mesh_.points[node];
  }
  const Point3 sight = camera_.perspective ? point - camera_.eye : camera_.forward;
  const double towards = glm::dot(mesh_.area_vector(best), sight);
  const bool turns_away = glm::dot(normal, sight) * towards <= 0;
  return SurfacePoint{point, towards > 0 ? -unit(normal) : unit(normal), turns_away};
}

double SmoothTones::at(std::uint32_t face, Point2 page_mm) const {
  if (face >= is_flat_.size()) return 1;
  const std::optional<SurfacePoint> surface = surface_at(face, page_mm);
  if (!surface) return of_face_[face];
  // At an outline the surface is dark.
  if (surface->turns_away) return 0;
  return std::min(1.0, factor_ * eye_brightness(camera_, surface->point, surface->normal));
}

}  // namespace ligne
