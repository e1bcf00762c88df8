#pragma once
/// Hill shading by strokes that lie on a surface z = f(x, y): along its level lines, or down its slope, the closer the
/// darker it is. Slopes count relative to the steeper ones of the surface, so that a plain is shaded like a mountain.

#include <array>
#include <vector>

#include "scene/surfaces/surface_mesh.hpp"

namespace ligne {

struct HachureOptions {
  double spacing = 1;      ///< of the closest strokes on the ground, in coordinates times the factor
  Point3 sun{-1, 1, 1.4};  ///< towards the light
  /// Down the slope: length of strokes on steeper slopes, in spacings.
  double length = 5;
};

/// Segments in coordinates times `factor`, each inside one triangle. `skip`: triangles without strokes, 1 for each; may be
/// empty.
std::vector<std::array<Point3, 2>> contour_hachures(const SurfaceMesh& mesh, const std::vector<std::uint8_t>& skip,
                                                    const Point3& factor, const HachureOptions& options);
std::vector<std::array<Point3, 2>> slope_hachures(const SurfaceMesh& mesh, const std::vector<std::uint8_t>& skip,
                                                  const Point3& factor, const HachureOptions& options);

}  // namespace ligne
