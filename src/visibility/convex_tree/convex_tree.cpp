// [Huet1994] 3.2. Huet's measure of termination is the number of planes that support a triangle of the set. Here it is
// the number of scene triangles with pieces in the set. That serves as well, since pieces of one triangle have one
// plane. Peeling takes all pieces of a triangle. A separating plane through a triangle leaves that triangle on its
// front side only, where it is peeled next. Any other separating plane leaves fewer pieces on either side, and no more
// triangles.
// Phases: (1) build the tree, in model space, (2) walk through it once, from the front, by dot products, (3) test every
// edge against the faces that have pieces in front of its own. See docs/methods/convex-tree.md.

#include "visibility/convex_tree/convex_tree.hpp"

#include <algorithm>
#include <numeric>
#include <optional>

#include "files/bytes.hpp"

namespace ligne {
namespace {

/// A tree of boxes over points, to find whether a point lies below a plane.

class PointBoxes {
 public:
  explicit PointBoxes(std::vector<Point3> points) : points_(std::move(points)) { build(); }

  /// Whether the height of some point over the plane is below -tolerance. Boxes wholly above are skipped.
  bool any_below(const ModelPlane& plane, double tolerance) const {
    if (points_.empty()) return false;
    std::vector<std::uint32_t> open{0};
    while (!open.empty()) {
      const Box& box = boxes_[open.back()];
      open.pop_back();
      const Point3 lowest{plane.normal.x > 0 ? box.low.x : box.high.x, plane.normal.y > 0 ? box.low.y : box.high.y,
                          plane.normal.z > 0 ? box.low.z : box.high.z};
      if (plane.height(lowest) >= -tolerance) continue;
      if (box.child == kNone) {
        for (std::uint32_t i = box.begin; i < box.end; ++i) {
          if (plane.height(points_[i]) < -tolerance) return true;
        }
      } else {
        open.push_back(box.child);
        open.push_back(box.child + 1);
      }
    }
    return false;
  }

 private:
  static constexpr std::uint32_t kInLeaf = 48;
  struct Box {
    Point3 low, high;
    std::uint32_t begin, end, child = kNone;  ///< the first of two consecutive children, or kNone
  };

  void build() {
    boxes_.push_back(box_of(0, static_cast<std::uint32_t>(points_.size())));
    for (std::size_t b = 0; b < boxes_.size(); ++b) {
      const auto [begin, end] = std::pair(boxes_[b].begin, boxes_[b].end);
      if (end - begin <= kInLeaf) continue;
      const Point3 size = boxes_[b].high - boxes_[b].low;
      const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
      const std::uint32_t middle = begin + (end - begin) / 2;
      std::nth_element(points_.begin() + begin, points_.begin() + middle, points_.begin() + end,
                       [axis](const Point3& p, const Point3& q) { return p[axis] < q[axis]; });
      boxes_[b].child = static_cast<std::uint32_t>(boxes_.size());
      boxes_.push_back(box_of(begin, middle));
      boxes_.push_back(box_of(middle, end));
    }
  }

  Box box_of(std::uint32_t begin, std::uint32_t end) const {
    Box box{Point3(1e300), Point3(-1e300), begin, end};
    for (std::uint32_t i = begin; i < end; ++i) {
      box.low = glm::min(box.low, points_[i]);
      box.high = glm::max(box.high, points_[i]);
    }
    return box;
  }

