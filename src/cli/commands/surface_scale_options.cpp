#include "cli/commands/surface_scale_options.hpp"

#include <string>

#include "cli/options/options.hpp"
#include "picture/parse/parse.hpp"
#include "picture/parse/parse_options.hpp"

namespace ligne {
void add_surface_scale_options(CLI::App& surface, SurfaceRequest& request) {
  OptionGroup group(surface, "Surface");
  group.add(
      "--aspect", "equal|box|X:Y:Z", request.aspect, parse_aspect,
      "proportions of the plot box. equal: one scale for x and y; box: x and y of equal length; or a ratio (default: equal "
      "if the ranges differ by less than a factor of 4 or the ground has a unit; else box)");
  const Option z_scale =
      group.add("--z-scale", "K", request.z_scale, parse_positive,
                "scale of z relative to the longer of x and y (default: heights take half of its length; parametric: 1)");
  group
      .add("--exaggeration", "K", request.exaggeration, parse_positive,
           "vertical exaggeration; 1 is true to scale, also for positions in degrees")
      .excludes({z_scale});
  group.add_flag("--log-x", request.log_axes[0], "logarithmic x axis");
  group.add_flag("--log-y", request.log_axes[1], "logarithmic y axis");
  group.add_flag("--log-z", request.log_axes[2], "logarithmic z axis: heights are log10 of the formula or the grid");
}

}  // namespace ligne
