#include "cli/view_options.hpp"

#include <stdexcept>

#include "cli/option_helpers.hpp"
#include "cli/parse.hpp"

namespace ligne {

void add_view_options(CLI::App& app, ViewOptions& options) {
  const std::string group = "View";
  const auto parse_view = [](const std::string& text) { return std::string(kNamedViews[parse_choice(text, kNamedViews)]); };
  const auto parse_fov = [](const std::string& text) { return parse_between(text, 0, 180, "degrees"); };

  CLI::Option* view =
      add_parsed(app, "--view", "NAME", options.view, parse_view, "front back left right top bottom iso dimetric trimetric")
          ->default_str("iso");
  CLI::Option* direction =
      add_parsed(app, "--direction", "X,Y,Z", options.direction, parse_vector, "line of sight, into the scene (parallel)");
  CLI::Option* eye = add_parsed(app, "--eye", "X,Y,Z", options.eye, parse_point, "place of the viewer (perspective)");
  CLI::Option* target = add_parsed(app, "--target", "X,Y,Z", options.target, parse_point,
                                   "point looked at from the eye (default: centre of the model)");
  CLI::Option* fov = add_parsed(app, "--fov", "DEG", options.fov_degrees, parse_fov, "vertical angle of view from the eye")
                         ->default_str("35");
  CLI::Option* up =
      add_parsed(app, "--up", "X,Y,Z", options.up, parse_vector, "what is up on the page (default: the up axis)");
  CLI::Option* up_axis = add_parsed(app, "--up-axis", "x|y|z", options.up_axis, parse_axis,
                                    "vertical axis of the model (default: y for glTF and OBJ, else z)");

  view->excludes(direction)->excludes(eye);
  direction->excludes(eye);
  target->needs(eye);
  fov->needs(eye);
  for (CLI::Option* option : {view, direction, eye, target, fov, up, up_axis}) option->group(group);
}

Camera camera_of(const ViewOptions& options, const Scene& scene) {
  CameraRequest request;
  request.named_view = options.view;
  request.direction = options.direction;
  request.eye = options.eye;
  request.target = options.target;
  request.fov_degrees = options.fov_degrees;
  request.up = options.up;
  request.up_axis = options.up_axis.value_or(scene.up_axis);
  try {
    return make_camera(request, scene);
  } catch (const std::invalid_argument& e) {
    throw UsageError(e.what());
  }
}

}  // namespace ligne
