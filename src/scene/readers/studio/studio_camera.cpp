#include "scene/readers/studio/studio_camera.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace ligne {

void set_lens(SceneCamera& camera, double lens_mm) {
  constexpr double kFilmHeightMm = 24, kFilmWidthMm = 36;
  camera.fov_degrees = 2 * std::atan2(kFilmHeightMm / 2, std::max(lens_mm, 0.0)) * 180 / std::numbers::pi;
  camera.aspect = kFilmWidthMm / kFilmHeightMm;
}

void bank_camera(SceneCamera& camera, double degrees) {
  const Point3 forward = glm::normalize(camera.forward), across = glm::cross(forward, Point3{0, 0, 1});
  if (degrees == 0 || glm::length(across) == 0) return;
  const Point3 right = glm::normalize(across);
  const double angle = degrees * std::numbers::pi / 180;
  camera.up = glm::cross(right, forward) * std::cos(angle) + right * std::sin(angle);
}

}  // namespace ligne
