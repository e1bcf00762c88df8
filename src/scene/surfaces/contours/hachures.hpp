#pragma once
/// Hill shading by strokes on a surface z = f(x, y), along its level lines or down its slopes: denser strokes are
/// darker. Slopes count relative to the steeper ones of the surface, so that a plain is shaded like a mountain.

#include <array>
#include <vector>

#include "scene/surfaces/surface_mesh.hpp"

namespace ligne {

struct HachureOptions {
  double spacing = 1;      ///< smallest distance of strokes on the ground, in scaled coordinates
  Point3 sun{-1, 1, 1.4};  ///< direction towards the light
  /// Length of strokes down steep slopes, in spacings.
  double length = 5;
};

/// Segments in coordinates times `factor`, each inside one triangle. `skip`: per triangle, 1 for no strokes; may be
/// empty.
std::vector<std::array<Point3, 2>> contour_hachures(const SurfaceMesh& mesh, const std::vector<std::uint8_t>& skip,
                                                    const Point3& factor, const HachureOptions& options);
std::vector<std::array<Point3, 2>> slope_hachures(const SurfaceMesh& mesh, const std::vector<std::uint8_t>& skip,
                                                  const Point3& factor, const HachureOptions& options);

}  // namespace ligne
