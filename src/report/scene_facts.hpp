#pragma once
/// Facts about a scene that do not depend on a method.

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "linework/stroke.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"
#include "view/projected_scene.hpp"

namespace ligne {

struct ObjectFacts {
  std::string name;
  std::size_t vertices = 0, faces = 0;
  std::vector<std::size_t> materials;  ///< materials of its faces, by index, ascending
  std::size_t border_edges = 0;        ///< edges of one face
  std::size_t many_face_edges = 0;     ///< edges of more than two faces
  std::size_t unlike_wound_edges = 0;  ///< edges whose two faces disagree on which side is outside

  /// Whether every edge has two faces.
  bool closed() const { return faces > 0 && border_edges == 0 && many_face_edges == 0; }
  /// Whether it is closed and the windings agree, so that back faces may be culled.
  bool solid() const { return closed() && unlike_wound_edges == 0; }
};

struct MaterialFacts {
  std::string name;
  Point3 color{0, 0, 0};
  double opacity = 1;
  std::size_t faces = 0;
};

struct SceneFacts {
  std::size_t vertices = 0, faces = 0, faces_with_holes = 0, triangles = 0, edges = 0;
  std::array<Point3, 2> bounds{};  ///< least and greatest corner; both zero if there is no vertex
  double precision = 0;            ///< largest precision of an object
  std::vector<ObjectFacts> objects;
  std::vector<MaterialFacts> materials;

  /// The sum of a count over all objects.
  std::size_t sum(std::size_t ObjectFacts::*member) const {
    std::size_t n = 0;
    for (const ObjectFacts& object : objects) n += object.*member;
    return n;
  }
};

/// Counts over a finished scene and its topology.
SceneFacts scene_facts(const Scene& scene, const Topology& topology);

struct ViewFacts {
  std::array<std::size_t, kLineClassCount> edges{};  ///< candidate edges of each class
  double nearest = 0, farthest = 0;                  ///< along the line of sight from the viewer or the centre, model units
};

/// Counts over a scene projected with all classes selected. A source edge that clipping cut counts once.
ViewFacts view_facts(const Scene& scene, const ProjectedScene& projected);

}  // namespace ligne
