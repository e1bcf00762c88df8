#include "visibility/atherton_weiler/zones.hpp"

#include <algorithm>

#include "geometry/connected_boxes.hpp"
#include "geometry/convex_hull.hpp"
#include "geometry/polygons/clip_contour_by_contour.hpp"

namespace ligne::atherton_weiler {
namespace {

/// Whether an edge of the first hull has the whole second hull outside or on its line.
bool separates(const std::vector<LatticePoint>& hull, const std::vector<LatticePoint>& other, std::uint64_t& signs) {
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const LatticePoint from = hull[i], to = hull[i + 1 == hull.size() ? 0 : i + 1];
    bool all_outside = true;
    for (std::size_t k = 0; k < other.size() && all_outside; ++k, ++signs)
      all_outside = orientation(from, to, other[k]) <= 0;
    if (all_outside) return true;
  }
  return false;
}

PageExtent extent_of(const std::vector<ContourFace>& faces) {
  constexpr double kPart = 1.0 / (1 << kFineBits);
  PageExtent extent;
  for (const ContourFace& face : faces) {
    for (const ContourEdge& e : face.contours[0]) {
      const FinePoint p = e.begin();
      const double x = static_cast<double>(p.x) * kPart, y = static_cast<double>(p.y) * kPart;
      extent.extend({{x, y, x, y}, {x + y, x - y, x + y, x - y}});
    }
  }
  return extent;
}

/// A binary tree of the extents of units. It halves the units by the middles of their boxes, along the longer side.
class ExtentTree {
 public:
  ExtentTree(const OverlapTests& tests, std::vector<std::uint32_t> units, DisjointSets& sets, PolygonCounts& counts)
      : tests_(tests), units_(std::move(units)), sets_(sets), counts_(counts) {
    if (!units_.empty()) root_ = build(0, units_.size());
  }

  void connect() {
    if (!units_.empty()) connect_within(root_);
  }

 private:
  struct Node {
    PageExtent extent;
    std::uint32_t unit = 0;                      ///< one of the units below
    std::uint32_t children[2] = {kNone, kNone};  ///< kNone: a leaf
    bool is_joined = true;                       ///< all units below are known to be in one set
  };

