#pragma once
/// Facets by place, for searches of pairs that may meet: a binary tree over the facets along a Morton curve of page and
/// depth [Morton1966], whose nodes are bounded by a box and by a slab. The slab lies between two parallel planes, tilted as
/// the facets of the node are on the average: facets that lie behind each other like the skins of an onion, or beside each
/// other on a bent surface, are apart by their slabs where their boxes are not.

#include <cstdint>
#include <vector>

#include "view/projected_scene.hpp"
#include "visibility/common/facet.hpp"

namespace ligne {

class FacetTree {
 public:
  /// A facet: its box on the page and in depth, and the plane of its depth, z(x, y) = zx x + zy y + z, right within `slack`.
  struct Item {
    std::int32_t left, right, top, bottom;  ///< lattice steps
    float z_near, z_far;
    double zx, zy, z, slack;
    std::uint32_t facet, face;
  };

  /// Items first to end; the second child begins where the first ends.
  struct Node {
    std::int32_t left, right, top, bottom;
    float z_near, z_far;
    double zx, zy, low, high;  ///< the slab: low <= z - zx (x - left) - zy (y - top) <= high, slacks twice included
    double slack;              ///< twice the largest of its facets
    double area;               ///< of its facets' boxes on the page, square steps
    std::uint32_t first, end;
    std::uint32_t children;  ///< the number of the first; the second has the next
    std::uint32_t face;      ///< of all its facets, or kNone
    std::uint32_t size() const { return end - first; }
  };

  /// Facets of several sizes would make nodes large: those of each size, within a factor of four, have a tree of their own.
  /// O(n log n).
  FacetTree(const ProjectedScene& scene, const std::vector<Facet>& facets);

  const std::vector<std::uint32_t>& roots() const { return roots_; }
  const Node& node(std::uint32_t i) const { return nodes_[i]; }
  const Item& item(std::uint32_t i) const { return items_[i]; }
  bool is_leaf(const Node& node) const { return node.size() <= kLeaf; }

  /// Whether a facet of the one may meet one of the other, of another face.
  static bool may_meet(const Node& a, const Node& b);
  static bool may_meet(const Item& a, const Item& b);

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

}  // namespace ligne
