/// Tangent edges that are dropped: chains that end freely, hooks, small rings, steps from facet to facet.

#include "main/script.hpp"
#include "scene/patches/borders/patch_edges.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

/// A chain of tangent edges between two faces. The edges have length 1 and are parallel to the axis of a cylinder, on which
/// the first face lies.
struct TangentChain {
  bool is_beside_plane = true;
  double width = 1;        ///< of both faces
  double object_size = 0;  ///< length of the object along the chain; 0: that of the chain
  bool is_ring = false;    ///< whether the last edge ends where the first one begins; otherwise both ends are free
  double step = 0;         ///< length of the fourth edge across the chain; 0: it goes straight on
};

/// Number of tangent edges that are left of a chain of so many.
std::size_t tangents_left(int edges, const TangentChain& chain = {}) {
  Topology topology;
  Scene scene;
  for (int i = 0; i < edges; ++i) {
    const auto v = static_cast<std::uint32_t>(i);
    topology.edges.push_back({v, chain.is_ring && i + 1 == edges ? 0 : v + 1, 0, 1});
    scene.vertices.emplace_back(chain.step > 0 && i > 3 ? i - 1 : i, i > 3 ? chain.step : 0, 0);
  }
  scene.vertices.emplace_back(edges, chain.step, 0);
  scene.vertices.emplace_back(0, chain.width, 0);
  scene.vertices.emplace_back(0, -chain.width, 0);
  scene.vertices.emplace_back(chain.object_size, 0, 0);
  scene.objects.resize(1);
  scene.objects[0].vertex_end = static_cast<std::uint32_t>(scene.vertices.size());
  const auto end = static_cast<std::uint32_t>(edges);
  scene.faces.add_face(std::array{0u, end, end + 1});
  scene.faces.add_face(std::array{0u, end + 2, end});
  const std::size_t count = topology.edges.size();
  topology.edge_flags.assign(count, 0);
  Patches patches;
  patches.list.resize(1);
  patches.list[0].surface.axis = Point3(1, 0, 0);
  patches.patch_of = {0, kNone};
  patches.is_freeform = {0, chain.is_beside_plane ? std::uint8_t{0} : std::uint8_t{1}};
  std::vector<PatchEdge> kinds(count, PatchEdge::tangent);
  drop_loose_tangents(scene, topology, patches, std::vector<std::uint8_t>(count, 0), kinds);
  return static_cast<std::size_t>(std::count(kinds.begin(), kinds.end(), PatchEdge::tangent));
}

/// Number of tangent edges that are left of a line that turns a corner behind its first eight edges, goes on for `beyond`
/// edges of length 0.5 and ends freely at both ends, beside a plane and wide faces.
std::size_t tangents_left_at_hook(int beyond) {
  Topology topology;
  Scene scene;
  for (int i = 0; i <= 8 + beyond; ++i) scene.vertices.emplace_back(3 * std::min(i, 8), 0.5 * std::max(0, i - 8), 0);
  for (std::uint32_t v = 0; v + 1 < scene.vertices.size(); ++v) topology.edges.push_back({v, v + 1, 0, 1});
  scene.objects.resize(1);
  scene.objects[0].vertex_end = static_cast<std::uint32_t>(scene.vertices.size());
  scene.faces.add_face(std::array{0u, 1u, scene.objects[0].vertex_end - 1});
  scene.faces.add_face(std::array{0u, scene.objects[0].vertex_end - 1, 1u});
  topology.edge_flags.assign(topology.edges.size(), 0);
  Patches patches;
  patches.patch_of = {kNone, kNone};
  patches.is_freeform = {1, 0};
  std::vector<PatchEdge> kinds(topology.edges.size(), PatchEdge::tangent);
  drop_loose_tangents(scene, topology, patches, std::vector<std::uint8_t>(kinds.size(), 0), kinds);
  return static_cast<std::size_t>(std::count(kinds.begin(), kinds.end(), PatchEdge::tangent));
}

/// For loose/loose_tangents.txt: "EDGES", of a chain, and "free-forms", "ring", "width=W", "object=LENGTH" or "step=LENGTH".
std::string left_of_chain(const std::string& text) {
  TangentChain chain;
  for (const std::string& word : test::words_of(text)) {
    const std::size_t equals = word.find('=');
    const double value = equals == word.npos ? 0 : std::stod(word.substr(equals + 1));
    if (word == "free-forms") chain.is_beside_plane = false;
    if (word == "ring") chain.is_ring = true;
    if (word.starts_with("width")) chain.width = value;
    if (word.starts_with("object")) chain.object_size = value;
    if (word.starts_with("step")) chain.step = value;
  }
  return std::to_string(tangents_left(std::stoi(text), chain));
}

[[maybe_unused]] const bool loose_are_added = test::add_function_scripts(
    LIGNE_SOURCE_DIR "/tests/patches/loose",
    {{"chain", left_of_chain}, {"hook", [](auto& t) { return std::to_string(tangents_left_at_hook(std::stoi(t))); }}});

}  // namespace
}  // namespace ligne
