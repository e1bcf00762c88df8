#include "view/view.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <glm/geometric.hpp>

#include "base/parallel.hpp"
#include "scene/model/bounds.hpp"
#include "view/clip.hpp"

namespace ligne {
namespace {

/// Sine below which two directions count as parallel: their cross product would be rounding noise of float input.
constexpr double kParallelSine = 0x1p-22;
/// Distance of the near plane, relative to the target distance. Nearer objects are not drawn.
constexpr double kNearPart = 1e-3;

/// The frame of the model: x to the right in the front view, back into the page, up.
struct ModelFrame {
  Point3 right, back, up;
};

ModelFrame model_frame(Axis up) {
  switch (up) {
    case Axis::x:
      return {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}};
    case Axis::y:
      return {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}};
    case Axis::z:
      break;
  }
  return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
}

struct ViewDirection {
  Point3 forward, up;
};

/// Lines of sight of the named views, in the model frame (right, back, up).
ViewDirection named_view_direction(std::string_view name, const ModelFrame& m) {
  const auto along = [&](double r, double b, double u) { return ViewDirection{m.right * r + m.back * b + m.up * u, m.up}; };
  if (name == "front") return along(0, 1, 0);
  if (name == "back") return along(0, -1, 0);
  if (name == "right") return along(-1, 0, 0);
  if (name == "left") return along(1, 0, 0);
  if (name == "top") return {-m.up, m.back};
  if (name == "bottom") return {m.up, -m.back};
  if (name == "iso") return along(-1, 1, -1);
  // Foreshortened 1 : 1/2 : 1 (ISO 5456-3): squares of the direction cosines 1/9, 7/9, 1/9.
  if (name == "dimetric") return along(-1, std::sqrt(7.0), -1);
  // 35 degrees around, 25 degrees from above: three different foreshortenings.
  constexpr double kRound = 35 * 3.14159265358979323846 / 180, kAbove = 25 * 3.14159265358979323846 / 180;
  if (name == "trimetric") {
    return along(-std::sin(kRound) * std::cos(kAbove), std::cos(kRound) * std::cos(kAbove), -std::sin(kAbove));
  }
  throw std::invalid_argument("there is no view '" + std::string(name) + "'");
}

bool parallel(const Point3& a, const Point3& b) {
  return glm::length(glm::cross(a, b)) <= kParallelSine * glm::length(a) * glm::length(b);
}

bool finite(const Point3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

}  // namespace

Camera make_camera(const CameraRequest& request, const Scene& scene) {
  return make_camera(request, bounding_box_centre(scene));
}

Camera make_camera(const CameraRequest& request, const Point3& centre) {
  const ModelFrame frame = model_frame(request.up_axis);
  const Point3 target = request.target.value_or(centre);
  Camera camera;
  ViewDirection sight{{0, 0, 0}, frame.up};
  if (request.eye) {
    camera.perspective = true;
    camera.eye = *request.eye;
    sight.forward = target - *request.eye;
    if (!finite(sight.forward) || glm::length(sight.forward) == 0) {
      throw std::invalid_argument("the eye and the target are the same point");
    }
    if (!(request.fov_degrees > 0 && request.fov_degrees < 180)) {
      throw std::invalid_argument("the field of view is not between 0 and 180 degrees");
    }
    camera.fov_degrees = request.fov_degrees;
    camera.target_distance = glm::length(sight.forward);
    if (request.aspect) camera.aspect = *request.aspect;
  } else {
    camera.eye = target;
    if (request.direction) {
      sight.forward = *request.direction;
      if (!finite(sight.forward) || glm::length(sight.forward) == 0) {
        throw std::invalid_argument("the view direction has no length");
      }
    } else {
      sight = named_view_direction(request.named_view, frame);
    }
  }
  if (request.up) sight.up = *request.up;
  if (!finite(sight.up) || glm::length(sight.up) == 0) throw std::invalid_argument("the up vector has no length");
  camera.forward = glm::normalize(sight.forward);
  if (parallel(camera.forward, sight.up)) sight.up = frame.up;
  // Looking straight down, the back of the model is up on the page; looking straight up, its front is, as in the views
  // top and bottom.
  if (parallel(camera.forward, sight.up)) sight.up = glm::dot(camera.forward, frame.up) < 0 ? frame.back : -frame.back;
  camera.right = glm::normalize(glm::cross(camera.forward, sight.up));
  camera.down = glm::cross(camera.forward, camera.right);
  return camera;
}

Point3 camera_coordinates(const Camera& camera, const Point3& p) {
  const Point3 d = p - camera.eye;
  return {glm::dot(camera.right, d), glm::dot(camera.down, d), glm::dot(camera.forward, d)};
}

