
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/parallel.hpp"
#include "visibility/horizon/horizon.hpp"

namespace ligne {
namespace {

/// Calls take(row, z, result) for all rows, in parallel, then merge(result) once for each block of rows, in order.
template <class Result, class Take, class Merge>
void for_rows(const HeightSource& heights, Take take, Merge merge) {
  constexpr std::size_t kRows = 64;
  const std::size_t rows = heights.y().size(), tasks = (rows + kRows - 1) / kRows;
  std::vector<Result> found(tasks);
  parallel_for(tasks, [&](std::size_t task) {
    std::vector<double> z(heights.x().size());
    for (std::size_t j = task * kRows; j < std::min(rows, (task + 1) * kRows); ++j) {
      heights.read_row(j, z);
      take(j, z, found[task]);
    }
  });
  for (const Result& f : found) merge(f);
}

/// The points with the least and the largest coordinates on the drawing plane.
struct Extremes {
  std::array<double, 2> low{}, high{};
  std::array<Point3, 2> at_low{}, at_high{};
  bool empty = true;

  void take(const Point3& p, const Point2& on_plane) {
    for (int k = 0; k < 2; ++k) {
      if (empty || on_plane[k] < low[k]) low[k] = on_plane[k], at_low[k] = p;
      if (empty || on_plane[k] > high[k]) high[k] = on_plane[k], at_high[k] = p;
    }
    empty = false;
  }
  void take(const Extremes& other) {
    if (other.empty) return;
    for (int k = 0; k < 2; ++k) {
      if (empty || other.low[k] < low[k]) low[k] = other.low[k], at_low[k] = other.at_low[k];
      if (empty || other.high[k] > high[k]) high[k] = other.high[k], at_high[k] = other.at_high[k];
    }
    empty = false;
  }
};

/// A scene whose faces are a fan of triangles over the points.
Scene scene_of(const std::vector<Point3>& points) {
  Scene scene;
  scene.vertices = points;
  for (std::uint32_t i = 2; i < points.size(); ++i) scene.faces.add_triangle(0, i - 1, i);
  return scene;
}

}  // namespace

HeightSurvey survey(const HeightSource& heights) {
  HeightSurvey all;
  for_rows<HeightSurvey>(
      heights,
      [](std::size_t, const std::vector<double>& z, HeightSurvey& found) {
        for (const double h : z) {
          if (!std::isfinite(h)) {
            found.holes = true;
          } else {
            found = {found.empty() ? h : std::min(found.low, h), found.empty() ? h : std::max(found.high, h), found.holes};
          }
        }
      },
      [&](const HeightSurvey& f) {
        const bool holes = all.holes || f.holes;
        if (all.empty()) {
          all = f;
        } else if (!f.empty()) {
          all = {std::min(all.low, f.low), std::max(all.high, f.high), holes};
        }
        all.holes = holes;
      });
  return all;
}

Scene box_of(const HeightSource& heights, const HeightSurvey& survey, double z_scale) {
  if (survey.empty()) return {};
  return scene_of({{heights.x().front(), heights.y().front(), survey.low * z_scale},
                   {heights.x().back(), heights.y().back(), survey.high * z_scale}});
}

Scene extent_scene(const HeightSource& heights, double z_scale, const Camera& camera) {
  // In perspective, points outside the field of view are moved to its border: the surface fills the view there.
  const double half_height = std::tan(camera.fov_degrees * 3.14159265358979323846 / 360),
               half_width = half_height * camera.aspect;
  Extremes extremes;
  for_rows<Extremes>(
      heights,
      [&](std::size_t j, const std::vector<double>& z, Extremes& e) {
        for (std::size_t i = 0; i < z.size(); ++i) {
          if (!std::isfinite(z[i] * z_scale)) continue;
          const Point3 p{heights.x()[i], heights.y()[j], z[i] * z_scale};
          const Point3 c = camera_coordinates(camera, p);
          if (!camera.perspective) {
            e.take(p, {c.x, c.y});
          } else if (c.z > 0) {
            const Point2 on_plane{std::clamp(c.x / c.z, -half_width, half_width),
                                  std::clamp(c.y / c.z, -half_height, half_height)};
            const Point3 in_view = camera.right * on_plane.x + camera.down * on_plane.y + camera.forward;
            e.take(camera.eye + in_view * camera.target_distance, on_plane);
          }
        }
      },
      [&](const Extremes& e) { extremes.take(e); });
  if (extremes.empty) return {};
  return scene_of({extremes.at_low[0], extremes.at_low[1], extremes.at_high[0], extremes.at_high[1]});
}

}  // namespace ligne
