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
      "sides of the picture's box: x and y true to each other, or both as long, or a ratio (default: equal where x and "
      "y range alike within a factor of 4, and for ground in one unit or in degrees; else box)");
  const Option z_scale =
      group.add("--z-scale", "K", request.z_scale, parse_positive,
                "the numbers of z are multiplied by K to be numbers of the longer of x and y (default: heights take half of "
                "its side; parametric: 1)");
  group
      .add("--exaggeration", "K", request.exaggeration, parse_positive,
           "heights against the ground, both in one unit; 1 is true to scale, also over degrees")
      .excludes({z_scale});
  group.add_flag("--log-x", request.log_axes[0], "the axis of x has decades");
  group.add_flag("--log-y", request.log_axes[1], "the axis of y has decades");
  group.add_flag("--log-z", request.log_axes[2],
                 "heights are log10 of the formula or of the grid, and the axis has decades");
}

}  // namespace ligne
