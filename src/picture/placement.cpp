#include "picture/placement.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include <glm/geometric.hpp>

#include "files/message_text.hpp"
#include "picture/errors.hpp"
#include "scene/clean/named_objects.hpp"
#include "scene/model/bounds.hpp"

namespace ligne {
namespace {

/// Slack for the rounding of the picture's size, in mm: the accuracy of a drawing.
constexpr double kSlackMm = 1e-3;

Page turned(Page page) {
  std::swap(page.width_mm, page.height_mm);
  return page;
}

/// Scale at which the extent fills the drawable part of the page.
double fitting_scale(const Page& page, const Rect& extent, double inset_part) {
  if (extent.empty()) return 0;
  constexpr double unbounded = std::numeric_limits<double>::infinity();
  const Rect area = page.drawable();
  const double across = extent.width() > 0 ? area.width() / extent.width() : unbounded;
  const double down = extent.height() > 0 ? area.height() * (1 - inset_part) / extent.height() : unbounded;
  return std::min(across, down);
}

/// Returns the camera of the file that the request names. Throws RequestError.
const SceneCamera& file_camera(const std::string& name, const std::vector<SceneCamera>& cameras) {
  if (cameras.empty()) throw RequestError("view", "the model has no camera");
  if (name.empty()) return cameras.front();
  const auto found = std::ranges::find_if(cameras, [&](const SceneCamera& c) { return name_fits(name, c.name); });
  if (found != cameras.end()) return *found;
  std::string names;
  for (const SceneCamera& c : cameras) names += (names.empty() ? "" : ", ") + printable(c.name);
  throw RequestError(
      "view", "no camera is called " + shown(name, '"') + "; there " + (cameras.size() == 1 ? "is " : "are ") + names);
}

/// Sets the request to a camera of the file. In perspective, lengths are true at the centre of the scene.
void look_through(const SceneCamera& from, const Point3& centre, CameraRequest& to) {
  const double length = glm::length(from.forward);
  if (!to.up) to.up = from.up;
  if (!from.perspective) {
    to.direction = from.forward;
    return;
  }
  const Point3 forward = from.forward / length;
  const double middle = glm::dot(centre - from.eye, forward);
  to.eye = from.eye;
  to.target = from.eye + forward * (middle > 0 ? middle : length);
  to.fov_degrees = from.fov_degrees;
  to.aspect = from.aspect;
}

}  // namespace

bool Placement::larger_than_page() const {
  return !picture.empty() && (picture.width() > page.width_mm + kSlackMm || picture.height() > page.height_mm + kSlackMm);
}

void check(const PageRequest& request) {
  Page page = request.size.page;
  page.margin_mm = request.margin_mm;
  if (!(page.drawable().width() > 0 && page.drawable().height() > 0)) {
    throw RequestError("margin", shortest(request.margin_mm) + " mm leaves no drawable area on a page of " +
                                     shortest(page.width_mm) + " x " + shortest(page.height_mm) + " mm");
  }
}

Camera camera_of(const ViewRequest& request, const Scene& scene) {
  if (request.made) return *request.made;
  const Point3 centre = bounding_box_centre(scene);
  CameraRequest camera;
  if (request.named_view) camera.named_view = *request.named_view;
  camera.direction = request.direction;
  camera.eye = request.eye;
  camera.target = request.target;
  camera.fov_degrees = request.fov_degrees;
  camera.up = request.up;
  camera.up_axis = request.up_axis.value_or(scene.up_axis);
  if (request.camera) look_through(file_camera(*request.camera, scene.cameras), centre, camera);
  try {
    const Camera made = make_camera(camera, centre);
    if (request.turn_degrees == 0) return made;
    return with_model_turned(made, camera.up_axis, centre, request.turn_degrees);
  } catch (const std::invalid_argument& e) {
    throw RequestError("", e.what());
  }
}

CameraPicture picture_of(const ViewRequest& view, const PageRequest& page, const Scene& scene) {
  const Camera camera = camera_of(view, scene);
  return {camera, page.extent ? *page.extent : projected_extent(scene, camera), scene.unit_mm};
}

Page page_for(const PageRequest& request, const Rect& extent) {
  Page page = request.size.page;
  page.margin_mm = request.margin_mm;
  const bool lies = page.width_mm > page.height_mm;
  if (request.landscape) return lies ? page : turned(page);
  if (request.portrait) return lies ? turned(page) : page;
  if (request.size.explicit_size) return page;
  return fitting_scale(turned(page), extent, request.inset_part) > fitting_scale(page, extent, request.inset_part)
             ? turned(page)
             : page;
}

Placement place(const CameraPicture& picture, const PageRequest& request, const Insets& insets) {
  const Rect& extent = picture.extent;
  Placement placement;
  placement.page = page_for(request, extent);
  Rect area = placement.page.drawable();
  area.min += Point2(insets.left, insets.top);
  area.max -= Point2(insets.right, insets.bottom + request.inset_part * area.height());
  if (!(area.width() > 0 && area.height() > 0)) {
    throw RequestError("page", "numbers and names of the axes leave no drawable area on a page of " +
                                   shortest(placement.page.width_mm) + " x " + shortest(placement.page.height_mm) +
                                   " mm; --text-height makes them smaller");
  }
  placement.view =
      make_view(extent, picture.camera, {area}, placement.page.sheet(), request.page_mm_per_unit(picture.unit_mm));
  if (!extent.empty()) {
    const Point2 size = Point2(extent.width(), extent.height()) * placement.view.scale;
    const Point2 centre = (area.min + area.max) * 0.5;
    placement.picture = {centre - size * 0.5, centre + size * 0.5};
  }
  return placement;
}

}  // namespace ligne
