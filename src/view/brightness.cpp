#include "view/brightness.hpp"

#include <algorithm>

#include <glm/geometric.hpp>

#include "scene/model/topology.hpp"

namespace ligne {

namespace {

/// eye_brightness() at the middle of a face.
double middle_brightness(const Scene& scene, const Camera& camera, std::uint32_t face) {
  const Point3 normal = face_normal(scene, face);
  if (!camera.perspective) return eye_brightness(camera, {0, 0, 0}, normal);
  const auto contour = scene.faces.contour(face, 0);
  Point3 middle{0, 0, 0};
  for (const std::uint32_t v : contour) middle += scene.vertices[v];
  middle /= double(contour.size());
  return eye_brightness(camera, middle, normal);
}

}  // namespace

double eye_brightness(const Camera& camera, const Point3& point, const Point3& normal) {
  if (!camera.perspective) {
    const double cosine = glm::dot(normal, camera.forward);
    return cosine * cosine;
  }
  const Point3 sight = point - camera.eye;
  const double square = glm::dot(sight, sight);
  if (!(square > 0) || glm::dot(sight, camera.forward) <= 0) return 0;
  const double cosine = glm::dot(normal, sight);
  return cosine * cosine / (square * square);  // `sight` is not of unit length
}

double eye_brightness_factor(const Scene& scene, const Camera& camera) {
  double largest = 0;
  for (std::uint32_t f = 0; f < scene.faces.size(); ++f) largest = std::max(largest, middle_brightness(scene, camera, f));
  return largest > 0 ? 1 / largest : 0;
}

std::vector<double> face_brightness(const Scene& scene, const Camera& camera) {
  std::vector<double> result(scene.faces.size(), 0);
  double largest = 0;
  for (std::uint32_t f = 0; f < result.size(); ++f) {
    result[f] = middle_brightness(scene, camera, f);
    largest = std::max(largest, result[f]);
  }
  for (double& b : result) b = largest > 0 ? b / largest : 1;
  return result;
}

FaceLight::FaceLight(const Scene& scene, const Camera& camera, std::span<const Light> lights)
    : scene_(scene), camera_(camera), lights_(lights) {
  if (lights.empty()) from_eye_ = face_brightness(scene, camera);
}

double FaceLight::of(std::uint32_t face, std::uint32_t reached, std::span<const double> shares) const {
  if (lights_.empty()) return from_eye_[face];
  const Point3 point = scene_.vertices[scene_.faces.contour(face, 0)[0]];
  Point3 normal = face_normal(scene_, face);
  const Point3 sight = camera_.perspective ? point - camera_.eye : camera_.forward;
  if (glm::dot(normal, sight) > 0) normal = -normal;
  return at(point, normal, reached, shares);
}

double FaceLight::at(const Point3& point, const Point3& normal, std::uint32_t reached,
                     std::span<const double> shares) const {
  double sum = 0;
  for (std::size_t i = 0; i < lights_.size(); ++i) {
    constexpr std::size_t kBits = 32;
    if (i < kBits && !(reached >> i & 1u)) continue;
    const Light& light = lights_[i];
    const Point3 way = light.kind == Light::Kind::parallel ? light.vector : point - light.vector;
    const double share = i < shares.size() ? shares[i] : 1;
    if (glm::dot(way, way) > 0) sum += share * std::max(0.0, -glm::dot(normal, glm::normalize(way)));
  }
  return std::min(1.0, sum / static_cast<double>(lights_.size()));
}

}  // namespace ligne
