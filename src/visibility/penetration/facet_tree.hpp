#pragma once
/// Facets by place, for searches of pairs that may meet: a binary tree over the facets along a Morton curve of page and
/// depth [Morton1966]. A box and a slab bound each node. The slab lies between two parallel planes with the mean tilt
/// of the node's facets. It separates facets that lie in layers behind each other, or beside each other on a bent
/// surface, even if their boxes meet.

#include <cstdint>
#include <vector>

#include "view/projected_scene.hpp"
#include "visibility/common/facet.hpp"
#include "visibility/penetration/penetration.hpp"

namespace ligne {

class FacetTree {
 public:
  /// A facet: its box on the page and in depth, and its plane z(x, y) = zx x + zy y + z, with an error of at most
  /// `slack`.
  struct Item {
    std::int32_t left, right, top, bottom;  ///< lattice steps
    float z_near, z_far;
    double zx, zy, z, slack;
    std::uint32_t facet, face;
  };

  /// A node with the items [first, end). Its second child begins where the first ends.
  struct Node {
    std::int32_t left, right, top, bottom;
    float z_near, z_far;
    double zx, zy, low, high;  ///< the slab: low <= z - zx (x - left) - zy (y - top) <= high, with twice the slacks
    double slack;              ///< twice the largest slack of its facets
    double area;               ///< total area of its facets' boxes on the page, in square steps
    std::uint32_t first, end;
    std::uint32_t children;  ///< number of the first child; the second follows it
    std::uint32_t face;      ///< face of all its facets, or kNone if they differ
    std::uint32_t size() const { return end - first; }
  };

  /// Builds the trees, O(n log n). Facets of mixed sizes would make nodes large, so facets of about one size, within a
  /// factor of four, get a separate tree.
  FacetTree(const ProjectedScene& scene, const std::vector<Facet>& facets);

  const std::vector<std::uint32_t>& roots() const { return roots_; }
  const Node& node(std::uint32_t i) const { return nodes_[i]; }
  const Item& item(std::uint32_t i) const { return items_[i]; }
  bool is_leaf(const Node& node) const { return node.size() <= kLeaf; }

  /// Whether a facet of `a` may meet a facet of `b` of another face.
  static bool may_intersect(const Node& a, const Node& b);
  static bool may_intersect(const Item& a, const Item& b);

 private:
  static constexpr std::uint32_t kLeaf = 8;  // adjustable

  void fill(const ProjectedScene& scene, const std::vector<Facet>& facets);
  std::uint32_t add_node(std::uint32_t first, std::uint32_t end);
  void bound_leaf(Node& node) const;
  void bound_parent(Node& node) const;

  std::vector<Item> items_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> roots_;
};

/// Finds all pairs of facets that may penetrate each other, hidden ones included, by comparing the tree with itself. Drops
/// pairs of nodes whose boxes or slabs are apart, or whose facets are all of one face. O(n log n) plus the number of pairs
/// that are near each other.
PenetrationSearch find_crossing_facets(const ProjectedScene& scene, const std::vector<Facet>& facets);

}  // namespace ligne
