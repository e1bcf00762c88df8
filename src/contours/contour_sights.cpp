#include "contours/contour_sights.hpp"

#include <algorithm>

#include <glm/geometric.hpp>

#include "base/no_index.hpp"
#include "base/parallel.hpp"

namespace ligne {
namespace {

// Adjustable parameters.
/// Number of segments before and behind over which slopes are averaged, so that single triangles of a noisy mesh make
/// no cusp.
constexpr std::size_t kSlopeWindow = 3;
/// Number of edges by which a search follows the outline away from the triangles at a segment.
constexpr int kOutlineSteps = 3;
/// Least cosine on the page between a normal and the direction across its segment. Below it the normal is wrong, or a
/// cusp is near.
constexpr double kLeastAcross = 0.5;

constexpr std::size_t kNoNode = static_cast<std::size_t>(-1);

class Sights {
 public:
  Sights(const SightScene& in, const ContourChain& chain, std::vector<ReachedSectors>& reached)
      : scene_(in.scene),
        view_(in.view),
        patch_(in.patch),
        outline_(in.outline),
        chain_(chain),
        slack_mm_(in.slack_mm),
        reached_(reached) {}

  std::vector<ContourSight> find() {
    std::vector<ContourSight> sights(chain_.size());
    const std::vector<int> free_side = free_sides();
    parallel_blocks(sights.size(), kSearchBlock, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) sights[i] = sight(i, free_side[i]);
    });
    return sights;
  }

 private:
  std::uint32_t vertex(std::uint32_t corner) const { return patch_.triangles[corner / 3].v[corner % 3]; }
  const Point3& point(std::uint32_t corner) const { return scene_.vertices[vertex(corner)]; }

  /// Cosine between the direction in which g grows fastest over the triangle and the direction to the eye.
  double slope(std::uint32_t t) const {
    const Point3 &a = point(3 * t), &b = point(3 * t + 1), &c = point(3 * t + 2);
    const Point3 area = glm::cross(b - a, c - a);
    const auto g = [&](std::uint32_t corner) { return patch_.g[patch_.sector[corner]]; };
    const Point3 along = g(3 * t) * (c - b) + g(3 * t + 1) * (a - c) + g(3 * t + 2) * (b - a);
    const Point3 gradient = glm::cross(area, along);
    const Point3 eye = to_eye(view_.camera, a);
    const double size = glm::length(gradient) * glm::length(eye);
    return size > 0 ? glm::dot(gradient, eye) / size : 0;
  }

  std::vector<int> free_sides() const {
    const std::size_t n = chain_.size();
    std::vector<double> weighted(n);
    for (std::size_t i = 0; i < n; ++i) {
      const ContourNode &a = chain_.nodes[i], &b = chain_.nodes[i + 1];
      const bool known = a.tangent != Point3(0.0) && b.tangent != Point3(0.0);
      weighted[i] = (known ? (a.radial + b.radial) / 2 : slope(chain_.triangles[i])) *
                    glm::length(chain_.nodes[i + 1].on_mesh - chain_.nodes[i].on_mesh);
    }
    std::vector<int> side(n);
    for (std::size_t i = 0; i < n; ++i) {
      double sum = weighted[i];
      for (std::size_t k = 1; k <= kSlopeWindow; ++k) {
        if (chain_.closed && n > 2 * kSlopeWindow) {
          sum += weighted[(i + k) % n] + weighted[(i + n - k) % n];
        } else {
          if (i + k < n) sum += weighted[i + k];
          if (i >= k) sum += weighted[i - k];
        }
      }
      side[i] = sum >= 0 ? 1 : -1;
    }
    move_to_cusps(side);
    return side;
  }

  /// The node of a number, which may lie beyond the ends of a closed chain; kNoNode beyond those of an open one.
  std::size_t node_at(std::ptrdiff_t number) const {
    const auto n = static_cast<std::ptrdiff_t>(chain_.size());
    if (chain_.closed) return static_cast<std::size_t>((number % n + n) % n);
    return number < 0 || number > n ? kNoNode : static_cast<std::size_t>(number);
  }

