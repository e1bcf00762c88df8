#pragma once
/// Options of ligne surface that say which lines are drawn beside plain curves, and what hides.

#include <optional>
#include <string>
#include <vector>

#include "visibility/horizon/horizon.hpp"

namespace CLI {
class App;
}

namespace ligne {

struct CurveOptions {
  std::optional<unsigned> contours;    ///< number of contour lines
  std::optional<double> contour_step;  ///< or their distance in height
  bool contours_base = false;
  std::optional<double> contour_base;  ///< height of the plane; nothing: a good deal below the lowest height
  std::optional<bool> outline;         ///< nothing: yes, unless curves hide
  Underside underside = Underside::same;
  HiddenBy hidden_by = HiddenBy::surface;
  bool ridgeline = false;
  double ridgeline_overlap = 0;  ///< range of heights in distances of rows
};

void add_curve_options(CLI::App& app, CurveOptions& options);

/// Throws UsageError for options that do not go together.
void check(const CurveOptions& options);

/// The option that only the method horizon can serve, or nothing.
std::string needs_horizon(const CurveOptions& options);

/// Heights of the contour lines between `low` and `high`, ascending. Throws UsageError when they are too many.
std::vector<double> contour_levels(const CurveOptions& options, double low, double high);

/// Height of the plane of the contours at the base.
double contour_base_of(const CurveOptions& options, double low, double high);

}  // namespace ligne
