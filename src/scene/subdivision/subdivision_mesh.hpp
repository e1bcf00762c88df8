#pragma once
/// A mesh of polygons with its edges, as index arrays, for subdivision.

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "base/no_index.hpp"
#include "geometry/point.hpp"
#include "scene/model/polygon_faces.hpp"

namespace ligne {

enum class SubdivisionScheme : std::uint8_t { catmull_clark, loop };

/// Sharpness of an edge or a vertex that stays sharp at every level.
inline constexpr float kAlwaysSharp = std::numeric_limits<float>::infinity();

struct SubdivisionEdge {
  std::array<std::uint32_t, 2> ends{kNone, kNone};   ///< vertices
  std::array<std::uint32_t, 2> sides{kNone, kNone};  ///< corners where it begins in its first two faces
};

/// Faces are cyclic lists of corners, one face after the other. A side of a face is identified by its first corner.
struct SubdivisionMesh {
  std::vector<Point3> points;           ///< per vertex
  std::vector<float> vertex_sharpness;  ///< per vertex, 0: smooth
  std::uint32_t face_size = 0;          ///< corners per face; 0: faces have different sizes
  std::vector<std::uint32_t> face_begin,
      corner_face;                         ///< sizes of their own: first corner per face and the end; face per corner
  std::vector<std::uint32_t> corners;      ///< vertex per corner
  std::vector<std::uint32_t> corner_edge;  ///< the edge of each side
  std::vector<SubdivisionEdge> edges;
  std::vector<float> edge_sharpness;     ///< per edge, 0: smooth; kAlwaysSharp on borders and at more than two faces
  std::vector<std::uint8_t> edge_flags;  ///< CornerFlag per edge; kCornerSharp: its control edge has a sharpness

  std::size_t face_count() const { return face_size ? corners.size() / face_size : face_begin.size() - 1; }
  std::uint32_t face_of(std::uint32_t corner) const { return face_size ? corner / face_size : corner_face[corner]; }
  std::uint32_t begin_of(std::uint32_t f) const { return face_size ? f * face_size : face_begin[f]; }
  std::uint32_t end_of(std::uint32_t f) const { return face_size ? (f + 1) * face_size : face_begin[f + 1]; }
  std::uint32_t next(std::uint32_t corner) const {
    const std::uint32_t f = face_of(corner);
    return corner + 1 == end_of(f) ? begin_of(f) : corner + 1;
  }
  std::uint32_t previous(std::uint32_t corner) const {
    const std::uint32_t f = face_of(corner);
    return (corner == begin_of(f) ? end_of(f) : corner) - 1;
  }
};

/// Sharpness and flags of the sides of a control mesh, per corner.
struct SideTags {
  std::vector<float> sharpness;
  std::vector<std::uint8_t> flags;  ///< CornerFlag
};

/// Finds the edges of a mesh with given faces and vertices: fills corner_edge, edges, edge_sharpness and edge_flags. An
/// edge is as sharp as its sharpest side and has the flags of its sides (kCornerFileHidden and kCornerInner only if all
/// sides have them). Borders and edges of more than two faces are always sharp; so are vertices at which fans of faces
/// share only the vertex. Edges are in ascending order of their vertices. O(n log n).
void connect_edges(SubdivisionMesh& mesh, const SideTags& sides);

/// The next level of a connected mesh, without the points. In the Catmull-Clark scheme, vertices are those of the mesh,
/// then one per edge, then one per face; face k is the quad at corner k of the mesh, from its vertex past the middle of
/// its side. In Loop's scheme (triangles), vertices are those of the mesh, then one per edge; triangle f gives the
/// faces at its three corners and the one in its middle. Edges 2 e and 2 e + 1 are the halves of edge e. The edges
/// inside faces follow, unless `last` omits them because no further level is made.
SubdivisionMesh refine(const SubdivisionMesh& mesh, SubdivisionScheme scheme, bool last);

}  // namespace ligne
