#pragma once
/// The surfaces that the curved parts of a mesh stand for. docs/patches.md.

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"
#include "scene/patches/freeform_borders.hpp"
#include "scene/patches/patch_surface.hpp"

namespace ligne {

/// Faces that hang together and were tessellated from one surface.
struct Patch {
  PatchSurface surface;
  double sag = 0;        ///< median distance of the facets' middles from the surface, model units
  bool outward = true;   ///< the faces look to the side to which the normals of the surface point
  bool is_band = false;  ///< it runs on into another one as if both were one: bands of a bent tube lie on cones
};

struct Patches {
  std::vector<Patch> list;
  std::vector<std::uint32_t> patch_of;  ///< per face; kNone where no surface was found
  /// Per face 1 where it has no surface but bends against others as those of a smooth surface do (freeform.hpp).
  std::vector<std::uint8_t> is_freeform;
  std::vector<FreeformBorder> borders;  ///< in ascending order of edges; chains are less than their number

  /// Unit normal of the surface of a face at p, or that of the face, `face_normal`, where none was found.
  Point3 normal(std::uint32_t face, const Point3& p, const Point3& face_normal) const;
};

/// Finds cylinders, cones, spheres and tori in the objects of a finished scene. `normals` are those of face_normals().
///   1. A facet and its neighbours, the largest first, give starting values of each kind of surface, which are fitted to
///      their corners (patch_surface.hpp).
///   2. The surface grows over facets whose corners lie on it, to the precision of the coordinates or a small part of the
///      sag, and is fitted again.
///   3. It counts when its corners can not lie on it by accident, and of several the one of the largest area does.
///   4. Then facets at the borders of patches join them, and patches of one surface become one.
/// The result does not depend on the order of faces. Objects in which few trials succeed, as scans, are given up early.
Patches find_patches(const Scene& scene, const Topology& topology, std::span<const glm::vec3> normals);

}  // namespace ligne