  std::vector<Point3> points_;
  std::vector<Box> boxes_;
};

constexpr std::size_t kMaxGreedySet = 96;  ///< adjustable: from sets larger than this only a large convex set is peeled
constexpr std::size_t kSample = 256;       ///< adjustable: pieces in the sample that estimates its share
constexpr std::size_t kLeastPart = 8;      ///< adjustable: one over the least share of a large convex set

/// Finds the pieces of a set whose planes have all other pieces on one side.
class HullSearch {
 public:
  HullSearch(const ModelPieces& pieces, const std::vector<std::uint32_t>& set) : pieces_(pieces), set_(set) {
    std::vector<std::pair<double, Point3>> low(kDirections.size(), {1e300, {}}), high(kDirections.size(), {-1e300, {}});
    for (const std::uint32_t piece : set) {
      for (const std::uint32_t corner : pieces.corners(piece)) {
        const Point3& p = pieces.point(corner);
        for (std::size_t d = 0; d < kDirections.size(); ++d) {
          const double place = glm::dot(kDirections[d], p);
          if (place < low[d].first) low[d] = {place, p};
          if (place > high[d].first) high[d] = {place, p};
        }
      }
    }
    for (std::size_t d = 0; d < kDirections.size(); ++d) {
      extremes_.push_back(low[d].second);
      extremes_.push_back(high[d].second);
    }
  }

  /// The plane of the piece, with its normal towards the side of all other pieces; none if there are pieces on both
  /// sides.
  std::optional<ModelPlane> supporting_plane(std::uint32_t piece) {
    ModelPlane plane = pieces_.plane_of(piece);
    const double tolerance = pieces_.tolerance();
    double low = 0, high = 0;
    for (const Point3& p : extremes_) {
      const double h = plane.height(p);
      low = std::min(low, h);
      high = std::max(high, h);
      if (low < -tolerance && high > tolerance) return std::nullopt;
    }
    if (low < -tolerance) plane.normal = -plane.normal;
    if (!boxes_) {
      std::vector<Point3> points;
      for (const std::uint32_t other : set_) {
        for (const std::uint32_t corner : pieces_.corners(other)) points.push_back(pieces_.point(corner));
      }
      boxes_.emplace(std::move(points));
    }
    if (!boxes_->any_below(plane, tolerance)) return plane;
    if (low < -tolerance || high > tolerance) return std::nullopt;
    plane.normal = -plane.normal;  // all extremes lie in the plane
    return boxes_->any_below(plane, tolerance) ? std::nullopt : std::optional(plane);
  }

 private:
  static inline const std::vector<Point3> kDirections{{1, 0, 0},  {0, 1, 0},  {0, 0, 1}, {1, 1, 0},  {1, -1, 0},
                                                      {1, 0, 1},  {1, 0, -1}, {0, 1, 1}, {0, 1, -1}, {1, 1, 1},
                                                      {1, 1, -1}, {1, -1, 1}, {-1, 1, 1}};
  const ModelPieces& pieces_;
  const std::vector<std::uint32_t>& set_;
  std::vector<Point3> extremes_;
  std::optional<PointBoxes> boxes_;
};

}  // namespace

ConvexTree::ConvexTree(const Scene& scene, const PlaneChoice& options) : pieces_(scene) {
  counts_.triangles = pieces_.pieces().size();
  counted_.assign(pieces_.triangles().size(), 0);
  if (pieces_.pieces().empty()) return;
  std::vector<Task> open(1);
  open[0].pieces.resize(pieces_.pieces().size());
  std::iota(open[0].pieces.begin(), open[0].pieces.end(), 0u);
  while (!open.empty()) {
    Task task = std::move(open.back());
    open.pop_back();
    compile(std::move(task), options, open);
  }
}

std::uint64_t ConvexTree::count_supports(const std::vector<std::uint32_t>& set) {
  ++counted_sets_;
  std::uint64_t count = 0;
  for (const std::uint32_t piece : set) {
    std::uint64_t& last = counted_[pieces_.pieces()[piece].triangle];
    count += last != counted_sets_;
    last = counted_sets_;
  }
  return count;
}

ConvexTree::ConvexTree(ByteReader& bytes, const Scene& scene) : pieces_(bytes, scene) {
  for (std::uint64_t* count :
       {&counts_.triangles, &counts_.convex_sets, &counts_.planes, &counts_.free_planes, &counts_.splits, &counts_.depth}) {
    *count = bytes.number<std::uint64_t>();
  }
  const std::vector<ModelPlane> planes = bytes.list<ModelPlane>();
  const std::vector<std::uint32_t> pieces = bytes.list<std::uint32_t>();
  bytes.need(planes.size() == pieces.size() && pieces.size() == pieces_.pieces().size(), "a piece is in no convex set");
  std::vector<std::uint8_t> is_there(pieces.size(), 0);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    bytes.need(pieces[i] < is_there.size() && !is_there[pieces[i]] && planes[i].is_finite(),
               "a piece is in two convex sets, or has no plane");
    is_there[pieces[i]] = 1;
    inward_.push_back({pieces[i], planes[i]});
  }
  const auto count = bytes.number<std::uint64_t>();
  for (std::uint64_t i = 0; i < count; ++i) {
    Node& node = nodes_.emplace_back();
    node.convex = bytes.number<std::uint8_t>() != 0;
    for (std::uint32_t* n : {&node.begin, &node.end, &node.front, &node.back}) *n = bytes.number<std::uint32_t>();
    for (Point3* p : {&node.plane.normal, &node.plane.point}) {
      for (int k = 0; k < 3; ++k) (*p)[k] = bytes.number<double>();
    }
    bytes.need(node.plane.is_finite() && node.begin <= node.end && node.end <= inward_.size(), "a node has no plane");
  }
  require_tree(bytes, nodes_);
  std::vector<std::uint8_t> is_owned(inward_.size(), 0);
  for (const Node& node : nodes_) {
    for (std::uint32_t k = node.begin; k < node.end; ++k) {
      bytes.need(node.convex && !is_owned[k], "two convex sets have a common piece");
      is_owned[k] = 1;
    }
  }
}

