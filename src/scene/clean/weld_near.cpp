// The vertices that stay where they are stand in a hashed grid of cells two distances wide, so that whatever is near
// enough to a vertex lies in its own cell or in those beyond its nearer walls: eight cells. Since those that stay are
// farther apart than the distance, a cell holds a few of them only, however wide it is.

#include "scene/clean/weld_near.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "geometry/parallel.hpp"

namespace ligne {
namespace {

class NearVertices {
 public:
  /// `count`: vertices that will be taken, at most.
  NearVertices(std::vector<Point3>& vertices, double distance, std::size_t count)
      : vertices_(vertices), distance_(distance), heads_(std::bit_ceil(count + 1), kNone) {}

  /// Moves vertex v onto one that stays, or lets it stay.
  void take(std::uint32_t v) {
    const Point3 p = vertices_[v];
    std::array<std::array<double, 2>, 3> cells;  // per axis: the own cell, and that beyond the nearer wall
    for (int axis = 0; axis < 3; ++axis) {
      const double position = p[axis] / (2 * distance_);
      if (!std::isfinite(position)) return;
      const double cell = std::floor(position);
      cells[axis] = {cell, position - cell < 0.5 ? cell - 1 : cell + 1};
    }
    for (unsigned k = 0; k < 8; ++k) {
      std::uint32_t link = heads_[slot(cells[0][k & 1], cells[1][k >> 1 & 1], cells[2][k >> 2])];
      for (; link != kNone; link = links_[link].next) {
        const Point3 there = links_[link].position;
        if (glm::distance(there, p) > distance_) continue;
        vertices_[v] = there;
        return;
      }
    }
    std::uint32_t& head = heads_[slot(cells[0][0], cells[1][0], cells[2][0])];
    links_.push_back({p, head});
    head = static_cast<std::uint32_t>(links_.size() - 1);
  }

 private:
  struct Link {
    Point3 position;  ///< of a vertex that stays
    std::uint32_t next;
  };

  /// Cells that share a slot only cost time: distances are looked at.
  std::size_t slot(double x, double y, double z) const {
    std::uint64_t k = 0;
    for (const double cell : {x, y, z}) {
      k = (std::rotl(k, 23) ^ std::bit_cast<std::uint64_t>(cell + 0.0)) * 0x9e3779b97f4a7c15u;
      k ^= k >> 29;
    }
    return k & (heads_.size() - 1);
  }

  std::vector<Point3>& vertices_;
  double distance_;
  std::vector<std::uint32_t> heads_;  ///< by slot: the first of the links of the vertices in its cells
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