  /// Whether the contour turns back on the page at a node. The turn may be shared with the node beside it.
  bool turns_back(std::ptrdiff_t number) const {
    const std::size_t before = node_at(number - 2), node = node_at(number), after = node_at(number + 2);
    if (before == kNoNode || node == kNoNode || after == kNoNode) return false;
    const auto at = [&](std::size_t k) { return page_point(view_, chain_.nodes[k].on_mesh); };
    return glm::dot(at(node) - at(before), at(after) - at(node)) < 0;
  }

  /// The number nearest to i for which is_cusp(number) holds, at most kSlopeWindow away; i if there is none.
  template <class IsCusp>
  std::ptrdiff_t nearest_cusp(std::ptrdiff_t i, const IsCusp& is_cusp) const {
    for (std::ptrdiff_t away = 0; away <= static_cast<std::ptrdiff_t>(kSlopeWindow); ++away) {
      for (const std::ptrdiff_t number : {i - away, i + away}) {
        if (is_cusp(number)) return number;
      }
    }
    return i;
  }

  /// Moves changes of side to a cusp nearby, since averages change a few segments beside it: to one of the fitted surface,
  /// else to where the contour turns back on the page.
  void move_to_cusps(std::vector<int>& side) const {
    const auto n = static_cast<std::ptrdiff_t>(side.size());
    if (n <= static_cast<std::ptrdiff_t>(2 * kSlopeWindow)) return;
    const std::vector<int> averaged = side;
    const auto is_cusp = [&](std::ptrdiff_t number) {
      const std::size_t node = node_at(number);
      return node != kNoNode && chain_.nodes[node].is_cusp();
    };
    for (std::ptrdiff_t i = chain_.closed ? 0 : 1; i < n; ++i) {
      const int before = averaged[node_at(i - 1)], after = averaged[i];
      if (before == after) continue;
      std::ptrdiff_t place = nearest_cusp(i, is_cusp);
      if (!is_cusp(place)) place = nearest_cusp(i, [&](std::ptrdiff_t number) { return turns_back(number); });
      for (std::ptrdiff_t k = i; k < place && k < i + n; ++k) side[node_at(k)] = before;
      for (std::ptrdiff_t k = place; k < i; ++k) side[node_at(k)] = after;
    }
  }

  ContourSight sight(std::size_t i, int side) const {
    const ContourNode &a = chain_.nodes[i], &b = chain_.nodes[i + 1];
    const Point2 pa = page_direction(view_, a.on_mesh, a.normal), pb = page_direction(view_, b.on_mesh, b.normal);
    const Point2 mean = double(side) * (pa + pb);
    const double size = glm::length(mean);
    if (!(size > 0)) return {a.on_mesh, b.on_mesh, side};
    const Protrusion beyond = protrusion(i, mean / size);
    // Moves a node along its own normal, far enough across the segment.
    const auto moved = [&](const ContourNode& node, Point2 on_page) {
      const double unit_mm = glm::length(page_direction(view_, node.on_mesh, view_.camera.right));
      const double across_mm = double(side) * glm::dot(on_page, beyond.across);
      const double by_normal = std::max(across_mm, kLeastAcross * unit_mm);
      return node.on_mesh + (side * (slack_mm_ + beyond.mm) / by_normal) * node.normal;
    };
    return {moved(a, pa), moved(b, pb), side};
  }

  /// How far the outline of the mesh rises beyond a segment.
  struct Protrusion {
    double mm;      ///< not below 0
    Point2 across;  ///< direction in which it is measured: across the segment
  };

