#pragma once
/// Creases found in meshes of known surfaces.

#include "patches/patch_scenes.hpp"
#include "scene/creases/find_creases.hpp"

namespace ligne::test {

struct FoundCreases {
  Scene scene;
  Topology topology;
  Creases creases;

  explicit FoundCreases(const std::vector<Corners>& polygons) : scene(scene_of(polygons)), topology(build_topology(scene)) {
    creases = find_creases(scene, topology, {});
  }
  const Point3& end(std::size_t e, bool second) const {
    return scene.vertices[second ? topology.edges[e].v1 : topology.edges[e].v0];
  }
  bool is_crease(std::size_t e) const { return creases.lines[e] == kCreaseLine; }
};

}  // namespace ligne::test
