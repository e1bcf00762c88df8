/// For gaps/tangent_gaps.txt: gaps in tangent lines are closed where they are shorter than the line, and the line goes where
/// they are longer.

#include "scene/patches/borders/tangent_gaps.hpp"

#include <string>

#include "main/script.hpp"
#include "patches/patch_scenes.hpp"
#include "support/test.hpp"

namespace ligne::test {
namespace {

/// A border of a cylinder and a free form along x, of edges of length 1: t is tangent, u is unknown, i is inside a surface,
/// l is another line. At a slash the border turns by 90 degrees. Returns the same letters after close_tangent_gaps().
std::string closed(const std::string& border) {
  Scene scene;
  Topology topology;
  Point3 at(0, 0, 0), way(1, 0, 0);
  scene.vertices.push_back(at);
  std::vector<PatchEdge> kinds;
  std::vector<std::uint8_t> is_line;
  for (const char c : border) {
    if (c == '/') {
      way = Point3(-way.y, way.x, 0);
      continue;
    }
    const auto v = static_cast<std::uint32_t>(kinds.size());
    topology.edges.push_back({v, v + 1, 0, 1});
    scene.vertices.push_back(at += way);
    kinds.push_back(c == 't' ? PatchEdge::tangent : c == 'i' ? PatchEdge::inside : PatchEdge::unknown);
    is_line.push_back(c == 'l');
  }
  topology.edge_flags.assign(kinds.size(), 0);
  Patches patches;
  patches.list.resize(1);
  patches.patch_of = {0, kNone};
  patches.is_freeform = {0, 1};
  close_tangent_gaps(scene, topology, patches, is_line, kinds);
  std::string after;
  std::size_t e = 0;
  for (const char c : border) {
    if (c == '/' || c == 'l') {
      after += c;
      e += c == 'l';
      continue;
    }
    const PatchEdge kind = kinds[e++];
    after += kind == PatchEdge::tangent ? 't' : kind == PatchEdge::inside ? 'i' : 'u';
  }
  return after;
}

[[maybe_unused]] const bool gaps_are_added =
    add_function_scripts(LIGNE_SOURCE_DIR "/tests/patches/gaps", {{"closed", closed}});

}  // namespace
}  // namespace ligne::test