  /// The protrusion of segment i, on the side of the page to which `out` points.
  Protrusion protrusion(std::size_t i, Point2 out) const {
    const Point2 q0 = page_point(view_, chain_.nodes[i].on_mesh), q1 = page_point(view_, chain_.nodes[i + 1].on_mesh);
    const double length = glm::length(q1 - q0);
    Point2 along = length > 0 ? (q1 - q0) / length : Point2{-out.y, out.x};
    Point2 across{-along.y, along.x};
    if (glm::dot(across, out) < 0) across = -across;
    if (glm::dot(across, out) < kLeastAcross) {  // the contour runs along its normal: near a cusp
      across = out;
      along = {-out.y, out.x};
    }
    double highest = 0;
    const auto rise = [&](Point2 p, Point2 q) {  // raises `highest` to the part of an edge beside the segment
      double sp = glm::dot(p - q0, along), sq = glm::dot(q - q0, along);
      double hp = glm::dot(p - q0, across), hq = glm::dot(q - q0, across);
      if (sp > sq) std::swap(sp, sq), std::swap(hp, hq);
      const double from = std::max(sp, -length), to = std::min(sq, 2 * length);
      if (from > to) return;
      const auto at = [&](double s) { return sq > sp ? hp + (s - sp) / (sq - sp) * (hq - hp) : std::max(hp, hq); };
      highest = std::max({highest, at(from), at(to)});
    };
    for_outline_near(chain_.triangles[i], [&](const OutlineGraph::End& e) { rise(e.p, e.q); });
    return {highest, across};
  }

  /// Calls visit(end) for the edges of the mesh's outline near a triangle, each once: those at its corners and at the
  /// corners of its neighbours, and those that continue them.
  template <class Visit>
  void for_outline_near(std::uint32_t t, Visit visit) const {
    ReachedSectors& reached = reached_[thread_index()];
    reached.clear(patch_.normals.size());
    for (std::uint32_t k = 3 * t; k < 3 * t + 3; ++k) {
      reached.add(patch_.sector[k]);
      if (patch_.across[k] != kNone) reached.add(patch_.sector[previous_corner(patch_.across[k])]);
    }
    std::size_t begin = 0;
    for (int step = 0; step < kOutlineSteps; ++step) {
      const std::size_t end = reached.size();
      for (std::size_t i = begin; i < end; ++i) {
        for (const OutlineGraph::End& e : outline_.at(reached[i])) {
          if (reached.add(e.other) >= i) visit(e);
        }
      }
      begin = end;
    }
  }

  const Scene& scene_;
  const View& view_;
  const SmoothPatch& patch_;
  const OutlineGraph& outline_;
  const ContourChain& chain_;
  double slack_mm_;
  std::vector<ReachedSectors>& reached_;
};

}  // namespace

OutlineGraph::OutlineGraph(const Scene& scene, const View& view, const SmoothPatch& patch,
                           const std::vector<OutlineSide>& sides)
    : ends_(patch.normals.size(), [&](const auto& put) {
        for (const OutlineSide& s : sides) {
          const std::uint32_t a = patch.sector[s.side], b = patch.sector[next_corner(s.side)];
          const auto& v = patch.triangles[s.side / 3].v;
          const Point2 p = page_point(view, scene.vertices[v[s.side % 3]]);
          const Point2 q = page_point(view, scene.vertices[v[(s.side + 1) % 3]]);
          put(a, {a, b, p, q});
          put(b, {b, a, q, p});
        }
      }) {}

std::vector<ContourSight> contour_sights(const SightScene& in, const ContourChain& chain,
                                         std::vector<ReachedSectors>& reached) {
  return Sights(in, chain, reached).find();
}

Point2 page_direction(const View& view, const Point3& p, const Point3& n) {
  const Camera& camera = view.camera;
  const Point2 d{glm::dot(camera.right, n), glm::dot(camera.down, n)};
  if (!camera.perspective) return view.scale * d;
  const Point3 c = camera_coordinates(camera, p);
  const double forward = glm::dot(camera.forward, n);
  return (view.scale * camera.target_distance / c.z) * Point2{d.x - c.x / c.z * forward, d.y - c.y / c.z * forward};
}

}  // namespace ligne
