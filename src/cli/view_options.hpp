#pragma once
/// Options that say from where the scene is seen.

#include <optional>
#include <string>

#include "geometry/point.hpp"
#include "scene/model/scene.hpp"
#include "view/view.hpp"

namespace CLI {
class App;
}

namespace ligne {

struct ViewOptions {
  std::string view = "iso";  ///< one of kNamedViews; used when neither direction nor eye is given
  std::optional<Point3> direction;
  std::optional<Point3> eye, target;
  double fov_degrees = 35;
  std::optional<Point3> up;
  std::optional<Axis> up_axis;
};

void add_view_options(CLI::App& app, ViewOptions& options);

/// The camera asked for. Throws UsageError where the request has no meaning for this scene.
Camera camera_of(const ViewOptions& options, const Scene& scene);

}  // namespace ligne
