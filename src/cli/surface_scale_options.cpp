#include "cli/surface_scale_options.hpp"

#include <string>

#include "cli/options.hpp"
#include "files/message_text.hpp"
#include "picture/parse.hpp"

namespace ligne {
namespace {

AspectRequest parse_aspect(const std::string& text) {
  if (text == "equal") return {AspectRequest::equal};
  if (text == "box") return {AspectRequest::box};
  AspectRequest aspect{AspectRequest::ratio};
  std::size_t begin = 0;
  for (int k = 0; k < 3; ++k) {
    const std::size_t end = k < 2 ? text.find(':', begin) : text.size();
    if (end == std::string::npos) throw std::invalid_argument(shown(text, '"') + " is not equal, box or X:Y:Z");
    aspect.sides[k] = parse_positive(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return aspect;
}

}  // namespace

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

void check_scale(const SurfaceRequest& request) {
  const bool is_ratio = request.aspect && request.aspect->kind == AspectRequest::ratio;
  if (is_ratio && (request.z_scale || request.exaggeration)) {
    throw UsageError("--aspect", "X:Y:Z says how high the picture is, and does not go with --z-scale or --exaggeration");
  }
  if (request.exaggeration && request.aspect && request.aspect->kind == AspectRequest::box)
    throw UsageError("--exaggeration", "needs --aspect equal");
  if (request.curves.ridgeline && request.aspect) throw UsageError("--ridgeline", "has its own --aspect");
  const std::optional<CurveRange>* ranges[] = {&request.x, &request.y};
  for (std::size_t k = 0; k < 2; ++k) {
    const std::string name(1, "xy"[k]);
    if (!request.log_axes[k] || !request.grids.empty()) continue;
    if (!*ranges[k]) throw UsageError("--log-" + name, "needs a range -" + name + " A:B above zero");
    if (!((*ranges[k])->from > 0)) throw UsageError("--log-" + name, "the range -" + name + " reaches down to zero");
  }
}

}  // namespace ligne