  std::uint32_t build(std::size_t first, std::size_t end) {
    Node node;
    for (std::size_t i = first; i < end; ++i) node.extent.extend(tests_.extent(units_[i]));
    node.unit = units_[first];
    if (end - first > 1) {
      const PageBox& box = node.extent.upright;
      const bool by_x = box.x1 - box.x0 > box.y1 - box.y0;
      const auto key = [&](std::uint32_t u) {
        const PageBox& b = tests_.extent(u).upright;
        return std::pair(by_x ? b.x0 + b.x1 : b.y0 + b.y1, u);
      };
      const std::size_t middle = first + (end - first) / 2;
      const auto at = [&](std::size_t i) { return units_.begin() + static_cast<std::ptrdiff_t>(i); };
      std::nth_element(at(first), at(middle), at(end), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
      node.children[0] = build(first, middle);
      node.children[1] = build(middle, end);
      node.is_joined = false;
    }
    nodes_.push_back(node);
    return static_cast<std::uint32_t>(nodes_.size() - 1);
  }

  bool is_leaf(std::uint32_t n) const { return nodes_[n].children[0] == kNone; }
  bool in_one_set(std::uint32_t a, std::uint32_t b) {
    return nodes_[a].is_joined && nodes_[b].is_joined && sets_.find(nodes_[a].unit) == sets_.find(nodes_[b].unit);
  }
  /// Marks a node if both children are joined and in one set.
  void update(std::uint32_t n) {
    if (!nodes_[n].is_joined) nodes_[n].is_joined = in_one_set(nodes_[n].children[0], nodes_[n].children[1]);
  }

  void connect_within(std::uint32_t n) {
    if (is_leaf(n)) return;
    const std::uint32_t a = nodes_[n].children[0], b = nodes_[n].children[1];
    connect_within(a);
    connect_within(b);
    connect_between(a, b);
    update(n);
  }

  /// Connects the units below two nodes. Nodes whose units are all in one set already are left out, so units at one place
  /// take one test for each join.
  void connect_between(std::uint32_t a, std::uint32_t b) {
    const Node &na = nodes_[a], &nb = nodes_[b];
    if (!na.extent.upright.meets(nb.extent.upright) || in_one_set(a, b)) return;
    if (tests_.test() >= ZoneTest::octagons && !na.extent.diagonal.meets(nb.extent.diagonal)) {
      counts_.zone_tests += is_leaf(a) && is_leaf(b);
      return;
    }
    if (is_leaf(a) && is_leaf(b)) {
      ++counts_.zone_tests;
      if (tests_.are_connected(na.unit, nb.unit, counts_)) sets_.join(na.unit, nb.unit);
      return;
    }
    const auto size = [](const Node& n) {
      return (n.extent.upright.x1 - n.extent.upright.x0) + (n.extent.upright.y1 - n.extent.upright.y0);
    };
    const bool divide_a = is_leaf(b) || (!is_leaf(a) && size(na) >= size(nb));
    const std::uint32_t whole = divide_a ? b : a, divided = divide_a ? a : b;
    for (const std::uint32_t child : nodes_[divided].children) connect_between(child, whole);
    update(divided);
  }

  const OverlapTests& tests_;
  std::vector<std::uint32_t> units_;
  DisjointSets& sets_;
  PolygonCounts& counts_;
  std::vector<Node> nodes_;
  std::uint32_t root_ = kNone;
};

DisjointSets connect(const std::vector<ClipUnit>& units, const OverlapTests& tests, PolygonCounts& counts) {
  if (tests.test() == ZoneTest::boxes) {
    std::vector<AxisBox> boxes;
    boxes.reserve(units.size());
    for (const ClipUnit& unit : units) boxes.push_back({unit.box.x0, unit.box.y0, unit.box.x1, unit.box.y1});
    return connect_boxes(boxes);
  }
  DisjointSets sets(units.size());
  std::vector<std::uint32_t> all(units.size());
  for (std::uint32_t u = 0; u < all.size(); ++u) all[u] = u;
  ExtentTree(tests, std::move(all), sets, counts).connect();
  return sets;
}

}  // namespace

OverlapTests::OverlapTests(const ProjectedScene& scene, const std::vector<Facet>& facets, const std::vector<ClipUnit>& units,
                           ZoneTest test)
    : units_(units), test_(test) {
  if (test == ZoneTest::boxes) return;
  extents_.reserve(units.size());
  for (const ClipUnit& unit : units) extents_.push_back(extent_of(unit.outline));
  if (test < ZoneTest::hulls) return;
  hulls_.reserve(units.size());
  std::vector<LatticePoint> points;
  for (const ClipUnit& unit : units) {
    points.clear();
    for (const UnitFace& face : unit.faces) {
      for (const std::uint32_t f : face.facets) {
        for (const std::uint32_t v : facets[f].v) points.push_back(scene.vertices[v].p);
      }
    }
    hulls_.push_back(convex_hull(points));
  }
}

bool OverlapTests::hulls_overlap(std::uint32_t a, std::uint32_t b, PolygonCounts& counts) const {
  return !separates(hulls_[a], hulls_[b], counts.test_signs) && !separates(hulls_[b], hulls_[a], counts.test_signs);
}

bool OverlapTests::may_overlap(std::uint32_t a, std::uint32_t b, PolygonCounts& counts) const {
  if (test_ == ZoneTest::boxes) return true;
  ++counts.pair_tests;
  if (extents_[a].diagonal.meets(extents_[b].diagonal) && (test_ < ZoneTest::hulls || hulls_overlap(a, b, counts))) {
    return true;
  }
  ++counts.told_apart;
  return false;
}

bool OverlapTests::are_connected(std::uint32_t a, std::uint32_t b, PolygonCounts& counts) const {
  if (test_ < ZoneTest::hulls) return true;
  if (!hulls_overlap(a, b, counts)) return false;
  return test_ < ZoneTest::contours || contours_overlap(units_[a].outline, units_[b].outline, counts.test_signs);
}

std::vector<std::vector<std::uint32_t>> zones_of(const std::vector<ClipUnit>& units, const OverlapTests& tests,
                                                 PolygonCounts& counts) {
  DisjointSets sets = connect(units, tests, counts);
  std::vector<std::vector<std::uint32_t>> zones;
  std::vector<std::uint32_t> number(units.size());
  for (std::uint32_t u = 0; u < units.size(); ++u) {
    const std::uint32_t root = sets.find(u);
    if (root == u) {
      number[u] = static_cast<std::uint32_t>(zones.size());
      zones.emplace_back();
    }
    zones[number[root]].push_back(u);
  }
  return zones;
}

}  // namespace ligne::atherton_weiler
