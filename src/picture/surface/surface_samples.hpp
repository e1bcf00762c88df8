#pragma once
/// Computes the samples of the requested surfaces.

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

/// Heights, and the strides of the curves in samples (HorizonOptions).
struct Surface {
  std::string name;                       ///< the formula, or the file
  std::unique_ptr<HeightSource> heights;  ///< null for a mesh
  std::optional<SurfacePoints> mesh;      ///< of a file in which x, y and z all vary
  std::size_t x_stride = 1, y_stride = 1;
  bool from_formula = false;
  std::shared_ptr<const HeightFunction> function;  ///< set for formulas
  bool thinned = false;                            ///< the strides are chosen so that curves stay distinct
  GroundUnit unit = GroundUnit::unknown;
  HeightSurvey survey;         ///< empty if unknown
  std::vector<char> left_out;  ///< cells (SurfacePoints)
};

/// Returns the surfaces z = f(x, y): formulas, then grids; after them the meshes of files. Throws RequestError,
/// InputError.
std::vector<Surface> surfaces_of(const SurfaceRequest& request, RunReport& run);

/// Reports a formula that has no height at any sample: throws InputError if there is nothing else to draw, else warns.
void refuse_empty(const SurfaceRequest& request, const std::string& formula, RunReport& run);

/// Returns the samples of all surfaces, for meshes, in the order of surfaces_of(), then the parametric surfaces. Throws
/// RequestError, InputError. `surfaces`: result of surfaces_of().
std::vector<SurfacePoints> points_of(const SurfaceRequest& request, const std::vector<Surface>& surfaces);

}  // namespace ligne
