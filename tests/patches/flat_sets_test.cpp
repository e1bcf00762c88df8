/// Limits of the search for planes where coordinates are coarse for their facets.

#include <numeric>

#include "patches/patch_scenes.hpp"
#include "scene/patches/facets/flat_sets.hpp"
#include "support/test.hpp"

namespace ligne::test {
namespace {

/// Ground of n x n squares of side 1 with heights of up to 32 steps, without order; a part of it is level.
Scene rough_ground(int n, double step, int level) {
  std::vector<Corners> polygons;
  add_grid(polygons, n, n, true, [&](int u, int v) {
    const auto mixed = static_cast<std::uint32_t>(u * 73856093) ^ static_cast<std::uint32_t>(v * 19349663);
    const bool is_level = u < level && v < level;
    return Point3(u, v, is_level ? 0 : step * (mixed * 2654435761u >> 27));
  });
  Scene scene = scene_of(polygons);
  scene.objects[0].precision = step / 2;
  return scene;
}

/// The sets of a scene in which each pair of faces seems flat.
FlatSets sets_of(const Scene& scene) {
  const Topology topology = build_topology(scene);
  std::vector<std::uint32_t> joints, order(scene.faces.size());
  for (std::uint32_t e = 0; e < topology.edges.size(); ++e) {
    if (topology.edges[e].face1 != kNone) joints.push_back(e);
  }
  std::iota(order.begin(), order.end(), 0u);
  return flat_sets(scene, scene.objects[0], topology.edges, joints, order);
}

TEST(FlatSets, GiveUpRoughGround) {
  const Scene scene = rough_ground(300, 0.1, 0);
  const FlatSets sets = sets_of(scene);
  EXPECT_GT(sets.looks, 5'400'000u) << "no search that must be ended";
  EXPECT_LT(sets.looks, 6'000'000u);
  EXPECT_FALSE(sets.has_small_faces);
  std::vector<std::uint32_t> own(scene.faces.size());
  std::iota(own.begin(), own.end(), 0u);
  EXPECT_EQ(sets.set_of, own);
}

TEST(FlatSets, FindTheLevelPartOfRoughGround) {
  const FlatSets sets = sets_of(rough_ground(200, 0.1, 60));
  std::vector<std::size_t> sizes(sets.set_of.size(), 0);
  for (const std::uint32_t set : sets.set_of) ++sizes[set];
  const std::size_t largest = *std::max_element(sizes.begin(), sizes.end());
  EXPECT_GE(largest, 2u * 59 * 59);
  EXPECT_LE(largest, 2u * 62 * 62);
}

}  // namespace
}  // namespace ligne::test
