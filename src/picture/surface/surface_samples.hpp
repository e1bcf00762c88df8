#pragma once
/// From the request for a surface to its samples.

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "picture/run_report.hpp"
#include "picture/surface/surface_request.hpp"
#include "scene/surfaces/formula/height_function.hpp"
#include "scene/surfaces/height_source.hpp"
#include "scene/surfaces/surface_points.hpp"

namespace ligne {

/// Heights, and every how many samples there is a curve (HorizonOptions).
struct Surface {
  std::string name;                       ///< the formula, or the file
  std::unique_ptr<HeightSource> heights;  ///< null for a mesh
  std::optional<SurfacePoints> mesh;      ///< of a file in which x, y and z all vary
  std::size_t x_stride = 1, y_stride = 1;
  bool from_formula = false;
  std::shared_ptr<const HeightFunction> function;  ///< of a formula
  bool thinned = false;                            ///< the strides are to be those at which curves keep apart
  GroundUnit unit = GroundUnit::unknown;
  HeightSurvey survey;         ///< empty where it is not known
  std::vector<char> left_out;  ///< cells (SurfacePoints)
};

/// The surfaces z = f(x, y), those of formulas, then those of grids; behind them the meshes of files. Throws RequestError,
/// InputError.
std::vector<Surface> surfaces_of(const SurfaceRequest& request, RunReport& run);

/// For a formula without any height where it is looked at: an InputError when it is all there is to draw, else a warning.
void refuse_empty(const SurfaceRequest& request, const std::string& formula, RunReport& run);

/// The samples of all surfaces, for meshes; in the order of surfaces_of(), then the parametric ones. Throws RequestError,
/// InputError. `surfaces`: those of surfaces_of().
std::vector<SurfacePoints> points_of(const SurfaceRequest& request, const std::vector<Surface>& surfaces);

}  // namespace ligne
