#pragma once
/// The surfaces behind a mesh as a list for people and other programs.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "scene/model/scene.hpp"
#include "scene/patches/find_patches.hpp"

namespace ligne {

/// Names of SurfaceKind, in its order.
inline constexpr std::array<std::string_view, 4> kSurfaceKindNames{"cylinder", "cone", "sphere", "torus"};

/// A surface with the part of it that faces cover.
struct FoundSurface {
  /// The first component of the axis that is larger than one half is positive; `at` of a cylinder or a cone is the point of
  /// the axis at which its faces begin.
  PatchSurface surface;
  bool outward = true;                ///< the faces look away from the axis, the centre or the middle circle
  double sag = 0;                     ///< median distance of the facets' middles from the surface, model units
  std::size_t faces = 0;              ///< number of its faces, 1 or more
  std::uint32_t object = 0;           ///< the object that they belong to
  std::array<double, 2> along{0, 0};  ///< cylinder, cone: where the faces begin and end along the axis, from `at`
  double turn = 0;                    ///< cylinder, cone: degrees about the axis that faces cover, 360 at the most
  /// Uncertainty of the radius, of a torus that of the tube, model units: twice the median distance of corners from the
  /// surface, but at least the precision of the coordinates, by the sagitta of the arc that they lie on.
  double error = 0;

  bool has_axis() const { return surface.kind != SurfaceKind::sphere; }
  bool has_length() const { return surface.kind == SurfaceKind::cylinder || surface.kind == SurfaceKind::cone; }
};

struct FoundSurfaces {
  std::vector<FoundSurface> list;      ///< by object
  std::vector<std::uint32_t> of_face;  ///< per face its number in the list, kNone where there is none; empty without any
};

/// The patches that have faces. O(n log n) for n corners of their faces.
FoundSurfaces found_surfaces(const Scene& scene, const Patches& patches);

}  // namespace ligne
