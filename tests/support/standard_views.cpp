#include "support/standard_views.hpp"

#include <cmath>
#include <cstdio>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace ligne::test {
namespace {

std::string text(const Point3& p) {
  char buffer[128];
  std::snprintf(buffer, sizeof buffer, "%.17g,%.17g,%.17g", p.x, p.y, p.z);
  return buffer;
}

StandardView parallel(const std::string& name, const Scene& scene, const Point3& direction) {
  StandardView view;
  view.name = name;
  view.camera.direction = direction;
  view.camera.up_axis = scene.up_axis;
  view.options = "--direction=" + text(direction);
  return view;
}

StandardView perspective(const std::string& name, const Scene& scene, const Point3& eye, const Point3& target, double fov) {
  StandardView view;
  view.name = name;
  view.camera.eye = eye;
  view.camera.target = target;
  view.camera.fov_degrees = fov;
  view.camera.up_axis = scene.up_axis;
  view.options = "--eye=" + text(eye) + " --target=" + text(target) + " --fov=" + std::to_string(static_cast<int>(fov));
  return view;
}

/// The model's front, as in the named view.
Point3 front(Axis up) { return up == Axis::z ? Point3{0, 1, 0} : Point3{0, 0, up == Axis::y ? -1 : 1}; }

}  // namespace

std::vector<StandardView> standard_views(const Scene& scene) {
  Point3 low = scene.vertices.empty() ? Point3(0) : scene.vertices[0], high = low;
  for (const Point3& v : scene.vertices) {
    low = glm::min(low, v);
    high = glm::max(high, v);
  }
  const Point3 size = high - low;
  const double radius = glm::length(size) / 2;
  // Few digits: the 64th part of a power of two near the radius is a step fine enough.
  const double step = radius > 0 ? std::exp2(std::floor(std::log2(radius)) - 6) : 1;
  const auto rounded = [&](const Point3& p) { return glm::round(p / step) * step; };
  const Point3 centre = rounded((low + high) * 0.5);
  const auto from = [&](const Point3& direction, double radii) {
    return rounded(centre + glm::normalize(direction) * (radii * radius));
  };
  return {
      parallel("iso", scene, {-1, 1, -1}),
      parallel("odd", scene, {-0.37, 0.83, -0.41}),
      parallel("dimetric", scene, {0.62, 0.31, -0.72}),
      parallel("front", scene, front(scene.up_axis)),
      perspective("far", scene, from({0.53, -0.71, 0.37}, 2.2), centre, 35),
      perspective("near", scene, from({-0.67, -0.29, -0.43}, 1.4), centre, 50),
      perspective("inside", scene, rounded(low + size * Point3{0.63, 0.36, 0.57}),
                  rounded(low + size * Point3{0.09, 0.94, 0.21}), 90),
  };
}

}  // namespace ligne::test
