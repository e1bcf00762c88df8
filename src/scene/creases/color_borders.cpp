#include "scene/creases/color_borders.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "base/no_index.hpp"
#include "scene/creases/crease_lines.hpp"
#include "scene/model/bounds.hpp"

namespace ligne {
namespace {

/// Colours of an object that may meet anywhere, such as those of a chessboard. More of them that meet at most edges, as in
/// a map of heights or a model made of cubes, would leave the mesh in place of lines. Taste.
constexpr std::size_t kFewColors = 4;

/// For each material the first one that looks the same.
std::vector<std::uint32_t> first_of_look(const std::vector<Material>& materials) {
  std::map<std::tuple<double, double, double, double>, std::uint32_t> first;
  std::vector<std::uint32_t> looks;
  for (const Material& m : materials) {
    const auto number = static_cast<std::uint32_t>(looks.size());
    looks.push_back(first.try_emplace({m.color.x, m.color.y, m.color.z, m.opacity}, number).first->second);
  }
  return looks;
}

/// The edges of an object on which no line lies yet.
struct FreeEdges {
  std::vector<std::uint32_t> borders;  ///< edges where colours meet
  std::size_t count = 0;               ///< of all edges of two faces
};

}  // namespace

void mark_color_borders(const Scene& scene, const Topology& topology, std::vector<std::uint8_t>& lines) {
  if (scene.face_material.empty()) return;
  const std::vector<std::uint32_t> looks = first_of_look(scene.materials);
  if (std::ranges::all_of(looks, [&](std::uint32_t look) { return look == looks[0]; })) return;
  const auto look_of = [&](std::uint32_t face) { return looks[scene.face_material[face]]; };
  std::vector<FreeEdges> objects(scene.objects.size());
  for (std::uint32_t e = 0; e < topology.edges.size(); ++e) {
    const Edge& edge = topology.edges[e];
    if (edge.face1 == kNone || lines[e] != 0 || (topology.edge_flags[e] & kEdgeManyFaces)) continue;
    FreeEdges& object = objects[object_of_vertex(scene, edge.v0)];
    ++object.count;
    if (look_of(edge.face0) != look_of(edge.face1)) object.borders.push_back(e);
  }
  for (const auto& [borders, count] : objects) {
    std::set<std::uint32_t> colors;
    for (const std::uint32_t e : borders) {
      colors.insert({look_of(topology.edges[e].face0), look_of(topology.edges[e].face1)});
      if (colors.size() > kFewColors) break;
    }
    if (colors.size() > kFewColors && 2 * borders.size() > count) continue;
    for (const std::uint32_t e : borders) lines[e] = kTangentLine;
  }
}

}  // namespace ligne
