#pragma once
/// The borders of an object, how far they lie from each other, and what of that is a crack.

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "scene/heal/edge_tree.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// The border edges of one object, and what can be asked of them.
class Border {
 public:
  /// `edges`: those of one object that have one face.
  Border(const Scene& scene, std::vector<Edge> edges);

  const std::vector<Edge>& edges() const { return edges_; }
  const std::vector<std::uint32_t>& vertices() const { return vertices_; }  ///< ascending
  std::vector<EdgeTree::Segment> segments() const;                          ///< the edges in space
  const Point3& point(std::uint32_t v) const { return scene_.vertices[v]; }
  double median_length() const;
  bool is_of_one_face() const { return one_face_; }

  /// Point `at` of edge e is not next to vertex v: the edge does not end in v, its face does not have v, and the point is
  /// not the other end of an edge of v.
  bool is_apart(std::uint32_t v, std::uint32_t e, double at) const;

 private:
  bool has(std::uint32_t face, std::uint32_t v) const;
  bool adjacent(std::uint32_t u, std::uint32_t v) const;

  const Scene& scene_;
  std::vector<Edge> edges_;  ///< ordered by their vertices
  std::vector<std::uint32_t> vertices_;
  /// (face, vertex) of the faces at the border, sorted; none where all faces are triangles.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> corners_;
  bool one_face_ = false;  ///< all edges are of one face
};

/// Finds the parts of a border that other parts of it come near to.
class BorderSearch {
 public:
  explicit BorderSearch(const Border& border) : border_(border), tree_(border.segments()) {}

  /// The nearest point of the border that is not next to vertex v. `inside` > 0: at least so far from both ends of its edge.
  NearestPoint nearest(std::uint32_t v, double distance, double inside = 0) const;

 private:
  const Border& border_;
  EdgeTree tree_;
};

/// The gaps within a distance, and those beyond it.
struct GapBreak {
  double distance = 0;   ///< of what is a crack; 0: there is none
  std::size_t near = 0;  ///< vertices within it
  double next = 0;       ///< the nearest beyond it, as far as was looked; 0: none
};

/// Tells cracks from openings by the distances from the vertices of the border to its other parts.
/// - What two roundings of one point leave between its copies is always a crack: straightness of the input's precision.
/// - Nothing is a crack that is wider than an eighth of the median border edge, or than 1/4096 of the model, which is less
/// than
///   a twentieth of a millimetre on A4: a seventh of a line.
/// - Between the two the widest break decides: the largest gap such that the next one is twice as wide or more.
/// Tessellations
///   of a common curve leave gaps of up to the square of their chords, and openings begin far beyond. Without such a break
///   nothing tells the one from the other, and only roundings are closed.
GapBreak find_gap_break(const Border& border, double precision, double model_size);

/// The break at a distance that is given.
GapBreak gaps_within(const Border& border, double distance);

}  // namespace ligne