void ConvexTree::write(ByteWriter& bytes) const {
  pieces_.write(bytes);
  for (const std::uint64_t count :
       {counts_.triangles, counts_.convex_sets, counts_.planes, counts_.free_planes, counts_.splits, counts_.depth}) {
    bytes.number(count);
  }
  std::vector<ModelPlane> planes;
  std::vector<std::uint32_t> pieces;
  for (const Inward& inward : inward_) {
    planes.push_back(inward.plane);
    pieces.push_back(inward.piece);
  }
  bytes.list(std::span<const ModelPlane>(planes));
  bytes.list(std::span<const std::uint32_t>(pieces));
  bytes.number(static_cast<std::uint64_t>(nodes_.size()));
  for (const Node& node : nodes_) {
    bytes.number(static_cast<std::uint8_t>(node.convex));
    for (const std::uint32_t n : {node.begin, node.end, node.front, node.back}) bytes.number(n);
    for (const Point3& p : {node.plane.normal, node.plane.point}) {
      for (int k = 0; k < 3; ++k) bytes.number(p[k]);
    }
  }
}

bool ConvexTree::should_peel(const std::vector<std::uint32_t>& set) const {
  if (set.size() <= kMaxGreedySet) return true;
  const std::size_t stride = (set.size() + kSample - 1) / kSample;
  std::vector<std::uint32_t> sample;
  for (std::size_t i = 0; i < set.size(); i += stride) sample.push_back(set[i]);
  // A vertex not on the hull of the sample is not on the hull of the set, so the sample alone rejects most sets.
  for (const std::vector<std::uint32_t>* among : {&std::as_const(sample), &set}) {
    HullSearch hull(pieces_, *among);
    std::size_t found = 0;
    for (const std::uint32_t piece : sample) found += hull.supporting_plane(piece).has_value();
    if (found * kLeastPart < sample.size()) return false;
  }
  return true;
}

void ConvexTree::compile(Task task, const PlaneChoice& options, std::vector<Task>& open) {
  const auto number = static_cast<std::uint32_t>(nodes_.size());
  if (task.parent != kNone) (task.front ? nodes_[task.parent].front : nodes_[task.parent].back) = number;
  counts_.depth = std::max(counts_.depth, task.depth);
  Node node;
  const std::uint64_t before = count_supports(task.pieces);
  if (task.lies_on_parent || !options.free_planes || should_peel(task.pieces)) peel(task, node);
  if (node.convex) {
    ++counts_.convex_sets;
    nodes_.push_back(node);
    const std::uint64_t after = count_supports(task.pieces);
    counts_.terminates = counts_.terminates && after < before && after < task.most_supports;
    if (task.pieces.empty()) return;
    open.push_back(
        {.pieces = std::move(task.pieces), .parent = number, .depth = task.depth + 1, .seed = scramble(task.seed)});
    return;
  }
  counts_.terminates = counts_.terminates && !task.lies_on_parent;
  task.parent = number;
  separate(std::move(task), node, options, open);
}

