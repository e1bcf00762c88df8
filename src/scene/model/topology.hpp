#pragma once
/// Edges with the faces that they join, and the triangulation of the faces.

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "base/no_index.hpp"
#include "geometry/point.hpp"
#include "scene/model/scene.hpp"

namespace ligne {

/// An edge of the scene: its two vertices, v0 < v1, and its first two faces.
struct Edge {
  std::uint32_t v0 = 0, v1 = 0;
  std::uint32_t face0 = kNone, face1 = kNone;  ///< face1 is kNone on a border
};

/// Whether two edges have a vertex in common.
inline bool share_vertex(const Edge& a, const Edge& b) {
  return a.v0 == b.v0 || a.v0 == b.v1 || a.v1 == b.v0 || a.v1 == b.v1;
}

/// Flags of an edge. Most of them come from the CornerFlag of a face at the edge.
enum EdgeFlag : std::uint16_t {
  kEdgeManyFaces = 1,    ///< more than two faces meet here
  kEdgeFileHidden = 2,   ///< the file marks the edge as hidden
  kEdgeInner = 4,        ///< triangulation of a polygon made the edge
  kEdgeUnlikeWound = 8,  ///< its two faces traverse it in the same direction: their windings disagree
  kEdgeCurve = 16,       ///< part of an iso-curve of a surface
  kEdgeCrossing = 32,    ///< surfaces penetrate each other along it
  kEdgeContour = 64,     ///< part of a contour line
  kEdgeSmooth = 128,     ///< the file says that the surface is smooth across it
  kEdgeSharp = 256,      ///< the file says that it has a crease here
  kEdgeLimit = 512,      ///< inside a limit surface of subdivision
  kEdgeBorder = 1024,    ///< only one face meets here
};

/// A triangle of a face, with the winding of the face.
struct Triangle {
  std::array<std::uint32_t, 3> v{};  ///< vertex indices
  std::uint32_t face = kNone;
};

struct Topology {
  std::vector<Edge> edges;                ///< sorted by (v0, v1)
  std::vector<std::uint16_t> edge_flags;  ///< per edge: EdgeFlag bits
  std::vector<Triangle> triangles;        ///< sorted by face
  /// Per vertex its first edge among `edges`, and their number: edge e is one of v0's if it lies in [first_edges[v0],
  /// first_edges[v0 + 1]). Empty: not known.
  std::vector<std::uint32_t> first_edges;
  /// Whether some of the triangles may have the same three vertices. Most meshes have none, but few steps look.
  bool may_repeat_triangles = true;
};

/// The flags that any edge has, as EdgeFlag bits.
std::uint16_t flags_of_any(const Topology& topology);

/// The edges that have any of these flags, ascending. Other edges cost little.
std::vector<std::uint32_t> edges_with(const Topology& topology, unsigned flags);

/// Indices of edges: [begin, end).
struct EdgeRange {
  std::uint32_t begin = 0, end = 0;
};

/// The edges of an object, which are consecutive since edges are sorted by their vertices. O(log n).
EdgeRange edges_of(const Topology& topology, const Object& object);

/// The edges whose lower vertex is `vertex`. O(log n), or constant after index_edges().
EdgeRange edges_up_from(const Topology& topology, std::uint32_t vertex);
/// Their first.
inline std::uint32_t first_edge_up_from(const Topology& topology, std::uint32_t vertex) {
  return topology.first_edges.empty() ? edges_up_from(topology, vertex).begin : topology.first_edges[vertex];
}

/// Sets Topology::first_edges.
void index_edges(Topology& topology, std::size_t vertices);

/// The edge between two vertices; null if there is none. O(log n), or less after index_edges().
const Edge* find_edge(const Topology& topology, std::pair<std::uint32_t, std::uint32_t> ends);

/// Finds the edges and triangulates the faces of a scene after finish_scene(). Takes time proportional to the number of
/// corners.
Topology build_topology(const Scene& scene);

/// Only the triangles of the faces, as in Topology::triangles.
std::vector<Triangle> triangulate_faces(const Scene& scene);

/// Unit normal of the triangle a, b, c; zero if it has no area. Equal to face_normal() bit for bit, and inline for loops.
inline Point3 triangle_normal(const Point3& a, const Point3& b, const Point3& c) {
  const Point3 sum = Point3{0, 0, 0} + glm::cross(b - a, c - a);  // no negative zeros
  const double length = glm::length(sum);
  return length > 0 ? sum / length : Point3{0, 0, 0};
}

/// Unit normal of a face by Newell's method over its outer contour; zero if the face has no area.
Point3 face_normal(const Scene& scene, std::uint32_t face);

}  // namespace ligne
