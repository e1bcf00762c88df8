#pragma once
/// Counts of the surfaces behind the meshes of a scene, and their radii.

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "scene/patches/found_surfaces.hpp"

namespace ligne {

/// A cylinder whose faces cover more degrees about its axis is a boss or a bore, another one an arc: no fillet covers more.
inline constexpr double kMostArcDegrees = 200;

/// Surfaces of one kind and one size.
struct SurfaceGroup {
  SurfaceKind kind = SurfaceKind::cylinder;
  bool outward = true;
  bool is_arc = false;  ///< cylinder: covers kMostArcDegrees or less
  /// Radius, of a torus that of its tube, model units; of a cone the angle between its axis and its side, degrees. Rounded
  /// to the precision of the fit.
  double size = 0;
  std::size_t count = 0;
};

struct SurfaceFacts {
  std::size_t cylinders = 0, bosses = 0, bores = 0, arcs = 0, cones = 0, spheres = 0, tori = 0;
  std::vector<SurfaceGroup> groups;  ///< the largest first

  bool any() const { return cylinders + cones + spheres + tori > 0; }
};

/// Counts the surfaces. Sizes that differ by no more than their errors are one.
SurfaceFacts surface_facts(const FoundSurfaces& found);

/// "4 bores, 1 boss, 2 arcs of cylinders, 1 sphere".
std::string counts_text(const SurfaceFacts& facts);

/// "4 bores, radius 2.5".
std::string group_text(const SurfaceGroup& group);

nlohmann::ordered_json json_of(const SurfaceFacts& facts);

}  // namespace ligne
