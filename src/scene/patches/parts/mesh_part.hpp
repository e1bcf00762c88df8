#pragma once
/// A part of a mesh of triangles, as a mesh of its own.

#include <algorithm>
#include <cstdint>
#include <glm/vec3.hpp>
#include <utility>
#include <vector>

#include "base/no_index.hpp"
#include "scene/creases/face_normals.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// An object of triangles within its scene.
struct TriangleObject {
  const Scene& scene;
  const Topology& topology;
  const Object& object;
  EdgeRange edges;           ///< those of the object
  const MeshAngles& angles;  ///< those of the scene

  std::uint32_t face_count() const { return object.face_end - object.face_begin; }
  std::uint32_t edge_count() const { return edges.end - edges.begin; }
  const Edge& edge(std::size_t k) const { return topology.edges[edges.begin + k]; }
};

/// Finds the edges and neighbours of faces.
class FaceWalk {
 public:
  explicit FaceWalk(const TriangleObject& whole) : whole_(whole) {}

  const TriangleObject& whole() const { return whole_; }

  /// Calls visit(k) for the edges k of a face of the object, numbered from the first one of the object.
  template <class Visit>
  void for_edges(std::uint32_t face, const Visit& visit) const {
    const auto contour = whole_.scene.faces.contour(whole_.object.face_begin + face, 0);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(contour[i], contour[i == 2 ? 0 : i + 1]);
      std::uint32_t e = first_edge_up_from(whole_.topology, low);
      while (whole_.topology.edges[e].v1 != high) ++e;
      visit(e - whole_.edges.begin);
    }
  }

  /// Calls visit(f) for the faces f at the edges of a face of the object.
  template <class Visit>
  void for_neighbours(std::uint32_t face, const Visit& visit) const {
    for_edges(face, [&](std::uint32_t k) {
      for (const std::uint32_t f : {whole_.edge(k).face0, whole_.edge(k).face1}) {
        if (f != kNone) visit(f - whole_.object.face_begin);
      }
    });
  }

 private:
  const TriangleObject& whole_;
};

/// A set of faces of an object.
struct FaceSet {
  explicit FaceSet(const TriangleObject& whole) : holds(whole.face_count(), 0) {}

  void add(std::uint32_t face) {
    if (!std::exchange(holds[face], std::uint8_t{1})) faces.push_back(face);
  }
  /// Adds the faces beside those of the set, `rings` times.
  void add_rings(const FaceWalk& walk, int rings);

  std::vector<std::uint8_t> holds;   ///< per face of the object
  std::vector<std::uint32_t> faces;  ///< without order
};

/// Some faces of an object with their edges and vertices, in the order that they have in the object. Edges to other faces
/// are borders.
struct MeshPart {
  Scene scene;  ///< one object
  Topology topology;
  std::vector<glm::vec3> normals;    ///< per face
  std::vector<std::uint32_t> faces;  ///< per face: its number in the object
  std::vector<std::uint32_t> edges;  ///< per edge: its index in the whole topology
};

MeshPart part_of(const FaceWalk& walk, const FaceSet& set);

}  // namespace ligne
