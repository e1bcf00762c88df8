// The vertices that stay are kept in a hashed grid of cells two distances wide, as in clean/weld.cpp: everything
// near enough to a vertex lies in its own cell or beyond the cell's nearer walls. Many vertices that must not be joined
// can lie in one cell. Only kMostTried of them are tested, so that time grows with the number of vertices.

#include <bit>
#include <glm/geometric.hpp>
#include <numeric>

#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "scene/clean/compact.hpp"
#include "scene/clean/near_cells.hpp"
#include "scene/heal/border_edges.hpp"
#include "scene/heal/border_gaps.hpp"
#include "scene/heal/corner_uses.hpp"
#include "scene/heal/sew_borders.hpp"

namespace ligne {
namespace {

/// Largest number of vertices tested per search. Adjustable.
constexpr int kMostTried = 64;

class Joiner {
 public:
  Joiner(const Scene& scene, const Object& object, std::span<const std::uint32_t> faces, const Border& border,
         double distance, std::vector<std::uint32_t>& target)
      : scene_(scene),
        distance_(distance),
        precision_(object.precision),
        target_(target),
        uses_(scene, object, faces, border.vertices()) {
    heads_.assign(std::bit_ceil(border.vertices().size() + 1), kNone);
  }

  /// Joins vertex v to one that stays, or adds it to those.
  bool take(std::uint32_t v) {
    const Point3 p = scene_.vertices[v];
    const auto slots = NearCells(p, distance_).slots(heads_.size());
    std::uint32_t best = kNone;
    double best_distance = distance_;
    int tried = 0;
    for (const std::size_t slot : slots) {
      std::uint32_t link = heads_[slot];
      for (; link != kNone && tried < kMostTried; link = links_[link].next, ++tried) {
        const std::uint32_t w = links_[link].vertex;
        const double d = glm::distance(scene_.vertices[w], p);
        if (d > best_distance || (d == best_distance && best != kNone && best <= w)) continue;
        if (may_join(v, w)) best = w, best_distance = d;
      }
    }
    if (best != kNone) {
      target_[v] = best;
      return true;
    }
    std::uint32_t& head = heads_[slots[0]];
    links_.push_back({v, head});
    head = static_cast<std::uint32_t>(links_.size() - 1);
    return false;
  }

 private:
  struct Link {
    std::uint32_t vertex, next;
  };

  /// Whether no face of v loses a corner, and no triangle turns over, when v moves to w.
  bool may_join(std::uint32_t v, std::uint32_t w) const {
    const auto& points = scene_.vertices;
    for (const CornerUse& use : uses_.of(v)) {
      const std::uint32_t before = target_[use.before], after = target_[use.after];
      if (before == w || after == w) return false;
      if (use.triangle && turns_over(points[v], points[w], points[before], points[after], precision_)) return false;
    }
    return true;
  }

  const Scene& scene_;
  double distance_, precision_;
  std::vector<std::uint32_t>& target_;  ///< per vertex of the scene: the vertex that it moved to, or itself
  CornerUses uses_;
  std::vector<std::uint32_t> heads_;  ///< per slot: the first link of the vertices in its cells
  std::vector<Link> links_;
};

/// Keeps the marks of the vertices that stay.
void keep_marks(std::vector<std::uint8_t>& marks, const std::vector<std::uint32_t>& target) {
  std::size_t left = 0;
  for (std::uint32_t v = 0; v < target.size(); ++v) {
    marks[left] = marks[v];
    left += target[v] == v;
  }
  marks.resize(left);
}

}  // namespace

std::size_t join_border_vertices(Scene& scene, std::span<const std::unique_ptr<Border>> borders, Sewing& sewing) {
  sewing.settled.assign(scene.vertices.size(), 0);
  std::vector<std::uint32_t> target(scene.vertices.size());
  std::iota(target.begin(), target.end(), 0u);
  std::vector<std::size_t> moved(scene.objects.size(), 0);
  parallel_tasks(scene.objects.size(), [&](std::size_t i) {
    if (!borders[i]) return;
    const Object& object = scene.objects[i];
    Joiner joiner(scene, object, faces_of(object, sewing.faces), *borders[i], sewing.distances[i], target);
    for (const std::uint32_t v : borders[i]->vertices()) {
      if (!joiner.take(v)) continue;
      sewing.settled[target[v]] = 1;
      ++moved[i];
    }
  });
  const std::size_t sum = std::accumulate(moved.begin(), moved.end(), std::size_t{0});
  if (sum == 0) return 0;
  constexpr std::size_t kParts = 3;
  parallel_tasks(kParts, [&](std::size_t part) {
    if (part == 0) merge_vertices(scene, target);
    if (part == 1) keep_marks(sewing.settled, target);
    if (part == 2) keep_marks(sewing.may_be_on_border, target);
  });
  return sum;
}

}  // namespace ligne
