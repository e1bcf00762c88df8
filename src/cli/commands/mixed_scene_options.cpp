#include "cli/commands/mixed_scene_options.hpp"

#include <string>

#include "cli/options/options.hpp"
#include "cli/options/parametric_options.hpp"
#include "picture/parse/parse.hpp"
#include "picture/parse/parse_options.hpp"

namespace ligne {
namespace {

constexpr unsigned kMostSamplesOfCurve = 2000;

}  // namespace

void add_mixed_scene_options(CLI::App& draw, SurfaceRequest& request) {
  OptionGroup group(draw, "Surfaces");
  group.add_repeatable(
      "--surface", "EXPR", [&request](const std::string& formula) { request.formulas.push_back(formula); },
      "draw a surface z = f(x, y) among the models, as curves (repeatable)");
  group.add_repeatable(
      "--grid", "FILE", [&request](const std::string& file) { request.grids.push_back(file); },
      "draw a surface with heights from a file; see ligne surface (repeatable)");
  add_parametric(group, request, "draw a surface given by three formulas in u and v (repeatable)");
  group.add("-x", "A:B[:N]", request.x, parse_range, "range of x and number of curves (default: the extent of the models)");
  group.add("-y", "A:B[:N]", request.y, parse_range, "range of y, likewise");
  add_parameter_ranges(group, request);
  group
      .add(
          "--samples", "N", request.samples, [](const std::string& t) { return parse_count(t, 2, kMostSamplesOfCurve); },
          "formula: points per curve")
      .standard("5 between curves");
  group
      .add(
          "--every", "N", request.every, [](const std::string& t) { return parse_count(t, 1, kMostSamplesOfCurve); },
          "grid: a curve at every Nth row and column")
      .standard("60 curves each way");
  group.add("--z-scale", "K", request.z_scale, parse_positive, "scale factor for the heights of surfaces").standard("1");
  group.add("--z-range", "A:B", request.z_range, parse_heights, "clip surfaces to heights A to B");
}

}  // namespace ligne
