#pragma once
/// Edges with their faces, and the triangles of the faces.

#include <array>
#include <cstdint>
#include <vector>

#include "base/no_index.hpp"
#include "scene/model/scene.hpp"

namespace ligne {

/// An edge of the scene: vertices in ascending order, and its first two faces.
struct Edge {
  std::uint32_t v0 = 0, v1 = 0;
  std::uint32_t face0 = kNone, face1 = kNone;  ///< face1 is kNone on a border
};

enum EdgeFlag : std::uint16_t {
  kEdgeManyFaces = 1,    ///< more than two faces meet here
  kEdgeFileHidden = 2,   ///< the file marks it as not to be drawn
  kEdgeInner = 4,        ///< inside a triangulated polygon
  kEdgeUnlikeWound = 8,  ///< its two faces run through it in the same direction: their windings disagree
  kEdgeCurve = 16,       ///< part of an iso-curve of a surface: one of its faces says so
  kEdgeCrossing = 32,    ///< surfaces cross along it
  kEdgeContour = 64,     ///< part of a contour line: one of its faces says so
  kEdgeSmooth = 128,     ///< the file says that the surface runs smoothly over it
  kEdgeSharp = 256,      ///< the file says that it does not
};

/// A triangle of a face; wound as the face is.
struct Triangle {
  std::array<std::uint32_t, 3> v{};
  std::uint32_t face = kNone;
};

struct Topology {
  std::vector<Edge> edges;                ///< ordered by (v0, v1)
  std::vector<std::uint16_t> edge_flags;  ///< EdgeFlag
  std::vector<Triangle> triangles;        ///< ordered by face
};

/// Finds the edges and triangulates the faces of a finished scene. Time grows with the number of corners.
Topology build_topology(const Scene& scene);

/// The triangles alone, as in the topology.
std::vector<Triangle> triangulate_faces(const Scene& scene);

/// Unit normal of a face by Newell's sum over its outer contour; zero when the face has no area.
Point3 face_normal(const Scene& scene, std::uint32_t face);

}  // namespace ligne