/// Moves the triangles on the convex hull from the set to the node; the node is convex if there are any.
void ConvexTree::peel(Task& task, Node& node) {
  const auto begin = static_cast<std::uint32_t>(inward_.size());
  HullSearch hull(pieces_, task.pieces);
  std::vector<std::uint32_t> rest;
  for (const std::uint32_t piece : task.pieces) {
    std::optional<ModelPlane> plane = hull.supporting_plane(piece);
    if (!plane && task.lies_on_parent && pieces_.side(piece, nodes_[task.parent].plane) == PlaneSide::on) {
      plane = nodes_[task.parent].plane;  // the whole set is in front of that plane
    }
    if (plane) {
      inward_.push_back({piece, *plane});
    } else {
      rest.push_back(piece);
    }
  }
  task.pieces = std::move(rest);
  node.begin = begin;
  node.end = static_cast<std::uint32_t>(inward_.size());
  node.convex = node.end > node.begin;
}

/// Separates the set by a plane. `task.parent` is the number that the node gets.
void ConvexTree::separate(Task task, Node& node, const PlaneChoice& options, std::vector<Task>& open) {
  const DividingPlane chosen = choose_plane(pieces_, task.pieces, options, task.seed);
  const std::uint64_t before = count_supports(task.pieces);
  node.plane = chosen.plane;
  Task front, back;
  for (const std::uint32_t piece : task.pieces) {
    switch (pieces_.side(piece, node.plane)) {
      case PlaneSide::on:
      case PlaneSide::front:
        front.pieces.push_back(piece);
        break;
      case PlaneSide::back:
        back.pieces.push_back(piece);
        break;
      case PlaneSide::both:
        back.pieces.push_back(pieces_.cut(piece, node.plane));
        front.pieces.push_back(piece);
        ++counts_.splits;
    }
  }
  const bool free = chosen.face == kNone;
  ++counts_.planes;
  counts_.free_planes += free;
  nodes_.push_back(node);
  const std::uint64_t behind = count_supports(back.pieces);
  counts_.terminates =
      counts_.terminates &&
      (free ? behind <= before && std::max(front.pieces.size(), back.pieces.size()) < task.pieces.size() : behind < before);
  front.lies_on_parent = !free;
  if (!free) front.most_supports = before;
  for (Task* child : {&back, &front}) {
    if (child->pieces.empty()) continue;
    child->parent = task.parent;
    child->front = child == &front;
    child->depth = task.depth + 1;
    child->seed = scramble(task.seed + child->front);
    open.push_back(std::move(*child));
  }
}

std::vector<PartitionNode> ConvexTree::partition() const {
  return partition_nodes(nodes_, [](const Node& node) { return !node.convex; });
}

const MethodTraits& ConvexTree::traits() {
  static const MethodTraits traits{
      .name = "convex-tree",
      .summary = "nested convex sets of triangles with separating planes, compiled once for all viewpoints",
      .products = kStrokes | kRegions | kOrder,
      .paper = "S. Huet, Compilation d'objets 3D, 1994",
      .parameters = kTreeParameters,
      .compiles = true,
      .transparency = TransparencyMode::seen_through};
  return traits;
}

void ConvexTree::report(Statistics& statistics) const {
  statistics.count("convex sets (nodes of type 1)", counts_.convex_sets);
  statistics.count("complexity (nodes of type 2)", counts_.planes);
  statistics.count("of these, planes that contain no face", counts_.free_planes);
}

}  // namespace ligne
