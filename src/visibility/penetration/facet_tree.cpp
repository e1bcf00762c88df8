#include "visibility/penetration/facet_tree.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "base/no_index.hpp"
#include "base/parallel.hpp"

namespace ligne {
namespace {

constexpr std::size_t kBlock = 1024;

/// Spreads the bits of a number of 20 bits to every third bit.
std::uint64_t spread_by_three(std::uint64_t v) {
  v = (v | (v << 32)) & 0x001f00000000ffffu;
  v = (v | (v << 16)) & 0x001f0000ff0000ffu;
  v = (v | (v << 8)) & 0x100f00f00f00f00fu;
  v = (v | (v << 4)) & 0x10c30c30c30c30c3u;
  return (v | (v << 2)) & 0x1249249249249249u;
}

/// Key of a facet's centre on the Morton curve; depths are scaled like lengths on the page.
std::uint64_t key_of(const FacetTree::Item& f, double steps_per_mm) {
  constexpr int kDropped = 7;  // low bits dropped of the 27 bits of a coordinate
  const auto whole = [](double steps) {
    const double least = -double(kLatticeLimit), most = double(kLatticeLimit) - 1;
    return static_cast<std::uint64_t>(std::clamp(steps, least, most) - least) >> kDropped;
  };
  const double x = (double(f.left) + f.right) / 2, y = (double(f.top) + f.bottom) / 2;
  const double z = (double(f.z_near) + f.z_far) / 2 * steps_per_mm;
  return spread_by_three(whole(x)) | spread_by_three(whole(y)) << 1 | spread_by_three(whole(z)) << 2;
}

/// Class of a facet's size: 0 for the smallest facets, and one more for each factor of four.
std::uint32_t size_class(const FacetTree::Item& f) {
  const auto extent = static_cast<std::uint32_t>(std::max(f.right - f.left, f.bottom - f.top));
  return static_cast<std::uint32_t>(std::bit_width(extent) / 2);
}

/// The least and the largest value of sx x + sy y over [0, w] x [0, h].
struct Range {
  double low, high;
};
Range range_of(double sx, double sy, double w, double h) {
  return {std::min(0.0, sx * w) + std::min(0.0, sy * h), std::max(0.0, sx * w) + std::max(0.0, sy * h)};
}

/// Extends the box of a node by another box.
template <class Box>
void include(FacetTree::Node& node, const Box& box) {
  node.left = std::min(node.left, box.left);
  node.right = std::max(node.right, box.right);
  node.top = std::min(node.top, box.top);
  node.bottom = std::max(node.bottom, box.bottom);
  node.z_near = std::min(node.z_near, box.z_near);
  node.z_far = std::max(node.z_far, box.z_far);
}

/// The depths between two parallel planes: their slopes, and their depths at the left upper corner of the box.
struct Slab {
  double zx, zy, low, high;
};

/// Extends the slab of a node by the part of another slab within its box.
template <class Box>
void include_slab(FacetTree::Node& node, const Box& box, const Slab& slab, double slack) {
  const auto [zx, zy, low, high] = slab;
  const double w = double(box.right) - box.left, h = double(box.bottom) - box.top;
  const double dx = double(box.left) - node.left, dy = double(box.top) - node.top;
  const double moved = node.zx * dx + node.zy * dy;
  const Range by_slab = range_of(zx - node.zx, zy - node.zy, w, h), by_box = range_of(-node.zx, -node.zy, w, h);
  node.low = std::min(node.low, std::max(low + by_slab.low, box.z_near - slack + by_box.low) - moved);
  node.high = std::max(node.high, std::min(high + by_slab.high, box.z_far + slack + by_box.high) - moved);
}

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

FacetTree::FacetTree(const ProjectedScene& scene, const std::vector<Facet>& facets) {
  fill(scene, facets);
  for (std::uint32_t first = 0, end = 0; first < items_.size(); first = end) {
    const std::uint32_t size = size_class(items_[first]);
    while (end < items_.size() && size_class(items_[end]) == size) ++end;
    roots_.push_back(add_node(first, end));
  }
  std::vector<std::size_t> level_ends{0, nodes_.size()};
  while (level_ends.back() > level_ends.end()[-2]) {
    for (std::size_t i = level_ends.end()[-2]; i < level_ends.back(); ++i) {
      if (is_leaf(nodes_[i])) continue;
      const std::uint32_t first = nodes_[i].first, end = nodes_[i].end, middle = first + (end - first) / 2;
      nodes_[i].children = add_node(first, middle);
      add_node(middle, end);
    }
    level_ends.push_back(nodes_.size());
  }
  for (std::size_t level = level_ends.size() - 1; level-- > 0;) {
    const std::size_t level_begin = level_ends[level];
    parallel_blocks(level_ends[level + 1] - level_begin, kBlock, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = level_begin + begin; i < level_begin + end; ++i) {
        is_leaf(nodes_[i]) ? bound_leaf(nodes_[i]) : bound_parent(nodes_[i]);
      }
    });
  }
}

std::uint32_t FacetTree::add_node(std::uint32_t first, std::uint32_t end) {
  nodes_.emplace_back();
  nodes_.back().first = first;
  nodes_.back().end = end;
  return static_cast<std::uint32_t>(nodes_.size() - 1);
}

