#include "support/standard_views.hpp"

#include "main/tier.hpp"

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
  view.options = "--direction=" + text(direction) + " --landscape";
  return view;
}

/// The model's front, as in the named view.
Point3 front(Axis up) { return up == Axis::z ? Point3{0, 1, 0} : Point3{0, 0, up == Axis::y ? -1 : 1}; }

/// The middle one of the values that are not 0, of two the lower; 1 when there is none.
double middle(std::vector<double> values) {
  std::erase_if(values, [](double v) { return v == 0; });
  std::sort(values.begin(), values.end());
  return values.empty() ? 1 : values[(values.size() - 1) / 2];
}

/// Cuts the sheet so that its borders go through a vertex each.
StandardView on_cut_sheet(StandardView view, const Scene& scene) {
  const Camera camera = make_camera(view.camera, scene);
  const Rect extent = projected_extent(scene, camera);
  const Point2 centre = (extent.min + extent.max) * 0.5;
  std::vector<double> x, y;
  for (const Point3& v : scene.vertices) {
    const Point3 c = camera_coordinates(camera, v);
    x.push_back(std::abs(c.x - centre.x));
    y.push_back(std::abs(c.y - centre.y));
  }
  const double half_width = middle(std::move(x)), half_height = middle(std::move(y));
  const int exponent = static_cast<int>(std::floor(std::log2(100 / std::max(half_width, half_height))));
  const double scale = std::ldexp(1.0, exponent);
  view.sheet.page = {{0, 0}, {2 * half_width * scale, 2 * half_height * scale}};
  view.sheet.frame = {view.sheet.page};
  view.sheet.scale = scale;
  char buffer[160];
  std::snprintf(buffer, sizeof buffer, " --page %.17gx%.17g --margin 0 --scale %.17g:%.17g", view.sheet.page.max.x,
                view.sheet.page.max.y, std::ldexp(1.0, std::max(exponent, 0)), std::ldexp(1.0, std::max(-exponent, 0)));
  view.options = "--direction=" + text(*view.camera.direction) + buffer;
  view.name = "sheet_" + view.name;
  return view;
}

Point3 up_vector(Axis axis) { return {axis == Axis::x ? 1 : 0, axis == Axis::y ? 1 : 0, axis == Axis::z ? 1 : 0}; }

/// From the front, as far from a vertex as that is above the centre: a field of view of 90 degrees ends at it.
StandardView through_a_vertex(const Scene& scene) {
  const Point3 forward = front(scene.up_axis), up = up_vector(scene.up_axis);
  Point3 low = scene.vertices[0], high = low;
  for (const Point3& v : scene.vertices) {
    low = glm::min(low, v);
    high = glm::max(high, v);
  }
  const Point3 centre = (low + high) * 0.5;
  std::vector<double> heights;
  for (const Point3& v : scene.vertices) heights.push_back(std::abs(glm::dot(v - centre, up)));
  const double height = middle(std::move(heights));
  double depth = 0;
  for (const Point3& v : scene.vertices)
    if (std::abs(glm::dot(v - centre, up)) == height) depth = glm::dot(v - centre, forward);
  const Point3 eye = centre + forward * (depth - height);
  return perspective_view("fov_border", scene, eye, eye + forward * std::exp2(std::ceil(std::log2(glm::length(high - low)))),
                          90);
}

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
      perspective_view("far", scene, from({0.53, -0.71, 0.37}, 2.2), centre, 35),
      perspective_view("near", scene, from({-0.67, -0.29, -0.43}, 1.4), centre, 50),
      perspective_view("inside", scene, rounded(low + size * Point3{0.63, 0.36, 0.57}),
                       rounded(low + size * Point3{0.09, 0.94, 0.21}), 90),
  };
}

std::vector<StandardView> rotated_views(const Scene& scene, std::string_view key, std::size_t count) {
  std::vector<StandardView> views = standard_views(scene);
  if (runs_all()) return views;
  const auto first = static_cast<std::ptrdiff_t>(rotation_of(key) % views.size());
  std::rotate(views.begin(), views.begin() + first, views.end());
  views.resize(std::min(count, views.size()));
  return views;
}

StandardView perspective_view(const std::string& name, const Scene& scene, const Point3& eye, const Point3& target,
                              double fov_degrees) {
  StandardView view;
  view.name = name;
  view.camera.eye = eye;
  view.camera.target = target;
  view.camera.fov_degrees = fov_degrees;
  view.camera.up_axis = scene.up_axis;
  view.options = "--eye=" + text(eye) + " --target=" + text(target) +
                 " --fov=" + std::to_string(static_cast<int>(fov_degrees)) + " --landscape";
  return view;
}

std::vector<StandardView> border_views(const Scene& scene) {
  if (scene.vertices.empty()) return {};
  return {
      on_cut_sheet(parallel("front", scene, front(scene.up_axis)), scene),
      on_cut_sheet(parallel("iso", scene, {-1, 1, -1}), scene),
      through_a_vertex(scene),
  };
}

}  // namespace ligne::test
