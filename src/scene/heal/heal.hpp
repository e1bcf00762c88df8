#pragma once
/// From a mesh as stored to a mesh of the shape that it stands for.

#include <cstddef>
#include <optional>
#include <vector>

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

struct HealOptions {
  /// Borders that lie so near to each other are sewn (model units); 0: none; nothing: see border_gaps.hpp.
  std::optional<double> sew_distance;
  /// Adjustable: a mesh of so many triangles that nothing is found wrong with costs less when its topology is built first.
  /// Results do not depend on it.
  std::size_t topology_first_from = 200'000;
};

/// The borders of one object, as found and as mended.
struct SewnBorders {
  std::size_t object = 0;         ///< index in Scene::objects
  double distance = 0;            ///< nothing has moved further, model units
  std::size_t edges = 0;          ///< border edges as stored
  std::size_t edges_left = 0;     ///< border edges that remain
  std::size_t vertices_near = 0;  ///< vertices of the border that lie within the distance of another one
  double next_gap = 0;            ///< the nearest of the others, as far as was looked; 0: none
};

struct HealReport {
  std::size_t objects_twice = 0;   ///< objects that lie exactly on another one: left without faces
  std::size_t faces_twice = 0;     ///< faces with the same vertices as another one: left out, those of objects_twice too
  std::size_t vertices_moved = 0;  ///< vertices of borders put onto another one
  std::size_t edges_split = 0;     ///< times a border was split where a vertex of another one lies on it (T-junctions)
  std::size_t faces_turned = 0;    ///< faces turned round so that windings agree
  std::size_t border_edges = 0;    ///< of the scene as stored, duplicates left out
  std::vector<SewnBorders> sewn;   ///< objects of which a border was sewn

  std::size_t edges_sewn() const {
    std::size_t n = 0;
    for (const SewnBorders& object : sewn) n += object.edges - object.edges_left;
    return n;
  }

  bool nothing() const { return objects_twice + faces_twice + faces_turned + sewn.size() == 0; }
};

/// Heals a finished scene (scene/clean/clean.hpp):
///   1. Objects that coincide exactly with an earlier one lose their faces, and of the faces of an object that have the same
///      vertices, in whatever winding, the first one stays. Edges keep the flags on which all agree, details move to the
///      face that stays (duplicate_faces.hpp).
///   2. Within each object, borders that run along each other nearer than a distance are sewn (sew_borders.hpp).
///   3. Windings of neighbours are made to agree (agree_windings.hpp).
/// The scene stays finished. `topology` becomes that of the healed scene, and is made once, unless faces were turned. The
/// result does not depend on the number of threads; time grows as n log n, memory with n.
HealReport heal(Scene& scene, Topology& topology, const HealOptions& options);

}  // namespace ligne