void FacetTree::fill(const ProjectedScene& scene, const std::vector<Facet>& facets) {
  struct Place {
    std::uint32_t size;
    std::uint64_t key;
    std::uint32_t item;
    auto operator<=>(const Place&) const = default;
  };
  std::vector<Item> items(facets.size());
  std::vector<Place> places(facets.size());
  parallel_blocks(facets.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Facet& f = facets[i];
      const FacetFunctions g(f, scene.vertices.data());
      const LatticePoint a = scene.vertices[f.v[0]].p, b = scene.vertices[f.v[1]].p, c = scene.vertices[f.v[2]].p;
      const auto [left, right] = std::minmax({a.x, b.x, c.x});
      const auto [top, bottom] = std::minmax({a.y, b.y, c.y});
      items[i] = {left,  right, top, bottom, f.z_near, f.z_far, g.zx, g.zy, g.z, g.slack, static_cast<std::uint32_t>(i),
                  f.face};
      places[i] = {size_class(items[i]), key_of(items[i], 1 / scene.lattice.step_mm), static_cast<std::uint32_t>(i)};
    }
  });
  parallel_sort(places.begin(), places.end());
  items_.resize(items.size());
  parallel_blocks(items.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) items_[i] = items[places[i].item];
  });
}

void FacetTree::bound_leaf(Node& node) const {
  const Item& one = items_[node.first];
  const std::uint32_t first = node.first, end = node.end;
  node = {one.left, one.right, one.top, one.bottom, one.z_near, one.z_far, 0, 0, 0, 0, 0, 0, first, end, 0, one.face};
  for (std::uint32_t i = node.first; i < node.end; ++i) {
    const Item& f = items_[i];
    // The area of the box is at least twice that of the facet, and serves as well as a weight.
    const double area = (double(f.right) - f.left) * (double(f.bottom) - f.top);
    include(node, f);
    node.zx += area * f.zx;
    node.zy += area * f.zy;
    node.area += area;
    node.slack = std::max(node.slack, 2 * f.slack);
    if (f.face != node.face) node.face = kNone;
  }
  if (node.area > 0) {
    node.zx /= node.area;
    node.zy /= node.area;
  }
  node.low = HUGE_VAL;
  node.high = -HUGE_VAL;
  for (std::uint32_t i = node.first; i < node.end; ++i) {
    const Item& f = items_[i];
    const double corner = f.zx * f.left + f.zy * f.top + f.z;
    include_slab(node, f, {f.zx, f.zy, corner - 2 * f.slack, corner + 2 * f.slack}, 2 * f.slack);
  }
}

void FacetTree::bound_parent(Node& node) const {
  const Node &a = nodes_[node.children], &b = nodes_[node.children + 1];
  const std::uint32_t first = node.first, end = node.end, children = node.children;
  node = a;
  node.first = first;
  node.end = end;
  node.children = children;
  include(node, b);
  node.slack = std::max(a.slack, b.slack);
  node.area = a.area + b.area;
  if (node.area > 0) {
    node.zx = (a.area * a.zx + b.area * b.zx) / node.area;
    node.zy = (a.area * a.zy + b.area * b.zy) / node.area;
  }
  node.face = a.face == b.face ? a.face : kNone;
  node.low = HUGE_VAL;
  node.high = -HUGE_VAL;
  for (const Node* child : {&a, &b}) {
    include_slab(node, *child, {child->zx, child->zy, child->low, child->high}, child->slack);
  }
}

bool FacetTree::may_intersect(const Node& a, const Node& b) {
  const std::int32_t left = std::max(a.left, b.left), right = std::min(a.right, b.right);
  const std::int32_t top = std::max(a.top, b.top), bottom = std::min(a.bottom, b.bottom);
  if (left > right || top > bottom || a.z_near > b.z_far || b.z_near > a.z_far) return false;
  if (a.face == b.face && a.face != kNone) return false;
  // The slab of `a` relative to that of `b`; both are linear over the page.
  const double zx = a.zx - b.zx, zy = a.zy - b.zy;
  const double z = a.zx * (double(left) - a.left) + a.zy * (double(top) - a.top) -
                   (b.zx * (double(left) - b.left) + b.zy * (double(top) - b.top));
  const Range range = range_of(zx, zy, double(right) - left, double(bottom) - top);
  return z + range.low + a.low <= b.high && z + range.high + a.high >= b.low;
}

/// Whether the planes may cross or touch where the boxes meet on the page.
bool FacetTree::may_intersect(const Item& a, const Item& b) {
  const std::int32_t x0 = std::max(a.left, b.left), x1 = std::min(a.right, b.right);
  const std::int32_t y0 = std::max(a.top, b.top), y1 = std::min(a.bottom, b.bottom);
  if (x0 > x1 || y0 > y1 || a.z_near > b.z_far || b.z_near > a.z_far || a.face == b.face) return false;
  const double left = x0, right = x1, top = y0, bottom = y1;
  const double zx = a.zx - b.zx, zy = a.zy - b.zy;
  const double z = a.z - b.z + (zx * (left + right) + zy * (top + bottom)) / 2;
  return std::abs(z) <= (std::abs(zx) * (right - left) + std::abs(zy) * (bottom - top)) / 2 + 2 * (a.slack + b.slack);
}

PenetrationSearch find_crossing_facets(const ProjectedScene& scene, const std::vector<Facet>& facets) {
  return CrossingSearch(scene, facets).run();
}

}  // namespace ligne
