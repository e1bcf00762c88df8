#pragma once
/// Heals meshes: collapses rounding errors, removes duplicate faces, sews cracks, and makes windings agree.

#include <cstddef>
#include <optional>
#include <vector>

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

struct HealOptions {
  /// Largest distance of borders that are sewn, model units; 0: none are sewn; nothing: find_gap_break() decides.
  std::optional<double> sew_distance;
  /// Number of triangles from which on the topology is built before faults are searched. That is faster for large
  /// meshes without faults; results do not depend on it. Adjustable.
  std::size_t topology_first_from = 200'000;
};

/// The result of sewing the borders of one object.
struct SewnBorders {
  std::size_t object = 0;         ///< index in Scene::objects
  double distance = 0;            ///< largest distance that a vertex may have moved, model units
  std::size_t edges = 0;          ///< border edges as stored
  std::size_t edges_left = 0;     ///< border edges that remain
  std::size_t vertices_near = 0;  ///< border vertices within this distance of another part of the border
  double next_gap = 0;            ///< narrowest gap that was not sewn, within the range of the search; 0: none
};

struct HealReport {
  std::size_t vertices_collapsed = 0;  ///< vertices that were merged because edges between them are rounding errors
  std::size_t vertices_at_steps = 0;   ///< vertices that were merged to close steps of curved surfaces
  std::size_t objects_twice = 0;       ///< objects that coincide with another one; their faces are removed
  std::size_t faces_twice = 0;         ///< removed faces with the same vertices as another one, objects_twice included
  std::size_t vertices_moved = 0;      ///< border vertices that were merged with another one
  std::size_t edges_split = 0;         ///< splits of border edges on which a vertex of another one lies (T-junctions)
  std::size_t faces_turned = 0;        ///< faces reversed so that windings agree
  std::size_t border_edges = 0;        ///< border edges of the scene as stored, without duplicates
  std::vector<SewnBorders> sewn;       ///< the objects whose borders were sewn

  std::size_t edges_sewn() const {
    std::size_t n = 0;
    for (const SewnBorders& object : sewn) n += object.edges - object.edges_left;
    return n;
  }

  /// Whether nothing was changed.
  bool nothing() const {
    return vertices_collapsed + vertices_at_steps + objects_twice + faces_twice + faces_turned + sewn.size() == 0;
  }
};

/// Heals a scene after finish_scene() (scene/clean/clean.hpp):
///
/// 1. It collapses edges that are shorter than a step of the coordinates (heal.cpp), and merges vertices of
///    triangles that are as fine as these (merge_fine_vertices.hpp). It closes invisible steps (close_steps.hpp).
/// 2. It removes the faces of objects that coincide exactly with an earlier object. If faces of one object have the
///    same vertices, in any winding, only the first stays; its edges keep the flags that all of them have, and details
///    move to it (duplicate_faces.hpp).
/// 3. Within each object, it sews borders that are closer to each other than a distance (sew_borders.hpp).
/// 4. It makes the windings of neighbours agree (heal.cpp).
///
/// The scene keeps the invariants of finish_scene(). `topology` becomes that of the healed scene. The result does not
/// depend on the number of threads. O(n log n) time, O(n) memory.
HealReport heal(Scene& scene, Topology& topology, const HealOptions& options);

}  // namespace ligne
