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
      "a surface z = f(x, y) among the models, as curves (repeatable)");
  group.add_repeatable(
      "--grid", "FILE", [&request](const std::string& file) { request.grids.push_back(file); },
      "the same with heights from a file: see ligne surface (repeatable)");
  add_parametric(group, request, "the same as three formulas in u and v (repeatable)");
  group.add("-x", "A:B[:N]", request.x, parse_range, "range of x and number of curves (default: the extent of the models)");
  group.add("-y", "A:B[:N]", request.y, parse_range, "the same of y");
  add_parameter_ranges(group, request);
  group
      .add(
          "--samples", "N", request.samples, [](const std::string& t) { return parse_count(t, 2, kMostSamplesOfCurve); },
          "formula: points along a curve")
      .standard("5 between curves");
  group
      .add(
          "--every", "N", request.every, [](const std::string& t) { return parse_count(t, 1, kMostSamplesOfCurve); },
          "grid: a curve at every Nth row and column")
      .standard("60 curves each way");
  group.add("--z-scale", "K", request.z_scale, parse_positive, "heights of surfaces are multiplied by K").standard("1");
  group.add("--z-range", "A:B", request.z_range, parse_heights, "cut surfaces off below A and above B");
}

}  // namespace ligne
