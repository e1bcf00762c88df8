// Two closed convex sets have no common point if a plane, or in some projection a line, lies strictly between them. The
// code below looks for such a plane or line:
//
//   plane of a triangle                     signs of plane_side()
//   plane through an edge and a side        the same: a line that has a side of a triangle on its left and another one on
//                                           its right passes the triangle by
//   line in a projection along an axis      orientation_sign(), which is exact; this distinguishes coplanar triangles
//
// So "apart" is always proven; if signs are uncertain, the answer is "not apart".

#include "scene/model/self_contact.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <utility>

#include "base/index_lists.hpp"
#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "base/parallel_each.hpp"
#include "geometry/predicates.hpp"

namespace ligne {
namespace {

// Adjustable.
constexpr std::size_t kLeaf = 4;  ///< largest number of triangles in a leaf of the tree

using Corner = std::array<float, 3>;

/// A bounding box in single precision, rounded outwards.
struct Box {
  Corner low, high;

  bool meets(const Box& o) const {
    return low[0] <= o.high[0] && o.low[0] <= high[0] && low[1] <= o.high[1] && o.low[1] <= high[1] && low[2] <= o.high[2] &&
           o.low[2] <= high[2];
  }
  void extend(const Box& o) {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], o.low[i]);
      high[i] = std::max(high[i], o.high[i]);
    }
  }
};

float rounded_down(double v) {
  const auto f = static_cast<float>(v);
  return double(f) > v ? std::nextafter(f, -std::numeric_limits<float>::infinity()) : f;
}
float rounded_up(double v) { return -rounded_down(-v); }

/// A triangle and its box.
struct Item {
  Box box;
  std::uint32_t triangle;
};

/// The tree of one surface, stored as a heap: the children of node i are 2 i + 1 and 2 i + 2.
class SelfSearch {
 public:
  SelfSearch(std::span<const Point3> vertices, std::span<const Triangle> triangles, std::span<const std::uint32_t> own)
      : vertices_(vertices), triangles_(triangles), items_(own.size()) {
    parallel_each(own.size(), [&](std::size_t i) { items_[i] = {box_of(own[i]), own[i]}; });
    std::size_t nodes = 1;
    for (std::size_t n = own.size(); n > kLeaf; n -= n / 2) nodes = 2 * nodes + 1;
    boxes_.resize(nodes);
    build({0, 0, own.size()});
  }

  bool run() {
    within({0, 0, items_.size()});
    return found_;
  }

 private:
  struct Node {
    std::size_t number, begin, end;
    std::size_t size() const { return end - begin; }
    bool leaf() const { return size() <= kLeaf; }
    Node first() const { return {2 * number + 1, begin, begin + size() / 2}; }
    Node second() const { return {2 * number + 2, begin + size() / 2, end}; }
  };

  Box box_of(std::uint32_t triangle) const {
    const auto& v = triangles_[triangle].v;
    const Point3 &a = vertices_[v[0]], &b = vertices_[v[1]], &c = vertices_[v[2]];
    Box box;
    for (int i = 0; i < 3; ++i) {
      box.low[static_cast<std::size_t>(i)] = rounded_down(std::min({a[i], b[i], c[i]}));
      box.high[static_cast<std::size_t>(i)] = rounded_up(std::max({a[i], b[i], c[i]}));
    }
    return box;
  }

  template <class First, class Second>
  static void both(std::size_t size, First first, Second second) {
    if (size > kShortWorkBlock) {
      parallel_tasks(2, [&](std::size_t half) { half == 0 ? first() : second(); });
    } else {
      first();
      second();
    }
  }

  void build(const Node& node) {
    Box box = items_[node.begin].box;
    for (std::size_t i = node.begin + 1; i < node.end; ++i) box.extend(items_[i].box);
    boxes_[node.number] = box;
    if (node.leaf()) return;
    const auto size = [&](std::size_t i) { return box.high[i] - box.low[i]; };
    const std::size_t axis = size(0) >= size(1) && size(0) >= size(2) ? 0 : size(1) >= size(2) ? 1 : 2;
    const auto at = [&](std::size_t i) { return items_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(node.begin), at(node.second().begin), at(node.end), [axis](const Item& a, const Item& b) {
      const float p = a.box.low[axis] + a.box.high[axis], q = b.box.low[axis] + b.box.high[axis];
      return p != q ? p < q : a.triangle < b.triangle;
    });
    both(
        node.size(), [&] { build(node.first()); }, [&] { build(node.second()); });
  }

