#include "visibility/penetration/crossing_facets.hpp"

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "visibility/penetration/facet_tree.hpp"

namespace ligne {
namespace {

/// Two nodes of the tree, or one node twice.
struct NodePair {
  std::uint32_t a, b;
};

class CrossingSearch {
 public:
  CrossingSearch(const ProjectedScene& scene, const std::vector<Facet>& facets)
      : scene_(scene), facets_(facets), tree_(scene, facets) {}

  PenetrationSearch run() const;

 private:
  template <class Visit>
  void visit_parts(const NodePair& pair, const Visit& visit) const;
  std::vector<NodePair> tasks() const;
  void search(const NodePair& pair, PenetrationSearch& found) const;
  void compare_leaves(const NodePair& pair, PenetrationSearch& found) const;

  const ProjectedScene& scene_;
  const std::vector<Facet>& facets_;
  FacetTree tree_;
};

/// Divides the larger node of a pair, and visits the resulting pairs that may meet.
template <class Visit>
void CrossingSearch::visit_parts(const NodePair& pair, const Visit& visit) const {
  const FacetTree::Node &a = tree_.node(pair.a), &b = tree_.node(pair.b);
  if (pair.a == pair.b) {
    if (a.face != kNone) return;
    visit(NodePair{a.children, a.children});
    visit(NodePair{a.children + 1, a.children + 1});
    if (FacetTree::may_intersect(tree_.node(a.children), tree_.node(a.children + 1))) {
      visit(NodePair{a.children, a.children + 1});
    }
    return;
  }
  const bool first = a.size() >= b.size();
  const std::uint32_t children = first ? a.children : b.children, other = first ? pair.b : pair.a;
  for (const std::uint32_t child : {children, children + 1}) {
    if (FacetTree::may_intersect(tree_.node(child), tree_.node(other))) visit(NodePair{child, other});
  }
}

/// Pairs of nodes that together cover all pairs of facets.
std::vector<NodePair> CrossingSearch::tasks() const {
  constexpr std::size_t kParts = 64, kFewest = 256;  // adjustable
  const auto& roots = tree_.roots();
  std::vector<NodePair> here;
  for (std::size_t i = 0; i < roots.size(); ++i) {
    here.push_back({roots[i], roots[i]});
    for (std::size_t k = i + 1; k < roots.size(); ++k) {
      if (FacetTree::may_intersect(tree_.node(roots[i]), tree_.node(roots[k]))) here.push_back({roots[i], roots[k]});
    }
  }
  const std::size_t most = std::max(kFewest, facets_.size() / kParts);
  std::vector<NodePair> result;
  while (!here.empty()) {
    const NodePair pair = here.back();
    here.pop_back();
    if (tree_.node(pair.a).size() + std::size_t{tree_.node(pair.b).size()} <= most) {
      result.push_back(pair);
    } else {
      visit_parts(pair, [&](const NodePair& part) { here.push_back(part); });
    }
  }
  return result;
}

void CrossingSearch::search(const NodePair& pair, PenetrationSearch& found) const {
  if (tree_.is_leaf(tree_.node(pair.a)) && tree_.is_leaf(tree_.node(pair.b))) {
    compare_leaves(pair, found);
  } else {
    visit_parts(pair, [&](const NodePair& part) { search(part, found); });
  }
}

void CrossingSearch::compare_leaves(const NodePair& pair, PenetrationSearch& found) const {
  const auto every = [](const PageSegment&) { return true; };
  const FacetTree::Node &first = tree_.node(pair.a), &second = tree_.node(pair.b);
  for (std::uint32_t i = first.first; i < first.end; ++i) {
    const FacetTree::Item& a = tree_.item(i);
    std::optional<PlacedFacet> placed;
    for (std::uint32_t k = pair.a == pair.b ? i + 1 : second.first; k < second.end; ++k) {
      const FacetTree::Item& b = tree_.item(k);
      if (!FacetTree::may_intersect(a, b)) continue;
      if (!placed) placed = found.place(a.facet);
      const PlacedFacet other = found.place(b.facet);
      // The nearer facet always comes first: a side in a plane along the rim of the plane's facet counts in one order
      // only.
      if (std::tie(a.z_near, a.facet) < std::tie(b.z_near, b.facet)) {
        found.test(*placed, other, every);
      } else {
        found.test(other, *placed, every);
      }
    }
  }
}

PenetrationSearch CrossingSearch::run() const {
  PenetrationSearch all(facets_, scene_.vertices);
  if (facets_.empty()) return all;
  const std::vector<NodePair> pairs = tasks();
  std::vector<PenetrationSearch> found(pairs.size(), all.empty_copy());
  parallel_for(pairs.size(), [&](std::size_t i) { search(pairs[i], found[i]); });
  for (PenetrationSearch& part : found) all.add(std::move(part));
  return all;
}

}  // namespace

PenetrationSearch find_crossing_facets(const ProjectedScene& scene, const std::vector<Facet>& facets) {
  return CrossingSearch(scene, facets).run();
}

}  // namespace ligne
