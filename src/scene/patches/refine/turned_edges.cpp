#include "scene/patches/refine/turned_edges.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

namespace ligne {
namespace {

/// Adjustable: number of passes over all triangles. Each turns the edges of a triangle at most once.
constexpr int kMostPasses = 16;

/// A side of a part: the key of its edge, and its number in the part.
struct TurnSide {
  std::uint64_t key;
  std::uint32_t part, side;
  bool operator<(const TurnSide& o) const { return std::pair(key, part) < std::pair(o.key, o.part); }
};

class EdgeTurner {
 public:
  EdgeTurner(std::vector<FacePart>& parts, const std::vector<Point3>& at, const Scene& scene, const Patches& patches)
      : parts_(parts), at_(at), scene_(scene), patches_(patches) {}

  /// Returns whether an edge was turned.
  bool pass() {
    sides_.clear();
    for (std::uint32_t i = 0; i < parts_.size(); ++i) {
      for (std::uint32_t k = 0; k < 3; ++k) sides_.push_back({edge_key(parts_[i].v[k], parts_[i].v[(k + 1) % 3]), i, k});
    }
    std::sort(sides_.begin(), sides_.end());
    is_done_.assign(parts_.size(), 0);
    bool any = false;
    for (std::size_t i = 0; i < sides_.size();) {
      std::size_t k = i + 1;
      while (k < sides_.size() && sides_[k].key == sides_[i].key) ++k;
      if (k - i == 2) any |= turn(sides_[i], sides_[i + 1]);
      i = k;
    }
    return any;
  }

 private:
  /// The cosine of the angle between a triangle and its surface when a new vertex on the surface halves its longest edge.
  double quality(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t face) const {
    const Patch& patch = patches_.list[patches_.patch_of[face]];
    const std::array<Point3, 3> p{at_[a], at_[b], at_[c]};
    std::size_t longest = 0;
    double length = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double side = glm::distance(p[k], p[(k + 1) % 3]);
      if (side > length) length = side, longest = k;
    }
    if (!(length > 0)) return 0;
    const Point3 &from = p[longest], &to = p[(longest + 1) % 3], &apex = p[(longest + 2) % 3];
    const double height = glm::length(glm::cross(to - from, apex - from)) / length;
    const double rise = std::abs(patch.surface.distance(0.5 * (from + to))), slope = std::hypot(height, rise);
    return slope > 0 ? cosine_to_surface(p[0], p[1], p[2], patch) * height / slope : 0;
  }

  bool is_edge(std::uint32_t a, std::uint32_t b) const {
    const auto side = std::lower_bound(sides_.begin(), sides_.end(), TurnSide{edge_key(a, b), 0, 0});
    return side != sides_.end() && side->key == edge_key(a, b);
  }

  bool turn(const TurnSide& first, const TurnSide& second) {
    FacePart &p = parts_[first.part], &q = parts_[second.part];
    const std::uint32_t patch = patches_.patch_of[p.face];
    if (is_done_[first.part] || is_done_[second.part] || patch == kNone || patch != patches_.patch_of[q.face]) return false;
    const std::vector<std::uint32_t>& material = scene_.face_material;
    if (!material.empty() && material[p.face] != material[q.face]) return false;
    const std::uint32_t a = p.v[first.side], b = p.v[(first.side + 1) % 3], c = p.v[(first.side + 2) % 3];
    const std::uint32_t d = q.v[(second.side + 2) % 3];
    if (q.v[second.side] != b || c == d) return false;
    const double now = std::min(quality(a, b, c, p.face), quality(b, a, d, p.face));
    if (now >= kLeastPartCosine || std::min(quality(a, d, c, p.face), quality(d, b, c, p.face)) <= now) return false;
    if (is_edge(c, d)) return false;
    p.v = {a, d, c};
    q.v = {d, b, c};
    p.is_turned = q.is_turned = true;
    is_done_[first.part] = is_done_[second.part] = 1;
    return true;
  }

  std::vector<FacePart>& parts_;
  const std::vector<Point3>& at_;
  const Scene& scene_;
  const Patches& patches_;
  std::vector<TurnSide> sides_;
  std::vector<std::uint8_t> is_done_;  ///< per part: 1 if it has changed in this pass
};

}  // namespace

double cosine_to_surface(const Point3& a, const Point3& b, const Point3& c, const Patch& patch) {
  const Point3 area = glm::cross(b - a, c - a);
  const double size = glm::length(area);
  if (!(size > 0)) return 0;
  return glm::dot(area, patch.surface.normal((a + b + c) / 3.0)) / (patch.outward ? size : -size);
}

void turn_slivers(std::vector<FacePart>& parts, const std::vector<Point3>& at, const Scene& scene, const Patches& patches) {
  EdgeTurner turner(parts, at, scene, patches);
  for (int pass = 0; pass < kMostPasses && turner.pass(); ++pass) {
  }
}

}  // namespace ligne
