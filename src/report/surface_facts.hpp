#pragma once
/// Counts the surfaces recognised behind the meshes of a scene, by their radii.

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "scene/patches/found_surfaces.hpp"

namespace ligne {

/// Largest angle of an arc about its axis, in degrees. A cylinder that covers more is a boss or a bore; no fillet
/// covers more.
inline constexpr double kMostArcDegrees = 200;

/// Surfaces of one kind and one size.
struct SurfaceGroup {
  SurfaceKind kind = SurfaceKind::cylinder;
  bool outward = true;
  bool is_arc = false;  ///< for a cylinder: whether it covers at most kMostArcDegrees
  /// The radius in model units; for a torus, that of its tube. For a cone, the angle between axis and side in degrees.
  /// Rounded to the precision of the fit.
  double size = 0;
  std::size_t count = 0;
};

struct SurfaceFacts {
  std::size_t cylinders = 0, bosses = 0, bores = 0, arcs = 0, cones = 0, spheres = 0, tori = 0, extruded = 0, revolved = 0;
  std::vector<SurfaceGroup> groups;  ///< the largest first; extruded and revolved surfaces have no size and are in none

  bool any() const { return cylinders + cones + spheres + tori + extruded + revolved > 0; }
};

/// Counts the surfaces. Sizes that differ by at most their errors count as equal.
SurfaceFacts surface_facts(const FoundSurfaces& found);

/// Text such as "4 bores, 1 boss, 2 arcs of cylinders, 1 sphere".
std::string counts_text(const SurfaceFacts& facts);

/// Text such as "4 bores, radius 2.5".
std::string group_text(const SurfaceGroup& group);

nlohmann::ordered_json json_of(const SurfaceFacts& facts);

}  // namespace ligne
