// The vertices that stay are kept in a hashed grid (near_cells.hpp). Since they are farther apart than the distance, a
// cell holds only a few of them.

#include "scene/clean/weld_near.hpp"

#include <bit>
#include <glm/geometric.hpp>
#include <vector>

#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "scene/clean/near_cells.hpp"

namespace ligne {
namespace {

class NearVertices {
 public:
  /// `count`: largest number of vertices that will be added.
  NearVertices(std::vector<Point3>& vertices, double distance, std::size_t count)
      : vertices_(vertices), distance_(distance), heads_(std::bit_ceil(count + 1), kNone) {}

  /// Moves vertex v onto one that stays, or adds it to those.
  void take(std::uint32_t v) {
    const Point3 p = vertices_[v];
    const NearCells cells(p, distance_);
    if (!cells.finite()) return;
    const auto slots = cells.slots(heads_.size());
    for (const std::size_t slot : slots) {
      std::uint32_t link = heads_[slot];
      for (; link != kNone; link = links_[link].next) {
        const Point3 there = links_[link].position;
        if (glm::distance(there, p) > distance_) continue;
        vertices_[v] = there;
        return;
      }
    }
    std::uint32_t& head = heads_[slots[0]];
    links_.push_back({p, head});
    head = static_cast<std::uint32_t>(links_.size() - 1);
  }

 private:
  struct Link {
    Point3 position;  ///< of a vertex that stays
    std::uint32_t next;
  };

  std::vector<Point3>& vertices_;
  double distance_;
  std::vector<std::uint32_t> heads_;  ///< per slot: the first link of the vertices in its cells
  std::vector<Link> links_;
};

}  // namespace

void weld_near_vertices(Scene& scene, double distance) {
  const auto weld = [&](std::uint32_t begin, std::uint32_t end) {
    NearVertices near(scene.vertices, distance, end - begin);
    for (std::uint32_t v = begin; v < end; ++v) near.take(v);
  };
  if (scene.objects.empty()) {
    weld(0, static_cast<std::uint32_t>(scene.vertices.size()));
    return;
  }
  parallel_for(scene.objects.size(),
               [&](std::size_t i) { weld(scene.objects[i].vertex_begin, scene.objects[i].vertex_end); });
}

}  // namespace ligne
