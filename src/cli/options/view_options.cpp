#include "cli/options/view_options.hpp"

#include "cli/options/options.hpp"
#include "picture/parse/parse.hpp"
#include "picture/parse/parse_options.hpp"

namespace ligne {
void add_view_options(CLI::App& app, ViewRequest& request, const std::string& standard) {
  OptionGroup group(app, "View");
  const auto take_view = [&request](const std::string& text) { parse_view(text, request); };
  const auto parse_fov = [](const std::string& text) { return parse_between(text, 0, 180, "degrees"); };

  const Option view =
      group
          .add_text("--view", "NAME", take_view,
                    "front back left right top bottom iso dimetric trimetric, or camera[:NAME] for a camera of the file")
          .standard(standard);
  const Option direction = group.add("--direction", "X,Y,Z", request.direction, parse_vector,
                                     "view direction, into the scene (parallel projection)");
  const Option eye = group.add("--eye", "X,Y,Z", request.eye, parse_point, "position of the eye (perspective projection)");
  const Option target = group.add("--target", "X,Y,Z", request.target, parse_point,
                                  "point at which the eye looks (default: centre of the model)");
  const Option fov =
      group.add("--fov", "DEG", request.fov_degrees, parse_fov, "vertical angle of view from the eye").standard("35");
  group.add("--up", "X,Y,Z", request.up, parse_vector, "direction that points up on the page (default: the up axis)");
  group.add("--up-axis", "x|y|z", request.up_axis, parse_axis,
            "vertical axis of the model (default: y for glTF and OBJ, else z)");

  view.excludes({direction, eye});
  direction.excludes({eye});
  target.needs(eye);
  fov.needs(eye);
}

}  // namespace ligne
