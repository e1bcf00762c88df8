#pragma once
/// ligne surface: a surface z = f(x, y) as iso-curves, hidden parts removed.

#include <optional>
#include <string>

#include "cli/output_options.hpp"
#include "cli/page_options.hpp"
#include "cli/run_options.hpp"
#include "cli/surface_axes.hpp"
#include "cli/view_options.hpp"

namespace ligne {

/// A range of a variable and its number of curves.
struct CurveRange {
  double from = -5, to = 5;
  std::optional<unsigned> curves;
};

enum class CurveFamilies { x, y, xy };
inline constexpr std::string_view kCurveFamilyNames[] = {"x", "y", "xy"};

struct SurfaceOptions {
  std::string formula, grid;  ///< one of them
  std::optional<CurveRange> x, y;
  std::optional<unsigned> samples;
  std::optional<unsigned> every;  ///< grid: a curve at every so many samples
  CurveFamilies lines = CurveFamilies::xy;
  std::optional<double> azimuth_degrees, elevation_degrees;
  bool view_given = false;
  std::optional<double> z_scale;  ///< nothing: heights take half of the larger side of the ground
  bool pixels = false;
  std::optional<unsigned> resolution;
  double dpi = 150;
  std::string title;
  AxesOptions axes;
  ViewOptions view;
  PageOptions page;
  OutputOptions output;
  RunOptions run;
};

void setup_surface(CLI::App& app, SurfaceOptions& options);

/// Throws UsageError, InputError, std::runtime_error.
void run_surface(const SurfaceOptions& options);

}  // namespace ligne
