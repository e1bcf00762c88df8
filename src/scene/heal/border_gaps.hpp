#pragma once
/// Measures the gaps between the borders of an object, and decides which of them are cracks.

#include <cstdint>
#include <utility>
#include <vector>

#include "scene/heal/edge_tree.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// The border edges of one object.
class Border {
 public:
  /// `edges`: the edges of one object that have exactly one face.
  Border(const Scene& scene, std::vector<Edge> edges);

  const std::vector<Edge>& edges() const { return edges_; }
  const std::vector<std::uint32_t>& vertices() const { return vertices_; }  ///< ascending
  std::vector<EdgeTree::Segment> segments() const;                          ///< the edges in space
  const Point3& point(std::uint32_t v) const { return scene_.vertices[v]; }
  double median_length() const;
  bool is_of_one_face() const { return one_face_; }

  /// Whether the point of edge e at the parameter `at` is not adjacent to vertex v: the edge does not end in v, its
  /// face does not contain v, and the point is not the other end of an edge of v.
  bool is_apart(std::uint32_t v, std::uint32_t e, double at) const;

 private:
  bool has(std::uint32_t face, std::uint32_t v) const;
  bool adjacent(std::uint32_t u, std::uint32_t v) const;

  const Scene& scene_;
  std::vector<Edge> edges_;  ///< sorted by their vertices
  std::vector<std::uint32_t> vertices_;
  /// Pairs (face, vertex) of the faces at the border, sorted; empty if all faces are triangles.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> corners_;
  bool one_face_ = false;  ///< whether all edges belong to one face
};

/// Finds the points of a border that are near to other parts of it.
class BorderSearch {
 public:
  explicit BorderSearch(const Border& border) : border_(border), tree_(border.segments()) {}

  /// The nearest point within `distance` of vertex v that is_apart() from it. If `inside` > 0, the point is at least
  /// that far from both ends of its edge.
  NearestPoint nearest(std::uint32_t v, double distance, double inside = 0) const;

 private:
  const Border& border_;
  EdgeTree tree_;
};

/// The limit between cracks and openings, model units.
struct GapBreak {
  double distance = 0;   ///< widest crack; 0: there are no cracks
  std::size_t near = 0;  ///< number of vertices with a gap up to this distance
  double next = 0;       ///< narrowest gap above it, within the range of the search; 0: none
};

/// Distinguishes cracks from openings by the gaps: the distances from the vertices of the border to its other parts.
/// - A gap that rounding can leave between two copies of one point is always a crack (straightness_tolerance()).
/// - A gap wider than an eighth of the median border edge, or than 1/4096 of the model, is never a crack. On A4 the
///   latter is less than a twentieth of a millimetre, a seventh of a line width.
/// - In between, the largest ratio decides: the widest gap such that the next wider one is at least twice as wide.
///   Different tessellations of one curve leave gaps proportional to the squares of their chords, and openings are far
///   wider. If there is no such break, only gaps from rounding are cracks.
GapBreak find_gap_break(const Border& border, double precision, double model_size);

/// Counts the gaps within a given distance, and finds the next wider one.
GapBreak gaps_within(const Border& border, double distance);

}  // namespace ligne
