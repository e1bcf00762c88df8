#pragma once
/// The surfaces recognised behind a mesh, as a list for reports and JSON output.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "scene/model/scene.hpp"
#include "scene/patches/find_patches.hpp"

namespace ligne {

/// Names of SurfaceKind, in its order.
inline constexpr std::array<std::string_view, 6> kSurfaceKindNames{"cylinder", "cone",     "sphere",
                                                                   "torus",    "extruded", "revolved"};

/// A surface, and the part of it that faces cover. Lengths are in model units.
struct FoundSurface {
  /// In a normal form: the first component of the axis whose absolute value exceeds one half is positive, and `at` of a
  /// surface with a length is the point of the axis at which its faces begin. The axis of an extruded surface goes through a
  /// corner. Profiles are left out.
  PatchSurface surface;
  bool outward = true;                ///< the faces face away from the axis, the centre or the middle circle
  double sag = 0;                     ///< median distance of the facets' centres from the surface
  std::size_t faces = 0;              ///< number of its faces, at least 1
  std::uint32_t object = 0;           ///< index of the object that the faces belong to
  std::array<double, 2> along{0, 0};  ///< with has_length(): interval along the axis that the faces cover, from `at`
  double turn = 0;                    ///< with has_turn(): angle about the axis that the faces cover, up to 360 degrees
  /// Uncertainty of the radius, or of the tube's radius of a torus; 0 of an extruded or revolved surface. Derived from twice
  /// the median distance of corners from the surface, but at least the precision of the coordinates, by the sagitta of the
  /// arc that the corners span.
  double error = 0;

  bool has_axis() const { return surface.kind != SurfaceKind::sphere; }
  bool has_length() const { return has_axis() && surface.kind != SurfaceKind::torus; }
  bool has_turn() const { return has_length() && surface.kind != SurfaceKind::extruded; }
  bool has_radius() const { return surface.kind != SurfaceKind::extruded && surface.kind != SurfaceKind::revolved; }
};

struct FoundSurfaces {
  std::vector<FoundSurface> list;      ///< sorted by object
  std::vector<std::uint32_t> of_face;  ///< per face: index into `list`, kNone for none; empty if the list is empty
};

/// Lists the patches that have faces. O(n log n) for n corners of their faces.
FoundSurfaces found_surfaces(const Scene& scene, const Patches& patches);

}  // namespace ligne