  /// Tests all pairs within the node.
  void within(const Node& node) {
    if (found_) return;
    if (node.leaf()) {
      for (std::size_t i = node.begin; i < node.end; ++i) {
        for (std::size_t k = i + 1; k < node.end; ++k) test(items_[i], items_[k]);
      }
      return;
    }
    both(
        node.size(), [&] { within(node.first()); }, [&] { within(node.second()); });
    between(node.first(), node.second());
  }

  /// Tests all pairs of one triangle from each node.
  void between(const Node& a, const Node& b) {
    if (found_ || !boxes_[a.number].meets(boxes_[b.number])) return;
    if (a.leaf() && b.leaf()) {
      for (std::size_t i = a.begin; i < a.end; ++i) {
        for (std::size_t k = b.begin; k < b.end; ++k) test(items_[i], items_[k]);
      }
    } else if (b.leaf() || (!a.leaf() && a.size() >= b.size())) {
      both(
          a.size(), [&] { between(a.first(), b); }, [&] { between(a.second(), b); });
    } else {
      both(
          b.size(), [&] { between(a, b.first()); }, [&] { between(a, b.second()); });
    }
  }

  void test(const Item& first, const Item& second) {
    if (!first.box.meets(second.box)) return;
    const Triangle &t = triangles_[first.triangle], &u = triangles_[second.triangle];
    if (t.face == u.face) return;
    // Moves the common vertices to the front.
    std::array<std::uint32_t, 3> tv = t.v, uv = u.v;
    int shared = 0;
    for (int i = 0; i < 3; ++i) {
      for (int k = shared; k < 3; ++k) {
        if (tv[i] != uv[k]) continue;
        std::swap(tv[i], tv[shared]);
        std::swap(uv[k], uv[shared]);
        ++shared;
        break;
      }
    }
    const Corners3 a{vertices_[tv[0]], vertices_[tv[1]], vertices_[tv[2]]};
    const Corners3 b{vertices_[uv[0]], vertices_[uv[1]], vertices_[uv[2]]};
    if (!are_apart(a, b, shared) && !has_no_area(a) && !has_no_area(b)) found_ = true;
  }

  std::span<const Point3> vertices_;
  std::span<const Triangle> triangles_;
  std::vector<Item> items_;  ///< in the order of the tree
  std::vector<Box> boxes_;
  std::atomic<bool> found_ = false;  ///< ends the search at the first contact
};

/// Relative error bound of the determinant of three differences, as a part of the sum of the sizes of its terms
/// (Shewchuk 1997, "o3derrboundA"), and an absolute bound on the loss by underflow: four products of two differences,
/// below 2^-1074 each, times differences below 2^202 (kLargestCoordinate).
constexpr double kPlaneSideErrorBound = (7.0 + 56.0 * 0x1p-53) * 0x1p-53;
constexpr double kUnderflow = 0x1p-868;

Point2 flat(const Point3& p, int axis) { return {p[(axis + 1) % 3], p[(axis + 2) % 3]}; }

/// Whether the segment and the triangle have no common point in the projection along the axis.
bool apart_in_projection(const Point3& p, const Point3& q, const Corners3& t, int axis) {
  const Point2 p2 = flat(p, axis), q2 = flat(q, axis);
  const std::array<Point2, 3> c{flat(t[0], axis), flat(t[1], axis), flat(t[2], axis)};
  const int turn = orientation_sign(c[0], c[1], c[2]);
  for (int i = 0; i < 3 && turn != 0; ++i) {
    const Point2 a = c[i], b = c[(i + 1) % 3];
    if (orientation_sign(a, b, p2) * turn < 0 && orientation_sign(a, b, q2) * turn < 0) return true;
  }
  const int side = orientation_sign(p2, q2, c[0]);
  return side != 0 && orientation_sign(p2, q2, c[1]) == side && orientation_sign(p2, q2, c[2]) == side;
}

