#pragma once
/// The options of ligne surface.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "cli/curve_options.hpp"
#include "cli/hatch_options.hpp"
#include "cli/method_options.hpp"
#include "cli/output_options.hpp"
#include "cli/page_options.hpp"
#include "cli/plotter_options.hpp"
#include "cli/run_options.hpp"
#include "cli/surface_axes.hpp"
#include "cli/view_options.hpp"

namespace ligne {

/// A range of a variable and its number of curves.
struct CurveRange {
  double from = -5, to = 5;
  std::optional<unsigned> curves;
};

enum class CurveFamilies { x, y, xy, none };
inline constexpr std::string_view kCurveFamilyNames[] = {"x", "y", "xy", "none"};

struct SurfaceOptions {
  std::vector<std::string> formulas, grids;
  std::vector<std::array<std::string, 3>> parametric;  ///< formulas of x, y and z in u and v
  std::optional<CurveRange> x, y;
  std::vector<CurveRange> u, v;  ///< of the parametric surfaces in their order; the last serves for all that follow
  std::optional<unsigned> samples;
  std::optional<unsigned> every;  ///< grid: a curve at every so many samples
  CurveFamilies lines = CurveFamilies::xy;
  std::optional<double> azimuth_degrees, elevation_degrees;
  bool view_given = false;
  std::optional<double> z_scale;  ///< nothing: heights take half of the larger side of the ground
  bool log_z = false;
  std::optional<std::array<double, 2>> z_range;
  bool skirt = false;
  std::optional<double> skirt_base;  ///< height; nothing: a little below the lowest
  bool horizon_given = false;        ///< the method horizon is asked for
  const Method* method = nullptr;    ///< the mesh method that is asked for; nullptr: the default
  HiddenLines hidden = HiddenLines::none;
  bool as_mesh = false;
  CurveOptions curves;
  HatchRequest hatch;
  AxesOptions axes;
  bool pixels = false;
  std::optional<unsigned> resolution;
  double dpi = 150;
  std::string title;
  ViewOptions view;
  PageOptions page;
  OutputOptions output;
  PlotterOptions plotter;
  RunOptions run;
};

/// Adds the command with its options, and no callback but one that notes what was given.
CLI::App* add_surface_command(CLI::App& app, SurfaceOptions& options);

/// Throws UsageError for options that do not go together.
void check(const SurfaceOptions& options);

/// Whether the floating horizon draws it: one surface z = f(x, y) without anything that only meshes can do, and no mesh
/// method is asked for.
bool drawn_by_horizon(const SurfaceOptions& options);

/// The method that draws the mesh; never nullptr.
const Method& mesh_method_of(const SurfaceOptions& options);

/// The camera's options, the two angles told as a direction.
ViewOptions view_of(const SurfaceOptions& options);

/// What stands at the head of warnings: the only grid, or "surface".
std::string place_of_warnings(const SurfaceOptions& options);

enum class MeshFormat { ligne_scene, obj };

/// With --as-mesh: by the suffix. Throws UsageError.
MeshFormat mesh_format_of(const OutputOptions& options);

}  // namespace ligne
