// The edges of scenes so large that they are filed in several parts, against a plain table of them.

#include "scene/model/topology.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "geometry/parallel.hpp"

namespace ligne {
namespace {

/// Of each edge the faces in their order, each with whether it runs through the edge from the lower vertex, and the flags
/// of its corner there.
struct Side {
  std::uint32_t face;
  bool upwards;
  std::uint8_t flags;
};
using EdgeTable = std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<Side>>;

EdgeTable edge_table(const Scene& scene) {
  EdgeTable table;
  for (std::uint32_t f = 0; f < scene.faces.size(); ++f) {
    for (std::size_t c = 0; c < scene.faces.contour_count(f); ++c) {
      const auto contour = scene.faces.contour(f, c);
      for (std::size_t k = 0; k < contour.size(); ++k) {
        const std::uint32_t a = contour[k], b = contour[(k + 1) % contour.size()];
        const std::size_t corner = scene.faces.corner_index(f, c) + k;
        const std::uint8_t flags = scene.corner_flags.empty() ? std::uint8_t{0} : scene.corner_flags[corner];
        table[std::minmax(a, b)].push_back({f, a < b, flags});
      }
    }
  }
  return table;
}

void expect_edges(const Scene& scene) {
  const EdgeTable table = edge_table(scene);
  for (const unsigned threads : {1u, 3u}) {
    Topology topology;
    run_with_threads(threads, [&] { topology = build_topology(scene); });
    ASSERT_EQ(topology.edges.size(), table.size());
    std::size_t e = 0, wrong = 0;
    for (const auto& [ends, sides] : table) {
      const Edge& edge = topology.edges[e];
      const std::uint16_t flags = topology.edge_flags[e++];
      wrong += edge.v0 != ends.first || edge.v1 != ends.second || edge.face0 != sides[0].face;
      wrong += edge.face1 != (sides.size() > 1 ? sides[1].face : kNone);
      wrong += ((flags & kEdgeManyFaces) != 0) != (sides.size() > 2);
      wrong += ((flags & kEdgeUnlikeWound) != 0) != (sides.size() == 2 && sides[0].upwards == sides[1].upwards);
      wrong += ((flags & kEdgeSharp) != 0) != std::ranges::any_of(sides, [](const Side& s) { return s.flags != 0; });
    }
    EXPECT_EQ(wrong, 0u) << threads << " threads";
  }
}

/// Triangles anywhere among neighbouring vertices, and some that reach over all of them.
Scene random_mesh(std::uint32_t vertices, std::uint32_t faces) {
  std::mt19937 random(3);
  const auto below = [&](std::uint32_t n) { return static_cast<std::uint32_t>(random() % n); };
  Scene scene;
  for (std::uint32_t v = 0; v < vertices; ++v) scene.vertices.emplace_back(v, v % 1000, v % 31);
  while (scene.faces.size() < faces) {
    const std::uint32_t first = below(vertices), reach = below(50) == 0 ? vertices : 6;
    std::array<std::uint32_t, 3> t{};
    for (std::uint32_t& v : t) v = (first + below(reach)) % vertices;
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) scene.faces.add_triangle(t[0], t[1], t[2]);
  }
  return scene;
}

TEST(Topology, EdgesOfManyParts) { expect_edges(random_mesh(60'000, 150'000)); }

TEST(Topology, EdgesWithFlagsOfManyParts) {
  Scene scene = random_mesh(60'000, 150'000);
  for (std::size_t k = 0; k < scene.faces.corners().size(); ++k) {
    scene.corner_flags.push_back(static_cast<std::uint8_t>(k % 7 == 0 ? kCornerSharp : 0));
  }
  expect_edges(scene);
}

TEST(Topology, EdgesOfPolygonsOfManyParts) {
  Scene scene = random_mesh(60'000, 100'000);
  for (std::uint32_t v = 0; v + 4 < 60'000; v += 3) scene.faces.add_face(std::array{v, v + 1, v + 4, v + 2});
  expect_edges(scene);
}

TEST(Topology, AHubOfManyFaces) {
  Scene scene = random_mesh(20'000, 20'000);
  for (std::uint32_t v = 1; v + 1 < 20'000; ++v) scene.faces.add_triangle(v + 1, 0, v);
  expect_edges(scene);
}

}  // namespace
}  // namespace ligne