bool segment_apart(const Point3& p, const Point3& q, const Corners3& t) {
  const int of_p = plane_side(t[0], t[1], t[2], p), of_q = plane_side(t[0], t[1], t[2], q);
  if (of_p * of_q > 0) return true;
  if (of_p != 0 || of_q != 0) {
    bool left = false, right = false;
    for (int i = 0; i < 3; ++i) {
      const int side = plane_side(p, q, t[i], t[(i + 1) % 3]);
      left = left || side < 0;
      right = right || side > 0;
    }
    if (left && right) return true;
  }
  return apart_in_projection(p, q, t, 0) || apart_in_projection(p, q, t, 1) || apart_in_projection(p, q, t, 2);
}

/// Whether the corners of u from `first` on lie strictly on one side of the plane of t.
bool beside(const Corners3& t, const Corners3& u, int first) {
  const int side = plane_side(t[0], t[1], t[2], u[first]);
  for (int i = first + 1; i < 3 && side != 0; ++i) {
    if (plane_side(t[0], t[1], t[2], u[i]) != side) return false;
  }
  return side != 0;
}

/// Whether triangles with a common side are apart: in different planes, or on different sides of it in one plane.
bool apart_beyond_side(const Corners3& t, const Corners3& u) {
  if (plane_side(t[0], t[1], t[2], u[2]) != 0) return true;
  for (int axis = 0; axis < 3; ++axis) {
    const Point2 a = flat(t[0], axis), b = flat(t[1], axis);
    if (orientation_sign(a, b, flat(t[2], axis)) * orientation_sign(a, b, flat(u[2], axis)) < 0) return true;
  }
  return false;
}

}  // namespace

std::vector<std::uint8_t> find_self_contacts(std::span<const Point3> vertices, std::span<const Triangle> triangles,
                                             std::span<const std::uint32_t> surface, std::uint32_t surface_count) {
  const IndexLists own(surface_count, [&](const auto& add) {
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
      if (surface[t] != kNone) add(surface[t], t);
    }
  });
  std::vector<std::uint8_t> result(surface_count, 0);
  parallel_for(surface_count, [&](std::size_t s) {
    if (!own[s].empty()) result[s] = SelfSearch(vertices, triangles, own[s]).run();
  });
  return result;
}

int plane_side(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const Point3 p = a - d, q = b - d, r = c - d;
  const double qxry = q.x * r.y, rxqy = r.x * q.y, rxpy = r.x * p.y, pxry = p.x * r.y, pxqy = p.x * q.y, qxpy = q.x * p.y;
  const double det = p.z * (qxry - rxqy) + q.z * (rxpy - pxry) + r.z * (pxqy - qxpy);
  const double size = (std::abs(qxry) + std::abs(rxqy)) * std::abs(p.z) + (std::abs(rxpy) + std::abs(pxry)) * std::abs(q.z) +
                      (std::abs(pxqy) + std::abs(qxpy)) * std::abs(r.z);
  const double bound = kPlaneSideErrorBound * size + kUnderflow;
  return det > bound ? 1 : det < -bound ? -1 : 0;
}

bool are_apart(const Corners3& t, const Corners3& u, int shared) {
  if (shared > 2) return false;
  if (shared == 2) return apart_beyond_side(t, u);
  if (beside(t, u, shared) || beside(u, t, shared)) return true;
  // Common points of two triangles other than a shared corner reach the opposite side of one of them.
  if (shared == 1) return segment_apart(t[1], t[2], u) && segment_apart(u[1], u[2], t);
  for (int i = 0; i < 3; ++i) {
    const int k = (i + 1) % 3;
    if (!segment_apart(t[i], t[k], u) || !segment_apart(u[i], u[k], t)) return false;
  }
  return true;
}

bool has_no_area(const Corners3& t) {
  for (int axis = 0; axis < 3; ++axis) {
    if (orientation_sign(flat(t[0], axis), flat(t[1], axis), flat(t[2], axis)) != 0) return false;
  }
  return true;
}

}  // namespace ligne
