#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "visibility/horizon/horizon.hpp"

namespace ligne {
namespace {

/// The points with the least and the largest of some coordinates.
template <std::size_t N>
struct Extremes {
  std::array<double, N> low, high;
  std::array<Point3, N> at_low, at_high;
  bool empty = true;

  void take(const Point3& p, const std::array<double, N>& coordinates) {
    for (std::size_t k = 0; k < N; ++k) {
      if (empty || coordinates[k] < low[k]) low[k] = coordinates[k], at_low[k] = p;
      if (empty || coordinates[k] > high[k]) high[k] = coordinates[k], at_high[k] = p;
    }
    empty = false;
  }
  void take(const Extremes& other) {
    if (other.empty) return;
    if (empty) {
      *this = other;
      return;
    }
    for (std::size_t k = 0; k < N; ++k) {
      if (other.low[k] < low[k]) low[k] = other.low[k], at_low[k] = other.at_low[k];
      if (other.high[k] > high[k]) high[k] = other.high[k], at_high[k] = other.at_high[k];
    }
  }
};

/// Calls take(point, extremes) for all samples.
template <std::size_t N, class Take>
Extremes<N> extremes_of(const HeightSource& heights, double z_scale, Take take) {
  constexpr std::size_t kRows = 64;
  const std::size_t rows = heights.y().size(), tasks = (rows + kRows - 1) / kRows;
  std::vector<Extremes<N>> found(tasks);
  tbb::parallel_for(std::size_t{0}, tasks, [&](std::size_t task) {
    std::vector<double> z(heights.x().size());
    for (std::size_t j = task * kRows; j < std::min(rows, (task + 1) * kRows); ++j) {
      heights.read_row(j, z);
      for (std::size_t i = 0; i < z.size(); ++i) {
        if (std::isfinite(z[i] * z_scale)) take(Point3{heights.x()[i], heights.y()[j], z[i] * z_scale}, found[task]);
      }
    }
  });
  Extremes<N> all;
  for (const auto& f : found) all.take(f);
  return all;
}

/// Every three of the points a face.
Scene scene_of(const std::vector<Point3>& points) {
  Scene scene;
  scene.vertices = points;
  for (std::uint32_t i = 2; i < points.size(); ++i) scene.faces.add_triangle(0, i - 1, i);
  return scene;
}

}  // namespace

Scene stand_in(const HeightSource& heights, double z_scale, const Camera* camera) {
  if (!camera) {
    const auto box = extremes_of<3>(heights, z_scale, [](const Point3& p, auto& e) { e.take(p, {p.x, p.y, p.z}); });
    if (box.empty) return {};
    return scene_of({{box.low[0], box.low[1], box.low[2]}, {box.high[0], box.high[1], box.high[2]}});
  }
  // In perspective what leaves the field of view fills it; a pyramid's corners tell that as well as all samples would.
  const double half_height = std::tan(camera->fov_degrees * 3.14159265358979323846 / 360), half_width = half_height * camera->aspect;
  const auto extremes = extremes_of<2>(heights, z_scale, [&](const Point3& p, auto& e) {
    const Point3 c = camera_coordinates(*camera, p);
    if (!camera->perspective) return e.take(p, {c.x, c.y});
    if (c.z <= 0) return;
    const Point2 on_plane{std::clamp(c.x / c.z, -half_width, half_width), std::clamp(c.y / c.z, -half_height, half_height)};
    const Point3 in_view = camera->right * on_plane.x + camera->down * on_plane.y + camera->forward;
    e.take(camera->eye + in_view * camera->target_distance, {on_plane.x, on_plane.y});
  });
  if (extremes.empty) return {};
  return scene_of({extremes.at_low[0], extremes.at_low[1], extremes.at_high[0], extremes.at_high[1]});
}

}  // namespace ligne