Rect projected_extent(const Scene& scene, const Camera& camera) {
  const auto coordinates_of = [&](std::size_t v) { return camera_coordinates(camera, scene.vertices[v]); };
  if (!camera.perspective) {
    const auto extent_of = [&](std::size_t begin, std::size_t end) {
      Rect part;
      for (std::size_t v = begin; v < end; ++v) {
        const Point3 c = coordinates_of(v);
        part.extend({c.x, c.y});
      }
      return part;
    };
    return parallel_reduce(scene.vertices.size(), kShortWorkBlock, Rect{}, extent_of, [](Rect sum, const Rect& part) {
      if (part.empty()) return sum;
      sum.extend(part.min);
      sum.extend(part.max);
      return sum;
    });
  }
  const double half_height = std::tan(camera.fov_degrees * 3.14159265358979323846 / 360) * camera.target_distance;
  const double half_width = half_height * camera.aspect;
  const double near_distance = camera.target_distance * kNearPart;
  const ClipVolume volume{{{-half_width, -half_height}, {half_width, half_height}}, near_distance};
  Rect extent;
  std::vector<HomogeneousPoint> contour;
  const auto to_plane = [&](std::uint32_t v) {
    const Point3 c = coordinates_of(v);
    return HomogeneousPoint{c.x * camera.target_distance, c.y * camera.target_distance, 0, c.z};
  };
  for (std::size_t f = 0; f < scene.faces.size(); ++f) {
    contour.clear();
    for (const std::uint32_t v : scene.faces.contour(f, 0)) contour.push_back(to_plane(v));
    if (!std::all_of(contour.begin(), contour.end(), [&](const auto& p) { return volume.contains(p); })) {
      clip_contour(contour, volume);
    }
    for (const HomogeneousPoint& p : contour) extent.extend({p.x / p.w, p.y / p.w});
  }
  return extent;
}

Camera with_model_turned(const Camera& camera, Axis axis, const Point3& centre, double degrees) {
  const double angle = -degrees * 3.14159265358979323846 / 180, cosine = std::cos(angle), sine = std::sin(angle);
  Point3 up{0, 0, 0};
  up[static_cast<int>(axis)] = 1;
  const auto turned = [&](const Point3& v) {
    return v * cosine + glm::cross(up, v) * sine + up * (glm::dot(up, v) * (1 - cosine));
  };
  Camera result = camera;
  result.eye = centre + turned(camera.eye - centre);
  result.right = turned(camera.right);
  result.down = turned(camera.down);
  result.forward = turned(camera.forward);
  return result;
}

View make_view(const Scene& scene, const Camera& camera, const Frame& frame, const Rect& window,
               std::optional<double> scale) {
  return make_view(projected_extent(scene, camera), camera, frame, window, scale);
}

View make_view(Rect extent, const Camera& camera, const Frame& frame, const Rect& window, std::optional<double> scale) {
  View view{.camera = camera, .window = window};
  if (extent.empty()) extent = {{0, 0}, {0, 0}};
  // A drawing without extent in one direction is scaled by the other one; a point is drawn at 1:1.
  double fit = 1e300;
  if (extent.width() > 0) fit = std::min(fit, frame.area.width() / extent.width());
  if (extent.height() > 0) fit = std::min(fit, frame.area.height() / extent.height());
  view.scale = scale ? *scale : fit < 1e300 ? fit : 1;
  const double s = view.scale;
  const Point2 offset = (frame.area.min + frame.area.max) * 0.5 - (extent.min + extent.max) * (0.5 * s);
  view.offset = offset;

  const Point3 r = camera.right, d = camera.down, f = camera.forward, e = camera.eye;
  const glm::dvec4 x_row{r, -glm::dot(r, e)}, y_row{d, -glm::dot(d, e)}, w_row{f, -glm::dot(f, e)};
  const glm::dvec4 one{0, 0, 0, 1};
  glm::dvec4 rows[4];
  if (camera.perspective) {
    const double distance = camera.target_distance;
    view.near_distance = distance * kNearPart;
    rows[0] = x_row * (s * distance) + w_row * offset.x;
    rows[1] = y_row * (s * distance) + w_row * offset.y;
    rows[2] = w_row * (s * distance) - one * (s * distance * distance);
    rows[3] = w_row;
    const double half_height = std::tan(camera.fov_degrees * 3.14159265358979323846 / 360) * distance * s;
    const Point2 half{half_height * camera.aspect, half_height};
    view.window.min = glm::max(window.min, offset - half);
    view.window.max = glm::min(window.max, offset + half);
  } else {
    rows[0] = x_row * s + one * offset.x;
    rows[1] = y_row * s + one * offset.y;
    rows[2] = w_row * s;
    rows[3] = one;
  }
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 4; ++k) view.model_to_page[k][i] = rows[i][k];
  }
  return view;
}

Point3 to_model_point(const View& view, Point2 page_mm, double depth) {
  const Camera& camera = view.camera;
  Point3 c{(page_mm.x - view.offset.x) / view.scale, (page_mm.y - view.offset.y) / view.scale, depth / view.scale};
  if (camera.perspective) {
    const double distance = camera.target_distance;
    c.z = distance / (1 - depth / (view.scale * distance));
    c.x *= c.z / distance;
    c.y *= c.z / distance;
  }
  return camera.eye + camera.right * c.x + camera.down * c.y + camera.forward * c.z;
}

HomogeneousPoint to_homogeneous(const View& view, const Point3& p) {
  const Point3 c = camera_coordinates(view.camera, p);
  const double s = view.scale;
  if (!view.camera.perspective) return {s * c.x + view.offset.x, s * c.y + view.offset.y, s * c.z, 1};
  const double distance = view.camera.target_distance;
  return {s * distance * c.x + view.offset.x * c.z, s * distance * c.y + view.offset.y * c.z,
          s * distance * (c.z - distance), c.z};
}

Point2 page_point(const View& view, const Point3& p) {
  const HomogeneousPoint h = to_homogeneous(view, p);
  return {h.x / h.w, h.y / h.w};
}

}  // namespace ligne
