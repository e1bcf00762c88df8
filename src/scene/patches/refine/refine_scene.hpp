#pragma once
/// A finer mesh of the surfaces that were recognised behind a mesh.
///
/// The lines of a coarse mesh lie up to its sag beside those of the surfaces: circles are polygons, and outlines, borders
/// and the lines that they hide do not meet where they should. New vertices on the surfaces themselves cure all of this at
/// once, before any line is chosen.

#include <optional>

#include "scene/creases/find_creases.hpp"
#include "scene/patches/refine/split_triangles.hpp"

namespace ligne {

/// A refined scene, and where its faces and edges are in the given one.
struct RefinedScene {
  Scene scene;
  Topology topology;
  std::vector<std::uint32_t> face_of;  ///< per face: the given face, or the first one of a plane that is one face now
  std::vector<std::uint32_t> edge_of;  ///< per edge: the given edge of which it is a part, or kNone inside a face
};

/// Refines the surfaces of `creases` whose edges lie farther from them than the limits permit, and makes one face of each
/// plane with new vertices on its border. Carries over the members of `creases` that refer to faces or edges, but for the
/// walls. Returns nothing, and changes nothing, if no surface is refined; so it does for scenes with lines of their own on
/// their faces, and for those that state facts. Surfaces along which bodies touch stay as they are (block_touching()).
std::optional<RefinedScene> refine_scene(const Scene& scene, const Topology& topology, const RefineLimits& limits,
                                         Creases& creases);

}  // namespace ligne
