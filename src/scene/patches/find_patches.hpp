#pragma once
/// Recognises the analytic surfaces that the curved parts of a mesh were tessellated from. Explained in
/// docs/patches.md.

#include <cstdint>
#include <vector>

#include "scene/creases/face_normals.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"
#include "scene/patches/borders/freeform_borders.hpp"
#include "scene/patches/patch_surface.hpp"

namespace ligne {

/// A connected set of faces that were tessellated from one surface.
struct Patch {
  PatchSurface surface;
  double sag = 0;        ///< median distance of the facets' centres from the surface, model units
  bool outward = true;   ///< the faces face the side to which the normals of the surface point
  bool is_band = false;  ///< one of several patches that approximate one smooth surface, as cones do a bent tube
};

/// The patches of a scene.
struct Patches {
  std::vector<Patch> list;
  std::vector<std::uint32_t> patch_of;  ///< per face: index into `list`, kNone if no surface was found
  /// Per face: 1 if no surface was found but the face belongs to a smooth free-form surface (freeform.hpp).
  std::vector<std::uint8_t> is_freeform;
  /// Edges inside planes, sorted, between faces whose tilt exceeds what rounding can cause at their size.
  std::vector<std::uint32_t> plane_edges;
  std::vector<FreeformBorder> borders;  ///< sorted by edge; FreeformBorder::chain is less than borders.size()

  /// Unit normal at p of the surface of a face; `face_normal` if the face has no surface.
  Point3 normal(std::uint32_t face, const Point3& p, const Point3& face_normal) const;
};

/// The edges that are not inside a free form, ascending: few of the edges of a scan.
std::vector<std::uint32_t> edges_outside_freeforms(const Topology& topology, const Patches& patches);

/// Finds the surfaces of all kinds (patch_surface.hpp) in the objects of a scene after finish_scene(). The search
/// takes these steps:
///
/// 1. A facet and its neighbours, the largest facet first, give starting values for each kind of surface. These are
///    fitted to the corners of the facets (patch_surface.hpp).
/// 2. The surface grows over facets whose corners lie on it, within the precision of the coordinates or a small
///    fraction of the sag, and is fitted again.
/// 3. A surface is accepted if its corners can not lie on it by accident. Among several, the one of largest area wins.
/// 4. Facets at the borders of patches join them, and patches on the same surface are merged.
/// 5. Other facets, and bands of them, become extruded and revolved surfaces (swept/swept_surfaces.hpp).
///
/// The result does not depend on the order of faces. The search stops early in objects in which few trials succeed,
/// such as scans.
Patches find_patches(const Scene& scene, const Topology& topology, const MeshAngles& angles);

}  // namespace ligne
