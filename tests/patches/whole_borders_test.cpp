/// Edges that are decided by the whole border of a patch.

#include "scene/patches/borders/whole_borders.hpp"
#include "support/test.hpp"

#include "patches/part_scenes.hpp"
#include "patches/patch_scenes.hpp"

namespace ligne {
namespace {

using namespace test;

/// A cylinder of radius 10 that becomes a cone at z = 0.
std::vector<Corners> pointed_shaft(int facets, double degrees) {
  return turned_body(facets, {{10, -20}, {10, 0}, {10 - 8 * std::tan(degrees * kPi / 180), 8}});
}

/// The edges of the ring at z = 0.
std::vector<std::size_t> ring_of(const FoundPatches& found) {
  std::vector<std::size_t> ring;
  for (std::size_t e = 0; e < found.edges.size(); ++e) {
    const Edge& edge = found.topology.edges[e];
    if (found.scene.vertices[edge.v0].z == 0 && found.scene.vertices[edge.v1].z == 0) ring.push_back(e);
  }
  return ring;
}

/// The ring of a shaft where so many edges have evidence of a kind, and all others are tangent.
std::vector<PatchEdge> ring_with(std::size_t count, BorderEvidence kind) {
  FoundPatches found(pointed_shaft(24, 20));
  const std::vector<std::size_t> ring = ring_of(found);
  std::vector<BorderEvidence> evidence(found.edges.size(), BorderEvidence::none);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    evidence[ring[i]] = i < count ? kind : BorderEvidence::tangent;
    found.edges[ring[i]] = i < count ? PatchEdge::unknown : PatchEdge::tangent;
  }
  decide_by_whole_borders(found.scene, found.topology, found.patches, evidence, found.edges);
  std::vector<PatchEdge> kinds;
  for (const std::size_t e : ring) kinds.push_back(found.edges[e]);
  return kinds;
}

TEST(WholeBorders, MostOfAChainDecidesForTheRest) {
  EXPECT_EQ(std::ranges::count(ring_with(9, BorderEvidence::open), PatchEdge::tangent), 24);
  EXPECT_EQ(std::ranges::count(ring_with(10, BorderEvidence::open), PatchEdge::tangent), 14);
  EXPECT_EQ(std::ranges::count(ring_with(2, BorderEvidence::against), PatchEdge::tangent), 24);
  EXPECT_EQ(std::ranges::count(ring_with(3, BorderEvidence::against), PatchEdge::tangent), 21);
}

}  // namespace
}  // namespace ligne
