/// The compiled part of the Python package ligne; python/ligne has the public functions.

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "bindings/drawing.hpp"
#include "bindings/errors.hpp"
#include "bindings/scene.hpp"
#include "files/closest_name.hpp"
#include "report/listing.hpp"
#include "view/view.hpp"
#include "visibility/registry.hpp"

namespace py = pybind11;

namespace ligne::python {
namespace {

Point3 point_of(const std::array<double, 3>& p) { return {p[0], p[1], p[2]}; }

/// Rows (right, up, towards the viewer) of the camera for a scene whose bounding box is centred on the origin.
std::vector<std::array<double, 3>> camera_frame(const std::optional<std::string>& named,
                                                const std::optional<std::array<double, 3>>& direction,
                                                const std::optional<std::array<double, 3>>& up, const std::string& up_axis) {
  CameraRequest request;
  if (named) request.named_view = *named;
  if (direction) request.direction = point_of(*direction);
  if (up) request.up = point_of(*up);
  request.up_axis = up_axis == "x" ? Axis::x : up_axis == "y" ? Axis::y : Axis::z;
  const Camera camera = make_camera(request, Scene{});
  const Point3 rows[] = {camera.right, -camera.down, -camera.forward};
  std::vector<std::array<double, 3>> frame;
  for (const Point3& r : rows) frame.push_back({r.x, r.y, r.z});
  return frame;
}

}  // namespace
}  // namespace ligne::python

PYBIND11_MODULE(_core, module) {
  using namespace ligne::python;
  module.doc() = "The compiled part of ligne.";
  add_errors(module);
  add_scene(module);
  add_drawing(module);
  add_surface(module);
  add_model_work(module);
  add_plot(module);
  add_study(module);
  module.def(
      "suggestion",
      [](const std::string& word, const std::vector<std::string>& names) {
        return ligne::suggestion(word, std::vector<std::string_view>(names.begin(), names.end()));
      },
      py::arg("word"), py::arg("names"));
  module.def("methods", [] { return ligne::methods_json(ligne::all_methods()); });
  module.def("devices", &ligne::devices_json);
  module.def("camera_frame", &camera_frame, py::arg("named"), py::arg("direction"), py::arg("up"), py::arg("up_axis"));
  std::vector<std::string> views(std::begin(ligne::kNamedViews), std::end(ligne::kNamedViews));
  module.attr("named_views") = views;
  module.attr("__version__") = LIGNE_VERSION;
}
